#include "mode_line.hpp"

#include <algorithm>
#include <limits>

#include "rational.hpp"

namespace signorini {

bool isWithin(const ModeLine& line, const ModeBounds& bounds)
{
    const Rational lowest(line.lowest.numerator, line.lowest.denominator);
    const Rational highest(line.highest.numerator, line.highest.denominator);
    const Rational longest(bounds.maxPeriod);
    if (longest <= lowest) {
        return false;
    }
    // gapSign (kappa T - mu) > 0 is monotone, so the end where it is largest decides; ends of the
    // interval are no members.
    const std::int64_t slope = line.gapSign * line.kappa;
    const bool isReached = slope == 0 || (slope > 0 && longest < highest);
    const Rational best = slope < 0 ? lowest : std::min(longest, highest);
    const Rational root = (line.kappa * best - line.mu) / line.divisor;
    const Rational ratio = root * root * Rational(bounds.maxEnergyRatio);
    return isReached ? ratio >= 1 : ratio > 1;
}

EnergyRange energyLimits(const ModeLine& line)
{
    const auto square = [](std::int64_t value) {
        return static_cast<double>(value) * static_cast<double>(value);
    };
    const auto limit = [&](const ExactPeriod& end) {
        const std::int64_t root = line.kappa * end.numerator - line.mu * end.denominator;
        return root == 0 ? std::numeric_limits<double>::infinity()
                         : square(line.divisor * end.denominator) / square(root);
    };
    const auto [least, most] = std::minmax({limit(line.lowest), limit(line.highest)});
    return {least, most};
}

}  // namespace signorini
