#include "axes.hpp"

#include <cmath>

#include "catch.hpp"

using namespace signorini;

TEST_CASE("axes: numbers on an axis are from 1 to below 1000 of an engineer's unit")
{
    CHECK(unitFor(0.002, "m").name == "mm");
    CHECK(unitFor(0.002, "m").factor == Approx(1e3));
    CHECK(unitFor(1.0, "s").name == "s");
    CHECK(unitFor(999.9, "N").name == "N");
    CHECK(unitFor(1000.0, "N").name == "kN");
    CHECK(unitFor(1e-12, "J").name == "pJ");
    CHECK(unitFor(1e-15, "J").name == "10^{-15} J");
    CHECK(unitFor(4e-6, "").name == "10^{-6}");
    CHECK(unitFor(0.0, "m").name == "m");
    for (const double size : {1e-300, 3.7e-16, 1e-12, 0.25, 1.0, 12.0, 999.0, 1e3, 7.7e11, 1e299}) {
        const double shown = size * unitFor(size, "m").factor;
        INFO(size);
        CHECK(shown >= 0.999999);
        CHECK(shown < 1000.0);
    }
    // At the ends of a double the number is still one.
    CHECK(std::isfinite(unitFor(5e-324, "m").factor));
    CHECK(5e-324 * unitFor(5e-324, "m").factor > 0.0);
}

TEST_CASE("axes: quantities as people write them")
{
    CHECK(withUnit(1e-3, "m") == "1 mm");
    CHECK(withUnit(-2.5e4, "N") == "-25 kN");
    CHECK(withUnit(0.5, "") == "500·10^{-3}");
    CHECK(withUnit(2.0, "") == "2");
}

TEST_CASE("axes: steps are 1, 2 or 5 times a power of ten, and not below what was asked")
{
    CHECK(niceStep(1.0) == Approx(1.0));
    CHECK(niceStep(1.1) == Approx(2.0));
    CHECK(niceStep(0.03) == Approx(0.05));
    CHECK(niceStep(600.0) == Approx(1000.0));
}
