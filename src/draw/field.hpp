#pragma once
/// \file
/// u(x, t) of a motion as an image, and where in a period the wall presses.

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

/// `Motion::wallForce` of all steps. O(n).
[[nodiscard]] std::vector<double> wallForces(const Motion& motion);

/// Steps [from, to[ in which the wall presses.
struct Pressed {
    std::int64_t from;
    std::int64_t to;
};

/// Where a force acts, in order: not where a schedule only allows it. O(n).
[[nodiscard]] std::vector<Pressed> pressed(const std::vector<double>& force);

}  // namespace signorini
