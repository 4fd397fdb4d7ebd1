#include <cmath>
#include <limits>
#include <random>

#include "catch.hpp"
#include "signorini/bar.hpp"
#include "signorini/schedule.hpp"

using namespace signorini;

TEST_CASE("scene: a bar is a scene, and every number that cannot be is refused by name")
{
    CHECK_NOTHROW(validate(Scene(Bar{.gap = -1e-3})));
    CHECK_NOTHROW(validate(Scene(Bar{.gap = 0.0})));
    CHECK_THROWS_WITH(validate(Scene(Bar{.gap = std::numeric_limits<double>::infinity()})),
                      containsText("gap = inf"));
    CHECK_THROWS_WITH(validate(Scene(Bar{}, -1e-3)), containsText("secondStop = -0.001"));
    CHECK_THROWS_WITH(validate(Scene(Bar{.gap = -2e-3}, 1e-3)), containsText("> -g = 0.002"));
    CHECK_THROWS_WITH(validate(Scene(Bar{}, 100.0)), containsText("times the gap"));
    CHECK_THROWS_WITH(
        validate(Scene(Bar{}, {}, {{.cells = 0}, {.cells = 1, .impedance = 0.0}})),
        containsText("cells of segment 1 = 0") && containsText("impedance of segment 2 = 0"));
    CHECK_THROWS_WITH(validate(Scene(Bar{}, {}, {{.cells = 1, .dashpot = -1.0}})),
                      containsText("dashpot of segment 1 = -1"));
}

TEST_CASE("scene: units of displacement are |g|, without a gap the length of the bar")
{
    const Scales pressed = scales(Bar{.length = 2.0, .axialStiffness = 3.0, .gap = -0.5});
    CHECK(pressed.displacement == 0.5);
    CHECK(pressed.energy == Approx(0.5 * 3.0 * 0.25 / 2.0).epsilon(1e-15));
    CHECK(scales(Bar{.length = 2.0, .gap = 0.0}).displacement == 2.0);
    CHECK(staticForce(Bar{.length = 2.0, .axialStiffness = 3.0, .gap = -0.5}) == 0.75);
    CHECK(staticForce(Bar{}) == 0.0);
}

TEST_CASE("scene: stops in units of the gap are the fractions that were meant")
{
    CHECK(stopsOf(Bar{}) == Stops{});
    CHECK(stopsOf(Bar{.gap = -1e-3}).right == -1);
    CHECK(stopsOf(Bar{.gap = 0.0}).right == 0);
    CHECK(stopsOf(Scene(Bar{}, 1e-3)).left == Fraction{1, 1});
    CHECK(stopsOf(Scene(Bar{}, 1.1e-3)).left == Fraction{11, 10});
    CHECK(stopsOf(Scene(Bar{.gap = -3e-4}, 1e-3)).left == Fraction{10, 3});
    CHECK(stopsOf(Scene(Bar{.length = 0.5, .gap = 0.0}, 0.1)).left == Fraction{1, 5});
}

TEST_CASE("scene: the simplest fraction rounds back, and no simpler one does")
{
    std::mt19937_64 generator(7);
    std::uniform_real_distribution<double> exponent(-9.0, 9.0);
    for (int k = 0; k < 2000; ++k) {
        const double value = std::exp(exponent(generator));
        const Fraction f = simplestFraction(value);
        REQUIRE(static_cast<double>(f.numerator) / static_cast<double>(f.denominator) == value);
    }
    for (std::int64_t q = 1; q < 60; ++q) {
        for (std::int64_t p = 1; p < 60; ++p) {
            const Fraction f = simplestFraction(static_cast<double>(p) / static_cast<double>(q));
            REQUIRE(f == exactPeriod(p, q));
        }
    }
}

TEST_CASE("scene: a schedule's phases touch stops that are there")
{
    Schedule schedule{4, {{1, 5}, {1, 5, Stop::left}}};
    CHECK_THROWS_WITH(validate(schedule), containsText("phase 2 = L:"));
    schedule.stops.left = Fraction{1, 1};
    CHECK_NOTHROW(validate(schedule));
    CHECK(describe(schedule) == "N = 4, (1, 5) L:(1, 5)");
    schedule.stops = {-1, Fraction{1, 1}};
    CHECK_THROWS_WITH(validate(schedule), containsText("left stop = 1/1"));
}
