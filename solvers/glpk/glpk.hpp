#pragma once
/// \file
/// GLPK behind the Solver interface. GLPK is GPL: a build with it is under the GPL as a whole.
///
/// GLPK keeps one environment per thread, so solvers may run in several threads at once. Where it
/// would stop the process for want of memory, std::bad_alloc is thrown (see guarded.hpp); the hooks
/// of the thread's environment are taken for that.

#include <memory>
#include <string>

#include "solver.hpp"

namespace signorini::glpk {

/// Version of the linked library, e.g. "5.0".
[[nodiscard]] std::string version();

/// Primal simplex in doubles, with GLPK's presolver.
[[nodiscard]] std::unique_ptr<Solver> makeSimplex(const Backend& row);

/// Primal-dual interior point. It has no settings: no tolerance, no limits.
[[nodiscard]] std::unique_ptr<Solver> makeInterior(const Backend& row);

/// Simplex in rational numbers: pivots and verdict are exact, the point is rounded at the end.
[[nodiscard]] std::unique_ptr<Solver> makeExact(const Backend& row);

}  // namespace signorini::glpk
