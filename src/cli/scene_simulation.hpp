#pragma once
/// \file
/// signorini simulate --scene: the simulation of a network in SI.

#include "arguments.hpp"

namespace signorini::cli {

struct SimulateCommand;

/// Does the work of a call with --scene. Exceptions are for `main` to translate.
[[nodiscard]] ExitStatus simulateScene(const SimulateCommand& command);

}  // namespace signorini::cli
