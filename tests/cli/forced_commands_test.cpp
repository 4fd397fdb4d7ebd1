// signorini response and signorini simulate: fields, units, files, wrong use.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <sstream>

#include "command_line.hpp"
#include "signorini/simulation.hpp"

using namespace signorini;
using namespace signorini::test;

namespace {

/// rho = 0.9, a force of 0.25 EA g/L on the tip, on 30 cells: the bar of theory.md, section 15.
const std::string section15 =
    " --cells 30 --damping 0.03353713 --force tip --amplitude 2.5e-4 --quiet";

json parsed(const CommandLine& program, const std::string& arguments, int status = 0)
{
    const auto outcome = program.run(arguments + " --format json");
    INFO(arguments << "\n" << outcome.err);
    REQUIRE(outcome.status == status);
    return json::parse(outcome.out);
}

}  // namespace

TEST_CASE("cli response: every field of the contract, and the numbers of section 15")
{
    const CommandLine program;
    const json answer =
        parsed(program, "response --from 1.1 --to 1.16 --stability --csv r.csv" + section15);
    CHECK(answer["schema"] == 2);
    CHECK(answer["status"] == "found");
    CHECK(answer["cells"] == 30);
    CHECK(answer["bar"]["gap"] == 1e-3);
    CHECK(answer["damping"]["ratio"] == 0.03353713);
    CHECK(answer["damping"]["dashpot"].get<double>() == Approx(1.0 / 19.0).epsilon(1e-5));
    CHECK(answer["force"] == "tip");
    CHECK(answer["amplitude"] == 2.5e-4);
    CHECK(answer["complete"] == true);
    REQUIRE(answer["frequencies"].size() == 6);  // n = 104 ... 109
    int rows = 1;
    for (const json& frequency : answer["frequencies"]) {
        CHECK(frequency["frequency_ratio"].get<double>() ==
              Approx(120.0 / frequency["steps"].get<double>()));
        CHECK(frequency["frequency"].get<double>() ==
              Approx(30.0 / frequency["steps"].get<double>()));
        CHECK(frequency["touches"] == false);
        REQUIRE(frequency["motions"].size() == 2);
        CHECK(frequency["motions"][0]["stable"] == false);
        CHECK(frequency["motions"][1]["stable"] == true);
        rows += 2;
    }
    const json& motions = answer["frequencies"][4]["motions"];  // n = 108
    CHECK(motions[0]["schedule"] == json::parse("[[8,100]]"));
    CHECK(motions[1]["schedule"] == json::parse("[[12,96]]"));
    CHECK(motions[0]["impulse"].get<double>() == Approx(0.1907e-3).margin(1e-7));
    CHECK(motions[1]["impulse"].get<double>() == Approx(1.0710e-3).margin(1e-7));
    CHECK(motions[1]["peak_force"].get<double>() > 0.0);
    CHECK(motions[1]["phase"].is_number());
    CHECK(lines(contentOf(program.file("r.csv"))) == rows);
}

TEST_CASE("cli response: a bar pressed at rest stays in contact, which is said once a frequency")
{
    const CommandLine program;
    const std::string range =
        "response --cells 20 --gap -1 --damping 0.02 --force tip --amplitude 0.3 --from 0.9 --to "
        "1.2 --csv r.csv --quiet";
    const json answer = parsed(program, range);
    CHECK(answer["complete"] == true);
    REQUIRE(answer["frequencies"].size() == 22);  // n = 67 ... 88
    for (const json& frequency : answer["frequencies"]) {
        CHECK(frequency["motions"].empty());
        CHECK(frequency["reason"].is_null());
        const json& held = frequency["permanent_contact"];
        CHECK(held["least_force"].get<double>() == Approx(0.7));
        // The static force for the whole period.
        CHECK(held["impulse"].get<double>() ==
              Approx(frequency["steps"].get<double>() / 20.0 * 1.0));
        CHECK(held["physical"]["tip_lowest"] == -1.0);
        CHECK(held["physical"]["contact_time"].get<double>() ==
              Approx(frequency["steps"].get<double>() / 20.0));
    }
    const std::string table = contentOf(program.file("r.csv"));
    CHECK(lines(table) == 23);
    CHECK(table.find("\n67,") != std::string::npos);
    CHECK(table.find(",67,0,0,") != std::string::npos);  // contact of all steps, no flight
    const auto text = program.run(range);
    CHECK(text.out.find("permanent   contact, 0.7 to 1.29") != std::string::npos);
    // A force on a tip that is held strains nothing: what it is pressed by at rest does, g/L.
    CHECK_THAT(text.out, containsText("strain      at most 1 [-]") &&
                             containsText("in contact that never opens"));
    const std::string steel = " --young 4 --density 4 --area 0.25 --yield-stress ";
    CHECK_THAT(program.run(range + steel + "3").out,
               containsText("133 % of the yield stress, the bar yields"));
    CHECK_THAT(program.run(range + steel + "5").out, containsText("80 % of the yield stress, no"));
    // A force that lifts the tip leaves none.
    const json lifted = parsed(program,
                               "response --cells 20 --gap -1 --damping 0.02 --force tip "
                               "--amplitude 1.2 --from 1 --to 1.05 --quiet");
    for (const json& frequency : lifted["frequencies"]) {
        CHECK(frequency["permanent_contact"].is_null());
    }
}

TEST_CASE("cli response: what was not decided is said, with its reason, and is no whole answer")
{
    const CommandLine program;
    const std::string range =
        "response --cells 5 --damping 0.1746 --force base --amplitude 8.18e-4 --from 2.45 --to "
        "2.55 --cycles 3 --second-stop 1e-3 --csv r.csv --quiet";
    const json answer = parsed(program, range, 3);
    CHECK(answer["status"] == "undecided");
    CHECK(answer["complete"] == false);
    bool isMarked = false;
    for (const json& frequency : answer["frequencies"]) {
        CHECK((frequency["undecided"] > 0) == frequency["reason"].is_string());
        isMarked = isMarked || frequency["undecided"] > 0;
    }
    CHECK(isMarked);
    CHECK(program.run(range).out.find("undecided   1 schedules: 0.6") != std::string::npos);
    CHECK(contentOf(program.file("r.csv")).find(",undecided,contact_time,") != std::string::npos);
    // Without any contact the linear response is the motion where it stays clear, and only there.
    const std::string quiet = " --cells 30 --damping 0.03353713 --force tip --quiet";
    CHECK(program.run("response --from 0.6 --to 0.61 --amplitude 1e-5" + quiet)
              .out.find("rattles     nowhere: the linear response stays clear") !=
          std::string::npos);
    CHECK(program.run("response --from 1.015 --to 1.02 --amplitude 2.5e-4" + quiet)
              .out.find("no motion   with one contact, though the linear response meets a stop") !=
          std::string::npos);
}

