#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "command_line.hpp"

using namespace signorini::test;

namespace {

/// The fields of each row but the first.
std::vector<std::vector<std::string>> fieldsOf(const std::string& table)
{
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(table);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        rows.push_back(cellsOf(line));
    }
    return rows;
}

/// Totals of the columns of --events, and what --statistics says of each; `columns` by their place.
void compare(const CommandLine& program, const std::map<std::string, std::size_t>& columns)
{
    const auto events = fieldsOf(contentOf(program.file("e.csv")));
    const auto statistics = fieldsOf(contentOf(program.file("s.csv")));
    REQUIRE(events.size() > 3);
    for (const auto& [quantity, column] : columns) {
        double total = 0.0;
        for (const auto& event : events) {
            total += std::stod(event.at(column));
        }
        double said = 0.0;
        std::size_t counted = 0;
        for (const auto& row : statistics) {
            if (row.at(1) == quantity) {
                said += row.at(3) == "total" ? std::stod(row.at(6)) : 0.0;
                counted += row.at(3) == "histogram" ? std::stoul(row.at(6)) : 0;
            }
        }
        INFO(quantity);
        CHECK(total > 0.0);
        CHECK(said == Approx(total));
        CHECK(counted == events.size());
    }
}

void write(const CommandLine& program, const char* name, const std::string& text)
{
    std::ofstream(program.file(name)) << text;
}

}  // namespace

TEST_CASE("cli impacts: --statistics counts each contact of --events once, of bars and of scenes")
{
    const CommandLine program;
    const std::string files = " --events e.csv --statistics s.csv";
    REQUIRE(program
                .run("simulate --rest --second-stop 1e-3 --damping 0.02 --force tip --amplitude "
                     "2e-3 --frequency 1 --periods 30 --cells 20" +
                     files)
                .status == 0);
    compare(program, {{"impulse", 2}, {"speed", 6}, {"energy", 7}});
    CHECK_THAT(contentOf(program.file("s.csv")), containsText("left,impacts,1/s,rate,,,"));
    REQUIRE(
        program.run("simulate --scene 'stop=-1e-3 30 stop=1e-3' --velocity 0.1 --time 40" + files)
            .status == 0);
    compare(program, {{"impulse", 3}, {"speed", 5}});
    // Nothing touches: rates are 0, and nothing is spread.
    REQUIRE(program.run("simulate --rest --time 2" + files).status == 0);
    CHECK(contentOf(program.file("s.csv")) ==
          "contact,quantity,unit,statistic,from,to,value\n"
          "right,impacts,-,count,,,0\nright,impacts,1/s,rate,,,0\n");
}

TEST_CASE("cli impacts: a force from a file moves a tip far from the wall as the integral says")
{
    const CommandLine program;
    // Until 2 L/c nothing comes back from the clamp: u = int F dt/(EA/c), whatever the step.
    const std::string column = GENERATE(as<std::string>{}, "force", "newtons");
    write(program, "f.csv", "time," + column + "\n0,0\n1,1e-3\n1.5,1e-3\n");
    for (const char* bar :
         {"--cells 14 --gap 1", "--segments 7:1,7:1 --gap 1", "--cells 14 --gap 1 --state end.csv",
          "--scene 'clamp 14 driven stop=1'"}) {
        const auto outcome =
            program.run("simulate --rest --force-file f.csv --time 1.5 --format json --tip t.csv " +
                        std::string(bar));
        INFO(bar << outcome.err);
        REQUIRE(outcome.status == 0);
        CHECK(std::stod(fieldsOf(contentOf(program.file("t.csv"))).back().back()) == Approx(1e-3));
        CHECK(json::parse(outcome.out)["excitation"].is_null());
    }
}

TEST_CASE(
    "cli impacts: what is wrong with a file of a force is said in one line, and nothing is written")
{
    const CommandLine program;
    write(program, "good.csv", "time,force\n0,0\n1,1\n");
    write(program, "back.csv", "time,force\n0,0\n1,1\n0.5,1\n");
    write(program, "words.csv", "time,force\n0,strong\n");
    write(program, "names.csv", "t,F\n0,1\n");
    const auto refuses = [&](const std::string& words, const std::string& part, int status = 2) {
        const auto outcome = program.run("simulate " + words + " --events e.csv");
        INFO(words << "\n" << outcome.err);
        CHECK(outcome.status == status);
        CHECK_THAT(outcome.err, containsText(part));
        CHECK(lines(outcome.err) == 1);
        CHECK_FALSE(fs::exists(program.file("e.csv")));
    };
    refuses("--rest --time 2 --force-file back.csv", "times that increase, in s: more than 1");
    refuses("--rest --time 2 --force-file words.csv", "strong");
    refuses("--rest --time 2 --force-file names.csv", "columns time [s] and force [N]");
    refuses("--rest --time 2 --force-file gone.csv", "--force-file", 4);
    refuses("--rest --periods 2 --force-file good.csv", "--force-file clashes");
    refuses("--rest --time 2 --force tip --amplitude 1 --frequency 1 --force-file good.csv",
            "--force-file clashes");
    refuses("--rest --time 1e9 --force-file good.csv", "--time = 1000000000");
    refuses("--scene 'clamp 9 stop=1' --time 1 --force-file good.csv", "the word driven");
    refuses("--rest --force-file good.csv", "--time, --periods: missing");
}

