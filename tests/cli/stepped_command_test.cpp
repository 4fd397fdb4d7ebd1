// signorini find --segments: bars of several segments.

#include <fmt/format.h>

#include <set>

#include "command_line.hpp"
#include "database.hpp"
#include "solver.hpp"

using namespace signorini::test;

namespace {

/// A value of JSON as tables have it.
std::string fieldOf(const json& value)
{
    return value.is_null()             ? ""
           : value.is_string()         ? value.get<std::string>()
           : value.is_boolean()        ? fmt::format("{:d}", value.get<bool>())
           : value.is_number_integer() ? fmt::format("{}", value.get<std::int64_t>())
                                       : fmt::format("{}", value.get<double>());
}

/// What the table of an atlas says in a column, by the JSON of its row.
std::string columnOf(const json& row, const std::string& name)
{
    for (const auto& [end, place] : {std::pair{"_min", 0U}, std::pair{"_max", 1U}}) {
        if (name.ends_with(end)) {
            const std::string range = name.substr(0, name.size() - 4) + "_range";
            return row.contains(range) && !row[range].is_null() ? fieldOf(row[range][place]) : "";
        }
    }
    if (!row.contains(name)) {
        return "";
    }
    if (name != "spans" && name != "schedule") {
        return fieldOf(row[name]);
    }
    std::vector<std::string> words;
    for (const json& item : row[name]) {
        words.push_back(name == "schedule"
                            ? fmt::format("{} {}", item[0].get<int>(), item[1].get<int>())
                            : fmt::format("{}:{}",
                                          item["closed"].empty()
                                              ? "-"
                                              : std::to_string(item["closed"][0].get<int>()),
                                          item["steps"].get<int>()));
    }
    return fmt::format("{}", fmt::join(words, " "));
}

}  // namespace

TEST_CASE("cli stepped: a motion, its segments and its cells, which are those of all segments",
          "[glpk][ipopt]")
{
    const CommandLine program;
    const json r = program.find("3 25 --segments 4:1,4:1.3", 0);
    CHECK(r["cells"] == 8);
    CHECK(r["kernel_dimension"] == 3);
    CHECK(r["objective"] == "min-energy");
    CHECK(r["energy_ratio"].get<double>() == Approx(15.807707).epsilon(1e-6));
    CHECK(r["segments"][1] ==
          json{{"cells", 4}, {"impedance", 1.3}, {"speed", 1.0}, {"dashpot", 0.0}});
    CHECK_THAT(r["route"].get<std::string>(), containsText("kernel"));

    const json none = program.find("3 12 --segments 4:1,4:1.3", 1);
    CHECK(none["certificate"]["rows"] == "network");
    CHECK(none["certificate"]["verified"] == true);
    CHECK(none["certificate"]["energy_ratio"].get<double>() > 1e15);
    const auto text = program.run("find 3 12 --segments 4:1,4:1.3");
    CHECK_THAT(text.out, containsText("checked by stepping backwards in time"));
}

TEST_CASE("cli stepped: speeds make the bar longer or shorter, not the motion another one",
          "[glpk][ipopt]")
{
    const CommandLine program;
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
    const CommandLine program;
    const auto drawn = program.run(
        "find 3 25 --segments 4:1,4:1.3 --figure m.svg --motion m.csv --state s.csv --quiet");
    INFO(drawn.err);
    REQUIRE(drawn.status == 0);
    CHECK(fs::file_size(program.file("m.svg")) > 1000);
    CHECK(lines(contentOf(program.file("s.csv"))) == 9);
}

