#pragma once
/// \file
/// Running a back end on a posed request.

#include "formulation.hpp"
#include "request.hpp"
#include "solver.hpp"

namespace signorini {

/// Solves; most energy by climbing, held energies from a start that takes amplitudes apart. Leaves
/// the direction of the last climb in the program.
[[nodiscard]] SolverResult solve(Formulated& formulated, Objective objective, const Solver& solver,
                                 const SolverOptions& settings);

}  // namespace signorini
