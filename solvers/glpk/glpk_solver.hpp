#pragma once
/// \file
/// GLPK behind the Solver interface. GLPK is GPL: a build with it is under the GPL as a whole.

#include <memory>
#include <string>

#include "signorini/solver.hpp"

namespace signorini::glpk {

/// Version of the linked library, e.g. "5.0".
[[nodiscard]] std::string version();

/// Primal simplex in doubles, with GLPK's presolver.
[[nodiscard]] std::unique_ptr<Solver> makeSimplex();

}  // namespace signorini::glpk
