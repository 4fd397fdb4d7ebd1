#pragma once
/// \file
/// From a schedule to a Program: which rows a solver gets.
///
/// `stateProgram` is the paper's own problem in a and b. The prefix sums of (12) enter as further
/// unknowns y_k = y_{k-1} + v(L)/(2c), y_k <= 0, so that every row stays sparse:
///
///     x = (a_1..a_N, b_1..b_N, y_1..y_m)          m = free steps of the folded schedule
///     (W - 1)(a, b) = 0                           (30), 2N rows
///     sum(b - a) = N                              (31)
///     -p_m <= 0                                   (10), one row per contact step
///     y_k - y_{k-1} - v_k = 0,   y_k <= 0         (12), and (11), which is its first row
///     y_k = 0 at the end of each free phase       only when there are several: one phase implies
///     it

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "signorini/program.hpp"
#include "signorini/schedule.hpp"
#include "signorini/state.hpp"

namespace signorini {

/// A program and the words for what it does not contain.
struct Formulated {
    Program program;
    std::vector<std::string> leftOut;
};

/// The paper's problem in a, b, without objective. O(n + N) memory.
/// \throws std::invalid_argument on an invalid or too large schedule (equations.hpp).
[[nodiscard]] Formulated stateProgram(const Schedule& schedule);

/// a and b out of the unknowns of `stateProgram`.
[[nodiscard]] State stateOf(const Eigen::VectorXd& x, std::int64_t cells);

}  // namespace signorini
