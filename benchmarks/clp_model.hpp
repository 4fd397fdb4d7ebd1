#pragma once
/// \file
/// A Program in the words of CLP.

#include <ClpSimplex.hpp>

#include "solver.hpp"

namespace signorini::bench {

/// Loads rows, bounds and objective, and silences CLP.
void loadClp(const Program& program, ClpSimplex& model);

/// The meaning of ClpSimplex::status.
[[nodiscard]] SolverStatus statusOfClp(int status);

}  // namespace signorini::bench
