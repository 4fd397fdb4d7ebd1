#pragma once
/// \file
/// Programs in their own units, so that the absolute tolerances of solver libraries mean something.
///
/// With the gap row in metres, 1e-10 on its right side, a solver with a tolerance of 1e-7 accepts
/// x = 0. Unknowns are therefore counted in units of about `naturalSize`, rows and objective
/// divided by about their largest coefficient. All factors are powers of two: nothing is rounded.

#include <optional>

#include "solver.hpp"

namespace signorini {

/// The factors between a program and its scaled copy.
struct Scaling {
    double unit = 1.0;             ///< x = unit * (scaled x)
    Eigen::VectorXd equalities;    ///< each row is multiplied by this
    Eigen::VectorXd inequalities;  ///< likewise
    double objective = 1.0;        ///< likewise
};

/// Nothing if the program is well scaled already, every factor within 2^-10 .. 2^10. O(entries).
[[nodiscard]] std::optional<Scaling> scalingOf(const Program& program);

/// The scaled copy.
[[nodiscard]] Program scaled(const Program& program, const Scaling& scaling);

/// Point and multipliers of the scaled copy, turned into those of the program.
void unscale(const Scaling& scaling, SolverResult& result);

}  // namespace signorini
