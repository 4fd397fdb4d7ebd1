#pragma once
/// \file
/// A response that chooses its grid: coarse over the whole range, then finer where something
/// happens, until the answer no longer changes. Where no motion touches a stop a coarse grid says
/// as much as a fine one.

#include <functional>
#include <vector>

#include "signorini/response.hpp"

namespace signorini {

/// All n of a range, or those that were done when it was cancelled.
using WorkResponse = std::function<std::vector<FrequencyResponse>(const ResponseRange&)>;

/// N of the first grid, by which each next one is finer, and of the last.
inline constexpr std::int64_t coarseResponseCells = 40;
inline constexpr std::int64_t mostRefinedCells = 160;

/// Something happens where a motion touches a stop, or the linear one would. The grid is twice as
/// fine each time, there and a step beyond, until largest impulse, force and strain change by less
/// than 1 % and the ends of the band by less than a step of the coarser grid, or N is
/// mostRefinedCells. range.cells becomes the N of the last. By descending frequency, on different
/// grids: N = n omega/omega_1/(4K).
[[nodiscard]] std::vector<FrequencyResponse> refinedResponse(ResponseRange& range,
                                                             const WorkResponse& work);

}  // namespace signorini
