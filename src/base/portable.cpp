#include "portable.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

namespace signorini::portable {

namespace {

template <std::size_t N>
double polynomial(const std::array<double, N>& coefficients, double x)
{
    double value = 0.0;
    for (std::size_t k = N; k-- > 0;) {
        value = value * x + coefficients[k];
    }
    return value;
}

/// sign^k/(first + step k)!.
template <std::size_t N>
constexpr std::array<double, N> inverseFactorials(int first, int step, double sign)
{
    std::array<double, N> all{};
    for (std::size_t k = 0; k < N; ++k) {
        double factorial = 1.0;
        for (int j = 2; j <= first + step * static_cast<int>(k); ++j) {
            factorial *= j;  // exact, or far beyond what matters
        }
        all[k] = (sign < 0.0 && k % 2 == 1 ? -1.0 : 1.0) / factorial;
    }
    return all;
}

// ln 2 and pi/2 in parts of at most 33 bits and a rest, so that multiples of the parts are exact.
constexpr double ln2High = 0x1.62e42feep-1;
constexpr double ln2Low = 0x1.a39ef35793c76p-33;
constexpr double quarterHigh = 0x1.921fb544p+0;
constexpr double quarterMiddle = 0x1.0b4611a6p-34;
constexpr double quarterLow = 0x1.3198a2e037073p-69;
constexpr double piLow = 0x1.1a62633145c07p-53;  // pi less the double next to it

/// e^x = 2^power (1 + rest), |rest| < 1/2.
struct Exponential {
    int power;
    double rest;
};

constexpr double mostExponent = 746.0;  // beyond, e^x is 0 or infinite

Exponential reducedExp(double x)
{
    const double turns = std::nearbyint(x / std::numbers::ln2);
    const double high = x - turns * ln2High;
    const double low = turns * ln2Low;
    const double r = high - low;
    const double rest = (high - r) - low;
    static constexpr auto series = inverseFactorials<14>(2, 1, 1.0);
    return {static_cast<int>(turns), r + (r * r * polynomial(series, r) + (rest + rest * r))};
}

/// An angle less whole quarters of a turn: |high + low| <= pi/4.
struct Angle {
    int quarter;  ///< of 4
    double high;
    double low;
};

Angle reducedAngle(double x)
{
    const double turns = std::nearbyint(x * (2.0 / std::numbers::pi));
    const double first = x - turns * quarterHigh;
    const double middle = turns * quarterMiddle;
    const double second = first - middle;
    const double rest = turns * quarterLow - ((first - second) - middle);
    const double high = second - rest;
    return {static_cast<int>(turns - 4.0 * std::floor(0.25 * turns)), high, (second - high) - rest};
}

double sinOf(const Angle& angle)
{
    static constexpr auto series = inverseFactorials<8>(5, 2, -1.0);
    const auto [quarter, x, low] = angle;
    const double z = x * x;
    const double cube = z * x;
    return x - ((z * (0.5 * low - cube * polynomial(series, z)) - low) + cube * (1.0 / 6.0));
}

double cosOf(const Angle& angle)
{
    static constexpr auto series = inverseFactorials<8>(4, 2, -1.0);
    const auto [quarter, x, low] = angle;
    const double z = x * x;
    const double half = 0.5 * z;
    const double most = 1.0 - half;
    return most + (((1.0 - most) - half) + (z * z * polynomial(series, z) - x * low));
}

constexpr double mostAngle = 1e6;

/// sin(x + quarters pi/2).
double wave(double x, int quarters)
{
    Angle angle = reducedAngle(x);
    angle.quarter = (angle.quarter + quarters) % 4;
    const double value = angle.quarter % 2 == 0 ? sinOf(angle) : cosOf(angle);
    return angle.quarter < 2 ? value : -value;
}

/// The angle of (1, t), 0 <= t <= 1: one step of Newton's from within 0.004.
double slopeAngle(double t)
{
    const double near = t * (0.25 * std::numbers::pi + 0.273 * (1.0 - t));
    const double s = sin(near);
    const double c = cos(near);
    const double tangent = (t * c - s) / (c + t * s);
    const double z = tangent * tangent;
    return near + (tangent - tangent * z * (1.0 / 3.0 - z * (0.2 - z / 7.0)));
}

}  // namespace

double exp(double x)
{
    if (!(std::abs(x) < mostExponent)) {
        return x < 0.0 ? 0.0 : x > 0.0 ? std::numeric_limits<double>::infinity() : x;
    }
    const auto [power, rest] = reducedExp(x);
    return std::ldexp(1.0 + rest, power);
}

double expm1(double x)
{
    if (!(std::abs(x) < mostExponent)) {
        return exp(x) - 1.0;
    }
    const auto [power, rest] = reducedExp(x);
    return power > 100 ? std::ldexp(1.0 + rest, power)
                       : std::ldexp(rest, power) + (std::ldexp(1.0, power) - 1.0);
}

double log(double x)
{
    if (!(x > 0.0 && x < std::numeric_limits<double>::infinity())) {
        return x == 0.0  ? -std::numeric_limits<double>::infinity()
               : x > 0.0 ? x
                         : std::numeric_limits<double>::quiet_NaN();
    }
    int power = 0;
    double m = std::frexp(x, &power);
    if (m < 0.5 * std::numbers::sqrt2) {
        m *= 2.0;
        --power;
    }
    // log(1 + f) = 2 artanh s.
    const double f = m - 1.0;
    const double s = f / (2.0 + f);
    const double z = s * s;
    static constexpr std::array series{2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11, 2.0 / 13,
                                       2.0 / 15, 2.0 / 17, 2.0 / 19, 2.0 / 21, 2.0 / 23};
    const double half = 0.5 * f * f;
    return power * ln2High -
           ((half - (s * (half + z * polynomial(series, z)) + power * ln2Low)) - f);
}

double pow(double x, double y)
{
    return exp(y * log(x));
}

double tanh(double x)
{
    const double lost = -expm1(-2.0 * x);
    return lost / (2.0 - lost);
}

double sin(double x)
{
    return std::abs(x) <= mostAngle ? wave(x, 0) : std::sin(x);
}

double cos(double x)
{
    return std::abs(x) <= mostAngle ? wave(x, 1) : std::cos(x);
}

double atan2(double y, double x)
{
    const double across = std::abs(x);
    const double up = std::abs(y);
    if (!(std::max(across, up) > 0.0)) {
        return 0.0;
    }
    double angle = slopeAngle(std::min(across, up) / std::max(across, up));
    if (up > across) {
        angle = 0.5 * std::numbers::pi - (angle - 0.5 * piLow);
    }
    if (x < 0.0) {
        angle = std::numbers::pi - (angle - piLow);
    }
    return y < 0.0 ? -angle : angle;
}

double acos(double x)
{
    return atan2(std::sqrt((1.0 - x) * (1.0 + x)), x);
}

double hypot(double x, double y)
{
    const double most = std::max(std::abs(x), std::abs(y));
    if (!(most > 0.0 && most < std::numeric_limits<double>::infinity())) {
        return most;
    }
    // Scaled by a power of two, which is exact.
    const int power = std::ilogb(most);
    const double u = std::scalbn(most, -power);
    const double v = std::scalbn(std::min(std::abs(x), std::abs(y)), -power);
    const double root = std::sqrt(u * u + v * v);
    // What rounding has left: root^2 - u^2 - v^2 in two parts each.
    const auto square = [](double z) { return std::pair(z * z, std::fma(z, z, -(z * z))); };
    const auto [all, allRest] = square(root);
    const auto [first, firstRest] = square(u);
    const auto [second, secondRest] = square(v);
    const double over = ((all - first) - second) + ((allRest - firstRest) - secondRest);
    return std::scalbn(root - 0.5 * over / root, power);
}

}  // namespace signorini::portable
