// Scenes on the command line: gaps of any sign, a second stop.

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <tuple>

#include "command_line.hpp"
#include "has_solver.hpp"

using namespace signorini;
using namespace signorini::test;

TEST_CASE("cli scenes: a bar pressed at rest, in newtons and joules")
{
    const CommandLine program;
    const json r = program.find("6 4 --cells 4 --gap -2e-3 --length 2 --axial-stiffness 1e6", 0);
    CHECK(r["stops"] == json::parse(R"([{"side": "right", "place": -0.002}])"));
    CHECK(r["static_force"].get<double>() == Approx(1e6 * 1e-3));
    CHECK(r["energy_ratio"].get<double>() == Approx(4.0));  // (w/win)^2, w = 4, win = 2
    CHECK(r["energy"].get<double>() == Approx(4.0 * 0.5 * 1e6 * 4e-6 / 2.0));
    CHECK(r["solution_set"]["kind"] == "simplex");
    CHECK(r["family"]["contact_blocks"] == 3);
    CHECK(r["physical"]["tip_lowest"].get<double>() < -2e-3);
    const auto text = program.run("find 6 4 --cells 4 --gap -2e-3 --figure f.svg");
    CHECK_THAT(text.out, containsText("at rest     the bar presses on the wall with 0.002 N"));
    CHECK(std::filesystem::exists(program.file("f.svg")));
    const json none = program.find("1 4 --cells 4 --gap -1e-3", 1);
    CHECK(none["certificate"]["gap"].get<std::int64_t>() > 0);
}

TEST_CASE("cli scenes: without a gap the energy is given in joules and answers say no E_1")
{
    const CommandLine program;
    const json r = program.find("3 7 --cells 4 --gap 0 --energy 2e-6 --quiet", 0);
    CHECK(r["energy"].get<double>() == Approx(2e-6));
    CHECK(r["energy_ratio"].is_null());
    CHECK(r["energy_ratio_range"] == json({nullptr, nullptr}));
    CHECK(r["solution_set"]["kind"] == "cone");
    const json none = program.find("3 8 --cells 4 --gap 0 --energy 2e-6", 1);
    CHECK(none["certificate"]["size"].get<std::int64_t>() < 0);
    const auto missing = program.run("find 3 7 --cells 4 --gap 0");
    CHECK(missing.status == 2);
    CHECK_THAT(missing.err, containsText("--energy is missing: allowed"));
    CHECK(lines(missing.err) == 1);
}

TEST_CASE("cli scenes: two stops, phases that name theirs, mirrored motions recognised")
{
    const CommandLine program;
    const json r =
        program.find("1 5 L:1 5 --cells 4 --second-stop 1e-3 --figure f.svg --motion m.csv", 0);
    CHECK(r["schedule"] == json::parse(R"([[1, 5], [1, 5, "left"]])"));
    CHECK(r["canonical_schedule"] == r["schedule"]);
    CHECK(r["symmetric"] == true);
    CHECK(r["energy_ratio"].get<double>() == Approx(8.0));
    CHECK(r["stops"][1]["place"] == -1e-3);
    CHECK(std::filesystem::exists(program.file("f.svg")));
    CHECK(program.find("1 4 L:1 4 --cells 4 --second-stop 1e-3", 1)["certificate"]["verified"] ==
          true);
    const auto refused = program.run("find 1 5 L:1 5 --cells 4");
    CHECK(refused.status == 2);
    CHECK_THAT(refused.err, containsText("phase 2 = L:1 5 is out of range"));
}

TEST_CASE("cli scenes: continua without a gap, in joules, and between two stops")
{
    const CommandLine program;
    const auto traced = [&program](const std::string& arguments) {
        const auto outcome = program.run("continuum " + arguments + " --format json --quiet");
        INFO(arguments << "\n" << outcome.err);
        REQUIRE(outcome.status == 0);
        return json::parse(outcome.out);
    };
    const json cone = traced("12 36 --cells 16 --gap 0 --energy 2e-6 --points 7 --csv k.csv");
    CHECK(cone["energy"].get<double>() == Approx(2e-6));
    CHECK(cone["energy_ratio"].is_null());
    CHECK(cone["energy_ratio_range"].is_null());
    CHECK(cone["connected"] == true);
    CHECK(cone["dimension"] == 11);
    CHECK(cone["orbits"] == 7);
    for (const json& point : cone["points"]) {
        CHECK(point["energy"].get<double>() == Approx(2e-6).epsilon(1e-12));
        CHECK(point["energy_ratio"].is_null());
    }
    CHECK(lines(contentOf(program.file("k.csv"))) == 8);

    const json stops = traced("6 36 --cells 12 --second-stop 4e-3 --energy-ratio 8 --points 7");
    CHECK(stops["stops"][1]["place"] == -4e-3);
    CHECK(stops["engine"] == "geometric");
    CHECK(stops["points"].size() == 7);
    CHECK(stops["energy_ratio"] == 8.0);

    CHECK(program.run("continuum 3 8 --cells 4 --gap 0 --energy 2e-6").status == 1);
    CHECK(program.run("continuum 6 36 --cells 12 --energy-ratio 8 --energy 1").status == 2);
    // The ends of an arc are written and read back in the unit of a bar without a gap.
    REQUIRE(program.run("find 12 36 --cells 16 --gap 0 --energy 2e-6 --state to.csv").status == 0);
    REQUIRE(program
                .run("continuum 12 36 --cells 16 --gap 0 --energy 2e-6 --member 0 --state "
                     "from.csv")
                .status == 0);
    CHECK(traced("12 36 --cells 16 --gap 0 --energy 2e-6 --from from.csv --to to.csv "
                 "--points 5")["points"]
              .size() == 5);
}