TEST_CASE("cli stepped: a call that cannot be meant is refused by name")
{
    const CommandLine program;
    const auto refuses = [&](const std::string& words, const std::string& part) {
        const auto outcome = program.run(words);
        INFO(words << "\n" << outcome.err);
        CHECK(outcome.status == 2);
        CHECK_THAT(outcome.err, containsText(part));
        CHECK(lines(outcome.err) == 1);
    };
    refuses("find 3 25 --segments 4", "CELLS:IMPEDANCE[:SPEED");
    refuses("find 3 25 --segments 4:0,4:1", "--segments");
    const std::string force = " --damping 0.1 --force tip --amplitude 1e-3";
    for (const std::string& asked :
         {std::string("find 3 25"), std::string("find --period 3"), "find --frequency 1.1" + force,
          "simulate --rest --periods 2 --frequency 1" + force,
          "response --exact --from 1 --to 1.1" + force,
          "sweep --periods 5 --points 2 --from 1 --to 1.1" + force}) {
        refuses(asked + " --segments 4:1,4:1.3 --cells 9",
                "--cells = 9 is out of range: allowed 8");
    }
    refuses("find 3 25 --segments 4:1,4:1.3:2 --motion m.pvd", "several speeds");
    refuses("find --frequency 8/7 --segments 4:1,4:1.3 --formulation state", "--formulation");
    refuses("simulate --segments 4:1,4:1.3:1:-1 --time 1", "dashpot of segment 2");
    refuses("atlas --database a.sqlite --segments 4:1,4:1.3 --cells 9",
            "--cells = 9 is out of range: allowed 8");
    refuses("atlas --database a.sqlite --segments 4:1,4:1.3 --families-only",
            "--families-only is not allowed");
    const std::string response = "response --damping 0.1 --force tip --amplitude 1e-4 --segments ";
    refuses(response + "400:1,400:1.3 --contacts 2", "contacts: 2, schedules");
    refuses(response + "4:1,4:1.3 --cells 9", "--cells = 9 is out of range: allowed 8");
    refuses(response + "4:1,4:1.3 --backbone-csv b.csv", "--backbone-csv");
    CHECK(program.files() == 0);
}

TEST_CASE("cli stepped: an atlas of segments is drawn")
{
    const CommandLine program;
    const auto made = program.run(
        "atlas --database a.sqlite --segments 4:1,4:1.3 --max-contact 4 --max-free 30 "
        "--figure f.svg");
    INFO(made.err);
    REQUIRE(made.status == 0);
    CHECK_THAT(contentOf(program.file("f.svg")),
               containsText("segments 4:1:1:0,4:1.3:1:0") && containsText("least energy") &&
                   containsText("pressing") && !containsText("families"));
}

TEST_CASE("cli stepped: a motion that was found goes on for ten periods when it is followed",
          "[glpk][ipopt]")
{
    const CommandLine program;
    const std::string bar = " --segments 4:1,4:1.3 --format json";
    const json found = program.find("3 25 --segments 4:1,4:1.3 --state s.csv", 0);
    const auto run =
        program.run("simulate --from s.csv --time 35 --events e.csv --tip t.csv" + bar);
    INFO(run.err);
    REQUIRE(run.status == 0);
    const json followed = json::parse(run.out);
    CHECK(followed["segments"] == found["segments"]);
    CHECK(followed["energy"].get<double>() == Approx(found["energy"].get<double>()).epsilon(1e-6));
    CHECK(followed["tip"].get<double>() == Approx(1e-3).epsilon(1e-6));
    CHECK(followed["impulse"].get<double>() ==
          Approx(10.0 * found["physical"]["impulse"].get<double>()).epsilon(1e-6));
    CHECK(lines(contentOf(program.file("e.csv"))) == 1 + followed["contacts"].get<int>());
}

TEST_CASE("cli stepped: forced from rest it comes to what one schedule has, and says so",
          "[glpk][ipopt]")
{
    const CommandLine program;
    const std::string bar = " --segments 4:1,4:1.3 --damping 0.1 --force tip --format json";
    const auto run =
        program.run("simulate --rest --amplitude 4e-4 --frequency 1 --periods 400" + bar);
    INFO(run.err);
    REQUIRE(run.status == 0);
    const json settled = json::parse(run.out);
    const json& balance = settled["balance"];
    CHECK(std::abs(balance["error"].get<double>()) < 1e-9 * balance["work"].get<double>());
    CHECK(balance["dissipated"].get<double>() > 0.0);
    CHECK(
        program.find("6 26 --segments 4:1,4:1.3 --damping 0.1 --force tip", 0)["motions"].size() ==
        1);
    const std::string absent = "5 24 --segments 4:1,4:1.3 --damping 0.05 --force tip";
    const json none = program.find(absent + " --certificate none.json", 1);
    CHECK(none["certificate"]["verified"] == true);
    CHECK(none["certificate"]["cuts"][0]["periodicity"].size() == 16);
    CHECK(json::parse(contentOf(program.file("none.json")))["certificate"] == none["certificate"]);
    CHECK_THAT(program.run("find " + absent).out, containsText("verified by interval arithmetic"));
    const json pressed = program.find(
        "6 26 --segments 4:1,4:1.3 --damping 0.1 --force tip --gap -1e-3 --second-stop 3e-3", 1);
    CHECK(pressed["reason"] == "penetration");
}

