// The program as people and scripts meet it: exit status, stdout, stderr, files.

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "command_line.hpp"
#include "solver.hpp"

using namespace signorini::test;

TEST_CASE("cli: the paper's case in JSON, every field of the contract")
{
    const CommandLine program;
    const json r = program.find("150 900", 0);
    CHECK(r["schema"] == 2);
    CHECK(r["version"].is_string());
    CHECK(r["bar"]["gap"] == 1e-3);
    CHECK(r["status"] == "found");
    CHECK(r["cells"] == 300);
    CHECK(r["schedule"] == json({{150, 900}}));
    CHECK(r["period"] == 3.5);
    CHECK(r["frequency_ratio"] == 8.0 / 7.0);
    CHECK(r["kernel_dimension"] == 150);
    CHECK(r["solution_set"] == json({{"kind", "simplex"}, {"dimension", 149}}));
    CHECK(r["contact"] == "pressing");
    CHECK(r["canonical_schedule"] == json({{150, 900}}));
    CHECK(r["approach_speeds"] == json::array({r["physical"]["approach_speed"]}));
    CHECK(r["energy"] == 2e-6);
    CHECK(r["energy_ratio"] == 4.0);
    CHECK(r["energy_ratio_range"] == json({4.0, 600.0}));
    for (const char* name : {"periodicity", "gap", "pressure", "penetration", "march"}) {
        CHECK(r["residuals"][name] == 0.0);
    }
    CHECK(r["reason"].is_null());
    CHECK(r["certificate"].is_null());
    CHECK(r["route"] == "closed-form");
    CHECK(r["left_out"].is_array());
    CHECK(r["solver"]["name"] == "closed-form");
    CHECK(r["solver"]["iterations"] == 0);
    CHECK(r["solver"]["seconds"].get<double>() >= 0.0);
}

TEST_CASE("cli: absence is exit status 1 with reason and verified certificate")
{
    const CommandLine program;
    const json r = program.find("2 4 --cells 2", 1);
    CHECK(r["status"] == "none");
    CHECK(r["reason"] == "gap");
    CHECK(r["solution_set"]["kind"] == "empty");
    CHECK(r["certificate"]["kind"] == "farkas");
    CHECK(r["certificate"]["verified"] == true);
    CHECK(r["energy"].is_null());
    CHECK(r["residuals"].is_null());
    CHECK(program.find("20 109 --cells 40", 1)["reason"] == "no-live-class");
}

TEST_CASE("cli: several phases in JSON, decided without a solver library")
{
    const CommandLine program;
    const json two = program.find("1 12 3 12 --cells 4", 0);
    CHECK(two["solution_set"] == json{{"kind", "simplex"}, {"dimension", 2}});
    CHECK(two["energy_ratio"].get<double>() == Approx(16.0 / 3.0));
    CHECK(two["energy_ratio_range"][1] == 8.0);
    CHECK(two["pressing_phases"] == json{true, true});
    CHECK(two["canonical_schedule"] == two["schedule"]);
    REQUIRE(two["approach_speeds"].size() == 2);
    CHECK(std::max(two["approach_speeds"][0], two["approach_speeds"][1]) ==
          two["physical"]["approach_speed"]);
    CHECK(two["route"] == "lumped");
    CHECK(two["solver"]["name"] == "closed-form");
    const json twice = program.find("1 9 1 9 --cells 3", 0);
    CHECK(twice["canonical_schedule"] == json::array({{1, 9}}));
    CHECK(twice["repetitions"] == 2);
    CHECK(twice["approach_speeds"].size() == 1);
    const json touching = program.find("2 3 1 29 --cells 10", 0);
    CHECK(touching["pressing_phases"] == json{true, false});
    const json none = program.find("1 1 1 1 --cells 4", 1);
    CHECK(none["certificate"]["verified"] == true);
    CHECK(none["solution_set"]["kind"] == "empty");
    CHECK_THAT(program.run("find 1 9 1 9 --cells 3").out, containsText("2 times over"));
    CHECK_THAT(program.run("find 2 3 1 29 --cells 10").out, containsText("without force: 2"));
}

