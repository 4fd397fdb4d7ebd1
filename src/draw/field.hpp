#pragma once
/// \file
/// u(x, t) of a motion as an image.

#include <cstdint>
#include <vector>

#include "signorini/figure_data.hpp"
#include "signorini/motion.hpp"

namespace signorini {

/// 0, k, 2k, ... <= last, at most about `most`: an even grid, as an image needs it.
[[nodiscard]] std::vector<std::int64_t> evenly(std::int64_t last, std::int64_t most);

/// At so many nodes and instants at the most; of a bar of this length, a time L/c and a
/// displacement of 1, in the units of the axes. O(nodes instants).
[[nodiscard]] plot::Series fieldOf(const Motion& motion, double length, double time,
                                   double displacement, std::int64_t nodes, std::int64_t instants);

}  // namespace signorini