TEST_CASE("cli stepped: a pressed bar and a second stop have responses, too", "[glpk]")
{
    const CommandLine program;
    const auto parsed = [&program](const std::string& words) {
        return json::parse(program.run(words + " --format json").out);
    };
    const std::string words =
        "response --damping 0.1 --force tip --segments 4:1,4:1.3 --from 0.8 --to 1.2 ";
    const json pressed = parsed(words + "--amplitude 4e-4 --gap -1e-3");
    int permanent = 0;
    for (const json& at : pressed["frequencies"]) {
        permanent += at["permanent_contact"].is_null() ? 0 : 1;
    }
    CHECK(permanent > 0);
    const json two = parsed(words + "--amplitude 4e-4 --gap 2e-3 --second-stop 1e-3");
    int onLeft = 0;
    for (const json& at : two["frequencies"]) {
        for (const json& motion : at["motions"]) {
            onLeft += motion["schedule"].front().size() == 3 ? 1 : 0;
        }
    }
    CHECK(onLeft > 0);
}

TEST_CASE("cli stepped: the response says what find says of each schedule, in all its files",
          "[glpk][ipopt]")
{
    const CommandLine program;
    const std::string words =
        " --segments 4:1,4:1.3:2 --damping 0.05 --force tip --amplitude 4e-4 --young 1e9 "
        "--density 1e9 --area 1e-9 --quiet --format json";
    const auto run = program.run(
        "response --from 0.9 --to 1.2 --stability --threads 2 --csv r.csv --map-csv m.csv "
        "--figure r.svg --map m.svg" +
        words);
    INFO(run.err);
    REQUIRE(run.status == 0);
    const json answer = json::parse(run.out);
    CHECK(answer["cells"] == 8);
    CHECK(answer["segments"].size() == 2);
    int motions = 0;
    for (const json& frequency : answer["frequencies"]) {
        CHECK(frequency["undecided"] == 0);
        for (const json& motion : frequency["motions"]) {
            ++motions;
            CHECK(motion["residual"].get<double>() < 1e-9);
            CHECK(motion["physical"]["peak_stress"].is_null());
            const auto phase = motion["schedule"][0].get<std::vector<int>>();
            const auto found = program.run("find " + std::to_string(phase[0]) + " " +
                                           std::to_string(phase[1]) + words);
            REQUIRE(found.status == 0);
            const json known = json::parse(found.out);
            int same = 0;
            for (const json& other : known["motions"]) {
                same += other["impulse"].get<double>() ==
                                    Approx(motion["impulse"].get<double>()).epsilon(1e-7) &&
                                other["physical"]["peak_compression"].get<double>() ==
                                    Approx(motion["physical"]["peak_compression"].get<double>())
                                        .epsilon(1e-7)
                            ? 1
                            : 0;
            }
            CHECK(same == 1);
        }
    }
    CHECK(motions >= 5);
    CHECK(lines(contentOf(program.file("r.csv"))) > motions);
    CHECK(lines(contentOf(program.file("m.csv"))) > motions);
    CHECK_THAT(contentOf(program.file("r.svg")), containsText("4:1, 4:1.3"));
    CHECK(fs::file_size(program.file("m.svg")) > 1000);
    // There is a figure also where nothing meets the wall.
    const auto clear = program.run(
        "response --segments 4:1,4:1.3 --damping 0.05 --force tip --amplitude 1e-9 --figure "
        "clear.svg --quiet");
    INFO(clear.err);
    CHECK(clear.status == 0);
    CHECK(fs::file_size(program.file("clear.svg")) > 1000);
}