TEST_CASE("cli: undecided is exit status 3 and says why", "[glpk]")
{
    const CommandLine program;
    const json r = program.find(
        "1500 12000 --cells 3000 --solver glpk-simplex --formulation state --time-limit 0.001", 3);
    CHECK(r["status"] == "undecided");
    CHECK_THAT(r["detail"].get<std::string>(), containsText("limit"));
}

TEST_CASE("cli: text is for people and goes to stdout, nothing to stderr")
{
    const CommandLine program;
    const auto found = program.run("find 150 900");
    CHECK(found.status == 0);
    CHECK(found.err.empty());
    for (const char* text : {"found", "N = 300", "simplex of dimension 149", "4 E₁", "residuals"}) {
        CHECK_THAT(found.out, containsText(text));
    }
    const auto none = program.run("find 2 4 --cells 2");
    CHECK(none.status == 1);
    CHECK_THAT(none.out, containsText("reason") && containsText("Farkas"));
}

TEST_CASE("cli: wrong use is exit status 2, one line naming argument, value and range, no file")
{
    struct Wrong {
        const char* arguments;
        const char* named;
    };
    const auto wrong = GENERATE(values<Wrong>({
        {"0 5", "NC (phase 1) = 0"},
        {"5 0", "NF (phase 1) = 0"},
        {"-5 3", "-5"},
        {"1.5 2", "1.5"},
        {"1e3 2", "1e3"},
        {"nan 2", "nan"},
        {"-inf 2", "-inf"},
        {"x 2", "= x"},
        {"'' 2", "''"},
        {"3", "even number"},
        {"3 4 5", "even number"},
        {"", "NC NF is missing"},
        {"99999999999999999999 3", "99999999999999999999"},
        {"4611686018427387904 4611686018427387904", "sum of all steps"},
        {"3 9 --cells 0", "--cells = 0"},
        {"3 9 --cells 100000001", "100000000"},
        {"3 9 --cells 3.5", "--cells = 3.5"},
        {"3 9 --gap nan", "--gap = nan"},
        {"3 9 --gap inf", "--gap = inf"},
        {"3 9 --gap 0", "--energy is missing: allowed"},
        {"3 9 --gap 1e-200", "gap"},
        {"3 9 --length 0", "--length = 0"},
        {"3 9 --wave-speed -2", "--wave-speed = -2"},
        {"3 9 --axial-stiffness x", "--axial-stiffness = x"},
        {"3 9 --young 1", "all three"},
        {"3 9 --young 1 --density 1 --area 1 --wave-speed 3", "clash"},
        {"3 9 --young 1 --density 0 --area 1", "--density = 0"},
        {"3 9 --format xml", "--format = xml"},
        {"3 9 --threads 0", "--threads = 0"},
        {"3 9 --solver oracle", "oracle"},
        {"3 9 --formulation dense", "--formulation = dense"},
        {"3 9 --objective best", "--objective = best"},
        {"3 9 --tolerance 0", "--tolerance = 0"},
        {"3 9 --tolerance 1", "tolerance = 1"},
        {"3 9 --time-limit -1", "--time-limit = -1"},
        {"3 9 --solver closed-form --formulation state", "formulation = state"},
        {"3 9 --frobnicate", "--frobnicate"},
        {"3 9 --gap", "--gap"},
        {"3 9 --gap 1 --gap 2", "--gap"},
        {"3 9 --cells ''", "--cells"},
        {"3 9 --state ''", "--state"},
        {"3 9 --energy-ratio 0", "--energy-ratio = 0"},
        {"3 9 --energy-ratio nan", "--energy-ratio = nan"},
        {"3 9 --strain-limit -1", "--strain-limit = -1"},
        {"3 9 --tip-floor x", "--tip-floor = x"},
        {"3 9 --tip-floor 0.001", "--tip-floor = 0.001"},
        {"3 9 --objective nearest", "--target"},
        {"3 9 --target s.csv", "--objective"},
        {"3 9 --objective min-energy --energy-ratio 9", "objective = min-energy"},
        {"3 9 --axial-stiffness 1e308 --gap 1", "axialStiffness"},
        {"3 9 --figure a.gif", "a.gif"},
        {"3 9 --motion a.txt", "a.txt"},
        {"3 9 --state a.csv --motion a.csv", "a.csv"},
        {"3 9 --state a.csv --motion ./a.csv", "a.csv"},
        {"150 900 --state a.csv --gap nan", "--gap"},
    }));
    const CommandLine program;
    const auto outcome = program.run(std::string("find ") + wrong.arguments);
    INFO(wrong.arguments << " -> " << outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(lines(outcome.err) == 1);
    CHECK_THAT(outcome.err, containsText(wrong.named));
    CHECK(program.files() == 0);
}

TEST_CASE("cli: a solver that cannot do what is asked is refused, one that is missing named")
{
    const CommandLine program;
    const auto outcome = program.run("find 3 9 --solver glpk-simplex --objective min-energy");
    if (signorini::findBackend("glpk-simplex").available()) {
        CHECK(outcome.status == 2);
        CHECK_THAT(outcome.err, containsText("quadratic"));
    } else {
        CHECK(outcome.status == 4);
        CHECK_THAT(outcome.err, containsText("SIGNORINI_WITH_GLPK"));
    }
    CHECK(lines(outcome.err) == 1);
}

TEST_CASE("cli: unknown and missing commands are wrong use")
{
    const CommandLine program;
    CHECK(program.run("").status == 2);
    CHECK(program.run("fly").status == 2);
    CHECK_THAT(program.run("fly").err, containsText("fly"));
    CHECK(lines(program.run("fly").err) == 1);
}

TEST_CASE("cli: help and version succeed; the version lists every back end")
{
    const CommandLine program;
    CHECK(program.run("--help").status == 0);
    CHECK_THAT(program.run("find --help").out, containsText("--figure"));
    // Whatever else is wrong, and each option once.
    const auto help = program.run("find --help --length 0");
    CHECK(help.status == 0);
    std::set<std::string> names;
    std::istringstream shown(help.out);
    for (std::string line; std::getline(shown, line);) {
        if (line.starts_with("  --")) {
            INFO(line);
            CHECK(names.insert(line.substr(2, line.find(' ', 2) - 2)).second);
        }
    }
    CHECK(names.contains("--version"));
    const auto version = program.run("--version");
    CHECK(version.status == 0);
    CHECK(program.run("find 3 18 --version").out == version.out);
    for (const signorini::Backend& backend : signorini::backends()) {
        CHECK_THAT(version.out, containsText(std::string(backend.name)));
    }
}

TEST_CASE("cli: the motion that is meant without --objective has a name")
{
    const CommandLine program;
    const std::string words = "150 900 --energy-ratio 20";
    CHECK(program.find(words + " --objective auto", 0)["objective"] ==
          program.find(words, 0)["objective"]);
}

TEST_CASE("cli: the nearest motion to a state file is found, wrong files are refused")
{
    const CommandLine program;
    REQUIRE(program.run("find 5 23 --cells 8 --objective max-energy --state target.csv").status ==
            0);
    const json r = program.find("5 23 --cells 8 --objective nearest --target target.csv", 0);
    CHECK(r["energy_ratio"].get<double>() == Approx(16.0).epsilon(1e-12));
    CHECK(r["distance"].get<double>() < 1e-12);
    CHECK(r["target"] == "waves a, b in 8 rows, one per cell");
    // Measured on another grid: twice the places, midway in halves of cells.
    std::ofstream table(program.file("measured.csv"));
    table << "# strain gauges\nx;velocity;strain\n";
    for (const json& row : rowsOf(contentOf(program.file("target.csv")))) {
        for (const double off : {0.75, 0.25}) {
            table << row[0].get<double>() - off / 8.0 << ";" << row[3] << ";" << row[4] << "\n";
        }
    }
    table.close();
    const json near = program.find("5 23 --cells 8 --objective nearest --target measured.csv", 0);
    CHECK(near["target"] == "velocity and strain in 16 rows, averaged onto 8 cells");
    CHECK(near["distance"].get<double>() > 0.01);
    CHECK(near["distance"].get<double>() < 0.5);
    const auto words = program.run("find 5 23 --cells 8 --objective nearest --target measured.csv");
    CHECK_THAT(words.out, containsText("distance    0.") && containsText("averaged onto 8 cells"));
    const auto refused = [&](const char* name, const std::string& text, int status,
                             const char* named) {
        std::ofstream(program.file(name)) << text;
        const auto outcome = program.run(std::string("find 5 23 --cells 8 --objective nearest ") +
                                         "--target " + name);
        INFO(name << " -> " << outcome.err);
        CHECK(outcome.status == status);
        CHECK(lines(outcome.err) == 1);
        CHECK_THAT(outcome.err, containsText(named));
    };
    refused("short.csv", "x,a,b\n1,2,3\n", 2, "cells of the target = 1");
    refused("nan.csv", "x,a,b\n1,nan,3\n", 2, "line 2");
    refused("word.csv", "x,a,b\n1,2,b\n", 2, "line 2");
    refused("header.csv", "x,y\n1,2\n", 2, "no column a");
    refused("empty.csv", "", 2, "no column a");
    const auto missing = program.run("find 5 23 --cells 8 --objective nearest --target no.csv");
    CHECK(missing.status == 4);
}

TEST_CASE("cli: further demands: energy, strain, tip, and what cannot be")
{
    const CommandLine program;
    const json energy = program.find("150 900 --energy-ratio 20", 0);
    CHECK(energy["energy_ratio"].get<double>() == Approx(20.0).epsilon(1e-12));
    const json outside = program.find("150 900 --energy-ratio 3.9", 1);
    CHECK(outside["reason"] == "constraints");
    CHECK(outside["certificate"] == json{{"kind", "energy-range"}, {"verified", true}});
    // Beyond the most of several phases: the exclusion is checked in rationals.
    const json above = program.find("1 7 1 7 --cells 2 --energy-ratio 13", 1);
    CHECK(above["certificate"]["verified"] == true);
    CHECK(program.find("150 900 --strain-limit 0.0021", 0)["peak_strain"].get<double>() ==
          Approx(0.002));
    const json tight = program.find("150 900 --strain-limit 0.0019", 1);
    CHECK(tight["reason"] == "constraints");
    CHECK(tight["certificate"]["verified"] == true);
    CHECK(tight["route"] == "closed-form");
    if (signorini::findBackend("glpk-simplex").available()) {
        CHECK(program.find("150 900 --tip-floor -0.0019", 1)["reason"] == "constraints");
    }
    CHECK(program.find("150 900 --tip-floor -0.0021", 0)["status"] == "found");
}

TEST_CASE("cli: a missing gnuplot is exit status 4, named, and leaves no file")
{
    const CommandLine program;
    const auto outcome =
        program.run("find 5 23 --cells 8 --state s.csv --figure f.svg", "PATH=/nowhere");
    CHECK(outcome.status == 4);
    CHECK_THAT(outcome.err, containsText("gnuplot"));
    CHECK(program.files() == 0);
}

TEST_CASE("cli: steel in SI units gives the same energy ratio")
{
    const CommandLine program;
    const json r = program.find("150 900 --young 210e9 --density 7800 --area 1e-4 --gap 1e-6", 0);
    CHECK(r["energy_ratio"].get<double>() == Approx(4.0).epsilon(1e-12));
    CHECK(r["period"].get<double>() == Approx(3.5 / 5188.7449).epsilon(1e-6));
}

TEST_CASE("cli: a certificate that is called verified is printed whole, however long")
{
    const json r = CommandLine().find("1 400001 --cells 200000", 1);
    CHECK(r["certificate"]["verified"] == true);
    for (const char* rows : {"periodicity", "pressure", "penetration"}) {
        CHECK(r["certificate"][rows].is_array());
    }
    CHECK(r["certificate"]["periodicity"].size() > 100'000);
    CHECK(r["solution_set"] == json{{"kind", "empty"}, {"dimension", nullptr}});
}