TEST_CASE("cli scenes: a solver that is named decides on two stops, too", "[glpk]")
{
    const CommandLine program;
    CHECK(program.find("1 5 L:1 5 --cells 4 --second-stop 1e-3 --solver glpk-simplex "
                       "--formulation state",
                       0)["route"] == "glpk-simplex on the state formulation");
}

TEST_CASE("cli scenes: commands say which scenes they do not know")
{
    const CommandLine program;
    for (const char* call :
         {"modes --second-stop 1e-3", "modes --gap 0", "modes --segments 4:1,4:1.3",
          "find 3 7 --cells 4 --gap 0 --damping 0.02 --force tip",
          "atlas --database a.sqlite --second-stop 1e-3 --figure f.svg",
          "families --segments 4:1,4:1.3", "find 1 5 --gap 1e-3 --second-stop 0",
          "find 1 5 --segments 4", "find 1 5 --gap -2e-3 --second-stop 1e-3"}) {
        const auto outcome = program.run(call);
        INFO(call << ": " << outcome.err);
        CHECK(outcome.status == 2);
        CHECK(lines(outcome.err) == 1);
    }
    CHECK(program.files() == 0);
}

TEST_CASE("cli scenes: refusals name what was typed, where, and what there is no method for")
{
    const CommandLine program;
    std::ofstream(program.file("e.json")) << "{}";
    std::ofstream(program.file("p.csv")) << "length,young,density,area\n1,2e11,8e3,1e-4\n"
                                            "1,2e11,8e3,2e-4\n";
    for (const auto& [call, start, text] :
         {std::tuple{"modes --scene 'clamp 6 6:1.3 stop=1e-3'", "--scene: allowed",
                     "sweep, atlas and scene; families and modes are theorems"},
          {"modes --scene 'clamp 6 stop=-2e-3 stop=1e-3'", "--scene: allowed of two", "one wall"},
          {"families --segments 6:1,6:1.3", "--segments: allowed", "there is no method"},
          {"mode 4 -1 --period 3 --segments-file p.csv", "--segments-file: allowed", "theorems"},
          {"scene e.json", "e.json: parts = null", "allowed a list"},
          {"find 3 7 --scene e.json", "e.json: parts = null", "allowed a list"},
          {"find :2 -:9 --scene 'clamp 3 gap=1e-3 4 clamp'", "schedule = :2",
           "allowed SET:STEPS, SET - or different contacts"}}) {
        const auto outcome = program.run(call);
        INFO(call << ": " << outcome.err);
        CHECK(outcome.status == 2);
        CHECK(lines(outcome.err) == 1);
        CHECK_THAT(outcome.err,
                   Catch::StartsWith(std::string("signorini: ") + start) && containsText(text));
    }
}

TEST_CASE("cli scenes: of bars that fly no energy but 0 is found where none else is", "[glpk]")
{
    const CommandLine program;
    const auto outcome =
        program.run("find --hertz 0.6 --scene 'stop=1e-3 6 stop=1e-3' --energy 1e-5");
    CHECK(outcome.status == 3);
    CHECK_THAT(outcome.out, containsText("no energy but 0 was found"));
}

TEST_CASE("cli scenes: modes, families and atlas of a bar pressed at rest")
{
    const CommandLine program;
    const json modes =
        json::parse(program.run("modes --gap -1e-3 --max-order 9 --format json").out);
    CHECK(modes["modes"].size() > 3);
    const json families = json::parse(program.run("families --gap -1e-3 --format json").out);
    CHECK(families["families"][0]["least_energy_ratio"] == 1.0);
    const auto built = program.run(
        "atlas --database a.sqlite --cells 4 --gap -1e-3 --max-contact 16 --max-free 24");
    INFO(built.err);
    REQUIRE(built.status == 0);
    const auto other = program.run("atlas --database a.sqlite --cells 4");
    CHECK(other.status == 2);
    CHECK_THAT(other.err, containsText("of other stops"));
    const json near = json::parse(
        program.run("atlas --database a.sqlite --cells 4 --period 5/2 --schedules --format json")
            .out);
    INFO(near.dump(1));
    CHECK(near["schedules"].size() > 0);
    const auto cone = program.run(
        "atlas --database b.sqlite --cells 4 --gap 0 --max-contact 16 "
        "--max-free 24 --format json");
    INFO(cone.err);
    REQUIRE(cone.status == 0);
    CHECK(json::parse(cone.out)["pressing"] == 12);
}

TEST_CASE("cli scenes: families and atlas beside a second stop")
{
    const CommandLine program;
    const auto families = [&program](const std::string& stops) {
        return json::parse(program.run("families --format json" + stops).out)["families"].size();
    };
    CHECK(families(" --second-stop 1e-3") == 0);
    CHECK(families(" --second-stop 1.2e-3") == 1);  // (12, 23, 1)
    CHECK(families(" --second-stop 1") == families(""));
    CHECK(families(" --second-stop 1 --gap 0") == families(" --gap 0"));
    const std::string call = "atlas --database a.sqlite --cells 4 --max-contact 4 --max-free 8 ";
    const auto built = program.run(call + "--second-stop 1e-3 --phases 2 --all");
    INFO(built.err);
    REQUIRE(built.status == 0);
    CHECK(program.run(call + "--second-stop 2e-3").status == 2);
    const auto again = program.run(call + "--second-stop 1e-3 --phases 2 --all --format json");
    REQUIRE(again.status == 0);
    const json near = json::parse(
        program.run("atlas --database a.sqlite --cells 4 --period 3 --schedules --format json")
            .out);
    bool isListed = false;
    for (const json& row : near["schedules"]) {
        isListed = isListed || row.at("schedule") == json::parse(R"([[1, 5], [1, 5, "left"]])");
    }
    INFO(near.dump(1));
    CHECK(isListed);
}

