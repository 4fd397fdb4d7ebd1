// The program as people and scripts meet it: exit status, stdout, stderr, files.

#include <filesystem>
#include <fstream>

#include "program.hpp"
#include "solver.hpp"

using namespace signorini::test;

TEST_CASE("cli: the paper's case in JSON, every field of the contract")
{
    const Program program;
    const json r = program.find("150 900", 0);
    CHECK(r["status"] == "found");
    CHECK(r["cells"] == 300);
    CHECK(r["schedule"] == json({{150, 900}}));
    CHECK(r["period"] == 3.5);
    CHECK(r["frequency_ratio"] == 8.0 / 7.0);
    CHECK(r["kernel_dimension"] == 150);
    CHECK(r["solution_set"] == json({{"kind", "simplex"}, {"dimension", 149}}));
    CHECK(r["contact"] == "pressing");
    CHECK(r["canonical_schedule"] == json({{150, 900}}));
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
    const Program program;
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
    const Program program;
    const json two = program.find("1 12 3 12 --cells 4", 0);
    CHECK(two["solution_set"] == json{{"kind", "simplex"}, {"dimension", 2}});
    CHECK(two["energy_ratio"].get<double>() == Approx(16.0 / 3.0));
    CHECK(two["energy_ratio_range"][1] == 8.0);
    CHECK(two["pressing_phases"] == json{true, true});
    CHECK(two["canonical_schedule"] == two["schedule"]);
    CHECK(two["route"] == "lumped");
    CHECK(two["solver"]["name"] == "closed-form");
    const json twice = program.find("1 9 1 9 --cells 3", 0);
    CHECK(twice["canonical_schedule"] == json::array({{1, 9}}));
    CHECK(twice["repetitions"] == 2);
    const json touching = program.find("2 3 1 29 --cells 10", 0);
    CHECK(touching["pressing_phases"] == json{true, false});
    const json none = program.find("1 1 1 1 --cells 4", 1);
    CHECK(none["certificate"]["verified"] == true);
    CHECK(none["solution_set"]["kind"] == "empty");
    CHECK_THAT(program.run("find 1 9 1 9 --cells 3").out, containsText("2 times over"));
    CHECK_THAT(program.run("find 2 3 1 29 --cells 10").out, containsText("without force: 2"));
}

TEST_CASE("cli: undecided is exit status 3 and says why")
{
    if (!signorini::findBackend("glpk-simplex").available()) {
        return;
    }
    const Program program;
    const json r = program.find(
        "1500 12000 --cells 3000 --solver glpk-simplex --formulation state --time-limit 0.001", 3);
    CHECK(r["status"] == "undecided");
    CHECK_THAT(r["detail"].get<std::string>(), containsText("limit"));
}

TEST_CASE("cli: text is for people and goes to stdout, nothing to stderr")
{
    const Program program;
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
        {"", "even number"},
        {"99999999999999999999 3", "99999999999999999999"},
        {"4611686018427387904 4611686018427387904", "sum of all steps"},
        {"3 9 --cells 0", "--cells = 0"},
        {"3 9 --cells 100000001", "100000000"},
        {"3 9 --cells 3.5", "--cells = 3.5"},
        {"3 9 --gap nan", "--gap = nan"},
        {"3 9 --gap inf", "--gap = inf"},
        {"3 9 --gap -1", "--gap = -1"},
        {"3 9 --gap 0", "--gap = 0"},
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
        {"3 9 --tip-floor 0.001", "tipFloor = 0.001"},
        {"3 9 --objective nearest", "--target"},
        {"3 9 --target s.csv", "--objective"},
        {"3 9 --objective min-energy --energy-ratio 9", "objective = min-energy"},
        {"3 9 --axial-stiffness 1e308 --gap 1", "axialStiffness"},
        {"3 9 --figure a.gif", "a.gif"},
        {"3 9 --motion a.txt", "a.txt"},
        {"3 9 --state a.csv --motion a.csv", "a.csv"},
        {"3 9 --state a.csv --motion ./a.csv", "a.csv"},
        {"150 900 --state a.csv --gap -1", "--gap"},
    }));
    const Program program;
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
    const Program program;
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
    const Program program;
    CHECK(program.run("").status == 2);
    CHECK(program.run("fly").status == 2);
    CHECK_THAT(program.run("fly").err, containsText("fly"));
    CHECK(lines(program.run("fly").err) == 1);
}

TEST_CASE("cli: help and version succeed; the version lists every back end")
{
    const Program program;
    CHECK(program.run("--help").status == 0);
    CHECK_THAT(program.run("find --help").out, containsText("--figure"));
    const auto version = program.run("--version");
    CHECK(version.status == 0);
    for (const signorini::Backend& backend : signorini::backends()) {
        CHECK_THAT(version.out, containsText(std::string(backend.name)));
    }
}

