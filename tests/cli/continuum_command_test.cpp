// signorini continuum: the curve in JSON, text, tables and figures, and what ends it.

#include <fstream>

#include "command_line.hpp"
#include "solver.hpp"

using namespace signorini::test;

TEST_CASE("cli: continuum in JSON, every field of the contract, and its table")
{
    const CommandLine program;
    const auto outcome =
        program.run("continuum 150 900 --energy-ratio 20 --points 5 --csv k.csv --format json");
    REQUIRE(outcome.status == 0);
    const json r = json::parse(outcome.out);
    CHECK(r["status"] == "found");
    CHECK(r["schema"] == 2);
    CHECK(r["version"].is_string());
    CHECK(r["cells"] == 300);
    CHECK(r["schedule"] == json({{150, 900}}));
    CHECK(r["bar"]["gap"] == 1e-3);
    CHECK(r["energy_ratio"] == 20.0);
    CHECK(r["connected"] == true);
    CHECK(r["dimension"] == 148);
    REQUIRE(r["points"].size() == 5);
    CHECK(r["parameter"] == "pause");
    CHECK(r["points"][0]["lambda"] == 0.0);
    CHECK(r["points"][4]["lambda"].get<double>() == Approx(0.4));
    CHECK(r["orbits"] == 5);
    for (const json& point : r["points"]) {
        CHECK(std::abs(point["energy_ratio"].get<double>() / 20.0 - 1.0) < 1e-12);
        CHECK(point["residual"].get<double>() < 1e-12);
        CHECK(point["peak_strain"].get<double>() > 0.0);
    }
    const std::string table = contentOf(program.file("k.csv"));
    CHECK(table.starts_with("lambda,a_1,a_2,"));
    CHECK(lines(table) == 6);
    CHECK(std::count(table.begin(), table.end(), ',') == 6 * 600);
}

TEST_CASE("cli: continuum joins two states of files, or proves that it cannot")
{
    const CommandLine program;
    const std::string small = " --cells 12 --gap 0.01";
    REQUIRE(program.run("find 6 36 --energy-ratio 8 --state from.csv" + small).status == 0);
    REQUIRE(program.run("find 6 36 --energy-ratio 16 --state high.csv" + small).status == 0);
    const auto joined = program.run(
        "continuum 6 36 --energy-ratio 8 --from from.csv --to from.csv --points 3" + small);
    CHECK(joined.status == 0);
    CHECK_THAT(joined.out, containsText("connected   yes"));
    const auto wrong =
        program.run("continuum 6 36 --energy-ratio 8 --from from.csv --to high.csv" + small);
    CHECK(wrong.status == 2);
    CHECK_THAT(wrong.err, containsText("to = a motion") && containsText("E/E_1 = 8"));
    // Two random members share their dominant amplitude, one of six, or not.
    int apart = 0;
    for (int seed = 1; seed <= 8; ++seed) {
        const auto outcome = program.run("continuum 6 36 --energy-ratio 16 --points 3 --seed " +
                                         std::to_string(seed) + small);
        CHECK_THAT(outcome.out, containsText("6 components") && containsText("connected   no"));
        if (outcome.status == 1) {
            ++apart;
            CHECK_THAT(outcome.out, containsText("different components"));
        }
    }
    CHECK(apart > 0);
}

TEST_CASE("cli: one member of a continuum, exactly at the lambda asked for")
{
    const CommandLine program;
    const std::string call = "continuum 150 900 --energy-ratio 20 --points 3 --format json";
    const auto outcome = program.run(call + " --member 0.137 --state m.csv");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    const json r = json::parse(outcome.out);
    CHECK(r["member"]["exact"] == true);
    CHECK(r["member"]["lambda"] == 0.137);
    CHECK(r["member"]["energy_ratio"].get<double>() == Approx(20.0).epsilon(1e-12));
    CHECK(r["points"].size() == 3);
    // It is a motion: the nearest one is itself.
    const json found = program.find("150 900 --objective nearest --target m.csv", 0);
    CHECK(found["distance"].get<double>() < 1e-7);
    CHECK(found["target"] == "waves a, b in 300 rows, one per cell");

    const auto path = program.run(
        "continuum 150 900 --energy-ratio 20 --points 3 --seed 4 "
        "--format json --member 0.5 --state n.csv");
    REQUIRE(path.status == 0);
    CHECK(json::parse(path.out)["member"]["exact"] == false);

    for (const auto& [arguments, text] :
         {std::pair{" --member 0.41 --state o.csv", "member = 0.41"},
          std::pair{" --member -0.1 --state o.csv", "member = -0.1"},
          std::pair{" --member 0.1", "--member and --state"},
          std::pair{" --state o.csv", "--member and --state"},
          std::pair{" --member x --state o.csv", "--member = x"}}) {
        const auto wrong = program.run(call + arguments);
        INFO(arguments << "\n" << wrong.err);
        CHECK(wrong.status == 2);
        CHECK(lines(wrong.err) == 1);
        CHECK_THAT(wrong.err, containsText(text));
    }
    CHECK(program.files() == 2);
}

