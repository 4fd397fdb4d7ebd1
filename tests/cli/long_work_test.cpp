// Work in parts: simulations that go on from a file, sweeps and studies that were interrupted,
// grids that choose themselves, and how far it has come.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <string>

#include "command_line.hpp"
#include "has_solver.hpp"

using namespace signorini::test;

namespace {

json parsed(const CommandLine& program, const std::string& words)
{
    const auto outcome = program.run(words + " --quiet --format json");
    INFO(words << "\n" << outcome.err);
    REQUIRE(outcome.status == 0);
    return json::parse(outcome.out);
}

void placeFile(const CommandLine& program, const char* name, const std::string& text)
{
    std::ofstream(program.file(name)) << text;
}

const std::string steelRod =
    " --length 3 --young 210GPa --density 7850 --area 1cm2 --gap 0.1mm --damping 5%";

}  // namespace

TEST_CASE("cli simulate: a run in two parts is the run in one, off the grid and without change")
{
    const CommandLine program;
    const std::string force = " --damping 0.02 --amplitude 3e-4 --frequency 1.07 --cells 30";
    for (const std::string& words :
         {force + " --force tip", force + " --force base --phase 1.5707963267948966",
          force + " --force tip --segments 12:1,18:1.4 --gap 2e-4",
          force + " --force base --gap -1e-4 --second-stop 2e-3"}) {
        const json whole = parsed(program, "simulate --rest --periods 61" + words);
        const json plain = parsed(program, "simulate --rest --periods 24" + words);
        json first = parsed(program, "simulate --rest --periods 24 --state s.csv" + words);
        CHECK(first == plain);
        const json second = parsed(program, "simulate --from s.csv --periods 37" + words);
        INFO(words);
        CHECK(second["energy"].get<double>() ==
              Approx(whole["energy"].get<double>()).epsilon(1e-7));
        CHECK(second["tip"].get<double>() ==
              Approx(whole["tip"].get<double>()).margin(1e-9 * 1e-3));
        CHECK(first["impulse"].get<double>() + second["impulse"].get<double>() ==
              Approx(whole["impulse"].get<double>()).epsilon(1e-6));
    }
}

TEST_CASE("cli simulate: the base goes from where a state has it to its motion, whatever the phase")
{
    const CommandLine program;
    const std::string bar = " --damping 0.05 --cells 20";
    const std::string base =
        bar + " --force base --amplitude 2e-4 --frequency 0.95 --periods 300 --tip t.csv";
    REQUIRE(program.run("find 10 60 --cells 20 --state s.csv").status == 0);
    const json rest = parsed(program, "simulate --rest" + base);
    REQUIRE(!rest["settled"].is_null());
    for (const char* phase : {"0", "0.9", "3.14159"}) {
        const json from =
            parsed(program, fmt::format("simulate --from s.csv --phase {}", phase) + base);
        // The motion of find begins at the wall, and so does its tip here: nothing has jumped.
        std::ifstream path(program.file("t.csv"));
        std::string line;
        std::getline(path, line);
        std::getline(path, line);
        CHECK(std::stod(line.substr(line.find(',') + 1)) == Approx(1e-3).epsilon(1e-12));
        REQUIRE(!from["settled"].is_null());
        CHECK(from["settled"]["periods"] == rest["settled"]["periods"]);
        CHECK(from["settled"]["impulse"].get<double>() ==
              Approx(rest["settled"]["impulse"].get<double>()).epsilon(1e-3));
    }
    // A forced motion of find goes on as it is, with the phase of its answer.
    const std::string words = " --cells 80 --damping 5% --force base --amplitude 2e-4";
    const json found = parsed(program, "find 59 202 --state f.csv" + words);
    const json& motion = found["motions"].back();
    const json same =
        parsed(program, fmt::format("simulate --from f.csv --frequency {} --phase {} --periods 40",
                                    320.0 / 261.0, motion["phase"].get<double>()) +
                            words);
    REQUIRE(!same["settled"].is_null());
    CHECK(same["settled"]["periods"] == 1);
    CHECK(same["settled"]["impulse"].get<double>() ==
          Approx(motion["physical"]["impulse"].get<double>()).epsilon(1e-9));
}

