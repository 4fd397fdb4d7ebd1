// signorini find asked in physics: period, frequency or hertz in place of steps; energies in
// joules.

#include <cmath>
#include <set>

#include "command_line.hpp"
#include "signorini/modes.hpp"
#include "signorini/one_phase_set.hpp"

using namespace signorini;
using namespace signorini::test;

TEST_CASE("cli question: the paper's frequency and energy belong to one connected family")
{
    const CommandLine program;
    const json r = program.find("--frequency 8/7 --energy-ratio 20", 0);
    CHECK(r["schema"] == 2);
    CHECK(r["status"] == "found");
    CHECK(r["cells"] == 300);
    CHECK(r["question"]["asked"] == json{{"frequency", "8/7"}});
    CHECK(r["question"]["steps"] == 1050);
    CHECK(r["question"]["period_ratio"] == 3.5);
    CHECK(r["question"]["energy_ratio"] == 20.0);
    CHECK(r["question"]["energy"].get<double>() == Approx(20.0 * 0.5e-6));
    REQUIRE(r["sets"].size() == 1);
    REQUIRE(r["motions"].size() == 1);
    const json& motion = r["motions"][0];
    CHECK(motion["schedule"] == json({{150, 900}}));
    CHECK(motion["family"]["order"] == 4);
    CHECK(motion["family"]["nu"] == 7);
    CHECK(motion["family"]["contact_blocks"] == 1);
    CHECK(motion["family"]["period_ratio"] == json({14, 4}));
    CHECK(motion["family"]["contact"] == json({2, 4}));
    CHECK(motion["family"]["least_energy_ratio"] == 4.0);
    CHECK(motion["family"]["offset"] == 0);
    CHECK(motion["energy_section"] ==
          json{{"dimension", 148}, {"connected", true}, {"components", 1}});
    CHECK(motion["objective"] == "min-peak-strain");
    CHECK(motion["energy_ratio"].get<double>() == Approx(20.0).epsilon(1e-12));
    const json same = program.find("150 900 --energy-ratio 20", 0);
    CHECK(same["physical"] == motion["physical"]);
    CHECK(same["canonical_schedule"] == json({{30, 1020}}));

    const auto text = program.run("find --frequency 8/7 --energy-ratio 20");
    CHECK(text.status == 0);
    CHECK(text.err.empty());
    for (const char* word : {"(4, 7, 1)", "dimension 148, connected", "its top", "on this grid",
                             "T = 7/2 L/c", "8/7"}) {
        CHECK_THAT(text.out, containsText(word));
    }
}

TEST_CASE("cli question: period, frequency and hertz are one question")
{
    const CommandLine program;
    const json period = program.find("--period 7/2 --energy-ratio 20", 0)["motions"];
    for (const char* words :
         {"--period 3.5", "--period 7/2", "--period 14/4", "--frequency 8/7",
          "--frequency 1.1428571428571428", "--hertz 0.2857142857142857", "--hertz 0.28575"}) {
        CAPTURE(words);
        json motions = program.find(std::string(words) + " --energy 1e-5", 0)["motions"];
        REQUIRE(motions.size() == 1);
        CHECK(motions[0]["schedule"] == period[0]["schedule"]);
        CHECK(motions[0]["physical"]["frequency"] == period[0]["physical"]["frequency"]);
        CHECK(motions[0]["energy_ratio"].get<double>() == Approx(20.0));
    }
    const json hertz = program.find("--hertz 0.28575 --energy-ratio 20", 0)["question"];
    CHECK(hertz["asked"] == json{{"hertz", "0.28575"}});
    CHECK(hertz["nearest"].get<double>() == Approx(2.0 / 7.0));
    CHECK(hertz["frequency"] == hertz["nearest"]);
    CHECK_THAT(program.run("find --hertz 0.28575 --energy-ratio 20").out,
               containsText("asked 0.28575 Hz"));
    CHECK(program.find("150 900 --energy 1e-5", 0)["energy_ratio"].get<double>() == Approx(20.0));
}