TEST_CASE("cli: the text of a continuum says how many motions there are")
{
    const CommandLine program;
    const auto split = program.run("continuum 150 900 --energy-ratio 20 --points 4");
    CHECK_THAT(split.out, containsText("split pulse, λ = pause between the two pulses") &&
                              containsText("all different motions"));
    const auto spikes = program.run("continuum 150 900 --energy-ratio 600");
    CHECK_THAT(spikes.out, containsText("orbits      1 different motion:"));
}

TEST_CASE("cli: continuum outside the range is exit status 1 with the range, and no file")
{
    const CommandLine program;
    for (const char* energy : {"3.99999", "600.001", "1e300"}) {
        const auto outcome =
            program.run(std::string("continuum 150 900 --csv k.csv --energy-ratio ") + energy +
                        " --format json");
        CHECK(outcome.status == 1);
        const json r = json::parse(outcome.out);
        CHECK(r["status"] == "none");
        CHECK(r["reason"] == "constraints");
        CHECK_THAT(r["detail"].get<std::string>(), containsText("[4, 600]"));
        CHECK(r["points"].empty());
        CHECK(r["components"] == 0);
        CHECK(r["dimension"].is_null());
    }
    CHECK(program.run("continuum 2 4 --cells 2 --energy-ratio 4").status == 1);
    CHECK(program.files() == 0);
}

TEST_CASE("cli: a wrong call of continuum is exit status 2, one line, and no file")
{
    const CommandLine program;
    for (const auto& [arguments, text] :
         {std::pair{"150 900", "--energy-ratio is missing"},
          std::pair{"150 900 --energy-ratio 0", "--energy-ratio = 0"},
          std::pair{"150 900 --energy-ratio nan", "--energy-ratio = nan"},
          std::pair{"150 --energy-ratio 20", "NC NF"},
          std::pair{"150 900 --energy-ratio 20 --points 1", "--points = 1"},
          std::pair{"150 900 --energy-ratio 20 --seed -1", "seed"},
          std::pair{"150 900 --energy-ratio 20 --engine magic", "--engine = magic"},
          std::pair{"150 900 --energy-ratio 20 --from a.csv", "--from"},
          std::pair{"150 900 --energy-ratio 20 --direction a.csv", "--direction"},
          std::pair{"150 900 --energy-ratio 20 --sample --from a.csv --to a.csv", "--sample"},
          std::pair{"150 900 --energy-ratio 20 --sample --engine ipopt", "engine"},
          std::pair{"150 900 --energy-ratio 20 --figure a.gif", "a.gif"},
          std::pair{"150 900 --energy-ratio 20 --csv a.png --figure ./a.png", "two different"}}) {
        const auto outcome = program.run(std::string("continuum ") + arguments);
        INFO(arguments << "\n" << outcome.err);
        CHECK(outcome.status == 2);
        CHECK(lines(outcome.err) == 1);
        CHECK(outcome.out.empty());
        CHECK_THAT(outcome.err, containsText(text));
    }
    CHECK(program.files() == 0);
    CHECK(program.run("continuum 150 900 --energy-ratio 20 --from no.csv --to no.csv").status == 4);
}

TEST_CASE("cli: an interrupted continuum reports what it found, and leaves a file as it was")
{
    const CommandLine program;
    std::ofstream(program.file("k.csv")) << "old\n";
    const auto outcome = program.run(
        "continuum 150 900 --energy-ratio 20 --points 1000000 --csv k.csv "
        "--format json",
        "timeout -s INT 0.5");
    // timeout itself answers 124; what the program wrote counts.
    const json r = json::parse(outcome.out);
    CHECK(r["status"] == "undecided");
    CHECK_THAT(r["detail"].get<std::string>(), containsText("interrupted after"));
    CHECK(!r["points"].empty());
    CHECK(contentOf(program.file("k.csv")) == "old\n");
    CHECK(program.files() == 1);
    CHECK_THAT(outcome.err, containsText("no file was written"));
}

