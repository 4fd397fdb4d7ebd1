// signorini find --segments: bars of several segments.

#include "program.hpp"
#include "solver.hpp"

using namespace signorini::test;

namespace {

}  // namespace

TEST_CASE("cli stepped: a motion, its segments and its cells, which are those of all segments",
          "[glpk][ipopt]")
{
    const Program program;
    const json r = program.find("3 25 --segments 4:1,4:1.3", 0);
    CHECK(r["cells"] == 8);
    CHECK(r["kernel_dimension"] == 3);
    CHECK(r["objective"] == "min-energy");
    CHECK(r["energy_ratio"].get<double>() == Approx(15.807707).epsilon(1e-6));
    CHECK(r["segments"][1] ==
          json{{"cells", 4}, {"impedance", 1.3}, {"speed", 1.0}, {"dashpot", 0.0}});
    CHECK_THAT(r["route"].get<std::string>(), containsText("kernel"));

    const json none = program.find("3 12 --segments 4:1,4:1.3", 1);
    CHECK(none["certificate"]["rows"] == "joints");
    CHECK(none["certificate"]["verified"] == true);
    CHECK(none["certificate"]["equalities"][0][1].is_string());
    const auto text = program.run("find 3 12 --segments 4:1,4:1.3");
    CHECK_THAT(text.out, containsText("of the joints formulation"));
}

TEST_CASE("cli stepped: speeds make the bar longer or shorter, not the motion another one",
          "[glpk][ipopt]")
{
    const Program program;
    const json same = program.find("1 30 --segments 4:1,4:1.3", 0);
    const json fast = program.find("1 30 --segments 4:1,4:1.3:3", 0);
    CHECK(fast["energy_ratio"].get<double>() ==
          Approx(same["energy_ratio"].get<double>()).epsilon(1e-9));
    // L = 1 m is (4 + 12)/8 times a bar of the first material: half the travel time, E_1 twice.
    CHECK(fast["period"].get<double>() == Approx(0.5 * same["period"].get<double>()));
    CHECK(fast["energy"].get<double>() == Approx(2.0 * same["energy"].get<double>()));
}

TEST_CASE("cli stepped: the motion is drawn with its joints, and written", "[glpk][ipopt]")
{
    const Program program;
    const auto drawn = program.run(
        "find 3 25 --segments 4:1,4:1.3 --figure m.svg --motion m.csv --state s.csv --quiet");
    INFO(drawn.err);
    REQUIRE(drawn.status == 0);
    CHECK(fs::file_size(program.file("m.svg")) > 1000);
    CHECK(lines(contentOf(program.file("s.csv"))) == 9);
}

TEST_CASE("cli stepped: a call that cannot be meant is refused by name")
{
    const Program program;
    const auto refuses = [&](const std::string& words, const std::string& part) {
        const auto outcome = program.run(words);
        INFO(words << "\n" << outcome.err);
        CHECK(outcome.status == 2);
        CHECK_THAT(outcome.err, containsText(part));
        CHECK(lines(outcome.err) == 1);
    };
    refuses("find 3 25 --segments 4", "CELLS:IMPEDANCE[:SPEED");
    refuses("find 3 25 --segments 4:0,4:1", "--segments");
    refuses("find 3 25 --segments 4:1,4:1.3 --cells 9", "cells of all segments = 8");
    refuses("find 3 25 --segments 4:1,4:1.3 --strain-limit 1", "for a bar of several segments");
    refuses("find 3 25 --segments 4:1,4:1.3:2 --figure m.svg", "one speed");
    refuses("find --frequency 8/7 --segments 4:1,4:1.3", "--segments");
    refuses("simulate --segments 4:1,4:1.3 --time 1", "--segments");
    refuses("atlas --database a.sqlite --segments 4:1,4:1.3", "--segments");
    refuses("response --damping 0.1 --force tip --amplitude 1e-4 --segments 4:1,4:1.3",
            "--segments");
    CHECK(program.files() == 0);
}
