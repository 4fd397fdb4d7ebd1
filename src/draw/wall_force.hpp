#pragma once
/// \file
/// The force of the wall on the tip, step by step.

#include <cstdint>
#include <vector>

#include "signorini/motion.hpp"
#include "signorini/schedule.hpp"

namespace signorini {

/// R = 2 p_m in contact, 0 in flight [EA g/L], for each step of the folded schedule. O(n).
[[nodiscard]] std::vector<double> wallForce(const State& state, const Schedule& schedule);

/// Steps [from, to[ in which the wall presses.
struct Pressed {
    std::int64_t from;
    std::int64_t to;
};

/// Where a force acts, in order: not where a schedule only allows it. O(n).
[[nodiscard]] std::vector<Pressed> pressed(const std::vector<double>& force);

}  // namespace signorini
