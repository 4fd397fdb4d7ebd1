#pragma once
/// \file
/// The energies of motions within a limit on strain: p_m <= cap, so no amplitude exceeds it.
///
/// All motions within the limit are a polytope, so their energies are those from the least to the
/// most, and the motions on the way from the one to the other have them all. Where the sums S of
/// the types are fixed, as with one contact phase, the most is known type by type.

#include <optional>

#include "request.hpp"

namespace signorini {

struct LimitedEnergy {
    double most = 0.0;            ///< E/E_1 that no motion within the limit exceeds
    std::optional<State> motion;  ///< of that energy; of the most that was found, if sums vary
};

/// Empty where nothing is known. `strainLimit` in [g/L]. O(N), on boxes see capped_amplitudes.hpp.
[[nodiscard]] std::optional<LimitedEnergy> energyWithin(const Known& known, double strainLimit);

/// A motion within the limit that has the energy, if the way from equal amplitudes to the motion of
/// most energy holds one.
[[nodiscard]] std::optional<State> motionWithin(const Known& known, double strainLimit,
                                                double energyRatio);

}  // namespace signorini
