#pragma once
/// \file
/// The dual of a linear program, for methods whose cost grows with the number of rows:
///
///     maximise    equalityRhs . y + inequalityRhs . mu + lower . z + upper . w
///     subject to  equalities^T y + inequalities^T mu + z + w = linear
///                 mu <= 0, z >= 0, w <= 0
///
/// with z and w of finite bounds alone. Its rows are the unknowns of the program, and their
/// multipliers its solution.

#include "solver.hpp"

namespace signorini {

/// Unknowns y, mu, z, w; what is maximised is minimised with the other sign. O(entries).
[[nodiscard]] Program dualOf(const Program& program);

/// What the answer to the dual says of the program: point and multipliers, or that it is
/// infeasible because the dual is unbounded. An infeasible dual says nothing: `failed`.
[[nodiscard]] SolverResult ofProgram(const Program& program, const SolverResult& ofDual);

}  // namespace signorini