TEST_CASE(
    "cli amplitudes: a base set by its velocity or acceleration is one with that displacement")
{
    const CommandLine program;
    const double omega =
        2.0 * std::numbers::pi * 0.25 * 1.1;  // of the default bar, c/(4 L) = 0.25 Hz
    const double displacement = 2e-4;
    const auto answer = [&](const std::string& words, int derivative) {
        const char* option[] = {"--amplitude", "--amplitude-velocity", "--amplitude-acceleration"};
        const auto outcome =
            program.run(fmt::format("{} {} {} --format json --quiet", words, option[derivative],
                                    displacement * std::pow(omega, derivative)));
        INFO(words << outcome.err);
        REQUIRE(outcome.status == 0);
        return json::parse(outcome.out);
    };
    const std::string base = " --damping 0.02 --force base";
    const char* scene =
        "simulate --scene 'clamp shaken 100 dash=0.02 stop=1e-3' --frequency 1.1 "
        "--periods 20";
    for (int derivative : {0, 1, 2}) {
        const json run = answer("simulate --rest --frequency 1.1 --periods 100" + base, derivative);
        CHECK(run["excitation"]["amplitude"].get<double>() == Approx(displacement));
        const json found = answer("find --frequency 11/10" + base, derivative);
        REQUIRE(found["motions"].size() == 1);
        const double impulse = found["motions"][0]["physical"]["impulse"].get<double>();
        const json drawn = answer("response --from 1.1 --to 1.1 --cells 110" + base, derivative);
        CHECK(drawn["frequencies"][0]["motions"][0]["impulse"].get<double>() ==
              Approx(impulse).epsilon(1e-6));
        const json settled = answer(
            "sweep --from 1.1 --to 1.1 --points 1 --cells 110 --rest --up" + base, derivative);
        CHECK(settled["points"][0]["impulse"].get<double>() == Approx(impulse).epsilon(2e-2));
        const char* of[] = {"displacement", "velocity", "acceleration"};
        for (const json& one : {drawn, settled}) {
            CHECK(one["amplitude_of"] == of[derivative]);
            CHECK(one["amplitude"].get<double>() ==
                  Approx(displacement * std::pow(omega, derivative)));
        }
        CHECK(answer(scene, derivative)["excitation"]["amplitude"].get<double>() ==
              Approx(displacement));
    }
    const auto refuses = [&](const std::string& words, const std::string& part) {
        const auto outcome = program.run(words);
        INFO(words << "\n" << outcome.err);
        CHECK(outcome.status == 2);
        CHECK_THAT(outcome.err, containsText(part));
        CHECK(lines(outcome.err) == 1);
    };
    refuses("response --damping 0.02 --force tip --amplitude-velocity 1", "only with --force base");
    refuses("sweep --damping 0.02 --force base --amplitude 1 --amplitude-velocity 1",
            "one amplitude");
    refuses(
        "simulate --scene 'clamp 9 driven stop=1' --amplitude-velocity 1 --frequency 1 --time 1",
        "a base that is shaken");
    refuses("response --damping 0.02 --force base --amplitude-velocity 1 --map m.svg", "--map");
    refuses("response --damping 0.02 --force base --amplitude-acceleration 0", "[m/s^2]");
}

TEST_CASE("cli impacts: no mean force is beyond the peak, however short the resolution")
{
    const CommandLine program;
    for (const char* resolution : {"1e-9", "1e-6", "1e-3"}) {
        REQUIRE(program
                    .run("simulate --rest --damping 0.05 --force tip --amplitude 1e-3 --frequency "
                         "1.1 --cells 20 --periods 100 --events e.csv --resolve " +
                         std::string(resolution))
                    .status == 0);
        const auto events = fieldsOf(contentOf(program.file("e.csv")));
        REQUIRE(events.size() > 50);
        for (const auto& event : events) {
            CHECK(std::stod(event.at(4)) <= std::stod(event.at(3)));
        }
    }
}
