#pragma once
/// \file
/// What is measured at one value of a sweep.

#include <cstdint>
#include <functional>
#include <vector>

#include "network_simulation.hpp"
#include "signorini/settling.hpp"
#include "signorini/sweep.hpp"

namespace signorini {

/// Goes on for so long in units of the start's `Waves`. \return the largest |b - a|/speed over all
/// x in that time, exactly. Looks at each segment once in the time in which waves cross it.
double largestStrain(BarSimulation& simulation, double duration);

/// Goes on for so long [h]. \return the largest |(l - r)/speed| over all bars in that time, the
/// shape at rest included; exactly, with weight to within that of half a cell.
double largestStrain(NetworkSimulation& simulation, double duration);

/// Follows until it repeats itself, or for `most` periods, and looks after 50, 100, 200, ...
/// \return whether it was not cancelled
[[nodiscard]] bool settle(SweepPoint& point, std::int64_t most,
                          const std::function<Followed(double periods)>& follow);

/// Takes what was counted in each of the periods that are reported.
void enterPeriods(SweepPoint& point, const std::vector<std::int64_t>& contacts,
                  const std::vector<double>& impulses);

}  // namespace signorini
