#pragma once
/// \file
/// Where in a period the wall presses.

#include <cstdint>
#include <vector>

#include "signorini/motion.hpp"

namespace signorini {

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