TEST_CASE("cli question: all sets of a period, as many as a search over every schedule finds")
{
    const CommandLine program;
    for (const auto& [cells, steps] :
         {std::pair{30, 104}, {30, 90}, {21, 66}, {30, 120}, {15, 20}, {12, 47}, {7, 22}}) {
        // A set is the largest of its kind: pressing schedules by family, grazing ones together if
        // they move with this period.
        std::set<std::int64_t> pressing;
        bool isGrazing = false;
        for (std::int64_t contact = 1; contact < steps; ++contact) {
            const Schedule schedule{cells, {{contact, steps - contact}}};
            const OnePhaseSet whole = onePhaseSet(schedule);
            if (whole.reason) {
                continue;
            }
            if (whole.contact == Contact::pressing) {
                pressing.insert(familyOf(schedule)->family.contactBlocks);
            } else {
                isGrazing = isGrazing || whole.members == 2;
            }
        }
        const std::size_t expected = pressing.size() + (isGrazing ? 1 : 0);
        const json r = program.find("--cells " + std::to_string(cells) + " --period " +
                                        std::to_string(steps) + "/" + std::to_string(cells),
                                    expected > 0 ? 0 : 1);
        CAPTURE(cells, steps);
        CHECK(r["sets"].size() == expected);
        CHECK(r["motions"].size() == expected);
        for (const json& motion : r["motions"]) {
            CHECK(motion["period_ratio"].get<double>() ==
                  Approx(static_cast<double>(steps) / cells));
            CHECK(motion["contact"] == (motion["family"].is_null() ? "grazing" : "pressing"));
        }
    }
}

TEST_CASE("cli question: none is proved for the grid, and says why")
{
    const CommandLine program;
    const json slow = program.find("--period 5 --energy-ratio 20", 1);
    CHECK(slow["status"] == "none");
    CHECK(slow["reason"] == "period");
    CHECK(slow["motions"].empty());
    CHECK(slow["sets"].empty());
    const json weak = program.find("--frequency 8/7 --energy-ratio 3.9", 1);
    CHECK(weak["reason"] == "constraints");
    CHECK(weak["sets"][0]["energy_ratio_range"] == json({4.0, 600.0}));
    CHECK(program.find("--frequency 8/7 --energy-ratio 601", 1)["status"] == "none");
    CHECK(program.find("--frequency 8/7 --energy-ratio 601 --cells 600", 0)["status"] == "found");
}

