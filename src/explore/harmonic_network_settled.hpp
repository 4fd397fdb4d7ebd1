#pragma once
/// \file
/// What a network at rest settles on under an exact harmonic, to the last digit.

#include <optional>

#include "harmonic_network.hpp"
#include "harmonic_settled.hpp"

namespace signorini {

/// What its contacts repeat.
struct SettledNetwork {
    std::int64_t contacts = 0;  ///< in a period; 0: it does not settle, or touches nothing
    std::int64_t cycles = 0;    ///< of the excitation in that period
    /// If the period is the one asked for and Newton comes to it (harmonic_network_pattern.hpp).
    std::optional<NetworkHarmonicMotion> motion = {};
    bool mayRest = true;  ///< else no pushes balance the constant forces: there is no motion
};

/// Marches from rest until contacts repeat (harmonic_network_march.hpp), then solves for the
/// motion. \throws std::invalid_argument as harmonicContacts (harmonic_network_contact.hpp).
[[nodiscard]] SettledNetwork settledHarmonic(const HarmonicNetwork& given,
                                             const SettlingSearch& search = {});

}  // namespace signorini