TEST_CASE(
    "cli response: an engineer reads where the machine rattles, how hard, and whether it yields",
    "[glpk]")
{
    const CommandLine program;
    const std::string rod =
        "response --length 3 --young 210e9 --density 7850 --area 1e-4 --gap 1e-4 --damping 0.05 "
        "--force base --amplitude 20e-6 --quiet";
    const auto outcome = program.run(rod + " --cells 60 --yield-stress 25e6 --csv r.csv");
    INFO(outcome.out << outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(lines(outcome.out) < 12);
    // Worst values are those of the table, which has them motion by motion.
    std::vector<double> band;
    double force = 0.0;
    double stress = 0.0;
    std::istringstream table(contentOf(program.file("r.csv")));
    std::string row;
    std::getline(table, row);
    CHECK(row.ends_with(
        ",contact_time,approach_speed,peak_compression,peak_tension,peak_stress,cells"));
    while (std::getline(table, row)) {
        const std::vector<std::string> cells = cellsOf(row);
        if (!cells[5].empty()) {
            band.push_back(std::stod(cells[2]));
            force = std::max(force, std::stod(cells[9]));
            stress = std::max(stress, std::stod(cells[21]));
        }
    }
    REQUIRE(band.size() == 86);
    CHECK_THAT(outcome.out, containsText(fmt::format("rattles     can: {:.6g} … {:.6g} Hz",
                                                     band.back(), band.front())));
    CHECK_THAT(outcome.out, containsText(fmt::format("force       at most {:.6g} N at ", force)));
    CHECK_THAT(outcome.out, containsText(fmt::format("stress      at most {:.6g} Pa at ", stress)));
    CHECK_THAT(outcome.out, containsText("121 % of the yield stress, the bar yields"));
    CHECK_THAT(program.run(rod + " --cells 10 --yield-stress 250e6").out, containsText("no yield"));
    const std::string json = rod + " --from 1 --to 1.1 --format json";
    for (const char* more : {" --cells 10", " --cells 10 --exact", " --exact --segments 5:1,5:2"}) {
        CHECK_THAT(program.run(json + more + " --yield-stress 25e6").out,
                   containsText("\"yield_stress\":25000000"));
        CHECK_THAT(program.run(json + more).out, !containsText("yield_stress"));
    }
    const auto bare = program.run(
        "response --damping 0.05 --force base --amplitude 2e-4 --cells 20 --yield-stress 1e6");
    CHECK(bare.status == 2);
    CHECK_THAT(bare.err, containsText("--yield-stress = 1e6"));
}

TEST_CASE("cli response: threads share the work, units are those of the bar")
{
    const CommandLine program;
    const std::string range = "response --from 0.9 --to 1.2 --cells 20 --damping 0.05 --quiet";
    const json base = parsed(program, range + " --force base --amplitude 3e-4");
    CHECK(base["frequencies"] ==
          parsed(program, range + " --force base --amplitude 3e-4 --threads 3")["frequencies"]);
    // EA = 2e7 N, g/L = 5e-7, L/c = 4e-4 s: forces in 10 N, impulses in 4e-3 N s.
    const std::string steel = " --length 2 --young 2e11 --density 8000 --area 1e-4 --gap 1e-6";
    const json big = parsed(program, range + " --force base --amplitude 3e-7" + steel);
    const json& plain = base["frequencies"];
    REQUIRE(big["frequencies"].size() == plain.size());
    int motions = 0;
    for (std::size_t k = 0; k < plain.size(); ++k) {
        const json& one = big["frequencies"][k];
        CHECK(one["frequency"].get<double>() == Approx(plain[k]["frequency"].get<double>() / 4e-4));
        REQUIRE(one["motions"].size() == plain[k]["motions"].size());
        for (std::size_t j = 0; j < one["motions"].size(); ++j) {
            const json& here = one["motions"][j];
            const json& there = plain[k]["motions"][j];
            CHECK(here["impulse"].get<double>() ==
                  Approx(there["impulse"].get<double>() * 4e-3 / 1e-3));
            CHECK(here["peak_force"].get<double>() ==
                  Approx(there["peak_force"].get<double>() * 10.0 / 1e-3));
            CHECK(here["phase"].get<double>() == Approx(there["phase"].get<double>()));
            ++motions;
        }
    }
    CHECK(motions > 0);
}

TEST_CASE("cli find: the forced motions of a schedule, by amplitude or of the least")
{
    const CommandLine program;
    // n = 104, n_c = 16: two motions at 0.25 EA g/L.
    const json two = parsed(program, "find 16 88 --state s.csv" + section15);
    CHECK(two["status"] == "found");
    CHECK(two["schedule"] == json::parse("[[16,88]]"));
    CHECK(two["frequency_ratio"].get<double>() == Approx(120.0 / 104.0));
    REQUIRE(two["motions"].size() == 2);
    CHECK(two["motions"][0]["impulse"].get<double>() == Approx(0.6285e-3).margin(1e-7));
    CHECK(two["motions"][1]["impulse"].get<double>() == Approx(1.5609e-3).margin(1e-7));
    CHECK(two["amplitude"].get<double>() == Approx(2.5e-4));
    CHECK(two["phase"] == two["motions"][1]["phase"]);
    // The state is that of the last one: the bar goes on and comes back, as long as it is told to.
    const json on = parsed(program,
                           "simulate --from s.csv --frequency 1.153846153846154 --periods 9 "
                           "--phase " +
                               two["phase"].dump() + section15);
    CHECK(on["contacts"] == 9);
    CHECK(on["impulse"].get<double>() == Approx(9.0 * two["motions"][1]["impulse"].get<double>()));

    // Without an amplitude the least one; over all n_c at n = 108 it is 0.1254 EA g/L.
    const std::string free = " --cells 30 --damping 0.03353713 --force tip --quiet";
    double least = 1.0;
    for (int contact = 1; contact <= 30; ++contact) {
        const auto outcome = program.run("find " + std::to_string(contact) + " " +
                                         std::to_string(108 - contact) + free + " --format json");
        const json answer = json::parse(outcome.out);
        if (answer["status"] == "found") {
            CHECK(outcome.status == 0);
            CHECK(answer["amplitude"].get<double>() ==
                  Approx(answer["amplitude_range"][0].get<double>()).epsilon(1e-14));
            least = std::min(least, answer["amplitude"].get<double>());
        } else {
            CHECK(outcome.status == (answer["status"] == "none" ? 1 : 3));
            CHECK((answer["status"] != "none" || answer["certificate"]["verified"] == true));
        }
    }
    CHECK(least == Approx(0.1254e-3).margin(5e-8));

    const json beyond = parsed(program, "find 12 96 --amplitude 1e-5" + free, 1);
    CHECK(beyond["reason"] == "constraints");
    CHECK(beyond["certificate"]["kind"] == "amplitude-range");
    CHECK(beyond["certificate"]["verified"] == true);
    // Two contacts in two cycles: one motion twice, and as a rule none.
    const json twice = parsed(program, "find 12 96 12 96 --cycles 2 --amplitude 2.5e-4" + free);
    CHECK(twice["schedule"] == json::parse("[[12,96],[12,96]]"));
    CHECK(twice["motions"].back()["impulse"].get<double>() == Approx(2.1420e-3).margin(2e-7));
    const json unlike = parsed(program, "find 12 96 13 95 --cycles 2" + free);
    CHECK(unlike["solution_set"]["kind"] == "point");
    CHECK(unlike["amplitude_range"][0] == unlike["amplitude_range"][1]);
    const json none = parsed(program, "find 12 96 14 94 --cycles 2" + free, 1);
    CHECK(none["certificate"]["verified"] == true);
    // A limit on strain takes the upper part of the range.
    const json all = parsed(program, "find 12 96" + free);
    const json limited = parsed(program, "find 12 96 --strain-limit 2.5e-3" + free);
    CHECK(limited["amplitude_range"][1] < all["amplitude_range"][1]);
    const json& physical = limited["motions"][0]["physical"];
    CHECK(physical["peak_compression"].get<double>() <= 2.5e-3 * (1.0 + 1e-12));
    CHECK(physical["frequency"].get<double>() == Approx(30.0 / 108.0));
    CHECK(physical["impulse"] == limited["motions"][0]["impulse"]);
    CHECK(limited["motions"][0]["admissible"] == true);
    // Strains beyond 1 are told.
    const auto huge = program.run("find 12 96 --cells 30 --damping 0.03 --force tip --gap 0.9");
    CHECK(huge.status == 0);
    CHECK_THAT(huge.err, containsText("not admissible"));
    for (const char* wrong :
         {"find 12 96 --force tip", "find 12 96 --damping 0.1", "find 12 96 --cycles 2",
          "find 12 96 --damping 0.1 --force tip --energy-ratio 3",
          "find 12 96 --damping 0.1 --force tip --yield-stress 1e6",
          "find 12 96 --damping 0.1 --force tip --tip-floor -1",
          "find 12 96 --damping 0.1 --force tip --cycles 54",
          "find --period 7/2 --damping 0.1 --force tip"}) {
        const auto outcome = program.run(wrong);
        INFO(wrong << "\n" << outcome.err);
        CHECK(outcome.status == 2);
        CHECK(lines(outcome.err) == 1);
    }
}

TEST_CASE("cli find: a period in place of a schedule has motions on no grid")
{
    const CommandLine program;
    const std::string force = " --damping 0.03353713 --force tip --amplitude 2.5e-4";
    const json answer = parsed(program, "find --frequency 10/9 --contacts 1" + force);
    CHECK(answer["status"] == "found");
    CHECK(answer["contacts"] == 1);
    CHECK(answer["exact_period"] == json({18, 5}));
    CHECK(answer["frequency_ratio"].get<double>() == Approx(10.0 / 9.0));
    REQUIRE(answer["motions"].size() == 2);
    const json& smooth = answer["motions"][0];
    CHECK(smooth["release"] == "smooth");
    CHECK(smooth["contact_time_ratio"].get<double>() == Approx(0.252428709).epsilon(1e-5));
    CHECK(smooth["physical"]["impulse"].get<double>() == Approx(0.190608685e-3).epsilon(1e-5));
    CHECK(smooth["growth"].get<double>() == Approx(1.6588).epsilon(1e-3));
    const json& pinned = answer["motions"][1];
    CHECK(pinned["release"] == "pinned");
    CHECK(pinned["contact_time_ratio"].get<double>() == Approx(0.4).epsilon(1e-14));
    CHECK(pinned["physical"]["impulse"].get<double>() == Approx(1.070913943e-3).epsilon(1e-6));
    CHECK(parsed(program, "find --period 18/5 --quiet" + force)["motions"] == answer["motions"]);
    CHECK(answer["complete_from"] == 0.0);
    const std::string within = "find --frequency 10/9 --strain-limit ";
    const json all = parsed(program, within + "4e-3" + force);
    CHECK(all["motions"] == answer["motions"]);
    CHECK(all["strain_limit"] == 4e-3);
    CHECK(all["beyond_limit"] == 0);
    const json gentle = parsed(program, within + "3e-3" + force);
    CHECK(gentle["motions"] == json::array({smooth}));
    CHECK(gentle["beyond_limit"] == 1);
    const json lacking = parsed(program, within + "2e-3 --figure f.svg" + force, 3);
    CHECK(lacking["motions"].empty());
    CHECK(lacking["beyond_limit"] == 2);
    CHECK_THAT(lacking["detail"].get<std::string>(), containsText("2 motions do not stay within"));
    CHECK(program.files() == 0);
    const json twice = parsed(program, "find --frequency 10/9 --cycles 2" + force, 1);
    CHECK(twice["exact_period"] == json({36, 5}));
    CHECK(twice["frequency_ratio"] == answer["frequency_ratio"]);
    // None, with a proof; the tip of a bar that is pressed at rest may stay there.
    CHECK(parsed(program, "find --period 118/30" + force, 1)["rests"] == false);
    const json pressed = parsed(program, "find --period 10/3 --gap -1e-3" + force, 1);
    CHECK(pressed["complete_from"] == 0.0);
    CHECK(pressed["rests"] == true);
    for (const char* bar : {"--damping 0.1", "--scene 'clamp 6 dash=0.1 driven stop=1e-3'"}) {
        const std::string call =
            fmt::format("find --period 18/5 {} --force tip --amplitude 1e-4 ", bar);
        for (const auto& [option, reason] : {std::pair{"--state s.csv", "constant on pieces"},
                                             {"--stability", "says by itself"}}) {
            const auto refused = program.run(call + option);
            CHECK(refused.status == 2);
            CHECK_THAT(refused.err, containsText(reason) && containsText("allowed"));
        }
    }
    for (const char* wrong :
         {"find --period 18/5 --damping 0 --force tip --amplitude 1e-4",
          "find --period 18/5 --damping 0.1 --force tip",
          "find --period 18/5 --contacts 61 --damping 0.1 --force tip --amplitude 1e-4",
          "find --period 1.23456789 --damping 0.1 --force tip --amplitude 1e-4",
          "find --period 18/5 --damping 0.1 --force tip --amplitude 1e-4 --energy 1"}) {
        const auto outcome = program.run(wrong);
        INFO(wrong << "\n" << outcome.err);
        CHECK(outcome.status == 2);
        CHECK(lines(outcome.err) == 1);
    }
}

TEST_CASE("cli find: a frequency of several bars, or of segments, has motions on no grid")
{
    const CommandLine program;
    const std::string force = " --force tip --amplitude 2e-4";
    // Equal segments are a bar: its own list, from its own engine.
    const json bar = parsed(program, "find --period 18/5 --damping 0.02 --cells 30" + force);
    const std::string dash = fmt::format("{:.17g}", Damping{.ratio = 0.02}.eta());
    const json words = parsed(program, "find --period 18/5 --scene 'clamp 30 dash=" + dash +
                                           " driven stop=1e-3'" + force);
    REQUIRE(words["motions"].size() == bar["motions"].size());
    for (std::size_t k = 0; k < bar["motions"].size(); ++k) {
        const json& one = words["motions"][k];
        const json& other = bar["motions"][k]["contacts"][0];
        CHECK(one["contact_time"].get<double>() ==
              Approx(other["end"].get<double>()).epsilon(1e-7));
        CHECK(one["impulse"].get<double>() == Approx(other["impulse"].get<double>()).epsilon(1e-7));
        CHECK(one["release"] == other["release"]);
    }
    const json stepped = parsed(program,
                                "find --hertz 0.27 --segments 15:1,15:1.3 --damping 0.02 --force "
                                "tip --amplitude 6e-4 --figure f.svg");
    CHECK(contentOf(program.file("f.svg")).find("open by") != std::string::npos);
    CHECK(stepped["status"] == "found");
    CHECK(stepped["steps"] == 111);
    CHECK(stepped["motions"][0]["residual"].get<double>() < 1e-9);
    const std::string bars = "find --scene 'clamp 6 dash=0.1 driven gap=1e-3 8 dash=0.2 2 clamp'";
    for (const std::string& wrong :
         {bars + " --hertz 1 --force base --amplitude 1e-4", bars + " --hertz 1 --force tip",
          bars + " --hertz 1e-9" + force, bars + " --period 0.3" + force,
          bars + " 3 4 --hertz 1" + force, bars + " --hertz 1 --state s.csv" + force,
          bars + " --hertz 1 --certificate c" + force,
          std::string("find --hertz 1 --scene 'clamp 6 driven stop=1e-3'") + force}) {
        const auto outcome = program.run(wrong);
        INFO(wrong << "\n" << outcome.err);
        CHECK(outcome.status == 2);
        CHECK(lines(outcome.err) == 1);
        CHECK(outcome.out.empty());
    }
}

TEST_CASE("cli find: without damping, waves that nothing holds need no force and bear none",
          "[glpk]")
{
    const CommandLine program;
    const json undamped = parsed(program, "find 15 90 --cells 30 --damping 0 --force base");
    CHECK(undamped["solution_set"]["kind"] == "polytope");
    CHECK(undamped["solution_set"]["free_waves"] == 15);
    CHECK(undamped["amplitude"].get<double>() < 1e-12);
    CHECK(parsed(program, "find 15 90 --cells 30 --damping 0 --force base --amplitude 1e-4",
                 1)["certificate"]["verified"] == true);
}

TEST_CASE("cli simulate: from rest to the motion of section 15, with its tables")
{
    const CommandLine program;
    const json answer = parsed(program,
                               "simulate --rest --frequency 1.1111111111111112 "
                               "--periods 300 --events e.csv --tip t.csv" +
                                   section15);
    CHECK(answer["schema"] == 2);
    CHECK(answer["status"] == "done");
    CHECK(answer["settled"]["periods"] == 1);
    CHECK(answer["settled"]["contacts"] == 1);
    CHECK(answer["settled"]["impulse"].get<double>() == Approx(1.0710e-3).margin(5e-7));
    CHECK(answer["excitation"]["steps"] == 108);
    CHECK(answer["excitation"]["frequency"].get<double>() == Approx(1.0 / 3.6));
    CHECK(answer["time"].get<double>() == Approx(1080.0));
    CHECK(std::abs(answer["balance"]["error"].get<double>()) < 1e-15);
    std::istringstream table(contentOf(program.file("e.csv")));
    std::string row;
    std::getline(table, row);
    CHECK(row == "start,end,impulse,peak_force,mean_force,speed,energy");
    std::int64_t contacts = 0;
    double impulse = 0.0;
    double before = 0.0;
    while (std::getline(table, row)) {
        double start = 0.0;
        double end = 0.0;
        double one = 0.0;
        REQUIRE(std::sscanf(row.c_str(), "%lf,%lf,%lf", &start, &end, &one) == 3);
        CHECK(start >= before);
        CHECK(end > start);
        before = end;
        impulse += one;
        ++contacts;
    }
    CHECK(answer["contacts"] == contacts);
    CHECK(answer["impulse"].get<double>() == Approx(impulse));
    CHECK(lines(contentOf(program.file("t.csv"))) > 1000);
}

TEST_CASE("cli simulate: a state of find goes on as find says, in seconds of the bar")
{
    const CommandLine program;
    const std::string steel =
        " --length 2 --young 2e11 --density 8000 --area 1e-4 --gap 1e-6 --quiet";
    REQUIRE(program.run("find 500 3000 --cells 1000 --state s.csv" + steel).status == 0);
    CHECK(parsed(program, "simulate --from s.csv --time 1.4e-2" + steel)["contacts"] == 10);
    REQUIRE(program.run("find 15 90 --cells 30 --state s.csv" + steel).status == 0);
    // Ten periods of 3.5 L/c = 1.4e-3 s; E = 4 E_1 = 4 EA g^2/(2L).
    const json answer = parsed(program, "simulate --from s.csv --time 1.4e-2" + steel);
    CHECK(answer["contacts"] == 10);
    CHECK(answer["settled"].is_null());
    CHECK(answer["excitation"].is_null());
    CHECK(answer["energy_ratio"].get<double>() == Approx(4.0).epsilon(1e-9));
    CHECK(answer["energy"].get<double>() == Approx(4.0 * 2e7 * 1e-12 / 4.0).epsilon(1e-9));
    CHECK(answer["tip"].get<double>() == Approx(1e-6).epsilon(1e-6));
}

TEST_CASE("cli sweep: JSON, table and words say the same, in Hz as in omega_1")
{
    const CommandLine program;
    const std::string call =
        "sweep --points 3 --periods 200 --yield-stress 1e5 --young 4 "
        "--density 4 --area 0.25 --csv s.csv";
    const json answer = parsed(program, call + " --from 1 --to 1.2" + section15);
    CHECK(answer["status"] == "done");
    CHECK(answer["over"] == "frequency");
    REQUIRE(answer["points"].size() == 6);
    CHECK(answer["points"][0]["direction"] == "up");
    CHECK(answer["points"][5]["direction"] == "down");
    CHECK(answer["points"][1]["frequency"].get<double>() == Approx(0.275).epsilon(1e-5));
    CHECK(answer["points"][1]["peak_stress"].get<double>() ==
          Approx(4.0 * answer["points"][1]["peak_strain"].get<double>()));
    std::ifstream table(program.file("s.csv"));
    std::string line;
    std::getline(table, line);
    CHECK(line.starts_with("value,frequency,direction,periods,"));
    for (const json& point : answer["points"]) {
        REQUIRE(std::getline(table, line));
        CHECK(line.starts_with(fmt::format("{},{},{},", point["value"].get<double>(),
                                           point["frequency"].get<double>(),
                                           point["direction"].get<std::string>())));
    }
    CHECK_FALSE(std::getline(table, line));
    CHECK(parsed(program, call + " --from-hertz 0.25 --to 0.3Hz" + section15)["points"] ==
          answer["points"]);
    const auto text = program.run(call + " --from 1 --to 1.2" + section15);
    CHECK_THAT(text.out, containsText("upward") && containsText("no yield"));
    const std::string high =
        "sweep --points 1 --periods 2 --from 12 --to 12 --cells 30 --damping 0.1 --force tip "
        "--amplitude 1e-4";
    CHECK_THAT(program.run(high).err, containsText("12 Hz are --from 12Hz"));
}

TEST_CASE("cli response, simulate: wrong use is one line, status 2 and no file")
{
    const CommandLine program;
    const std::string force = " --force tip --amplitude 1";
    const std::string out = " --csv r.csv";
    const std::pair<std::string, const char*> calls[] = {
        {"response" + force + out, "--damping is missing"},
        {"response --damping 0.1 --amplitude 1" + out, "--force"},
        {"response --damping 0.1 --force tip" + out, "--amplitude"},
        {"response --damping 0" + force + out, "--damping = 0"},
        {"response --damping -1" + force + out, "--damping = -1"},
        {"response --damping nan" + force + out, "--damping"},
        {"response --damping 0.1 --force rope --amplitude 1" + out, "tip|base"},
        {"response --damping 0.1 --force tip --amplitude 0" + out, "--amplitude = 0"},
        {"response --damping 0.1 --from 3" + force + out, "--from = 3"},
        {"response --damping 0.1 --from 9 --to 9.001 --cells 2" + force + out, "frequency ratios"},
        {"response --damping 0.1 --cycles 0" + force + out, "--cycles"},
        {"response --damping 0.1 --contacts 3" + force + out, "--contacts = 3"},
        {"response --damping 0.1 --band 0.1" + force + out, "--band = 0.1"},
        {"response --damping 0.1 --contacts 2 --band 1" + force + out, "--band = 1"},
        {"response --damping 0.1 --contacts 2" + force + out, "contacts: 2"},
        {"response --damping 0.1 --figure r.gif" + force + out, "figure"},
        {"response --damping 0.1 --from 1 --from-hertz 3" + force + out, "both are one"},
        {"sweep --damping 0.1" + out, "--force is missing"},
        {"sweep --damping 0.1 --force tip" + out, "--amplitude is missing"},
        {"sweep --damping 0.1 --over gap" + force + out, "--frequency is missing"},
        {"sweep --damping 0.1 --over gap --frequency 1" + force + out, "--from is missing"},
        {"sweep --over damping --damping 0.1 --frequency 1" + force + out, "--damping = 0.1"},
        {"sweep --over amplitude --frequency 1" + force + out, "--amplitude = 1"},
        {"sweep --from 2 --to 1" + force + out, "--from = 2"},
        {"sweep --from 1 --from-hertz 1" + force + out, "--from = 1"},
        {"sweep --from-hertz 2 --to-hertz 1Hz" + force + out,
         "--from-hertz = 2 is out of range: allowed numbers up to --to-hertz = 1Hz"},
        {"response --damping 0.1 --from-hertz 2 --to 1" + force + out, "--from-hertz = 2 is"},
        {"sweep --from 4000 --to 5000" + force + out, "--from = 4000 is"},
        {"sweep --from-hertz 4kHz --to-hertz 5kHz" + force + out, "--from-hertz = 4kHz is"},
        {"sweep --to-hertz 1MHz" + force + out, "--to-hertz = 1MHz is"},
        {"sweep --points 0" + force + out, "--points = 0"},
        {"sweep --periods 0" + force + out, "--periods = 0"},
        {"sweep --over speed" + force + out, "frequency|amplitude|gap|damping"},
        {"sweep --yield-stress 1" + force + out, "--yield-stress"},
        {"sweep --gap 0 --over gap --from 1 --to 2 --frequency 1" + force + out, "--gap = 0"},
        {"simulate --rest", "--time"},
        {"simulate --time 1 --periods 2" + force + " --frequency 1", "--periods"},
        {"simulate --periods 2", "--force"},
        {"simulate --time 1" + force, "all three"},
        {"simulate --time 1 --frequency 1000" + force + " --events r.csv", "--frequency"},
        {"simulate --time 0 --events r.csv", "--time"},
        {"simulate --time 1e308 --length 1e-100 --gap 1e-103 --events r.csv", "--time"},
        {"simulate --time 1 --phase x --events r.csv", "--phase"},
    };
    for (const auto& [call, word] : calls) {
        const auto outcome = program.run(call);
        INFO(call << "\n" << outcome.err);
        CHECK(outcome.status == 2);
        CHECK(lines(outcome.err) == 1);
        CHECK_THAT(outcome.err, containsText(word) && containsText("allowed"));
        CHECK(outcome.out.empty());
        CHECK(program.files() == 0);
    }
    CHECK(program.run("simulate --time 1 --from no.csv").status == 4);
}

TEST_CASE("cli simulate: one bar in words takes --damping, as it does by its options")
{
    const CommandLine program;
    for (const auto& [words, options] :
         {std::pair{"'clamp 12 stop=1e-3'", "--cells 12"},
          {"'clamp 6 6:1.3 stop=-2e-3 stop=1e-3'", "--segments 6:1,6:1.3 --second-stop 2e-3"}}) {
        for (const char* driven :
             {"--force tip --amplitude 4e-4 --frequency 1 --periods 30", "--rest --time 3"}) {
            const std::string damped = std::string(" --damping 0.02 ") + driven;
            const json said = parsed(program, std::string("simulate --scene ") + words + damped);
            CHECK(said == parsed(program, std::string("simulate ") + options + damped));
            CHECK(said["damping"]["ratio"] == 0.02);
        }
    }
    CHECK(
        program.run("simulate --scene 'clamp 6 gap=1e-3 6 clamp' --damping 0.1 --time 1").status ==
        2);
}

TEST_CASE("cli simulate: cells that are not those of the state are refused")
{
    const CommandLine program;
    REQUIRE(program.run("find 3 18 --cells 6 --state s.csv").status == 0);
    const auto outcome = program.run("simulate --from s.csv --time 1 --cells 20");
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err,
               Catch::StartsWith("signorini: --cells = 20") && containsText("allowed 6"));
    CHECK(parsed(program, "simulate --from s.csv --time 1 --cells 6") ==
          parsed(program, "simulate --from s.csv --time 1"));
}

