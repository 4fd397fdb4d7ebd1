#pragma once
/// \file
/// How far a solver's point is from the minimum of a diagonal quadratic objective.

#include <optional>

#include "solver.hpp"

namespace signorini {

/// A bound on the distance of x from the minimiser x*, in the metric of the objective and relative
/// to the size of x: with g the gradient at x, convexity gives
///
///     sum q_i (x_i - x*_i)^2  <=  g . x - min over the rows of g . y,
///
/// a linear program, whose solver did not find x. Empty if that does not solve it.
[[nodiscard]] std::optional<double> minimumError(const Program& program, const Eigen::VectorXd& x,
                                                 const Solver& linear,
                                                 const SolverOptions& options);

}  // namespace signorini
