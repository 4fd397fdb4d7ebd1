#include "signorini/motion.hpp"

#include "catch.hpp"
#include "support.hpp"

using namespace signorini;

TEST_CASE("state: v = a + b, s = b - a, u is the running sum of s, E/E_1 = 2/N sum(a^2 + b^2)")
{
    const State state{Eigen::Vector2d{1.0, -2.0}, Eigen::Vector2d{3.0, 5.0}};
    CHECK(velocity(state) == Eigen::Vector2d(4.0, 3.0));
    CHECK(strain(state) == Eigen::Vector2d(2.0, 7.0));
    CHECK(displacement(state) == Eigen::Vector2d(1.0, 4.5));
    CHECK(energyRatio(state) == 39.0);
    CHECK(amplitude(state) == 5.0);
}

TEST_CASE("state: energy agrees with the integral of v^2 + s^2 over the bar")
{
    // E = 1/2 EA int(v^2/c^2 + s^2) dx, in units of E_1 = 1/2 EA g^2/L.
    const State state = test::randomState(17);
    const double integral = (velocity(state).squaredNorm() + strain(state).squaredNorm()) / 17.0;
    CHECK(energyRatio(state) == Approx(integral).epsilon(1e-14));
}

TEST_CASE("state: refinement repeats each cell and keeps energy and tip displacement")
{
    const State coarse = test::randomState(5);
    const State fine = refined(coarse, 3);
    REQUIRE(fine.cells() == 15);
    for (Eigen::Index i = 0; i < 15; ++i) {
        CHECK(fine.a[i] == coarse.a[i / 3]);
        CHECK(fine.b[i] == coarse.b[i / 3]);
    }
    CHECK(energyRatio(fine) == Approx(energyRatio(coarse)).epsilon(1e-14));
    CHECK(displacement(fine)[14] == Approx(displacement(coarse)[4]).epsilon(1e-13));
}