TEST_CASE("cli question: wrong use names the remedy")
{
    struct Wrong {
        const char* arguments;
        const char* named;
    };
    const auto wrong = GENERATE(values<Wrong>({
        {"150 900 --period 7/2", "clash"},
        {"--period 7/2 --frequency 8/7", "allowed one of them"},
        {"--period 7/2 --hertz 1", "allowed one of them"},
        {"--period 7/2 --cells 3", "needs --cells 2"},
        {"--period 10/3 --cells 100000000 --energy 0", "--energy = 0"},
        {"--frequency 1.143", "nearest 8/7"},
        {"--frequency 1.143", "needs --cells 1143"},
        {"--period 0", "--period = 0"},
        {"--period -1", "--period = -1"},
        {"--period 1/0", "--period = 1/0"},
        {"--period 7/2/1", "--period = 7/2/1"},
        {"--period x", "--period = x"},
        {"--period 1/300", "periods of 2.."},
        {"--frequency nan", "--frequency = nan"},
        {"--hertz 1000", "--hertz = 1000"},
        {"--hertz 0", "--hertz = 0"},
        {"150 900 --energy 1 --energy-ratio 2", "clash"},
        {"--period 3.5 --objective min-peak-strain --energy-ratio 20 --formulation state",
         "objective = min-peak-strain"},
    }));
    const CommandLine program;
    const auto outcome =
        program.run(std::string("find ") + wrong.arguments + " --state s.csv --format json");
    CAPTURE(wrong.arguments, outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(lines(outcome.err) == 1);
    CHECK_THAT(outcome.err, containsText(wrong.named));
    CHECK(program.files() == 0);
}

TEST_CASE("cli question: files are written for the one motion that answers; two are wrong use")
{
    const CommandLine program;
    CHECK(program.run("find --period 7/2 --energy-ratio 20 --state s.csv").status == 0);
    CHECK(fs::exists(program.file("s.csv")));
    const auto again = program.run("find 150 900 --energy-ratio 20 --state t.csv");
    CHECK(contentOf(program.file("s.csv")) == contentOf(program.file("t.csv")));
    // T = 22/7, w = 7: (7, 11, 1) and (7, 11, 3).
    const auto two = program.run("find --period 22/7 --cells 70 --state u.csv");
    CHECK(two.status == 2);
    CHECK(two.out.empty());
    CHECK(lines(two.err) == 1);
    CHECK_THAT(two.err, containsText("2 motions"));
    CHECK_FALSE(fs::exists(program.file("u.csv")));
}

TEST_CASE("cli: each motion says what can be measured, in SI units")
{
    const CommandLine program;
    const std::string steel = " --length 2 --young 210e9 --density 7800 --area 1e-4 --gap 1e-5";
    const json r = program.find("150 900" + steel, 0);
    const json& p = r["physical"];
    const double c = std::sqrt(210e9 / 7800.0);
    CHECK(p["frequency"].get<double>() == Approx(c / 7.0));
    CHECK(p["contact_time"].get<double>() == Approx(1.0 / c));
    CHECK(p["peak_force"].get<double>() == Approx(210.0));
    CHECK(p["impulse"].get<double>() == Approx(210.0 / c));
    CHECK(p["approach_speed"].get<double>() == Approx(1e-5 * c));
    CHECK(p["peak_compression"].get<double>() == Approx(1e-5));
    CHECK(p["peak_tension"].get<double>() == Approx(1e-5));
    CHECK(p["peak_stress"].get<double>() == Approx(2.1e6));
    // The flight lasts 3 L/c: the tip goes away at 2 c g/L for half of it, and comes back.
    CHECK(p["tip_lowest"].get<double>() == Approx(1e-5 * (1.0 - 3.0)));
    CHECK(r["admissible"] == true);
    CHECK(r["bar"]["young"] == 210e9);
    const json plain = program.find("150 900", 0);
    CHECK(plain["physical"]["peak_stress"].is_null());
    CHECK(plain["bar"]["young"].is_null());
    const auto text = program.run("find 150 900" + steel);
    for (const char* word : {"frequency", "pressed for", "met at", "lowest", "stress 2.1e+06 Pa"}) {
        CHECK_THAT(text.out, containsText(word));
    }

    const auto wild = program.run("find 150 900 --gap 0.6 --format json");
    CHECK(wild.status == 0);
    CHECK(json::parse(wild.out)["admissible"] == false);
    CHECK_THAT(wild.err, containsText("not admissible"));
    CHECK(lines(wild.err) == 1);
    CHECK(program.run("find 150 900 --gap 0.6 --quiet").err.empty());

    CHECK_THAT(program.run("find 150 900 --yield-stress 2e6" + steel).err,
               containsText("beyond --yield-stress"));
    CHECK(program.run("find 150 900 --yield-stress 2.2e6" + steel).err.empty());
    CHECK(program.run("find 150 900 --yield-stress 2e6").status == 2);
}

TEST_CASE("cli question: of bars and under a harmonic, too, an answer says what was asked of it")
{
    const CommandLine program;
    const std::string bars = R"(--scene "clamp 4 gap=1e-3 4:1.3 clamp" )";
    const std::string forced = " --damping 0.05 --force tip --amplitude 4e-4";
    struct Asked {
        std::string words;
        json asked;
        const char* nearest;  ///< nullptr: that of the grid
    };
    for (const auto& [words, asked, nearest] :
         {Asked{"--hertz 0.28 --segments 4:1,4:1.3", {{"hertz", "0.28"}}, "asked 0.28 Hz"},
          {"--frequency 0.28Hz --cells 8", {{"hertz", "0.28"}}, "asked 0.28 Hz"},
          {"--frequency 8/7 --energy-ratio 7 --segments 4:1,4:1.3",
           {{"frequency", "8/7"}},
           "asked 8/7 ω₁"},
          {"--period 29/8 --segments 4:1,4:1.3", {{"period", "29/8"}}, nullptr},
          {"--hertz 0.28 " + bars, {{"hertz", "0.28"}}, "asked 0.28 Hz"},
          {"--hertz 0.28 --segments 4:1,4:1.3" + forced, {{"hertz", "0.28"}}, "asked 0.28 Hz"},
          {"--frequency 10/9 --cells 8" + forced, {{"frequency", "10/9"}}, nullptr},
          {"--hertz 0.28 --cells 8" + forced, {{"hertz", "0.28"}}, "asked 0.28 Hz"}}) {
        const auto outcome = program.run("find --format json " + words);
        INFO(words << outcome.err);
        REQUIRE(outcome.status != 2);
        const json question = json::parse(outcome.out)["question"];
        CHECK(question["asked"] == asked);
        CHECK(question.contains("nearest") == (nearest != nullptr));
        CHECK(question["period"].get<double>() * question["frequency"].get<double>() ==
              Approx(1.0));
        const std::string text = program.run("find " + words).out;
        if (nearest != nullptr) {
            CHECK(question["nearest"] == question["frequency"]);
            CHECK_THAT(text, containsText(nearest) && containsText("nearest on this grid"));
        } else {
            CHECK_THAT(text, !containsText("nearest"));
        }
    }
}
