#pragma once
/// \file
/// What is measured at one value of a sweep.

#include "network_simulation.hpp"
#include "signorini/sweep.hpp"

namespace signorini {

/// Largest |b - a| over all x while the tip is watched for so many crossings of the bar, exactly:
/// what left the tip at t_1 meets what arrives there at t_2, t_1 <= t_2 <= t_1 + 2 L/c. `states`
/// are those at the beginning, and after each crossing. O(pieces).
[[nodiscard]] double largestStrain(const std::vector<Waves>& states);

/// Goes on for so long [h]. \return the largest |(l - r)/speed| over all bars in that time, the
/// shape at rest included; exactly, with weight to within that of half a cell. Looks at each row
/// once in the time in which waves cross it.
double largestStrain(NetworkSimulation& simulation, double duration);

/// The waves in a stretch of the bar of so many units, `begin` of them before it from the base.
[[nodiscard]] Waves partOf(const Waves& waves, double begin, double crossing);

}  // namespace signorini