TEST_CASE("cli response --exact: curves, and beside them what a staircase has")
{
    const CommandLine program;
    const std::string asked =
        "response --exact --cells 10 --damping 0.05 --force tip --amplitude 4e-4 --from 0.9 --to "
        "1.3";
    const json answer = parsed(program, asked);
    CHECK(answer["complete"] == true);
    REQUIRE(answer["branches"].size() > 0);
    for (const json& branch : answer["branches"]) {
        for (const json& mark : branch["marks"]) {
            const std::string event = mark["event"];
            INFO(event);
            CHECK((event == "fold" || event == "grazing" || event == "new contact" ||
                   event == "lost contact" || event == "pin" || event == "end"));
        }
    }
    const auto text = program.run(
        "response --exact --cells 10 --damping 0.05 --force tip --amplitude 8e3 --from 0.9 --to "
        "1.3 --young 2e11 --density 8e3 --area 1e-4 --yield-stress 1GPa --csv e.csv");
    CHECK(text.status == 0);
    CHECK_THAT(text.out, containsText("strain      at most") &&
                             containsText("stress      at most") &&
                             containsText("of the yield stress"));
    CHECK_THAT(contentOf(program.file("e.csv")), containsText("peak_stress"));
    const auto drawn = program.run(asked + " --quiet --force-steps 40 --figure exact.svg");
    if (drawn.status != 4) {  // there is gnuplot
        CHECK(drawn.status == 0);
        CHECK_THAT(contentOf(program.file("exact.svg")),
                   containsText("staircase, 40 steps in L/c") && containsText("one contact"));
    }
    for (const std::string& wrong :
         {asked + " --force-steps 40", asked + " --force-steps 0 --figure f.svg",
          asked + " --yield-stress 1GPa",
          std::string("response --cells 10 --damping 0.05 --force tip "
                      "--amplitude 4e-4 --force-steps 40")}) {
        const auto outcome = program.run(wrong);
        INFO(wrong << "\n" << outcome.err);
        CHECK(outcome.status == 2);
        CHECK(lines(outcome.err) == 1);
    }
}