TEST_CASE("cli sweep: a run that was cut short ends with the same rows")
{
    const CommandLine program;
    const std::string words =
        "sweep --damping 0.02 --force tip --amplitude 2e-4 --from 1 --to 1.3 --points 7 --cells 20 "
        "--periods 100 --quiet --format json --csv t.csv";
    const auto whole = program.run(words);
    REQUIRE(whole.status == 0);
    const std::string table = contentOf(program.file("t.csv"));
    CHECK(program.files() == 1);
    // A signal at once leaves what was done; --resume asks for the same question only.
    REQUIRE(program.run(words, "timeout --signal=INT 0.15").status != 2);
    if (fs::exists(program.file("t.csv.part"))) {
        const auto other = program.run(words + " --resume --up");
        CHECK(other.status == 2);
        CHECK_THAT(other.err, Catch::Contains("t.csv") && Catch::Contains("another question"));
        std::ofstream(program.file("t.csv.part"), std::ios::app) << "1.2 1.2 0 50";  // cut short
    }
    fs::remove(program.file("t.csv"));
    const auto resumed = program.run(words + " --resume");
    CHECK(resumed.status == 0);
    CHECK(resumed.out == whole.out);
    CHECK(contentOf(program.file("t.csv")) == table);
    CHECK(program.files() == 1);
    CHECK(program.run("sweep --damping 0.1 --force tip --amplitude 1e-4 --resume").status == 2);
}

TEST_CASE("cli sweep: a refused sweep of several bars leaves no file and names what was typed")
{
    const CommandLine program;
    const std::string bars =
        "sweep --scene 'clamp 6 dash=0.1 driven gap=1e-3 4:1.5 dash=0.2 5 "
        "clamp' --force tip --amplitude 2e-3 --points 2 --periods 20 --csv x.csv ";
    for (const auto& [wrong, named] :
         {std::pair{"--resolve 1e-9", "--resolve = 1e-9 is out of range: allowed at least"},
          {"--to-hertz 9", "--to-hertz = 9 is out of range: allowed about 1.5e-07..5 [Hz]"},
          {"--from-hertz 8 --to-hertz 9", "--from-hertz = 8 is out of range: allowed about"}}) {
        const auto outcome = program.run(bars + wrong);
        INFO(wrong << outcome.err);
        CHECK(outcome.status == 2);
        CHECK(lines(outcome.err) == 1);
        CHECK_THAT(outcome.err, containsText(named));
        CHECK(program.files() == 0);
    }
}

