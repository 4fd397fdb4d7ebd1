#pragma once
/// \file
/// Proofs that a program has no feasible point, exact though a solver in doubles suggests them.
///
/// For the rows of a Program (energy equality and objective aside) a proof is a pair (y, mu >= 0)
/// of integers such that with c = equalities^T y + inequalities^T mu
///
///     min over lower <= x <= upper of c . x   >   y . equalityRhs + mu . inequalityRhs:
///
/// every x within the bounds breaks the combined row. All numbers of a program are doubles, hence
/// exact rationals, and the comparison is made in rational arithmetic.

#include <optional>

#include "program.hpp"
#include "signorini/certificate.hpp"
#include "solver.hpp"

namespace signorini {

/// Checks a proof in exact rational arithmetic. O(entries of the rows used + n).
[[nodiscard]] bool isProof(const InfeasibilityProof& proof, const Program& program);

/// The same for multipliers that are rationals; false also where one cannot be read.
[[nodiscard]] bool isProof(const RationalProof& proof, const Program& program);

/// The proof by a single row with multiplier 1 or -1, if the bounds alone contradict one: what a
/// limit too tight for the gap row needs. O(entries).
[[nodiscard]] std::optional<InfeasibilityProof> proveByOneRow(const Program& program);

/// Looks for a proof: solves the elastic phase-one program (least sum of row violations) with a
/// back end that returns duals, rounds the duals to rationals of small denominator, clears the
/// denominators, and checks the result exactly. Empty if the phase one finds a feasible point, or
/// if no exact proof came of it.
/// \throws std::invalid_argument if the solver does not return duals.
[[nodiscard]] std::optional<InfeasibilityProof> proveInfeasible(const Program& program,
                                                                const Solver& solver,
                                                                const SolverOptions& options = {});

}  // namespace signorini