TEST_CASE("cli response --exact: a list that was interrupted says so")
{
    const CommandLine program;
    const std::string asked =
        "response --exact --cells 300 --damping 0.02 --force tip --amplitude 2e-4 ";
    const auto json = nlohmann::json::parse(
        program.run(asked + "--format json --csv e.csv", "timeout -s INT 0.6").out);
    CHECK(json["status"] == "undecided");
    CHECK(json["complete"] == false);
    CHECK(program.files() == 0);
    const auto text = program.run(asked, "timeout -s INT 0.6");
    CHECK_THAT(text.err, containsText("interrupted"));
    CHECK_THAT(text.out, containsText("interrupted") && !containsText("all of them"));
}

TEST_CASE("cli response --exact of several bars: lists of find, and where a simulation settles")
{
    const CommandLine program;
    const std::string bars = " --scene 'clamp 6 dash=0.1 driven gap=1e-3 8 dash=0.2 2 clamp'";
    // A simulation drives in steps: these are eight times as many.
    const std::string finer = " --scene 'clamp 48 dash=0.1 driven gap=1e-3 64 dash=0.2 16 clamp'";
    const std::string force = " --force tip --amplitude 2e-3";
    const json answer =
        parsed(program, "response --exact --from-hertz 0.4 --to-hertz 0.8 --threads 2 --csv r.csv" +
                            bars + force);
    std::size_t motions = 0;
    std::size_t settled = 0;
    for (const json& at : answer["frequencies"]) {
        const std::string period = fmt::format("{}/16", at["steps"].get<int>());
        INFO(period);
        const auto found = program.run("find --format json --period " + period + bars + force);
        CHECK(json::parse(found.out)["motions"] == at["motions"]);
        motions += at["motions"].size();
        CHECK(at["touches"] == (at["distance"][0].get<double>() < 0.0));
        const json run =
            parsed(program, fmt::format("simulate --rest --periods 400 --hertz {:.17g}",
                                        at["frequency"].get<double>()) +
                                finer + force);
        if (!at["touches"].get<bool>()) {
            CHECK(run["contacts"][0]["count"] == 0);
        }
        const json& end = run["settled"];
        if (!end.is_null() && end["periods"] == 1 && end["contacts"] == 1) {
            ++settled;
            const auto& list = at["motions"];
            CHECK(std::any_of(list.begin(), list.end(), [&](const json& motion) {
                return motion["impulse"].get<double>() ==
                       Approx(end["impulse"].get<double>()).epsilon(1e-3);
            }));
        }
    }
    CHECK(motions >= 8);
    CHECK(settled >= 5);
    CHECK(lines(contentOf(program.file("r.csv"))) >= 1 + std::ssize(answer["frequencies"]));
    for (const std::string& wrong :
         {"response --band 0.1" + bars + force, "response --exact --damping 0.1" + bars + force,
          "response --exact --stability" + bars + force,
          "response --exact --contacts 2 --band 0.1" + bars + force,
          "response --exact --map m.svg" + bars + force,
          "response --exact --from 1e-4" + bars + force}) {
        const auto outcome = program.run(wrong);
        INFO(wrong << "\n" << outcome.err);
        CHECK(outcome.status == 2);
        CHECK(lines(outcome.err) == 1);
    }
    // A bar that nothing holds bounces if it has weight.
    const json bouncing =
        parsed(program,
               "find --period 2.4 --scene 'clamp shaken 3 dash=0.4 gap=0 2 dash=0.1' "
               "--gravity -0.02 --force base --amplitude 0.02");
    REQUIRE(!bouncing["motions"].empty());
    for (const json& motion : bouncing["motions"]) {
        CHECK(motion["impulse"].get<double>() == Approx(0.02 * 0.4 * 2.4).epsilon(1e-9));
    }
    const std::string flying = " --scene 'stop=-1e-3 8 dash=0.5 driven stop=1e-3'" + force;
    const auto none = program.run("find --period 2" + flying);
    CHECK(none.status == 1);
    CHECK_THAT(none.out, containsText("balance"));
    const json both = parsed(program, "find --frequency 0.3 --contacts 2" + flying);
    REQUIRE(both["motions"].size() == 1);
    const json& contacts = both["motions"][0]["contacts"];
    REQUIRE(contacts.size() == 2);
    CHECK(contacts[0]["contact"] != contacts[1]["contact"]);
    // Neither a harmonic force nor a dashpot has given it momentum after a period.
    CHECK(contacts[0]["impulse"].get<double>() ==
          Approx(contacts[1]["impulse"].get<double>()).epsilon(1e-12));
    const auto pulled = program.run(
        "find --period 2 --contacts 2 --scene 'force=-0.1 4 dash=0.1 "
        "driven stop=1e-3'" +
        force);
    CHECK(pulled.status == 1);
}

