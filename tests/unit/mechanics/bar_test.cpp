#include "signorini/bar.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "catch.hpp"

using namespace signorini;

TEST_CASE("bar: the paper's data give E_1 = 0.5 uJ and omega_1 = pi/2 rad/s")
{
    const Scales unit = scales(Bar{});
    CHECK(unit.energy == Approx(0.5e-6).epsilon(1e-15));
    CHECK(unit.frequency == Approx(std::numbers::pi / 2).epsilon(1e-15));
    CHECK(unit.time == 1.0);
    CHECK(unit.strain == Approx(1e-3).epsilon(1e-15));
}

TEST_CASE("bar: material data give c = sqrt(E/rho) and EA")
{
    const Bar steel = barOfMaterial(2.0, 210e9, 7800.0, 1e-4, 1e-6);
    CHECK(steel.waveSpeed == Approx(5188.745).epsilon(1e-6));
    CHECK(steel.axialStiffness == Approx(21e6).epsilon(1e-15));
    CHECK(steel.length == 2.0);
    CHECK(steel.gap == 1e-6);
}

TEST_CASE("bar: every field that is not finite and positive is refused by name")
{
    const double bad = GENERATE(0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::infinity());
    CHECK_THROWS_WITH(validate(Bar{.length = bad}), containsText("length = "));
    CHECK_THROWS_WITH(validate(Bar{.waveSpeed = bad}), containsText("waveSpeed = "));
    CHECK_THROWS_WITH(validate(Bar{.axialStiffness = bad}), containsText("axialStiffness = "));
    CHECK_THROWS_AS(barOfMaterial(1, bad, 1, 1, 1), std::invalid_argument);
    CHECK_THROWS_AS(barOfMaterial(1, 1, bad, 1, 1), std::invalid_argument);
    CHECK_THROWS_AS(barOfMaterial(1, 1, 1, bad, 1), std::invalid_argument);
}

TEST_CASE("bar: all faults are named in one message")
{
    CHECK_THROWS_WITH(validate(Bar{.length = -1, .waveSpeed = 0}),
                      containsText("length") && containsText("waveSpeed"));
}

TEST_CASE("bar: scales that a double cannot hold are refused")
{
    CHECK_THROWS_AS(validate(Bar{.gap = 1e-200}), std::invalid_argument);
    CHECK_THROWS_AS(validate(Bar{.length = 1e-300, .waveSpeed = 1e300}), std::invalid_argument);
    CHECK_NOTHROW(validate(Bar{.waveSpeed = 1e9, .gap = 1e-12}));
    CHECK_NOTHROW(validate(Bar{.waveSpeed = 1e-6, .gap = 1e3}));
}