TEST_CASE("cli scenes: forced motions with any gap and between two stops")
{
    const CommandLine program;
    const std::string force = " --cells 10 --damping 0.05 --force tip";
    const json pressed = program.find("14 12 --gap -1e-3 --amplitude 1.5e-3" + force, 0);
    CHECK(pressed["static_force"].get<double>() == Approx(1e-3));
    CHECK(pressed["motions"][0]["residual"].get<double>() < 1e-9);
    const auto rest = program.run("find 12 8 --gap 0" + force);
    CHECK(rest.status == 2);
    CHECK_THAT(rest.err, containsText("--amplitude is missing"));
    const auto response = program.run(
        "response --amplitude 5e-4 --from 0.8 --to 1.6 --second-stop 1e-3 --csv r.csv --figure "
        "r.svg --map m.svg --format json" +
        force);
    INFO(response.err);
    REQUIRE(response.status == 3);  // some schedules are undecided, and it says so
    const json answer = json::parse(response.out);
    CHECK(answer["complete"] == false);
    CHECK(answer["stops"].size() == 2);
    const std::string table = contentOf(program.file("r.csv"));
    CHECK_THAT(table, containsText(",both,"));
    CHECK_THAT(contentOf(program.file("r.svg")), containsText("second stop"));
}

TEST_CASE("cli scenes: a simulation between two stops names the stop of each contact")
{
    const CommandLine program;
    const auto outcome = program.run(
        "simulate --rest --second-stop 1e-3 --damping 0.02 --force tip --amplitude 2e-3 "
        "--frequency 1 --periods 30 --cells 20 --events e.csv --figure f.svg");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    const std::string events = contentOf(program.file("e.csv"));
    CHECK(events.starts_with("start,end,impulse,peak_force,stop,mean_force,speed,energy\n"));
    CHECK_THAT(events, containsText(",left,") && containsText(",right,"));
}

TEST_CASE("cli scenes: find --scene knows any bars that are held, and proves what it says")
{
    const CommandLine program;
    const json r = program.find(
        "--scene 'clamp 3 stop=1e-3 3 clamp' 1 10 --state s.csv --certificate c.json --figure "
        "f.svg",
        0);
    CHECK(contentOf(program.file("f.svg")).find("u at contact 1") != std::string::npos);
    // Its state simulated for a period by its own decisions is its state, with the same energy.
    const std::string again =
        fmt::format("simulate --scene 'clamp 3 stop=1e-3 3 clamp' --from s.csv --time {:.17g}",
                    r["period"].get<double>());
    const json once = json::parse(program.run(again + " --format json").out);
    CHECK(once["energy"].get<double>() == Approx(r["energy"].get<double>()).epsilon(1e-9));
    CHECK(once["contacts"][0]["contact_time"].get<double>() ==
          Approx(r["contacts"][0]["contact_time"].get<double>()).epsilon(1e-9));
    CHECK(r["energy"].get<double>() ==
          Approx(0.75e-6 * 6.0));  // 27 Z_1 delta^2/h, delta = g/6, h = 1/6 s
    CHECK(r["energy_ratio_proved"].get<double>() ==
          Approx(r["energy_ratio"].get<double>()).epsilon(1e-7));
    CHECK(r["contacts"][0]["impulse"].get<double>() > 0.0);
    CHECK(r["contacts"][0]["contact_time"].get<double>() == Approx(1.0 / 6.0));
    CHECK(lines(contentOf(program.file("s.csv"))) > 6);
    CHECK(json::parse(contentOf(program.file("c.json"))) == r);
    const std::string bars = "--scene 'clamp 3 stop=1e-3 3 gap=1e-3 4 clamp' ";
    const json none = program.find(bars + "1:2 -:9 2:3 -:8", 1);
    CHECK(none["schedule"] ==
          json::parse(R"([{"closed": [1], "steps": 2}, {"closed": [], "steps": 9},
                                              {"closed": [2], "steps": 3}, {"closed": [], "steps": 8}])"));
    CHECK(none["certificate"]["energy_ratio"].get<double>() > 1e9);
    CHECK_THAT(program.run("find " + bars + "1:2 -:9 1+2:3 -:8").out,
               containsText("1:2 -:9 1+2:3 -:8"));
    const auto refuses = [&](const std::string& words, const std::string& part) {
        const auto outcome = program.run("find " + words);
        INFO(words << "\n" << outcome.err);
        CHECK(outcome.status == 2);
        CHECK_THAT(outcome.err, containsText(part));
        CHECK(lines(outcome.err) == 1);
    };
    refuses(bars + "1+9:5 -:3", "schedule = 1+9:5");
    refuses(bars + "1+1:5 -:3", "different contacts 1..2");
    refuses(bars + "3 9", "SET:STEPS");
    refuses("--scene 'clamp 4 stop=1e-3' 3 x", "schedule = x");
    refuses("--scene 'clamp 4 stop=1e-3' 3", "NC NF");
    refuses("--scene 'clamp 4 stop=0' 3 9", "at rest are a motion");
    refuses("--scene '4 gap=1e-3 4' 3 9", "bar = 1");
    refuses(bars + "1:3 -:9 --tip-floor -1", "--tip-floor clashes with --scene");
    refuses(bars + "1:3 -:9 --energy-ratio 3 --energy 1", "--energy clashes with --energy-ratio");
    refuses(bars + "1:3 -:9 --objective nearest", "--target is missing");
    refuses("--scene 'stop=1e-3 8 stop=1e-3' 1:3 -:9 --energy-ratio 3", "--energy-ratio = 3");
    refuses(bars + "1:3 -:9 --force tip --damping 0.1", "--damping clashes with --scene");
    refuses(bars + "1:3 -:9 --force tip", "tip for a scene with the word driven");
    refuses("--scene 'clamp 4 dash=0.1 driven gap=1e-3 4 clamp' 3 9 --force tip --energy 1",
            "without --force");
}

