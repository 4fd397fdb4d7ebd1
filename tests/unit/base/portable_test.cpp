// Against numbers of 113 bits by Boost, in units of the last place.

#include "portable.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "catch.hpp"

using namespace signorini;
using Wide = boost::multiprecision::cpp_bin_float_quad;

namespace {

double unitsOff(double value, const Wide& truth)
{
    const double size = std::abs(static_cast<double>(truth));
    const double unit = std::nextafter(size, 2.0 * size) - size;
    return std::abs(static_cast<double>((Wide(value) - truth) / unit));
}

/// The most that a function is off at random arguments, of both signs where `low` < 0, half of them
/// small.
template <typename Function, typename Truth>
double worst(double low, double high, Function function, Truth truth)
{
    std::mt19937_64 generator(20191);
    std::uniform_real_distribution<double> even(low, high);
    std::uniform_real_distribution<double> power(-9.0, 0.0);
    double most = 0.0;
    for (int k = 0; k < 4000; ++k) {
        const double x = even(generator) * (k % 2 == 0 ? 1.0 : std::pow(10.0, power(generator)));
        most = std::max(most, unitsOff(function(x), truth(Wide(x))));
    }
    return most;
}

}  // namespace

TEST_CASE("portable functions are off by units in the last place alone")
{
    CHECK(worst(-700.0, 700.0, portable::exp, [](const Wide& x) { return Wide(exp(x)); }) < 1.0);
    CHECK(worst(-40.0, 700.0, portable::expm1, [](const Wide& x) { return Wide(expm1(x)); }) < 1.5);
    CHECK(worst(-1.0, 0.5, portable::expm1, [](const Wide& x) { return Wide(expm1(x)); }) < 1.5);
    CHECK(worst(0.0, 1e9, portable::log, [](const Wide& x) { return Wide(log(x)); }) < 1.0);
    CHECK(worst(0.5, 2.0, portable::log, [](const Wide& x) { return Wide(log(x)); }) < 1.0);
    CHECK(worst(0.0, 20.0, portable::tanh, [](const Wide& x) { return Wide(tanh(x)); }) < 3.0);
    CHECK(worst(-10.0, 10.0, portable::sin, [](const Wide& x) { return Wide(sin(x)); }) < 1.0);
    CHECK(worst(-10.0, 10.0, portable::cos, [](const Wide& x) { return Wide(cos(x)); }) < 1.0);
    CHECK(worst(-1e6, 1e6, portable::sin, [](const Wide& x) { return Wide(sin(x)); }) < 1.0);
    CHECK(worst(-1e6, 1e6, portable::cos, [](const Wide& x) { return Wide(cos(x)); }) < 1.0);
    CHECK(worst(-1.0, 1.0, portable::acos, [](const Wide& x) { return Wide(acos(x)); }) < 3.0);
    const auto angle = [](double x) { return portable::atan2(x, -0.7); };
    CHECK(worst(-9.0, 9.0, angle, [](const Wide& x) { return Wide(atan2(x, Wide(-0.7))); }) < 3.0);
    const auto slope = [](double x) { return portable::atan2(x, 0.7); };
    CHECK(worst(-9.0, 9.0, slope, [](const Wide& x) { return Wide(atan2(x, Wide(0.7))); }) < 3.0);
    const auto length = [](double x) { return portable::hypot(x, 0.7); };
    CHECK(worst(-9.0, 9.0, length,
                [](const Wide& x) { return Wide(sqrt(x * x + Wide(0.7) * Wide(0.7))); }) < 0.51);
    const auto tenth = [](double x) { return portable::pow(x, 10.0); };
    CHECK(worst(0.5, 1.0, tenth, [](const Wide& x) { return Wide(pow(x, 10)); }) < 300.0);
}

TEST_CASE("portable functions at their ends")
{
    CHECK(portable::exp(0.0) == 1.0);
    CHECK(portable::exp(-800.0) == 0.0);
    CHECK(std::isinf(portable::exp(800.0)));
    CHECK(std::isnan(portable::exp(std::nan(""))));
    CHECK(portable::expm1(0.0) == 0.0);
    CHECK(portable::expm1(-800.0) == -1.0);
    CHECK(std::isinf(portable::expm1(709.9)));
    CHECK(portable::log(1.0) == 0.0);
    CHECK(std::isinf(portable::log(0.0)));
    CHECK(std::isnan(portable::log(-1.0)));
    CHECK(portable::tanh(0.0) == 0.0);
    CHECK(portable::tanh(500.0) == 1.0);
    CHECK(portable::cos(0.0) == 1.0);
    CHECK(portable::sin(0.0) == 0.0);
    CHECK(portable::atan2(0.0, 0.0) == 0.0);
    CHECK(portable::atan2(0.0, -1.0) == std::numbers::pi);
    CHECK(portable::atan2(-2.0, 0.0) == -std::numbers::pi / 2.0);
    CHECK(portable::hypot(3.0, -4.0) == 5.0);
    CHECK(portable::hypot(3e300, 4e300) == 5e300);
    CHECK(portable::hypot(0.0, 0.0) == 0.0);
}
