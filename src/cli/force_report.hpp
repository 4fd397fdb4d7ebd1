#pragma once
/// \file
/// What answers about forced motions share: units, damping, a motion.

#include "json.hpp"
#include "signorini/response.hpp"
#include "signorini/simulation.hpp"

namespace signorini::cli {

/// {"ratio": zeta, "dashpot": N s/m}.
[[nodiscard]] Json dampingAsJson(const Damping& damping, const Bar& bar);

/// One unit of force [N], EA g/L, and of impulse [N s], EA g/c.
[[nodiscard]] double forceUnit(const Bar& bar);
[[nodiscard]] double impulseUnit(const Bar& bar);

/// What an amplitude of 1 is [N] or [m].
[[nodiscard]] double amplitudeUnit(Excited place, const Bar& bar);

/// A motion as all answers tell it.
[[nodiscard]] Json asJson(const ForcedMotion& motion, const Bar& bar);

}  // namespace signorini::cli