TEST_CASE("cli scenes: two equal bars show what the paper's shows, with half its forces")
{
    const CommandLine program;
    const auto answer = [&program](const std::string& arguments) {
        return json::parse(program.run("find 6 36 --format json --quiet " + arguments).out);
    };
    const std::string bars = "--length 2 --scene 'clamp 12 gap=1e-3 12 clamp'";
    const json one = answer("--cells 12");
    const json two = answer(bars);
    const auto half = [&](const char* key, double factor) {
        INFO(key);
        CHECK(two["physical"][key].get<double>() ==
              Approx(factor * one["physical"][key].get<double>()).epsilon(1e-12));
    };
    for (const char* key : {"frequency", "contact_time", "approach_speed"}) {
        half(key, 1.0);
    }
    for (const char* key : {"peak_force", "impulse", "peak_compression", "peak_tension"}) {
        half(key, 0.5);
    }
    CHECK(two["frequency_ratio"].get<double>() == Approx(8.0 / 7.0).epsilon(1e-12));
    CHECK(two["period_ratio"].get<double>() == Approx(1.75).epsilon(1e-12));
    CHECK(two["admissible"] == true);
    // Of the excitation, where there is one: 4 N K/n.
    const json driven =
        answer("--scene 'clamp 12 dash=0.02 driven stop=1e-3' --force tip --cycles 3");
    CHECK(driven["frequency_ratio"].get<double>() == Approx(24.0 / 7.0).epsilon(1e-12));
    CHECK(answer("--length 2 --scene 'clamp 12 gap=3 12 clamp'")["admissible"] == false);
}

TEST_CASE("cli scenes: an energy is held, and the most impulse, as of the paper's bar")
{
    if (!hasSimplex()) {
        return;  // both searches need one
    }
    const CommandLine program;
    // Two bars of one length and impedance meet in the middle of the gap, as at a wall.
    const std::string bars = "--scene 'clamp 4 gap=2e-3 4 clamp' --length 2 ";
    const json two = program.find(bars + "3 11 --objective max-impulse --state s.csv", 0);
    const json one = program.find("3 11 --cells 4 --objective max-impulse", 0);
    CHECK(two["contacts"][0]["impulse"].get<double>() ==
          Approx(one["physical"]["impulse"].get<double>()));
    CHECK(two["certificate"].is_null());
    // Sets of contacts name those of one bar with any demand, too.
    CHECK(
        program.find("1:3 -:11 --scene 'clamp 4 stop=1e-3' --objective max-energy", 0)["energy"] ==
        program.find("3 11 --cells 4 --objective max-energy", 0)["energy"]);
    const auto highest = program.run("find " + bars + "3 11 --objective max-energy");
    CHECK_THAT(highest.out, containsText("the most found, not proved the most; proved: none"));
    // Of segments it is said, too, and not where a closed form knows it.
    const std::string climbed = "objective   max-energy, the most found, not proved the most";
    CHECK_THAT(program.run("find 6 36 --segments 6:1,6:2 --objective max-energy").out,
               containsText(climbed));
    CHECK_THAT(program.run("find 6 36 --cells 12 --objective max-energy").out,
               !containsText(climbed));
    const double least = one["energy_ratio_range"][0].get<double>() * 1e-6;  // of two bars
    CHECK(program.find(bars + "2 14 --energy 3e-6", 0)["energy"].get<double>() == Approx(3e-6));
    const json none = program.find(fmt::format("{} 3 11 --energy {}", bars, 0.99 * least), 1);
    CHECK(none["reason"] == "constraints");
    CHECK(none["certificate"]["energy"].get<double>() == Approx(least).epsilon(1e-6));
    // Where there is no motion at all, that is no matter of the energy.
    CHECK_FALSE(program.find(bars + "11 3 --energy 3e-6", 1).contains("reason"));
    CHECK(
        program.find(bars + "3 11 --objective nearest --target s.csv", 0)["energy"].get<double>() ==
        Approx(two["energy"].get<double>()));
}

namespace {

/// The file of the motion that is found, without its header.
std::vector<std::vector<double>> motionTable(const CommandLine& program, const std::string& words)
{
    CHECK(program.find(words + " --motion m.csv", 0)["status"] == "found");
    std::vector<std::vector<double>> rows;
    std::istringstream text(contentOf(program.file("m.csv")));
    std::string line;
    for (std::getline(text, line); std::getline(text, line);) {
        std::vector<double>& row = rows.emplace_back();
        std::istringstream fields(line);
        for (std::string field; std::getline(fields, field, ',');) {
            row.push_back(std::stod(field));
        }
    }
    return rows;
}

}  // namespace

