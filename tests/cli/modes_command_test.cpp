// signorini modes: units of the bar, words about wrong numbers.

#include "program.hpp"

using namespace signorini;
using namespace signorini::test;

TEST_CASE("cli modes: hertz and joules are those of the bar, ratios those of every bar")
{
    const Program program;
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
        const auto period = [&range](int end) {
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
    const Program program;
    for (const char* call : {"modes -5", "atlas --database a.sqlite -5"}) {
        const auto outcome = program.run(call);
        INFO(outcome.err);
        CHECK(outcome.status == 2);
        CHECK_THAT(outcome.err, containsText("-5") && containsText("allowed"));
        CHECK_FALSE(outcome.err.find("step") != std::string::npos);
    }
    CHECK_THAT(program.run("find -5 3").err, containsText("= -5"));
}