TEST_CASE("cli: files are written whole, together, and replace old ones")
{
    const Program program;
    std::ofstream(program.file("state.csv")) << "old";
    const auto outcome = program.run(
        "find 5 23 --cells 8 --state state.csv --motion motion.csv --figure figure.svg");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(program.files() == 3);
    CHECK_THAT(contentOf(program.file("state.csv")),
               containsText("x,a,b,velocity,strain,displacement\n"));
    CHECK(lines(contentOf(program.file("state.csv"))) == 9);
    CHECK(lines(contentOf(program.file("motion.csv"))) == 1 + 29 * 9);
    CHECK_THAT(contentOf(program.file("figure.svg")), containsText("</svg>"));
    CHECK(program.run("find 5 23 --cells 8 --motion m.vtk").status == 0);
    CHECK_THAT(contentOf(program.file("m.vtk")), containsText("RECTILINEAR_GRID"));
}

TEST_CASE("cli: without a motion no file is written, and old ones stay")
{
    const Program program;
    std::ofstream(program.file("state.csv")) << "old";
    const auto outcome = program.run("find 2 4 --cells 2 --state state.csv --figure f.png");
    CHECK(outcome.status == 1);
    CHECK_THAT(outcome.err, containsText("no file was written"));
    CHECK(contentOf(program.file("state.csv")) == "old");
    CHECK(program.files() == 1);
}

TEST_CASE("cli: files that cannot be written are exit status 4, and nothing is left behind")
{
    const Program program;
    for (const char* arguments :
         {"--state /no/such/folder/x.csv", "--state .", "--state /dev/full",
          "--motion good.csv --state /dev/full", "--figure /no/such/folder/x.png"}) {
        const auto outcome = program.run(std::string("find 5 23 --cells 8 ") + arguments);
        INFO(arguments << " -> " << outcome.err);
        CHECK(outcome.status == 4);
        CHECK(outcome.out.empty());
        CHECK(lines(outcome.err) == 1);
        CHECK(program.files() == 0);
    }
    const auto full = program.run("find 5 23 --cells 8 >/dev/full; exit $?; #");
    CHECK(full.status == 4);
}

TEST_CASE("cli: a file size limit is a full disk: exit status 4 and nothing left behind")
{
    const Program program;
    for (const char* arguments : {"find 150 900 --figure f.svg", "find 150 900 --figure f.png",
                                  "find 150 900 --state s.csv", "find 150 900 --motion m.vtk"}) {
        const auto outcome = program.run(arguments, "ulimit -f 16;");
        INFO(arguments << " -> " << outcome.err);
        CHECK(outcome.status == 4);
        CHECK(program.files() == 0);
    }
}

