#pragma once
/// \file
/// What a bar at rest settles on under an exact harmonic, to the last digit.

#include <optional>

#include "harmonic_motion.hpp"
#include "signorini/control.hpp"

namespace signorini {

struct SettlingSearch {
    std::int64_t cycles = 4000;   ///< of the excitation, to wait for
    std::int64_t mostCycles = 8;  ///< in a period of the motion
    double sameTime = 1e-5;       ///< [L/c], contacts of two periods that are the same
    Cancel cancel = {};
};

/// The same at each of many frequencies.
inline constexpr std::int64_t responseCycles = 600;

/// A motion and its period, so many of the excitation's.
struct SettledHarmonic {
    HarmonicCase given;
    HarmonicMotion motion;
};

/// Marches from rest until contacts repeat, then solves for the motion (harmonicNear). Of the
/// harmonic the frequency is read, its cycles are not. None: it does not settle, touches no stop,
/// or a motion has cells beyond maxHarmonicCells. \throws as harmonicCase.
[[nodiscard]] std::optional<SettledHarmonic> settledHarmonic(const Damping& damping,
                                                             const Harmonic& excitation,
                                                             const Stops& stops = {},
                                                             const SettlingSearch& search = {});

}  // namespace signorini