TEST_CASE("cli response of several bars in steps: what find says of each schedule", "[glpk]")
{
    const CommandLine program;
    const std::string bars = " --scene 'clamp 6 dash=0.1 driven gap=1e-3 8 dash=0.2 2 clamp'";
    const std::string force = " --force tip --amplitude 2e-3";
    const json answer = parsed(program,
                               "response --from-hertz 0.5 --to-hertz 0.8 --stability "
                               "--csv r.csv" +
                                   bars + force);
    int tried = 0;
    std::size_t motions = 0;
    for (const json& at : answer["frequencies"]) {
        const int steps = at["steps"].get<int>();
        motions += at["motions"].size();
        for (const json& motion : at["motions"]) {
            const int closed = motion["contact_steps"].get<int>();
            const json found =
                parsed(program, fmt::format("find {} {}", closed, steps - closed) + bars + force);
            const auto& list = found["motions"];
            INFO(closed << " of " << steps);
            CHECK(std::any_of(list.begin(), list.end(), [&](const json& other) {
                return std::abs(std::remainder(
                           motion["phase"].get<double>() - other["phase"].get<double>(),
                           2.0 * std::numbers::pi)) < 1e-6 &&
                       motion["impulse"].get<double>() ==
                           Approx(other["contacts"][0]["impulse"].get<double>()).epsilon(1e-6) &&
                       motion["strains"]["peak_compression"].get<double>() ==
                           Approx(other["strains"]["peak_compression"].get<double>());
            }));
            tried += motion["stability"]["verdict"] == "attracts" ? 1 : 0;
        }
    }
    CHECK(answer["exact"] == false);
    CHECK(tried > 0);
    CHECK(motions >= 8);
    CHECK_THAT(contentOf(program.file("r.csv")), containsText(",step,"));
    // Bars that nothing holds, and waves that nothing damps: each schedule by its own programs.
    for (const char* scene :
         {"stop=1e-3 4 dash=0.1 driven stop=1e-3", "clamp 4 driven gap=1e-3 4 clamp"}) {
        const json other = parsed(program, fmt::format("response --from-hertz 0.4 --to-hertz 0.8 "
                                                       "--scene '{}'",
                                                       scene) +
                                               force);
        CHECK(std::any_of(other["frequencies"].begin(), other["frequencies"].end(),
                          [](const json& at) { return !at["motions"].empty(); }));
    }
}

