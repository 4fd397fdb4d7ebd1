#pragma once
/// \file
/// NLopt behind the Solver interface: small and medium programs, as a second opinion.
///
/// NLopt wants neither redundant equalities nor, in practice, any linear ones: it stops at x = 0
/// and calls that success. So the equalities are solved first (free_program.hpp) and NLopt
/// searches among their solutions, where only inequalities, bounds and an energy equality are left.
/// A program without an objective gets the point nearest to the start. All three methods are local;
/// none answers "infeasible" after a search.

#include <memory>
#include <string>

#include "solver.hpp"

namespace signorini::nlopt {

/// Version of the linked library, e.g. "2.7.1".
[[nodiscard]] std::string version();

/// Sequential least squares, dense: O(d^3) per iteration, d = variables - independent equalities.
[[nodiscard]] std::unique_ptr<Solver> makeSlsqp(const Backend& row);

/// Augmented Lagrangian, each of its subproblems by separable convex approximations (CCSAQ).
[[nodiscard]] std::unique_ptr<Solver> makeAuglag(const Backend& row);

/// Linear approximations without derivatives.
[[nodiscard]] std::unique_ptr<Solver> makeCobyla(const Backend& row);

}  // namespace signorini::nlopt