TEST_CASE("cli scenes: a motion in a file is that of the bar's own field, and two bars mirror it")
{
    const CommandLine program;
    const auto one = motionTable(program, "3 11 --cells 4");
    const auto two = motionTable(program, "--scene 'clamp 4 gap=2e-3 4 clamp' --length 2 3 11");
    REQUIRE(one.size() == 15 * 5);
    REQUIRE(two.size() == 15 * 10);
    for (std::size_t m = 0; m < 15; ++m) {
        for (std::size_t i = 0; i < 5; ++i) {
            const auto& bar = one[5 * m + i];
            const auto& left = two[10 * m + i];
            const auto& right = two[10 * m + 9 - i];
            CHECK(left[0] == Approx(bar[0]));
            CHECK(left[1] == Approx(bar[1]).margin(1e-12));
            CHECK(left[2] == Approx(bar[2]).margin(1e-15));
            CHECK(right[2] == Approx(-bar[2]).margin(1e-15));
            CHECK(right[1] == Approx(2.0 - bar[1]));
            // At the last instant the next period has begun for the bar's field, or not.
            if (m < 14) {
                CHECK(left[3] == Approx(bar[3]).margin(1e-15));
                CHECK(left[4] == Approx(bar[4]).margin(1e-15));
                CHECK(left[5] == Approx(bar[5]).margin(1e-12));
            }
        }
    }
    const std::string bars = "find --scene 'clamp 4 gap=2e-3 4 clamp' 3 11 --motion ";
    const auto refused = program.run(bars + "m.pvd");
    CHECK(refused.status == 2);
    CHECK_THAT(refused.err, containsText("FILE.csv|.vtk of several bars"));
    CHECK(program.run(bars + "m.vtk").status == 0);
    CHECK_THAT(contentOf(program.file("m.vtk")), containsText("DIMENSIONS 10 15 1"));
}

TEST_CASE("cli scenes: files and strains under an exact harmonic are those of the bar's field")
{
    const CommandLine program;
    const std::string force = "--period 4 --force tip ";
    const double dashpot = std::tanh(0.5 * std::numbers::pi * 0.05);  // damps as zeta = 0.05
    const std::string bar = force + "--amplitude 2e-3 --cells 10 --damping 0.05";
    const std::string steel =
        fmt::format("{}--scene 'clamp 10 dash={:.17g} driven stop=1e-3' ", force, dashpot);
    const std::string words = steel + "--amplitude 2e-3";
    const auto one = motionTable(program, bar);
    const auto row = motionTable(program, words);
    const json strains = program.find(words, 0)["motions"][0]["strains"];
    const json physical = program.find(bar, 0)["motions"][0]["physical"];
    CHECK(strains["peak_compression"].get<double>() ==
          Approx(physical["peak_compression"].get<double>()).epsilon(1e-9));
    const double deepest = strains["peak_compression"].get<double>();
    const auto limited = [&](double limit) {
        return words + fmt::format(" --strain-limit {:.17g}", limit);
    };
    CHECK(program.find(limited(deepest), 0)["beyond_limit"] == 0);
    const json beyond = program.find(limited(0.99 * deepest), 3);
    CHECK(beyond["beyond_limit"] == 1);
    CHECK_THAT(beyond["detail"].get<std::string>(), containsText("1 motion does not stay within"));
    REQUIRE(row.size() == one.size());
    double largest = 0.0;
    for (std::size_t k = 0; k < row.size(); ++k) {
        CHECK(row[k][0] == Approx(one[k][0]).margin(1e-12));
        CHECK(row[k][1] == Approx(one[k][1]).margin(1e-12));
        CHECK(row[k][2] == Approx(one[k][2]).margin(1e-12));
        largest = std::max(largest, -row[k][4]);
    }
    CHECK(largest <= strains["peak_compression"].get<double>());
    CHECK(largest > 0.8 * strains["peak_compression"].get<double>());
    const auto warned =
        program.run("find " + steel +
                    "--young 2e11 --density 8e3 --area 1e-4 --amplitude 1e5 --yield-stress 1e8 "
                    "--figure f.svg --animate a.gif --motion m.vtk");
    CHECK(warned.status == 0);
    CHECK_THAT(warned.err, containsText("beyond --yield-stress"));
    for (const char* file : {"f.svg", "a.gif", "m.vtk"}) {
        CHECK(std::filesystem::file_size(program.file(file)) > 1000);
    }
    CHECK_THAT(program.run("find " + words + " --motion m.pvd").err, containsText("FILE.csv|.vtk"));
}

TEST_CASE("cli scenes: forced motions of bars that meet, the least amplitude and those of one")
{
    const CommandLine program;
    const std::string bars =
        "--scene 'clamp 3 dash=0.1 driven gap=1e-3 4:1.3 dash=0.05 2 clamp' 4 13 --force tip ";
    const json least = program.find(bars + "--state s.csv --figure f.svg", 0);
    CHECK(std::filesystem::exists(program.file("f.svg")));
    const double amplitude = least["amplitude_range"][0].get<double>();
    CHECK(least["motions"][0]["amplitude"].get<double>() == Approx(amplitude));
    CHECK(lines(contentOf(program.file("s.csv"))) > 9);
    const json two = program.find(bars + fmt::format("--amplitude {}", 1.01 * amplitude), 0);
    for (const json& motion : two["motions"]) {
        CHECK(motion["amplitude"].get<double>() == Approx(1.01 * amplitude));
        CHECK(motion["contacts"][0]["impulse"].get<double>() > 0.0);
    }
    const json none =
        program.find(bars + fmt::format("--amplitude {} --certificate c.json", 0.5 * amplitude), 1);
    CHECK(least["amplitude"] == least["motions"][0]["amplitude"]);
    CHECK(least["phase"] == least["motions"][0]["phase"]);
    CHECK(none["certificate"]["kind"] == "amplitude-range");
    CHECK(json::parse(contentOf(program.file("c.json"))) == none);
}

