#pragma once
/// \file
/// What is measured at one value of a sweep.

#include "signorini/sweep.hpp"

namespace signorini {

/// Largest |b - a| over all x while the tip is watched for so many crossings of the bar, exactly:
/// what left the tip at t_1 meets what arrives there at t_2, t_1 <= t_2 <= t_1 + 2 L/c. `states`
/// are those at the beginning, and after each crossing. O(pieces).
[[nodiscard]] double largestStrain(const std::vector<Waves>& states);

/// The waves in a stretch of the bar of so many units, `begin` of them before it from the base.
[[nodiscard]] Waves partOf(const Waves& waves, double begin, double crossing);

}  // namespace signorini
