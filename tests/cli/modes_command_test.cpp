// signorini modes: units of the bar, words about wrong numbers.

#include "command_line.hpp"

using namespace signorini;
using namespace signorini::test;

TEST_CASE("cli modes: hertz and joules are those of the bar, ratios those of every bar")
{
    const CommandLine program;
    const auto ask = [&program](const std::string& options) {
        const auto outcome = program.run("modes --max-order 3 --format json" + options);
        REQUIRE(outcome.status == 0);
        return json::parse(outcome.out);
    };
    // c = 5000 m/s, EA = 2e7 N: f = c/(L T), E_1 = EA g^2/(2L).
    const json steel = ask(" --length 2 --young 2e11 --density 8000 --area 1e-4 --gap 1e-6");
    const json plain = ask("");
    CHECK(steel["schema"] == 2);
    CHECK(steel["version"].is_string());
    CHECK(steel["bar"]["wave_speed"] == 5000.0);
    CHECK(plain["bar"]["length"] == 1.0);
    REQUIRE(steel["modes"].size() == plain["modes"].size());
    const double unit = 2e7 * 1e-12 / 4.0;
    for (std::size_t k = 0; k < steel["modes"].size(); ++k) {
        const json& mode = steel["modes"][k];
        const json& range = mode["period_range"];
        const auto period = [&range](std::size_t end) {
            return range[end][0].get<double>() / range[end][1].get<double>();
        };
        CHECK(mode["frequency_range"][0].get<double>() == Approx(2500.0 / period(1)));
        CHECK(mode["frequency_range"][1].get<double>() == Approx(2500.0 / period(0)));
        const double least = mode["energy_ratio_range"][0].get<double>();
        CHECK(mode["energy_range"][0].get<double>() == Approx(least * unit));
        CHECK(mode["energy_range"][1].is_null() == mode["energy_ratio_range"][1].is_null());
        for (const char* exact :
             {"contact", "period_range", "inverse_sqrt_energy", "energy_ratio_range"}) {
            CHECK(mode[exact] == plain["modes"][k][exact]);
        }
    }
}

TEST_CASE("cli modes: a number without an option is no step count")
{
    const CommandLine program;
    for (const char* call : {"modes -5", "atlas --database a.sqlite -5"}) {
        const auto outcome = program.run(call);
        INFO(outcome.err);
        CHECK(outcome.status == 2);
        CHECK_THAT(outcome.err, containsText("-5") && containsText("allowed"));
        CHECK_FALSE(outcome.err.find("step") != std::string::npos);
    }
    CHECK_THAT(program.run("find -5 3").err, containsText("= -5"));
}

TEST_CASE("cli: modes in JSON, every field of the contract")
{
    const CommandLine program;
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
    const CommandLine program;
    const auto few = program.run("modes --max-energy-ratio 10 --max-order 3");
    CHECK(few.status == 0);
    CHECK(lines(few.out) == 3 + 1 + 3);
    CHECK_THAT(few.out, containsText("3 modes") && containsText("4 - T") &&
                            containsText("]3, 4[") && containsText("subharmonic 2") &&
                            containsText("]5/4, 4/3["));
    const auto none = program.run("modes --max-period 0.001");
    CHECK(none.status == 0);
    CHECK(lines(none.out) == 2);
    CHECK_THAT(none.out, containsText("0 modes"));
    CHECK(json::parse(program.run("modes --max-period 3 --format json").out)["modes"].size() == 9);
}

TEST_CASE("cli: a wrong call of modes is exit status 2, one line, and no file")
{
    const CommandLine program;
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
    const CommandLine program;
    const auto outcome = program.run("modes --max-order 10001 --format json", "timeout -s INT 2");
    // timeout itself answers 124; what the program wrote counts.
    const json r = json::parse(outcome.out);
    CHECK(r["complete"] == false);
    CHECK(!r["modes"].empty());
}

