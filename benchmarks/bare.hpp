#pragma once
/// \file
/// Solver libraries called as their manuals show it: default settings, the program in whatever
/// units it comes, the answer believed.

#include <string_view>
#include <vector>

#include "solver.hpp"

namespace signorini::bench {

/// What the library says, and its point.
struct BareAnswer {
    SolverStatus status = SolverStatus::notRun;
    Eigen::VectorXd x;
};

/// "glpk-simplex", "clp-simplex", "clp-barrier", "ipopt".
[[nodiscard]] const std::vector<std::string_view>& bareLibraries();

/// \throws BackendUnavailable if this build does not contain the library.
[[nodiscard]] BareAnswer solveBare(std::string_view library, const Program& program);

}  // namespace signorini::bench
