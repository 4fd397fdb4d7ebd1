#pragma once
/// \file
/// COIN-OR CLP as one more solver, a rival that the library does not link.

#include <memory>
#include <string_view>
#include <vector>

#include "solver.hpp"

namespace signorini::bench {

/// "clp-simplex", "clp-barrier" (without crossover), "clp-primal" (quadratic programs too).
[[nodiscard]] const std::vector<std::string_view>& clpMethods();

/// "1.17.6", or "absent" if this build found no CLP.
[[nodiscard]] std::string_view clpVersion();

/// \throws BackendUnavailable if this build found no CLP.
[[nodiscard]] std::unique_ptr<Solver> makeClp(std::string_view method);

}  // namespace signorini::bench