TEST_CASE("cli response --map-csv of several bars: the amplitudes that find has", "[glpk]")
{
    const CommandLine program;
    const std::string bars = " --scene 'clamp 6 dash=0.1 driven gap=1e-3 8 dash=0.2 2 clamp'";
    const json answer = parsed(program,
                               "response --from-hertz 0.666 --to-hertz 0.667 --force tip "
                               "--amplitude 2e-3 --map-csv m.csv" +
                                   bars);
    REQUIRE(answer["frequencies"].size() == 1);
    std::istringstream map(contentOf(program.file("m.csv")));
    std::string line;
    std::getline(map, line);
    CHECK(line ==
          "steps,frequency_ratio,frequency,which,contact,free,least_amplitude,most_amplitude,"
          "second,second_contact,second_free");
    std::map<int, std::array<double, 2>> seen;  // by closed steps; of two pieces both ends
    std::size_t motions = 0;
    while (std::getline(map, line)) {
        const std::vector<std::string> cells = cellsOf(line);
        REQUIRE(cells.size() == 11);
        const double least = std::stod(cells[6]);
        const double most =
            cells[7].empty() ? std::numeric_limits<double>::infinity() : std::stod(cells[7]);
        const auto [range, isNew] = seen.insert({std::stoi(cells[4]), {least, most}});
        range->second = {std::min(range->second[0], least), std::max(range->second[1], most)};
        motions += cells[4] != "0" && least <= 2e-3 && 2e-3 <= most ? 1 : 0;
    }
    CHECK(motions == answer["frequencies"][0]["motions"].size());
    // Where the bars meet without contact: their distance is linear in the amplitude.
    const double distance = answer["frequencies"][0]["distance"][0].get<double>();
    CHECK(seen.at(0)[1] == Approx(2e-3 * 1e-3 / (1e-3 - distance)));
    std::size_t found = 1;
    for (int closed = 1; closed < 24; ++closed) {
        INFO(closed);
        const json range =
            parsed(program, fmt::format("find {} {} --force tip", closed, 24 - closed) + bars,
                   seen.contains(closed) ? 0 : 1)["amplitude_range"];
        REQUIRE(range.is_null() != seen.contains(closed));
        if (!range.is_null()) {
            ++found;
            CHECK(seen[closed][0] == Approx(range[0].get<double>()));
            CHECK(std::isinf(seen[closed][1]) == range[1].is_null());
            CHECK((range[1].is_null() || seen[closed][1] == Approx(range[1].get<double>())));
        }
    }
    CHECK(found == seen.size());
    CHECK(found >= 5);
    const auto drawn = program.run(
        "response --from-hertz 0.6 --to-hertz 0.7 --force tip --amplitude 2e-3 --map m.svg" + bars);
    if (drawn.status != 4) {  // gnuplot is here
        for (const char* label : {"amplitude of the force", "16 cells", "the least", "Hz"}) {
            CHECK_THAT(contentOf(program.file("m.svg")), containsText(label));
        }
    }
}

TEST_CASE("cli response --map: pressed bars have contact that never opens, up to an amplitude")
{
    const CommandLine program;
    const std::string pressed =
        "response --cells 8 --gap=-1e-4 --damping 0.05 --force tip --from 1 --to 1.1 --map-csv "
        "m.csv --amplitude ";
    (void)parsed(program, pressed + "5e-5");
    const std::string map = contentOf(program.file("m.csv"));
    const json at = parsed(program, pressed + "9.999e-5")["frequencies"][0];
    CHECK(at["permanent_contact"].is_object());
    CHECK(parsed(program, pressed + "1.0001e-4")["frequencies"][0]["permanent_contact"].is_null());
    const std::string row = map.substr(map.find(",1," + at["steps"].dump() + ",0,,,0,") + 1);
    CHECK(std::stod(row.substr(row.find_last_of(',', row.find('\n')) + 1)) == Approx(1e-4));
}

TEST_CASE("cli response --map-csv: contact that never opens ends where another one closes")
{
    const CommandLine program;
    const std::string call =
        "response --scene 'clamp 4 dash=0.1 driven 2 stop=-1e-4 gap=1e-2 4 dash=0.2 "
        "stop=right:-2e-4 2 clamp' --force tip --from 0.8 --to 0.81 --map-csv m.csv --amplitude ";
    std::set<std::string> rows;
    for (const char* amplitude : {"5e-5", "1e-4", "1.2e-4", "2e-4"}) {
        const json answer = parsed(program, call + amplitude);
        const json& at = answer["frequencies"][0];
        const std::string map = contentOf(program.file("m.csv"));
        const std::size_t row = map.find(",3," + at["steps"].dump() + ",0,0,");
        INFO(amplitude << map);
        REQUIRE(row != std::string::npos);
        const double most = std::stod(map.substr(map.find(",0,0,", row) + 5));
        rows.insert(fmt::format("{:.9e}", most));
        const bool isHeld =
            std::any_of(at["motions"].begin(), at["motions"].end(),
                        [&](const json& motion) { return motion["contact_steps"] == at["steps"]; });
        CHECK(isHeld == (std::stod(amplitude) <= most));
    }
    CHECK(rows.size() == 1);
    // What the force does not reach and what presses at rest is not a motion without contact.
    (void)parsed(program,
                 "response --scene 'clamp 4 dash=0.1 driven gap=1e-3 4 dash=0.2 stop=right:-1e-4 "
                 "2 clamp' --force tip --amplitude 1e-4 --from 0.8 --to 1.1 --map-csv n.csv");
    CHECK_THAT(contentOf(program.file("n.csv")), containsText(",,0,30,0,0,,,\n"));
}

TEST_CASE("cli response, simulate: figures with their labels")
{
    const CommandLine program;
    const auto outcome =
        program.run("response --from 1.1 --to 1.16 --stability --figure r.svg" + section15);
    if (outcome.status == 4) {
        return;  // no gnuplot here
    }
    CHECK(outcome.status == 0);
    for (const char* label : {"impulse", "swing", "attracts", "repels", "no contact"}) {
        CHECK_THAT(contentOf(program.file("r.svg")), containsText(label));
    }
    CHECK(program.run("simulate --frequency 1.1 --periods 40 --figure s.svg" + section15).status ==
          0);
    CHECK(program.run("simulate --time 40 --figure rest.svg --quiet").status == 0);
    for (const char* label : {"the beginning", "the end", "of a contact", "impulse"}) {
        CHECK_THAT(contentOf(program.file("s.svg")), containsText(label));
    }
    CHECK_THAT(contentOf(program.file("rest.svg")), containsText("no contact"));
}

TEST_CASE("cli response in words: what the linear response does not say is not taken for clear",
          "[glpk]")
{
    const CommandLine program;
    const auto textOf = [&](const std::string& asked) {
        const auto outcome = program.run("response --force tip --amplitude " + asked);
        INFO(asked << "\n" << outcome.err);
        CHECK((outcome.status == 0 || outcome.status == 3));
        CHECK(outcome.out.find("stays clear") == std::string::npos);
        return outcome.out;
    };
    const auto unknown = containsText("the linear response does not say that there is one: 0.");
    // A bar that flies may be anywhere; forces that nothing balances leave no place to settle from.
    CHECK_THAT(textOf("1e-2 --from 0.2 --to 1.1 --scene 'stop=-1e-3 8 driven dash=0.2 stop=1e-3'"),
               unknown && containsText("rattles     nowhere that was decided"));
    CHECK_THAT(textOf("1e-2 --from 1 --to 1.1 --exact --contacts 2 --scene 'force=-0.1 8 driven "
                      "dash=0.2 stop=1e-3'"),
               unknown);
    // What is pressed at rest need not open.
    CHECK_THAT(textOf("1e-4 --from 0.5 --to 1.5 --exact --cells 4 --damping 0.1 --gap -1e-3"),
               unknown);
    const std::string held =
        textOf("1e-4 --from 0.5 --to 1.5 --scene 'clamp 4 dash=0.2 driven gap=-1e-3 4 clamp'");
    CHECK_THAT(held, containsText("permanent   contact: 0.258065 … 0.470588 Hz"));
    CHECK_THAT(held, containsText("closes a contact: nowhere"));
    CHECK_THAT(textOf("1e-4 --from 0.99 --to 1.01 --exact --scene 'clamp 4 dash=0.2 driven "
                      "gap=1e-3 4 clamp'"),
               containsText("undecided   0.5 Hz") && containsText("resonate"));
}