TEST_CASE("cli stepped: an atlas is the same by threads and by processes, and keeps bar and proofs",
          "[glpk][ipopt]")
{
    const CommandLine program;
    const bool areSegments = GENERATE(true, false);
    const std::string scene = areSegments ? "--segments 2:1,2:1.3 --max-contact 6 --max-free 24"
                                          : "--scene 'clamp 2 stop=1e-3 gap=2e-3 2:1.3 clamp' "
                                            "--max-contact 3 --max-free 24";
    const std::string words = "atlas " + scene + " --all --quiet --format json --database ";
    const auto one = program.run(words + "one.sqlite");
    INFO(one.err);
    REQUIRE(one.status == 0);
    const json report = json::parse(one.out);
    if (areSegments) {
        CHECK(report["segments"].size() == 2);
    } else {
        CHECK(report["contacts"].size() == 2);
        CHECK(report["reference"]["energy"] > 0.0);
    }
    CHECK(report["decided"] == 144);
    CHECK(report["undecided"] == 0);
    REQUIRE(program.run(words + "two.sqlite --threads 2").status == 0);
    const auto rows = dump(program.file("one.sqlite"));
    CHECK(rows.size() == 144);
    CHECK(dump(program.file("two.sqlite")) == rows);
    CHECK(number(program.file("one.sqlite"),
                 "SELECT COUNT(*) FROM schedules WHERE status = 'none' AND proof IS NULL") == 0);
    if (SIGNORINI_HAS_MPI != 0) {
        const std::string launch =
            "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
            "OMPI_MCA_btl_vader_single_copy_mechanism=none mpirun --oversubscribe -n 3";
        REQUIRE(program.run(words + "three.sqlite", launch).status == 0);
        CHECK(dump(program.file("three.sqlite")) == rows);
    }
    const auto other = program.run(
        "atlas --segments 2:1,2:1.4 --max-contact 6 --max-free 24 "
        "--quiet --database one.sqlite");
    CHECK(other.status == 2);
    CHECK_THAT(other.err, containsText("segments"));
}

TEST_CASE("cli stepped: --csv of an atlas has what JSON says of each schedule", "[glpk][ipopt]")
{
    const CommandLine program;
    const bool areSegments = GENERATE(true, false);
    const std::string scene =
        areSegments ? "--segments 2:1,2:1.3" : "--scene 'clamp 2 stop=1e-3 gap=2e-3 2:1.3 clamp'";
    const std::string range =
        areSegments ? " --max-contact 6 --max-free 24" : " --max-contact 3 --max-free 24";
    const auto made =
        program.run("atlas --database a.sqlite --all --quiet --csv all.csv " + scene + range);
    INFO(made.err);
    REQUIRE(made.status == 0);
    const std::string all = contentOf(program.file("all.csv"));
    CHECK(lines(all) == 1 + 144);
    REQUIRE(program.run("atlas --database a.sqlite --csv again.csv").status == 0);
    CHECK(contentOf(program.file("again.csv")) == all);

    // Those of one period alone, in the order of the answer: some have motions, some have none.
    const auto asked = program.run(
        std::string("atlas --database a.sqlite --csv some.csv --format json --period ") +
        (areSegments ? "7/2" : "7/4"));
    INFO(asked.err);
    REQUIRE(asked.status == 0);
    const json schedules = json::parse(asked.out)["schedules"];
    std::istringstream table(contentOf(program.file("some.csv")));
    std::string line;
    std::getline(table, line);
    CHECK(all.starts_with(line + "\n"));
    const std::vector<std::string> names = cellsOf(line);
    std::set<std::string> verdicts;
    for (const json& row : schedules) {
        REQUIRE(std::getline(table, line));
        CHECK_THAT(all, containsText("\n" + line + "\n"));
        const std::vector<std::string> cells = cellsOf(line);
        REQUIRE(cells.size() == names.size());
        for (std::size_t k = 0; k < names.size(); ++k) {
            INFO(names[k] << " of " << line);
            CHECK(cells[k] == columnOf(row, names[k]));
        }
        verdicts.insert(row["status"]);
        const std::string words = columnOf(row, row.contains("spans") ? "spans" : "schedule");
        (void)program.find(words + " " + scene, row["status"] == "found" ? 0 : 1);
    }
    CHECK_FALSE(std::getline(table, line));
    CHECK(verdicts == std::set<std::string>{"found", "none"});
}

TEST_CASE("cli segments: with several speeds the state written is what a simulation repeats")
{
    const CommandLine program;
    const std::string bar = "--segments 5:1:1,4:1:2 --damping 0.05 --force base ";
    const json found = program.find("6 30 " + bar + "--state s.csv --motion m.csv", 0);
    const json& motion = found["motions"][0];
    const auto outcome = program.run(fmt::format(
        "simulate {} --from s.csv --amplitude {} --hertz {} --phase={} --periods 20 --format json",
        bar, motion["amplitude"].get<double>(), motion["physical"]["frequency"].get<double>(),
        motion["phase"].get<double>()));
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    const json run = json::parse(outcome.out);
    CHECK(run["settled"]["periods"] == 1);
    CHECK(run["settled"]["impulse"].get<double>() ==
          Approx(motion["physical"]["impulse"].get<double>()).epsilon(1e-4));
    // 37 instants of 11 places: 6 nodes of the first segment, 5 of the second.
    CHECK(lines(contentOf(program.file("m.csv"))) == 1 + 37 * 11);
}