TEST_CASE("cli study: each row is the worst of a sweep, and a list may grow")
{
    const CommandLine program;
    const std::string question =
        "# units as on the command line\nforce = \"base\"\ndamping = [0.03, \"10%\"]\n"
        "gap = [\"0.1mm\", 2e-4]\namplitude = {}\nyoung = \"210GPa\"\ndensity = 7850\n"
        "area = \"1cm2\"\nfrom = 0.9\nto = 1.3\npoints = 4\ncells = 20\nperiods = 200\n";
    placeFile(program, "q.toml", fmt::format(fmt::runtime(question), "[\"20um\"]"));
    const json first = parsed(program, "study q.toml --csv s.csv");
    REQUIRE(first["points"].size() == 4);
    CHECK(first["cells"] == 20);
    CHECK(first["bar"]["young"] == 210e9);
    CHECK(first["bar"]["gap"] == 1e-4);
    const auto words = program.run("study q.toml --csv s.csv --resume --verbose");
    CHECK(words.status == 0);
    CHECK_THAT(words.out, Catch::StartsWith("bar         N = 20, L = 1 m, c = 5172") &&
                              containsText("g and E₁ above are of the first"));
    const json& point = first["points"][1];  // gap slowest, amplitude fastest
    CHECK(point["gap"] == 1e-4);
    CHECK(point["damping"] == 0.1);
    const json seen = parsed(
        program,
        "sweep --force base --damping 10% --gap 1e-4 --amplitude 2e-5 --young 210GPa --density "
        "7850 --area 1cm2 --from 0.9 --to 1.3 --points 4 --cells 20 --periods 200");
    double worst = 0.0;
    double stress = 0.0;
    for (const json& at : seen["points"]) {
        worst = std::max(worst, at["impulse_range"][1].get<double>());
        stress = std::max(stress, at["peak_stress"].get<double>());
    }
    CHECK(point["impulse"] == worst);
    CHECK(point["peak_stress"] == stress);
    placeFile(program, "q.toml", fmt::format(fmt::runtime(question), "[\"20um\", 3e-5]"));
    const json more = parsed(program, "study q.toml --csv s.csv --resume --threads 2");
    REQUIRE(more["points"].size() == 8);
    CHECK(more["points"][2] == point);
    CHECK(program.files() == 2);
    for (const auto& [text, fault] :
         {std::pair("gap = [1e-3", "line 1"),
          std::pair("gaps = 1e-3", "--gaps 0.001 is not expected"),
          std::pair("cells = [20, 30]", "cells = [...]"), std::pair("csv = \"a\"", "csv: allowed"),
          std::pair("gap = -1e-3\nforce = \"rope\"", "--force")}) {
        placeFile(program, "wrong.toml", text);
        const auto outcome = program.run("study wrong.toml");
        INFO(text << "\n" << outcome.err);
        CHECK(outcome.status == 2);
        CHECK_THAT(outcome.err, Catch::Contains("wrong.toml: ") && Catch::Contains(fault));
    }
    CHECK(program.run("study none.toml").status == 4);
    for (const char* option : {"--cells 4", "--cells=4", "--second-stop 1 --cells 4"}) {
        const auto outcome = program.run(std::string("study q.toml ") + option);
        INFO(outcome.err);
        CHECK(outcome.status == 2);
        CHECK_THAT(outcome.err, Catch::Contains("; allowed in FILE.toml: ") &&
                                    Catch::Contains(" = ...") && !Catch::Contains("find"));
    }
    // A file does not take it either.
    CHECK_THAT(program.run("study q.toml --over gap").err,
               Catch::Contains("allowed with sweep") && !Catch::Contains("FILE.toml"));
}

TEST_CASE("cli response: --cells auto ends with what a fine grid says, in less time")
{
    if (!test::hasSimplex()) {
        return;
    }
    const CommandLine program;
    const std::string words = "response --force base --amplitude 20um" + steelRod;
    const json chosen = parsed(program, words + " --cells auto --csv r.csv");
    const auto worst = [](const json& answer) {
        double most = 0.0;
        for (const json& at : answer["frequencies"]) {
            for (const json& motion : at["motions"]) {
                most = std::max(most, motion["physical"]["impulse"].get<double>());
            }
        }
        return most;
    };
    const json fine = parsed(program, words + " --cells 160 --from-hertz 500 --to-hertz 540");
    CHECK(worst(chosen) == Approx(worst(fine)).epsilon(0.02));
    double before = 1e9;
    std::set<std::int64_t> grids;
    for (const json& at : chosen["frequencies"]) {
        const auto cells = at["cells"].get<std::int64_t>();
        grids.insert(cells);
        CHECK(at["frequency_ratio"].get<double>() ==
              Approx(4.0 * static_cast<double>(cells) / at["steps"].get<double>()));
        CHECK(at["frequency"].get<double>() < before);
        before = at["frequency"].get<double>();
    }
    CHECK(grids.size() > 1);
    CHECK(*grids.rbegin() == chosen["cells"]);
    CHECK(program.run(words + " --cells auto --map m.svg").status == 2);
    CHECK(program.run("find 5 40 --cells auto").status == 2);
}

TEST_CASE("cli progress: a file of words, and an estimate where work is long")
{
    const CommandLine program;
    const auto outcome = program.run(
        "response --damping 0.02 --force tip --amplitude 2e-4 --cells 500 --progress p.txt",
        "timeout --signal=INT 8");
    CHECK_THAT(outcome.err, Catch::Contains("frequencies, about"));
    const std::string words = contentOf(program.file("p.txt"));
    CHECK_THAT(words, Catch::Contains(" left\n"));
    CHECK(program.run("families --progress none/p.txt").status == 4);
}