TEST_CASE("cli response of several bars in steps: what repels is small in its figure")
{
    const CommandLine program;
    const auto outcome = program.run(
        "response --scene 'clamp 12 dash=0.1 driven gap=1e-3 16 dash=0.2 4 clamp' --force tip "
        "--amplitude 3e-3 --from-hertz 0.8 --to-hertz 1.2 --stability --figure b.svg");
    if (outcome.status == 4) {
        return;  // no gnuplot here
    }
    CHECK(outcome.status == 0);
    for (const char* label : {"harmonic in steps", "contact 1, repels", "do not meet"}) {
        CHECK_THAT(contentOf(program.file("b.svg")), containsText(label));
    }
}

TEST_CASE("cli sweep: figures, also where no exact motion can stand behind them")
{
    const CommandLine program;
    const auto outcome = program.run(
        "sweep --from 1 --to 1.2 --points 3 --periods 60 --figure s.svg --bifurcation b.svg" +
        section15);
    if (outcome.status == 4) {
        return;  // no gnuplot here
    }
    CHECK(outcome.status == 0);
    CHECK_THAT(contentOf(program.file("s.svg")),
               containsText("exact motions") && containsText("upward") && containsText("swing"));
    CHECK_THAT(contentOf(program.file("b.svg")), containsText("impulse of a contact"));
    for (const char* scene : {" --from 1.00031 --to 1.00032", " --segments 15:1,15:2 --gap 0",
                              " --segments 15:1,15:2 --second-stop 1e-3"}) {
        const auto bare = program.run("sweep --points 2 --periods 60 --figure t.svg" +
                                      std::string(scene) + section15);
        INFO(scene << "\n" << bare.err);
        CHECK(bare.status == 0);
        CHECK_THAT(contentOf(program.file("t.svg")), containsText("swing"));
    }
}

TEST_CASE("cli find --stability: what becomes of a free motion, with what was tried")
{
    const CommandLine program;
    const json answer = parsed(program, "find 15 90 --cells 30 --stability --quiet");
    REQUIRE(answer["stability"].size() == 2);
    const json& undamped = answer["stability"][0];
    CHECK(undamped["damping"]["ratio"] == 0.0);
    CHECK(undamped["periods"] == 300);
    CHECK(undamped["trials"].size() == 4);
    CHECK(undamped["drift"] == 0.0);
    CHECK(undamped["verdict"] != "attracts");
    CHECK(answer["stability"][1]["damping"]["ratio"] == 0.001);
    CHECK(answer["stability"][1]["drift"].get<double>() > 1e-4);
    CHECK_THAT(program.run("find 15 90 --cells 30 --stability").out,
               containsText("disturbances") && containsText("periods"));
    CHECK(program.run("find --period 7/2 --damping 0.1 --force tip --amplitude 1e-3 --stability")
              .status == 2);
    const auto tooLong = program.run("find 150 1000000 --stability");
    CHECK(tooLong.status == 2);
    CHECK_THAT(tooLong.err, containsText("steps of a period = 1000150") && containsText("1000000"));
    // Of several segments, and of several bars, free or forced, likewise.
    CHECK(parsed(program, "find 3 18 --segments 3:1,3:2 --stability --quiet")["stability"].size() ==
          2);
    const json bars =
        parsed(program, "find 1:3 -:11 --scene 'clamp 4 gap=2e-3 4 clamp' --stability --quiet");
    CHECK(bars["stability"]["verdict"] == "repels");
    CHECK(bars["stability"]["trials"].size() == 4);
    const json forced =
        parsed(program,
               "find 1:6 -:42 --scene 'clamp 6 dash=0.2 driven gap=1e-3 dash=0.3 6 clamp' "
               "--force tip --amplitude 2.1e-3 --stability --quiet");
    CHECK(forced["motions"][0]["stability"]["verdict"] == "attracts");
}

TEST_CASE(
    "cli find: a forced motion is drawn, written, tried and compared with yield as a free one")
{
    const CommandLine program;
    const std::string rod =
        " --length 3 --young 210GPa --density 7850 --area 1cm2 --gap 0.1mm --damping 5% --force ";
    // One motion of this schedule attracts; the response says so, too.
    const json answer = parsed(program,
                               "find 20 150 --cells 40 --yield-stress 10MPa --stability "
                               "--motion m.csv" +
                                   rod + "base");
    const json& motion = answer["motions"].back();
    CHECK(motion["stable"] == true);
    const json again = parsed(program,
                              "response --cells 40 --stability --from 0.94 --to 0.945"
                              " --amplitude " +
                                  answer["amplitude"].dump() + rod + "base");
    bool isListed = false;
    for (const json& one : again["frequencies"][0]["motions"]) {
        isListed = isListed || (one["impulse"].get<double>() ==
                                    Approx(motion["impulse"].get<double>()).epsilon(1e-6) &&
                                one["stable"] == true);
    }
    CHECK(isListed);
    CHECK_FALSE(
        parsed(program, "find 20 150 --cells 40" + rod + "base")["motions"][0].contains("stable"));

    // In the table the tip is at the wall as long as it is pressed, and the clamp moves as the
    // base.
    std::ifstream table(program.file("m.csv"));
    std::string line;
    std::getline(table, line);
    double highest = -1.0;
    double swing = 0.0;
    while (std::getline(table, line)) {
        std::istringstream fields(line);
        std::array<double, 3> values{};
        for (double& value : values) {
            fields >> value;
            fields.ignore();
        }
        highest = values[1] == 3.0 ? std::max(highest, values[2]) : highest;
        swing = values[1] == 0.0 ? std::max(swing, std::abs(values[2])) : swing;
    }
    CHECK(highest == Approx(1e-4).epsilon(1e-9));
    CHECK(swing == Approx(answer["amplitude"].get<double>()).epsilon(1e-2));

    const auto told =
        program.run("find 20 150 --cells 40 --yield-stress 10MPa --stability" + rod + "tip");
    CHECK_THAT(told.err, containsText("beyond --yield-stress"));
    CHECK_THAT(told.out, containsText("attracts (tried"));
    for (const char* place : {"tip", "base"}) {
        const auto drawn = program.run("find 20 150 --cells 40 --figure f.svg" + rod + place);
        if (drawn.status == 4) {
            return;  // no gnuplot here
        }
        CHECK(drawn.status == 0);
        CHECK_THAT(
            contentOf(program.file("f.svg")),
            containsText(place[0] == 't' ? "force on the tip 232.7 N" : "base moved by 22.39"));
    }
}

TEST_CASE("cli response --map: amplitude against frequency")
{
    const CommandLine program;
    const auto outcome =
        program.run("response --from 0.9 --to 1.3 --map m.svg --figure r.svg" + section15);
    if (outcome.status == 4) {
        return;  // no gnuplot here
    }
    CHECK(outcome.status == 0);
    for (const char* label : {"amplitude of the force", "meets a stop", "the least", "two"}) {
        CHECK_THAT(contentOf(program.file("m.svg")), containsText(label));
    }
    CHECK_THAT(contentOf(program.file("r.svg")), containsText("modes"));
}

TEST_CASE("cli response --contacts 2: motions with their own amplitude, in answer and table")
{
    const CommandLine program;
    const std::string call =
        "response --from 1.01 --to 1.02 --contacts 2 --band 0.15 --csv r.csv --map-csv m.csv" +
        section15;
    const json answer = parsed(program, call);
    CHECK(answer["contacts"] == 2);
    CHECK(answer["band"] == 0.15);
    REQUIRE(answer["frequencies"].size() == 1);
    CHECK(answer["frequencies"][0]["steps"] == 118);
    const json& motions = answer["frequencies"][0]["motions"];
    REQUIRE(motions.size() == 2);
    CHECK(motions[0]["schedule"] == json::parse("[[2,100],[2,14]]"));
    CHECK(motions[0]["amplitude"].get<double>() == Approx(0.2346e-3).margin(1e-7));
    CHECK(motions[1]["amplitude"].get<double>() == Approx(0.2823e-3).margin(1e-7));
    CHECK(parsed(program, call + " --threads 2")["frequencies"] == answer["frequencies"]);
    CHECK_THAT(
        contentOf(program.file("r.csv")),
        containsText("amplitude,second_contact,second_free") && containsText(",2,14,right,0,"));
    CHECK_THAT(program.run(call).out, containsText("(2, 101) (2, 13)") && containsText("± 15 %"));
    // Each of them as find has it.
    for (const json& motion : motions) {
        const json one = parsed(program, "find " + motion["schedule"][0][0].dump() + " " +
                                             motion["schedule"][0][1].dump() + " " +
                                             motion["schedule"][1][0].dump() + " " +
                                             motion["schedule"][1][1].dump() +
                                             " --cells 30 --damping 0.03353713 --force tip");
        CHECK(one["amplitude"].get<double>() ==
              Approx(motion["amplitude"].get<double>()).epsilon(1e-9));
        CHECK(one["motions"][0]["physical"]["impulse"].get<double>() ==
              Approx(motion["impulse"].get<double>()).epsilon(1e-9));
    }
}