TEST_CASE("cli: links are followed, modes kept, read-only and looping targets refused")
{
    const Program program;
    std::ofstream(program.file("private.csv")) << "old";
    fs::permissions(program.file("private.csv"), fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("private.csv", program.file("link.csv"));
    fs::create_symlink("new.csv", program.file("dangling.csv"));
    fs::create_symlink("loop2.csv", program.file("loop1.csv"));
    fs::create_symlink("loop1.csv", program.file("loop2.csv"));
    CHECK(program.run("find 5 23 --cells 8 --state link.csv").status == 0);
    CHECK(fs::is_symlink(program.file("link.csv")));
    CHECK(lines(contentOf(program.file("private.csv"))) == 9);
    CHECK(fs::status(program.file("private.csv")).permissions() ==
          (fs::perms::owner_read | fs::perms::owner_write));
    CHECK(program.run("find 5 23 --cells 8 --state dangling.csv").status == 0);
    CHECK(lines(contentOf(program.file("new.csv"))) == 9);
    CHECK(program.run("find 5 23 --cells 8 --state loop1.csv").status == 4);
    CHECK(program.run("find 5 23 --cells 8 --figure f.svg", "TMPDIR=/no/such/folder").status == 4);
}

TEST_CASE("cli: standard output is for the report alone")
{
    const Program program;
    CHECK(program.run("find 5 23 --cells 8 --state /dev/stdout").status == 2);
    CHECK(program.run("--version >/dev/full; exit $?; #").status == 4);
    const auto large =
        program.run("find 2000 10901 --cells 4000 --format json >/dev/full; exit $?; #");
    CHECK(large.status == 4);
}

TEST_CASE("cli: a signal removes what was begun")
{
    const Program program;
    const auto outcome =
        program.run("find 1 39999999 --cells 10000000 --state s.csv", "timeout --signal=INT 0.7");
    if (outcome.status == 0) {
        return;  // a machine fast enough to finish first
    }
    CHECK(program.files() == 0);
}

TEST_CASE("cli: the nearest motion to a state file is found, wrong files are refused")
{
    const Program program;
    REQUIRE(program.run("find 5 23 --cells 8 --objective max-energy --state target.csv").status ==
            0);
    const json r = program.find("5 23 --cells 8 --objective nearest --target target.csv", 0);
    CHECK(r["energy_ratio"].get<double>() == Approx(16.0).epsilon(1e-12));
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
    const Program program;
    const json energy = program.find("150 900 --energy-ratio 20", 0);
    CHECK(energy["energy_ratio"].get<double>() == Approx(20.0).epsilon(1e-12));
    const json outside = program.find("150 900 --energy-ratio 3.9", 1);
    CHECK(outside["reason"] == "constraints");
    CHECK(outside["certificate"] == json{{"kind", "energy-range"}, {"verified", true}});
    // The upper end of several phases rests on vertices that nothing else has checked.
    const json above = program.find("1 7 1 7 --cells 2 --energy-ratio 13", 1);
    CHECK(above["certificate"]["verified"] == false);
    CHECK(above["certificate"]["note"].is_string());
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
    const Program program;
    const auto outcome =
        program.run("find 5 23 --cells 8 --state s.csv --figure f.svg", "PATH=/nowhere");
    CHECK(outcome.status == 4);
    CHECK_THAT(outcome.err, containsText("gnuplot"));
    CHECK(program.files() == 0);
}

TEST_CASE("cli: steel in SI units gives the same energy ratio")
{
    const Program program;
    const json r = program.find("150 900 --young 210e9 --density 7800 --area 1e-4 --gap 1e-6", 0);
    CHECK(r["energy_ratio"].get<double>() == Approx(4.0).epsilon(1e-12));
    CHECK(r["period"].get<double>() == Approx(3.5 / 5188.7449).epsilon(1e-6));
}

TEST_CASE("cli: a million cells stay under three states of memory")
{
    const Program program;
    const auto outcome = program.run("find 500000 3000000 --cells 1000000 --quiet");
    REQUIRE(outcome.status == 0);
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
#if !defined(__SANITIZE_ADDRESS__)
    const double stateKilobytes = 2e6 * sizeof(double) / 1024.0;
    CHECK(static_cast<double>(usage.ru_maxrss) < 3.0 * stateKilobytes);
#endif
}

TEST_CASE("cli: a certificate that is called verified is printed whole, however long")
{
    const json r = Program().find("1 400001 --cells 200000", 1);
    CHECK(r["certificate"]["verified"] == true);
    for (const char* rows : {"periodicity", "pressure", "penetration"}) {
        CHECK(r["certificate"][rows].is_array());
    }
    CHECK(r["certificate"]["periodicity"].size() > 100'000);
    CHECK(r["solution_set"] == json{{"kind", "empty"}, {"dimension", nullptr}});
}

TEST_CASE("cli: continuum in JSON, every field of the contract, and its table")
{
    const Program program;
    const auto outcome =
        program.run("continuum 150 900 --energy-ratio 20 --points 5 --csv k.csv --format json");
    REQUIRE(outcome.status == 0);
    const json r = json::parse(outcome.out);
    CHECK(r["status"] == "found");
    CHECK(r["energy_ratio"] == 20.0);
    CHECK(r["connected"] == true);
    CHECK(r["dimension"] == 148);
    REQUIRE(r["points"].size() == 5);
    CHECK(r["points"][0]["lambda"] == 15.0);
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
    const Program program;
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

TEST_CASE("cli: continuum outside the range is exit status 1 with the range, and no file")
{
    const Program program;
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
    }
    CHECK(program.run("continuum 2 4 --cells 2 --energy-ratio 4").status == 1);
    CHECK(program.files() == 0);
}

TEST_CASE("cli: a wrong call of continuum is exit status 2, one line, and no file")
{
    const Program program;
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

TEST_CASE("cli: an interrupted continuum reports and writes what it found")
{
    const Program program;
    const auto outcome = program.run(
        "continuum 150 900 --energy-ratio 20 --points 1000000 --csv k.csv "
        "--format json",
        "timeout -s INT 0.5");
    // timeout itself answers 124; what the program wrote counts.
    const json r = json::parse(outcome.out);
    CHECK(r["status"] == "undecided");
    CHECK_THAT(r["detail"].get<std::string>(), containsText("interrupted after"));
    CHECK(!r["points"].empty());
    CHECK(lines(contentOf(program.file("k.csv"))) ==
          static_cast<std::ptrdiff_t>(r["points"].size()) + 1);
}

TEST_CASE("cli: continuum: who traces may be named as an engine or as a back end")
{
    const Program program;
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
    const Program program;
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
    const Program program;
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

TEST_CASE("cli: modes in JSON, every field of the contract")
{
    const Program program;
    const auto outcome = program.run("modes --format json");
    REQUIRE(outcome.status == 0);
    CHECK(outcome.err.empty());
    const json r = json::parse(outcome.out);
    CHECK(r["complete"] == true);
    REQUIRE(r["modes"].size() == 29);
    CHECK(r["modes"][0]["contact"] == json({4, -1}));
    CHECK(r["modes"][0]["period_range"] == json::parse("[[3, 1], [4, 1]]"));
    CHECK(r["modes"][0]["inverse_sqrt_energy"] == json({1, 3}));
    CHECK(r["modes"][0]["family"] == "main");
    CHECK(r["modes"][0]["energy_ratio_range"] == json({1.0, nullptr}));
    const auto odd = std::find_if(r["modes"].begin(), r["modes"].end(), [](const json& mode) {
        return mode["contact"] == json({24, -7});
    });
    REQUIRE(odd != r["modes"].end());
    CHECK((*odd)["period_range"] == json::parse("[[10, 3], [24, 7]]"));
    CHECK((*odd)["inverse_sqrt_energy"] == json({-2, -7}));
    CHECK((*odd)["ends"] == json({"jumps-meet", "contact-vanishes"}));
    CHECK((*odd)["energy_ratio_range"] == json({9.0, 49.0}));
    CHECK((*odd)["family"].is_null());
}

TEST_CASE("cli: modes in words, within bounds, none being an answer too")
{
    const Program program;
    const auto few = program.run("modes --max-energy-ratio 10 --max-order 3");
    CHECK(few.status == 0);
    CHECK(lines(few.out) == 2 + 1 + 3);
    CHECK_THAT(few.out, containsText("3 modes") && containsText("4 - T") &&
                            containsText("]3, 4[") && containsText("subharmonic 2") &&
                            containsText("]5/4, 4/3["));
    const auto none = program.run("modes --max-period 0.001");
    CHECK(none.status == 0);
    CHECK(lines(none.out) == 1);
    CHECK_THAT(none.out, containsText("0 modes"));
    CHECK(json::parse(program.run("modes --max-period 3 --format json").out)["modes"].size() == 9);
}

TEST_CASE("cli: a wrong call of modes is exit status 2, one line, and no file")
{
    const Program program;
    for (const auto& [arguments, text] :
         {std::pair{"--max-order 0", "--max-order = 0"}, std::pair{"--max-order 10002", "1..10001"},
          std::pair{"--max-order 2.5", "--max-order = 2.5"},
          std::pair{"--max-period 0", "--max-period = 0"},
          std::pair{"--max-period inf", "--max-period = inf"},
          std::pair{"--max-energy-ratio nan", "--max-energy-ratio = nan"},
          std::pair{"--max-energy-ratio=-1", "--max-energy-ratio = -1"},
          std::pair{"--format xml", "--format = xml"}, std::pair{"--cells 0", "--cells = 0"},
          std::pair{"7", "7"}}) {
        const auto outcome = program.run(std::string("modes --figure f.svg ") + arguments);
        INFO(arguments << "\n" << outcome.err);
        CHECK(outcome.status == 2);
        CHECK(lines(outcome.err) == 1);
        CHECK(outcome.out.empty());
        CHECK_THAT(outcome.err, containsText(text));
    }
    CHECK(program.run("modes --figure a.gif").status == 2);
    CHECK(program.run("modes --figure no/such/f.svg").status == 4);
    CHECK(program.files() == 0);
}

TEST_CASE("cli: an interrupted listing of modes says that it is not complete")
{
    const Program program;
    const auto outcome = program.run("modes --max-order 10001 --format json", "timeout -s INT 0.5");
    // timeout itself answers 124; what the program wrote counts.
    const json r = json::parse(outcome.out);
    CHECK(r["complete"] == false);
    CHECK(!r["modes"].empty());
}

TEST_CASE("cli: modes draws its figure")
{
    const Program program;
    const auto outcome = program.run("modes --figure f.svg --quiet");
    if (outcome.status == 4) {
        return;  // no gnuplot here
    }
    CHECK(outcome.status == 0);
    const std::string figure = contentOf(program.file("f.svg"));
    for (const char* label : {"frequency", "energy", "main", "subharmonic", "higher"}) {
        CHECK_THAT(figure, containsText(label));
    }
}
