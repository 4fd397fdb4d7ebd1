#pragma once
/// \file
/// Ipopt behind the Solver interface: linear and convex quadratic programs, and programs with an
/// energy equality.
///
/// Ipopt is a local method. On a convex program what it finds is the minimum; with an energy
/// equality it is a local one. It never answers "infeasible" after a search.

#include <memory>
#include <string>

#include "solver.hpp"

namespace signorini::ipopt {

/// Version of the headers this was compiled with, e.g. "3.11.9".
[[nodiscard]] std::string version();

[[nodiscard]] std::unique_ptr<Solver> makeIpopt(const Backend& row);

}  // namespace signorini::ipopt