TEST_CASE("cli response --contacts 2: the bar of section 15 said as bars in a row has the same")
{
    const CommandLine program;
    const json answer = parsed(
        program,
        "response --from 1.01 --to 1.02 --contacts 2 --band 0.15 --csv r.csv --map-csv m.csv "
        "--figure r.svg --map m.svg --force tip --amplitude 2.5e-4 "
        "--scene 'clamp 30 driven dash=0.052631578947368421 stop=1e-3'");
    CHECK(answer["most_contacts"] == 2);
    CHECK(answer["band"] == 0.15);
    REQUIRE(answer["frequencies"].size() == 1);
    const json& motions = answer["frequencies"][0]["motions"];
    REQUIRE(motions.size() == 2);
    const auto spans = [&motions](std::size_t k) {
        std::vector<int> steps;
        for (const json& span : motions[k]["spans"]) {
            steps.push_back(span["steps"].get<int>());
        }
        return steps;
    };
    CHECK(spans(0) == std::vector<int>{2, 100, 2, 14});
    CHECK(spans(1) == std::vector<int>{2, 101, 2, 13});
    CHECK(motions[0]["amplitude"].get<double>() == Approx(0.2346e-3).margin(1e-7));
    CHECK(motions[1]["amplitude"].get<double>() == Approx(0.2823e-3).margin(1e-7));
    CHECK_THAT(contentOf(program.file("r.csv")), containsText("1:2 -:100 1:2 -:14"));
    CHECK_THAT(contentOf(program.file("m.csv")), containsText(",1,2,14"));
    for (const char* figure : {"r.svg", "m.svg"}) {
        CHECK_THAT(contentOf(program.file(figure)), containsText("two contacts"));
    }
}

TEST_CASE("cli response: the map and the backbone as tables")
{
    const CommandLine program;
    const json answer = parsed(
        program, "response --from 1.06 --to 1.16 --map-csv m.csv --backbone-csv b.csv" + section15);
    // An amplitude has as many motions as rows hold it.
    std::istringstream map(contentOf(program.file("m.csv")));
    std::string line;
    std::getline(map, line);
    CHECK(line ==
          "steps,frequency_ratio,frequency,contacts,contact,free,second_contact,second_free,"
          "least_amplitude,most_amplitude");
    std::map<int, std::size_t> motions;
    std::map<int, int> withoutContact;
    while (std::getline(map, line)) {
        const std::vector<std::string> cells = cellsOf(line);
        REQUIRE(cells.size() == 10);
        const double most =
            cells[9].empty() ? std::numeric_limits<double>::infinity() : std::stod(cells[9]);
        const bool holds = std::stod(cells[8]) <= 2.5e-4 && 2.5e-4 <= most;
        (cells[3] == "0" ? withoutContact[std::stoi(cells[0])] : withoutContact[-1]) += 1;
        motions[std::stoi(cells[0])] += cells[3] == "1" && holds ? 1 : 0;
    }
    for (const json& frequency : answer["frequencies"]) {
        const int n = frequency["steps"];
        CHECK(motions[n] == frequency["motions"].size());
        CHECK(withoutContact[n] == 1);
    }
    // Every row of the backbone is a motion that `mode` has.
    std::istringstream backbone(contentOf(program.file("b.csv")));
    std::getline(backbone, line);
    CHECK(line ==
          "a4,b,family,frequency_ratio,frequency,period_ratio,energy_ratio,impulse,peak_force,"
          "tip_lowest");
    int rows = 0;
    while (std::getline(backbone, line)) {
        const std::vector<std::string> cells = cellsOf(line);
        REQUIRE(cells.size() == 10);
        CHECK(std::stod(cells[3]) * std::stod(cells[5]) == Approx(4.0));
        if (rows++ % 100 == 0) {
            const json mode = parsed(program, "mode " + cells[0] + " " + cells[1] + " --period " +
                                                  cells[5] + " --quiet");
            CHECK(mode["energy_ratio"].get<double>() == Approx(std::stod(cells[6])));
            CHECK(mode["physical"]["impulse"].get<double>() == Approx(std::stod(cells[7])));
        }
    }
    CHECK(rows > 100);
}

TEST_CASE("cli find, forced: equal segments are the uniform bar, with its proofs and its scenes",
          "[glpk]")
{
    const CommandLine program;
    const std::string force = " --damping 0.05 --force tip";
    const json whole = parsed(program, "find 12 8 --cells 10" + force, 1);
    const json parts = parsed(program, "find 12 8 --segments 5:1,5:1" + force, 1);
    CHECK(parts["status"] == "none");
    CHECK(parts["reason"] == whole["reason"]);
    CHECK(parts["certificate"] == whole["certificate"]);
    CHECK(parts["segments"].size() == 2);
    const std::string pressed = " --gap -1e-3 --second-stop 3e-3" + force;
    CHECK(parsed(program, "find 15 10 --segments 4:2,6:2" + pressed)["amplitude_range"] ==
          parsed(program, "find 15 10 --cells 10" + pressed)["amplitude_range"]);
}

TEST_CASE("cli simulate: a motion that grows has not settled, whatever its tip does")
{
    // At resonance the tip passes through 0 at the end of every period; 400 periods later it
    // meets the wall.
    const CommandLine program;
    const std::string call =
        "simulate --rest --damping 0.001 --force tip --frequency 1 "
        "--periods 200 --amplitude ";
    for (const char* amplitude : {"3e-6", "2e-6"}) {
        const json answer = parsed(program, call + amplitude);
        CHECK(answer["settled"].is_null());
        CHECK(answer["why"].is_string());
    }
}

TEST_CASE("cli simulate: without a gap what happens does not depend on the size of the force")
{
    const CommandLine program;
    for (const double scale : {1e-9, 1e-5, 1.0, 1e9}) {
        const json answer =
            parsed(program, fmt::format("simulate --rest --cells 16 --damping 0.05 --force tip "
                                        "--frequency 0.9556 --phase 4.693 --gap 0 --periods 1500 "
                                        "--resolve 1e-9 --amplitude {}",
                                        2.653 * scale));
        INFO(scale);
        REQUIRE(answer["settled"].is_object());
        CHECK(answer["settled"]["periods"] == 7);
        CHECK(answer["settled"]["contacts"] == 10);
        CHECK(answer["settled"]["impulse"].get<double>() == Approx(41.4609 * scale).epsilon(1e-5));
    }
}

TEST_CASE("cli simulate: contact times that waver in their last digit have settled")
{
    // Changes of 1e-8 .. 1e-6 of the state, the root of the rounding of contact times, come and go.
    const CommandLine program;
    for (const char* scene : {
             "--cells 23 --damping 0.1007 --amplitude 0.00109641 --frequency 1.2002 --phase 0.402",
             "--cells 21 --damping 0.1150 --amplitude 0.00135559 --frequency 1.2682 --phase 3.316",
             "--cells 20 --damping 0.0650 --amplitude 0.000257643 --frequency 1.0561 --phase 4.309",
         }) {
        const json answer =
            parsed(program, fmt::format("simulate --rest --force tip --periods 3000 {}", scene));
        INFO(scene << answer["why"]);
        REQUIRE(answer["settled"].is_object());
        CHECK(answer["settled"]["periods"] == 1);
        CHECK(answer["settled"]["contacts"] == 1);
    }
}

TEST_CASE("cli simulate: a base may start anywhere")
{
    const CommandLine program;
    const json answer = parsed(program,
                               "simulate --rest --damping 0.05 --force base "
                               "--amplitude 2e-3 --frequency 0.7 --periods 20");
    CHECK(answer["contacts"].get<int>() > 0);
    CHECK(std::abs(answer["balance"]["error"].get<double>()) < 1e-15);
}
