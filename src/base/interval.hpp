#pragma once
/// \file
/// Numbers that are known to lie between two doubles, whatever was rounded on the way.

#include <algorithm>
#include <cmath>

#include "infinity.hpp"

namespace signorini {

/// Every operation widens its result by one double to each side, which covers its rounding.
struct Interval {
    double low = 0.0;
    double high = 0.0;

    Interval() = default;
    Interval(double value) : low(value), high(value) {}  // NOLINT: a double is an interval
    Interval(double least, double most) : low(least), high(most) {}

    [[nodiscard]] bool isPositive() const { return low > 0.0; }
    [[nodiscard]] bool isNegative() const { return high < 0.0; }

    friend Interval operator+(Interval x, Interval y)
    {
        return widened(x.low + y.low, x.high + y.high);
    }
    friend Interval operator-(Interval x, Interval y)
    {
        return widened(x.low - y.high, x.high - y.low);
    }
    friend Interval operator*(Interval x, Interval y)
    {
        const auto [least, most] =
            std::minmax({x.low * y.low, x.low * y.high, x.high * y.low, x.high * y.high});
        return widened(least, most);
    }
    /// Everything if y may be 0.
    friend Interval operator/(Interval x, Interval y)
    {
        if (!y.isPositive() && !y.isNegative()) {
            return {-infinity, infinity};
        }
        const auto [least, most] =
            std::minmax({x.low / y.low, x.low / y.high, x.high / y.low, x.high / y.high});
        return widened(least, most);
    }

    /// The roots of what of it is not negative.
    [[nodiscard]] Interval root() const
    {
        return widened(std::sqrt(std::max(low, 0.0)), std::sqrt(std::max(high, 0.0)));
    }
    /// The largest |x|.
    [[nodiscard]] Interval magnitude() const
    {
        return {std::max({low, -high, 0.0}), std::max(std::abs(low), std::abs(high))};
    }
    /// By one double to each side.
    [[nodiscard]] Interval widened() const { return widened(low, high); }

private:
    static Interval widened(double low, double high)
    {
        return {std::nextafter(low, -infinity), std::nextafter(high, infinity)};
    }
};

}  // namespace signorini
