#pragma once
/// \file
/// Quantities of modes are linear in their period.

#include <cmath>
#include <cstdint>

#include "signorini/modes.hpp"

namespace signorini {

/// k T + l, rounded once. \pre |k|, |l| < 2^53.
[[nodiscard]] inline double linear(std::int64_t k, double period, std::int64_t l)
{
    return std::fma(static_cast<double>(k), period, static_cast<double>(l));
}

/// 1/sqrt(E/E_1) = gapSign (kappa T - mu)/divisor > 0 between two periods.
struct ModeLine {
    ExactPeriod lowest;
    ExactPeriod highest;
    std::int64_t kappa = 0;
    std::int64_t mu = 0;
    std::int64_t divisor = 1;
    int gapSign = 1;
};

/// Is there a motion inside with T <= maxPeriod and E/E_1 <= maxEnergyRatio? Exact.
[[nodiscard]] bool isWithin(const ModeLine& line, const ModeBounds& bounds);

/// The limits of E/E_1 at both ends.
[[nodiscard]] EnergyRange energyLimits(const ModeLine& line);

}  // namespace signorini
