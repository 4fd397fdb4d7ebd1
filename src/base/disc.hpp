#pragma once
/// \file
/// Complex numbers known to lie in a disc, whatever was rounded on the way. Where an interval for
/// each part would grow with every turn, a disc does not.

#include <algorithm>
#include <cmath>
#include <complex>

#include "interval.hpp"

namespace signorini {

/// Every operation widens its radius by more than its rounding.
struct Disc {
    std::complex<double> middle;
    double radius = 0.0;

    Disc() = default;
    Disc(std::complex<double> value, double within = 0.0)
        : middle(value), radius(within) {}  // NOLINT
    Disc(double value) : middle(value) {}   // NOLINT: a double is a disc

    friend Disc operator+(const Disc& x, const Disc& y)
    {
        return widened(x.middle + y.middle, x.radius + y.radius, size(x) + size(y));
    }
    friend Disc operator-(const Disc& x, const Disc& y)
    {
        return widened(x.middle - y.middle, x.radius + y.radius, size(x) + size(y));
    }
    friend Disc operator*(const Disc& x, const Disc& y)
    {
        return widened(x.middle * y.middle,
                       size(x) * y.radius + size(y) * x.radius + x.radius * y.radius,
                       size(x) * size(y));
    }
    /// Everything if y may be 0.
    friend Disc operator/(const Disc& x, const Disc& y)
    {
        const double apart = size(y) * (1.0 - slack) - y.radius;
        if (!(apart > 0.0)) {
            return {0.0, infinity};
        }
        const std::complex<double> quotient = x.middle / y.middle;
        return widened(quotient, (x.radius + (std::abs(quotient) + slack) * y.radius) / apart,
                       std::abs(quotient));
    }

    /// Re z, and |z|.
    [[nodiscard]] Interval real() const
    {
        return Interval(middle.real()) + Interval(-radius, radius);
    }
    [[nodiscard]] Interval magnitude() const
    {
        const double within = radius + slack * std::abs(middle);
        return {std::max(0.0, std::abs(middle) - within), std::abs(middle) + within};
    }

private:
    static constexpr double slack = 0x1p-50;

    static double size(const Disc& z) { return std::abs(z.middle); }
    static Disc widened(std::complex<double> middle, double radius, double terms)
    {
        return {middle, radius * (1.0 + slack) + slack * terms + 1e-300};
    }
};

}  // namespace signorini