TEST_CASE("cli scenes: bars that nothing holds rest, fly and bounce; energies are in joules")
{
    const CommandLine program;
    const json rest = program.find("--scene '4 stop=1e-3' 8 24", 0);
    CHECK(rest["contact"] == "grazing");
    CHECK(rest["energy"] == 0.0);
    CHECK(rest["energy_ratio"].is_null());
    CHECK_THAT(program.run("find --scene '4 stop=1e-3' 8 24").out,
               containsText("the pushes on a bar that nothing else holds balance"));
    const json flight = program.find("--scene 'stop=-1e-3 3 stop=1e-3' 2:6 -:9 1:6 -:9", 0);
    CHECK(flight["contact"] == "pressing");
    CHECK(flight["certificate"]["energy"].get<double>() ==
          Approx(flight["energy"].get<double>()).epsilon(1e-7));
    // Dropped from 5 it hits undeformed with 10 (Doyen, Ern and Piperno); uniformly it is as fast.
    const std::string ground =
        "--scene '10 stop=0' --length 10 --wave-speed 30 --axial-stiffness 900 --gravity 10 ";
    const json bounce = program.find(ground + "20 60", 0);
    CHECK(bounce["energy"].get<double>() == Approx(0.5 * 10.0 * 100.0));
    CHECK(bounce["period"].get<double>() == Approx(8.0 / 3.0));
    CHECK(program.find(ground + "20 61", 1)["certificate"]["energy"].get<double>() > 1e9);
}

TEST_CASE(
    "cli find of several bars: strains, stress and speeds of a bar are those of its own answer")
{
    const CommandLine program;
    const auto answered = [&program](const std::string& words) {
        return json::parse(program.run(words + " --format json").out);
    };
    const std::string steel = " --young 210e9 --density 7800 --area 1e-4";
    const json bar = answered("find 3 25 --cells 8" + steel)["physical"];
    const json words = answered("find 1:3 -:25 --scene 'clamp 8 stop=1e-3'" + steel);
    for (const char* key : {"peak_compression", "peak_tension", "peak_stress"}) {
        CHECK(words["strains"][key].get<double>() == Approx(bar[key].get<double>()).epsilon(1e-9));
    }
    CHECK(words["contacts"][0]["approach_speed"].get<double>() ==
          Approx(bar["approach_speed"].get<double>()).epsilon(1e-9));
    // Two bars have that of the one whose mirror image they are.
    const std::string two = "find 3 25 --scene 'clamp 8 gap=2e-3 8 clamp' --length 2" + steel;
    const json mirror = answered(two);
    CHECK(mirror["strains"]["peak_stress"].get<double>() ==
          Approx(bar["peak_stress"].get<double>()).epsilon(1e-9));
    const double stress = mirror["strains"]["peak_stress"];
    CHECK_THAT(program.run(two + fmt::format(" --yield-stress {}", 0.99 * stress)).err,
               containsText("beyond --yield-stress"));
    CHECK(program.run(two + fmt::format(" --yield-stress {}", 1.01 * stress)).err.empty());
    const std::string forced =
        "find 1:6 -:42 --scene 'clamp 6 dash=0.2 driven gap=1e-3 dash=0.3 6 clamp' --force tip";
    CHECK_THAT(program.run(forced + steel + " --yield-stress 1").err,
               containsText("beyond --yield-stress"));
    CHECK_THAT(program
                   .run("find --period 1.75 --scene 'clamp 4 gap=2e-3 4 clamp'" + steel +
                        " --yield-stress 1")
                   .err,
               containsText("beyond --yield-stress"));
    // Whose modulus is not known, or not one.
    for (const std::string& wrong :
         {forced + " --yield-stress 1",
          "find 3 14 --scene 'clamp 4 gap=2e-3 4:1:2 clamp' --yield-stress 1" + steel}) {
        const auto outcome = program.run(wrong);
        INFO(wrong << "\n" << outcome.err);
        CHECK(outcome.status == 2);
        CHECK(lines(outcome.err) == 1);
    }
}

TEST_CASE("cli scenes: a bar is the same question by its words and by its options")
{
    const CommandLine program;
    const auto same = [&](const std::string& words, const std::string& scene,
                          const std::string& options) {
        INFO(words);
        const auto given = program.run(words + " --scene '" + scene + "'");
        const auto plain = program.run(words + " " + options);
        CHECK(given.status == plain.status);
        CHECK(plain.status <= 1);
        CHECK(given.out == plain.out);
    };
    const std::string bar = "clamp shaken 8 free driven stop=1e-3";
    same("find 3 25 --energy-ratio 20", bar, "--cells 8");
    same("find --frequency 8/7 --energy-ratio 20", "clamp 12 stop=2e-3", "--cells 12 --gap 2e-3");
    same("find 2 12 --damping 0.05 --force tip", "clamp 4 4 stop=right:-1e-3",
         "--cells 8 --gap -1e-3");
    same("find 6 28 --damping 0.05 --force base", "clamp 4 dash=0.1 4:1.3 stop=1e-3 stop=-2e-3",
         "--segments 4:1:1:0.1,4:1.3 --second-stop 2e-3");
    same("continuum 3 25 --energy-ratio 20 --points 5", bar, "--cells 8");
    same("families --max-order 4", bar, "--cells 8");
    same("modes --max-order 3", bar, "");
    same("mode 4 -1 --period 7/2", bar, "--cells 8");
    same("response --damping 0.05 --force tip --amplitude 1e-3", "clamp 4 4:1.3 stop=1e-3",
         "--segments 4:1,4:1.3");
    same("sweep --damping 0.05 --force tip --amplitude 1e-3 --from 0.9 --to 1.1 --points 3", bar,
         "--cells 8");
    const auto refuses = [&](const std::string& words) {
        const auto outcome = program.run(words);
        INFO(words << "\n" << outcome.err);
        CHECK(outcome.status == 2);
        CHECK_THAT(outcome.err, containsText("one bar, clamped on the left"));
        CHECK(lines(outcome.err) == 1);
    };
    for (const char* scene :
         {"clamp 4 gap=1e-3 4 clamp", "clamp 4 stop=1e-3 4 clamp", "spring=4 8 stop=1e-3",
          "stop=-1e-3 8 stop=1e-3", "clamp 8:2 stop=1e-3", "clamp 8 dash=0.1 stop=1e-3",
          "clamp 4 driven 4 stop=1e-3"}) {
        refuses(fmt::format("families --max-order 4 --scene '{}'", scene));
    }
    CHECK_THAT(program.run("modes --scene 'clamp 8 stop=1e-3' --gap 2e-3").err,
               containsText("--scene clashes with"));
}

