#pragma once
/// \file
/// signorini simulate --force-range: what any force between two bounds can do.

#include "simulate_command.hpp"

namespace signorini::cli {

/// Asks, and reports to stdout. \throws std::invalid_argument on options that do not go with it.
[[nodiscard]] ExitStatus reportReach(const SimulateCommand& command);

}  // namespace signorini::cli