TEST_CASE("cli: modes draws its figure")
{
    const CommandLine program;
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

TEST_CASE("cli modes: the table holds the curves of the figure")
{
    const CommandLine program;
    REQUIRE(program.run("modes --max-order 3 --max-energy-ratio 20 --csv m.csv").status == 0);
    const json modes = json::parse(
        program.run("modes --max-order 3 --max-energy-ratio 20 --format json").out)["modes"];
    const std::vector<json> rows = rowsOf(contentOf(program.file("m.csv")));
    REQUIRE(rows.size() == 100 * modes.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const json& mode = modes[k / 100];
        CHECK(mode["contact"] == json({rows[k][0], rows[k][1]}));
        const double period = rows[k][2].get<double>();
        CHECK(rows[k][3].get<double>() == Approx(4.0 / period));
        const double a4 = rows[k][0].get<double>();
        CHECK(rows[k][4].get<double>() == Approx(a4 + rows[k][1].get<double>() * period));
        const double root = mode["inverse_sqrt_energy"][0].get<double>() * period -
                            mode["inverse_sqrt_energy"][1].get<double>();
        CHECK(rows[k][5].get<double>() == Approx(1.0 / (root * root)));
        CHECK(rows[k][5].get<double>() <= 20.0);
    }
    CHECK(program.run("modes --csv a.png --figure a.png").status == 2);
}

TEST_CASE("cli modes: two contacts, exact polygons in text, JSON and a table")
{
    const CommandLine program;
    const auto outcome =
        program.run("modes --phases 2 --max-order 5 --max-energy-ratio 1e9 --format json --csv " +
                    program.file("p.csv").string());
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    const json r = json::parse(outcome.out);
    CHECK(r["phases"] == 2);
    CHECK(r["complete"] == true);
    CHECK(r["max_period_ratio"] == 8.0);
    REQUIRE(r["polytopes"].size() == 6);
    const json& first = r["polytopes"][0];
    CHECK(
        first["chains"] ==
        json::parse(R"([{"k": 2, "turns": 1, "release": 2}, {"k": 2, "turns": 2, "release": 1}])"));
    CHECK(first["contact"] == json({8, -3}));
    CHECK(first["free_times"] == 1);
    CHECK(first["inverse_sqrt_energy"] == json({2, 5, 1}));
    CHECK(first["vertices"] ==
          json::parse("[[[5, 2], [1, 1]], [[5, 2], [3, 2]], [[8, 3], [4, 3]]]"));
    CHECK(first["energy_ratio_range"] == json({9.0, nullptr}));
    CHECK(r["polytopes"][1]["free_times"] == 0);
    CHECK(r["polytopes"][1]["inverse_sqrt_energy"] == json({1, 6, 2}));
    // The table: contact and flight add up to T, contact to 8 - 3T, which either may have alone.
    std::ifstream lines(program.file("p.csv"));
    std::string line;
    std::getline(lines, line);
    CHECK(line ==
          "type,free_times,period_ratio,frequency_ratio,energy_ratio,frequency,contact_1_ratio,"
          "flight_1_ratio,contact_2_ratio,flight_2_ratio");
    int corners = 0;
    while (std::getline(lines, line) && line.rfind("2/1→2 2/2→1,1,", 0) == 0) {
        std::vector<double> numbers;
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) {
            numbers.push_back(std::atof(cell.c_str()));
        }
        REQUIRE(numbers.size() == 10);
        CHECK(numbers[5] == Approx(1.0 / numbers[2]));  // L/c = 1 s
        CHECK(numbers[6] + numbers[7] + numbers[8] + numbers[9] == Approx(numbers[2]));
        CHECK(numbers[6] + numbers[8] == Approx(8.0 - 3.0 * numbers[2]));
        CHECK(numbers[6] * numbers[8] == Approx(0.0).margin(1e-12));
        ++corners;
    }
    CHECK(corners == 40);
    CHECK_THAT(program.run("modes --phases 2 --max-order 3").out,
               containsText("2/1→2 2/2→1") && containsText("8 - 3T") && containsText("2T - 5"));
    const auto wrong = program.run("modes --phases 6");
    CHECK(wrong.status == 2);
    CHECK_THAT(wrong.err, containsText("--phases") && containsText("1..5"));
    const auto large = program.run("modes --phases 2 --max-order 103");
    CHECK(large.status == 2);
    CHECK_THAT(large.err, containsText("--max-order = 103") && containsText("1..101"));
}
