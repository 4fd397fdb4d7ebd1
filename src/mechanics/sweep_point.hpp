#pragma once
/// \file
/// What is measured at one value of a sweep.

#include "signorini/sweep.hpp"

namespace signorini {

/// Largest |b - a| over all x while the tip is watched for so many crossings of the bar, exactly:
/// what left the tip at t_1 meets what arrives there at t_2, t_1 <= t_2 <= t_1 + 2 L/c. `states`
/// are those at the beginning, and after each crossing. O(pieces).
[[nodiscard]] double largestStrain(const std::vector<Waves>& states);

}  // namespace signorini
