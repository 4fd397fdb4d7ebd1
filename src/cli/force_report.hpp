#pragma once
/// \file
/// Damping in answers, and the units in which forces and impulses are told.

#include "json.hpp"
#include "signorini/simulation.hpp"

namespace signorini::cli {

/// {"ratio": zeta, "dashpot": N s/m}.
[[nodiscard]] Json dampingAsJson(const Damping& damping, const Bar& bar);

/// One unit of force [N], EA g/L, and of impulse [N s], EA g/c.
[[nodiscard]] double forceUnit(const Bar& bar);
[[nodiscard]] double impulseUnit(const Bar& bar);

}  // namespace signorini::cli