TEST_CASE("cli simulate: the base of a scene moves as that of options, whatever its phase")
{
    const CommandLine program;
    const std::string shaken = "--force base --amplitude 7e-4 --hertz 0.2 --phase ";
    const auto ofBar = [](const std::string& stops) {
        return "simulate --rest --cells 12 --damping 0.06387546623297946 " + stops + " ";
    };
    const auto ofScene = [](const std::string& stops) {
        return "simulate --scene 'clamp shaken 12 dash=0.1 " + stops + "' ";
    };
    for (const double phase : {0.0, 1.0, 2.0, 3.5}) {
        for (const auto& [words, options] :
             {std::pair{"stop=1e-3", "--gap 1e-3"},
              {"stop=1e-3 stop=-3e-4", "--gap 1e-3 --second-stop 3e-4"},  // presses at times
              {"stop=2e-4", "--gap 2e-4"}}) {
            const std::string rest = shaken + fmt::format("{} --time 40 --format json", phase);
            const json scene = json::parse(program.run(ofScene(words) + rest).out);
            const json bar = json::parse(program.run(ofBar(options) + rest).out);
            INFO(words << " " << phase);
            double impulse = 0.0;
            for (const json& contact : scene["contacts"]) {
                impulse += contact["impulse"].get<double>();
            }
            CHECK(impulse == Approx(bar["impulse"].get<double>()));
            CHECK(scene["energy"].get<double>() == Approx(bar["energy"].get<double>()));
        }
    }
    // From a state whose base stands elsewhere it is led to its motion: what is left is that.
    const std::string scene =
        " --scene 'clamp shaken 12 dash=0.4 stop=1e-3' --force base "
        "--amplitude 7e-4 --hertz 0.25 ";
    REQUIRE(program.run("simulate --time 3 --phase 0 --state s.csv" + scene).status == 0);
    const auto settled = [&](const std::string& call) {
        const json answer =
            json::parse(program.run("simulate --periods 100 --format json " + call + scene).out);
        INFO(call);
        REQUIRE(!answer["settled"].is_null());
        return answer["settled"]["impulse"].get<double>();
    };
    CHECK(settled("--from s.csv --phase 2") == Approx(settled("--phase 2")).epsilon(1e-5));
}

TEST_CASE("cli find --objective max-energy: of bars within a limit on strain", "[glpk]")
{
    const CommandLine program;
    const auto energy = [&program](const std::string& call, double limit) {
        const auto outcome = program.run(fmt::format(
            "find {} --strain-limit {} --objective max-energy --format json", call, limit));
        INFO(call << " " << limit << outcome.out << outcome.err);
        REQUIRE(outcome.status == 0);
        return json::parse(outcome.out)["energy"].get<double>();
    };
    // The most that a linear program of waves found, climbing by itself [J].
    for (const auto& [call, limit, most] :
         {std::tuple{"1:3 -:21 --scene 'clamp 3 stop=1e-3 3:1.3 clamp'", 0.01, 2.3495e-4},
          {"1:1 -:29 --scene '3 gap=1e-3 2:0.5 clamp'", 0.005, 6.0e-6},
          {"1:1 -:39 --scene '4 gap=1e-3 4:1.3 clamp'", 0.005, 5.36e-6},
          {"1:9 -:47 --scene '4 gap=1e-3 4:2 clamp'", 0.01, 0.0}}) {
        const double found = energy(call, limit);
        CHECK(found >= 0.999 * most);
        CHECK(found <= 1.001 * most);
        // A wider limit keeps these motions.
        for (const double wider : {2.0, 6.0, 100.0}) {
            CHECK(energy(call, wider * limit) >= 0.999 * found);
        }
    }
}

TEST_CASE("cli: a round bar is given by its diameter")
{
    const CommandLine program;
    const std::string steel = "find 3 25 --cells 8 --young 210GPa --density 7850 ";
    const auto round = program.run(steel + "--diameter 20mm");
    CHECK(round.status == 0);
    CHECK(round.out == program.run(steel + "--area 3.141592653589793e-4").out);
    const auto both = program.run(steel + "--diameter 20mm --area 1cm2");
    CHECK(both.status == 2);
    CHECK_THAT(both.err, containsText("--area clashes with --diameter"));
}

TEST_CASE("cli: where there is no motion the nearest schedule with some is named")
{
    const CommandLine program;
    const json none = program.find("20 109 --cells 40", 1);
    const std::string near = fmt::format("{} {}", none["near_schedule"][0][0].get<int>(),
                                         none["near_schedule"][0][1].get<int>());
    CHECK(near != "20 109");
    CHECK(program.find(near + " --cells 40", 0)["contact"] == "pressing");
    CHECK_THAT(program.run("find 20 109 --cells 40").out, containsText("\nnear        N = 40, ("));
    // It has motions, but not of this energy; several segments and contacts are not asked about.
    CHECK_FALSE(program.find("150 900 --energy-ratio 2", 1).contains("near_schedule"));
    CHECK_FALSE(program.find("12 8 --segments 5:1,5:1.5", 1).contains("near_schedule"));
}

TEST_CASE("cli: the route, and what it left out, are said if asked for")
{
    const CommandLine program;
    const std::string plain = program.run("find 3 25 --cells 8").out;
    const std::string verbose = program.run("find 3 25 --cells 8 --verbose").out;
    CHECK(plain.find("\nroute ") == std::string::npos);
    CHECK(verbose.starts_with(plain));
    CHECK_THAT(verbose, containsText("\nroute       closed-form") && containsText("\nleft out "));
}