TEST_CASE("cli: continuum: who traces may be named as an engine or as a back end")
{
    const CommandLine program;
    const auto traced = [&program](const std::string& engine) {
        const auto outcome = program.run(
            "continuum 6 36 --cells 12 --energy-ratio 8 --points 5 --format json --engine " +
            engine);
        INFO(engine << "\n" << outcome.err);
        CHECK(outcome.status == 0);
        return outcome.out;
    };
    CHECK(traced("closed-form") == traced("geometric"));
    CHECK(json::parse(traced("closed-form"))["engine"] == "geometric");
    if (signorini::findBackend("nlopt-auglag").available()) {
        CHECK(traced("nlopt-auglag") == traced("nlopt"));
        CHECK(json::parse(traced("nlopt"))["engine"] == "nlopt");
        CHECK(json::parse(traced("nlopt-slsqp"))["engine"] == "nlopt-slsqp");
    }
}

TEST_CASE("cli: continuum draws its figure")
{
    const CommandLine program;
    const auto outcome =
        program.run("continuum 6 36 --cells 12 --energy-ratio 8 --figure k.svg --quiet");
    if (outcome.status == 4) {
        return;  // no gnuplot here
    }
    CHECK(outcome.status == 0);
    const std::string figure = contentOf(program.file("k.svg"));
    for (const char* label : {"strain", "velocity", "position", "time", "displacement", "E/E"}) {
        CHECK_THAT(figure, containsText(label));
    }
}

TEST_CASE("cli: continuum: motions spread over the set, and a walk in a direction")
{
    const CommandLine program;
    const auto sampled = program.run(
        "continuum 150 900 --energy-ratio 20 --sample --points 10 --csv members.csv --format json");
    REQUIRE(sampled.status == 0);
    const json members = json::parse(sampled.out);
    CHECK(members["points"].size() == 10);
    CHECK(members["parameter"] == "number");
    CHECK(lines(contentOf(program.file("members.csv"))) == 11);

    REQUIRE(program.run("find 6 36 --cells 12 --energy-ratio 8 --state from.csv").status == 0);
    REQUIRE(program.run("find 6 36 --cells 12 --state towards.csv").status == 0);
    const auto walked = program.run(
        "continuum 6 36 --cells 12 --energy-ratio 8 --from from.csv --direction towards.csv "
        "--format json");
    REQUIRE(walked.status == 0);
    CHECK(json::parse(walked.out)["points"].size() >= 1);
}

TEST_CASE("cli: continuum of several bars: a sample, paths through files, a table, pictures",
          "[glpk]")
{
    const CommandLine program;
    const std::string asked =
        "continuum 1:6 -:40 --scene 'clamp 12 gap=1e-3 16 clamp' --length 2 --energy-ratio 8 ";
    const auto sampled = program.run(
        asked + "--sample --points 6 --format json --csv s.csv --figure s.svg --animate s.gif");
    REQUIRE(sampled.status == 0);
    const json r = json::parse(sampled.out);
    CHECK(r["parameter"] == "number");
    CHECK(r["dimension"] == 4);
    CHECK(r["connected"].is_null());
    CHECK(r["schedule"] ==
          json::parse(R"([{"closed": [1], "steps": 6}, {"closed": [], "steps": 40}])"));
    REQUIRE(r["points"].size() == 6);
    for (const json& point : r["points"]) {
        CHECK(point["energy_ratio"].get<double>() == Approx(8.0));
        CHECK(point["energy"].get<double>() ==
              Approx(8.0 * r["reference"]["energy"].get<double>()));
        CHECK(point["residual"].get<double>() < 1e-7);
        CHECK(point["peak_strain"] == point["strains"]["peak_compression"]);
        CHECK(point["contacts"][0]["impulse"].get<double>() > 0.0);
    }
    const std::string table = contentOf(program.file("s.csv"));
    CHECK(table.starts_with("lambda,wave_1,wave_2,"));
    CHECK(table.find("wave_56,displacement_1,") != std::string::npos);
    CHECK(lines(table) == 7);
    CHECK_THAT(contentOf(program.file("s.svg")), containsText("force of contact 1"));
    for (const int k : {1, 4}) {
        REQUIRE(program
                    .run(asked + "--sample --points 6 --member " + std::to_string(k) + " --state " +
                         std::to_string(k) + ".csv")
                    .status == 0);
    }
    // The file of a member is one of find's, too: the nearest motion to it is itself.
    const auto same = program.run(
        "find 1:6 -:40 --scene 'clamp 12 gap=1e-3 16 clamp' --length 2 --objective nearest "
        "--target 4.csv --format json");
    REQUIRE(same.status == 0);
    CHECK(json::parse(same.out)["energy_ratio"].get<double>() == Approx(8.0));
    const auto wrong = program.run(asked + "--from 1.csv --to 4.csv --strain-limit 1e-3");
    CHECK(wrong.status != 0);
    const auto otherEnergy = program.run(
        "continuum 1:6 -:40 --scene 'clamp 12 gap=1e-3 16 clamp' --length 2 --energy-ratio 9 "
        "--from 1.csv --to 4.csv");
    CHECK(otherEnergy.status == 2);
    CHECK_THAT(otherEnergy.err, containsText("from = a state of 0.888888889 times the energy"));
    const auto low = program.run(
        "continuum 1:6 -:40 --scene 'clamp 12 gap=1e-3 16 clamp' --energy-ratio 5 --csv no.csv");
    CHECK(low.status == 1);
    CHECK_THAT(low.out, containsText("every motion of the schedule has more energy") &&
                            containsText("proved: none has less than 5.24"));
    CHECK_THAT(low.err, containsText("no motion to write"));
    CHECK(program.run(asked + "--engine geometric").status == 2);
    for (const char* call : {"continuum 6 36 --cells 12 --energy-ratio 9",
                             "continuum 6 36 --segments 6:1,6:1 --energy-ratio 9"}) {
        const auto engine = program.run(std::string(call) + " --engine glpk-simplex");
        CHECK(engine.status == 2);
        CHECK_THAT(engine.err, containsText("--engine = glpk-simplex is out of range"));
    }
    if (signorini::preferred({.energyEquality = true, .start = true}) == nullptr) {
        return;
    }
    const auto path = program.run(asked + "--from 1.csv --to 4.csv --points 21");
    CHECK(path.status == 0);
    CHECK_THAT(path.out, containsText("connected   yes") && containsText("arc length [√E₁]"));
    const auto way = program.run(asked + "--from 1.csv --direction 4.csv --points 21");
    CHECK(way.status == 0);
    CHECK_THAT(way.out, containsText("walk in a given direction"));
}

TEST_CASE("cli: continuum of segments and of a bar under gravity", "[glpk]")
{
    const CommandLine program;
    const auto one = json::parse(
        program.run("continuum 6 36 --cells 12 --energy-ratio 9 --sample --points 3 --format json")
            .out);
    const auto two = json::parse(
        program
            .run("continuum 6 36 --segments 6:1,6:1 --energy-ratio 9 --sample --points 3 "
                 "--format json")
            .out);
    // A bar of 1 m that sags by 2e-4 m of its gap.
    const auto sagging = json::parse(
        program
            .run("continuum 6 36 --cells 12 --gap 1.2e-3 --gravity 4e-4 --energy 4.5e-6 --sample "
                 "--points 3 --format json")
            .out);
    for (const json& answer : {two, sagging}) {
        CHECK(answer["status"] == "found");
        CHECK(answer["dimension"] == one["dimension"]);
        for (const json& point : answer["points"]) {
            CHECK(point["energy"].get<double>() == Approx(4.5e-6));
            CHECK(point["contacts"][0]["impulse"].get<double>() ==
                  Approx(one["points"][0]["physical"]["impulse"].get<double>()));
        }
    }
    // The state of a bar of segments, as find writes it, is an end.
    REQUIRE(program.run("find 6 36 --segments 6:1,6:2 --state least.csv").status == 0);
    const auto curve = program.run(
        "continuum 6 36 --segments 6:1,6:2 --from least.csv --to least.csv --points 3 --energy 1");
    CHECK(curve.status == 2);
    CHECK_THAT(curve.err, containsText("from = a state of") && containsText("times the energy"));
    // A bar in the words of a scene, with its schedule in either way.
    for (const char* call :
         {"6 36 --scene 'clamp 12 stop=1e-3'", "1:6 -:36 --scene 'clamp 12 stop=1e-3'",
          "6 36 --scene 'clamp 6:1 6:1 stop=1e-3'", "1:6 -:36 --scene 'clamp 5:1 7:2 stop=1e-3'"}) {
        const auto answer =
            program.run(std::string("continuum ") + call + " --energy-ratio 9 --sample --points 2");
        INFO(call << answer.err);
        CHECK(answer.status < 2);
    }
    const auto words = program.run("continuum 2:6 -:36 --segments 6:1,6:2 --energy-ratio 200");
    CHECK(words.status == 2);
    CHECK_THAT(words.err, containsText("allowed"));
}