TEST_CASE("cli scenes: a stepped bar from a drawing")
{
    const CommandLine program;
    const auto write = [&](const std::string& text) {
        std::ofstream(program.file("rod.csv")) << text;
    };
    const std::string files = " --segments-file rod.csv --cells 20 ";
    write("length,young,density,diameter\n1.2,210e9,7850,0.02\n0.8,210e9,7850,0.03\n");
    const json r = program.find("12 68" + files + "--gap 1e-4", 0);
    CHECK(r["cells"] == 20);
    CHECK(r["bar"]["length"].get<double>() == Approx(2.0));
    CHECK(r["bar"]["axial_stiffness"].get<double>() == Approx(210e9 * 1e-4 * std::acos(-1.0)));
    REQUIRE(r["segments"].size() == 2);
    CHECK(r["segments"][0]["cells"] == 12);
    CHECK(r["segments"][1]["impedance"].get<double>() == Approx(2.25));
    CHECK(r["bar"]["young"] == 210e9);
    // The same with units, and the same bar in relative numbers.
    write("length,young,density,diameter\n1.2 m,210GPa,7850,20mm\n80cm,210e9,7.85g/cm3,0.03\n");
    CHECK(program.find("12 68" + files + "--gap 1e-4", 0)["energy"] == r["energy"]);
    const json plain = program.find(
        "12 68 --segments 12:1,8:2.25 --gap 1e-4 --length 2 --young 210e9 --density 7850 "
        "--area 3.141592653589793e-4",
        0);
    CHECK(r["energy"].get<double>() == Approx(plain["energy"].get<double>()));
    CHECK_THAT(program.run("find 12 68" + files).out,
               containsText("pieces      on 20 cells; lengths are rounded by at most "));
    const auto refuses = [&](const std::string& words, const std::string& part) {
        const auto outcome = program.run("find 12 68" + files + words);
        INFO(words << "\n" << outcome.err);
        CHECK(outcome.status == 2);
        CHECK_THAT(outcome.err, containsText(part));
        CHECK(lines(outcome.err) == 1);
    };
    refuses("--young 3 --density 1 --area 1", "--segments-file clashes with");
    refuses("--segments 4:1,4:2", "--segments-file clashes with");
    write("length,young,density\n1,2,3\n");
    refuses("", "area and diameter: allowed one of them");
    write("length,young,density,area\n1,2,3,4\n1,-2,3,4\n");
    refuses("", "line 3: column young (field 2): '-2': allowed numbers > 0 [Pa]");
    write("length,young,density,area\n");
    refuses("", "pieces = 0");
}

TEST_CASE("cli find --period of several bars: each schedule is decided as by itself")
{
    const CommandLine program;
    const auto parsed = [&program](const std::string& words) {
        const auto outcome = program.run(words + " --format json");
        INFO(words << outcome.err);
        REQUIRE(outcome.status <= 1);
        return json::parse(outcome.out);
    };
    // Two bars that meet are the paper's bar and its mirror image.
    const json bars = parsed("find --period 1.75 --scene 'clamp 4 gap=2e-3 4 clamp'");
    REQUIRE(bars["steps"] == 14);
    REQUIRE(bars["sets"].size() == 13);
    std::size_t found = 0;
    for (const json& set : bars["sets"]) {
        const auto steps = set["steps"].get<int>();
        const std::string asked = fmt::format("find {} {} --cells 4", steps, 14 - steps);
        const json one = parsed(asked);
        INFO(asked);
        CHECK(set["contact"] == 1);
        CHECK(set["status"] == one["status"]);
        if (set["status"] == "found") {
            const json& motion = bars["motions"][found++];
            CHECK(motion["schedule"][0]["steps"] == steps);
            CHECK(motion["energy_ratio"].get<double>() ==
                  Approx(one["energy_ratio"].get<double>()).epsilon(1e-9));
        }
    }
    CHECK(found == bars["motions"].size());
    CHECK(found > 0);
    const json stepped = parsed("find --period 7/2 --segments 3:1,3:2");
    REQUIRE(stepped["sets"].size() == 20);
    for (const int k : {1, 2, 5, 6, 7, 11, 19}) {
        const json one = parsed(fmt::format("find {} {} --segments 3:1,3:2", k, 21 - k));
        INFO(k);
        CHECK(stepped["sets"][static_cast<std::size_t>(k) - 1]["status"] == one["status"]);
    }
    // Each motion is perturbed as that of its schedule is.
    const std::string meeting = " --scene 'clamp 4 gap=2e-3 4 clamp'";
    const json tried = parsed("find --period 1.75 --stability" + meeting);
    const json& one = tried["motions"].front();
    const json alone =
        parsed(fmt::format("find {} {} --stability", one["schedule"][0]["steps"].get<int>(),
                           one["schedule"][1]["steps"].get<int>()) +
               meeting);
    CHECK(one["stability"] == alone["stability"]);
    const auto written =
        program.run("find --period 1.75 --scene 'clamp 4 gap=2e-3 4 clamp' --state s.csv --quiet");
    CHECK(written.status == 0);
    CHECK_THAT(written.out, containsText("proved to have none"));
    CHECK(program.files() == 1);
    for (const auto& [words, part] : {std::pair{"--certificate c.json", "--certificate clashes"},
                                      {"--tip-floor -1", "--tip-floor"},
                                      {"3 11", "NC NF clash"}}) {
        const auto outcome =
            program.run("find --period 7/2 --segments 3:1,3:2 " + std::string(words));
        INFO(words << outcome.err);
        CHECK(outcome.status == 2);
        CHECK_THAT(outcome.err, containsText(part));
    }
}
