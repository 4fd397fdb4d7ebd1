#pragma once
/// \file
/// What any force between two bounds can do to bars at rest until a contact first closes.
///
/// Until then the network is linear. In step m a unit force of step 0 moves a contact with the
/// velocity k_m, which is enclosed in intervals on the way, so a force F gives
///
///     v(t) = v_0 + sum_{j <= t/h} k_j F(t - j h),   d(t) = d_0 + int_0^t K(t - s) F(s) ds,   K =
///     sum k_j,
///
/// linear in F: over all measurable F in [low, high] the most is sum max(k_j low, k_j high), and so
/// for d. That is the dual bound of this linear program; the force that it names, low or high by
/// the sign of k_j, is then followed by the simulation, which reaches it. docs/theory.md,
/// section 20.

#include <cstdint>
#include <optional>
#include <vector>

#include "network_simulation.hpp"

namespace signorini {

/// What no force exceeds, what one reaches, and when.
struct ForcePeak {
    double bound = 0.0;    ///< every rounding included
    double reached = 0.0;  ///< in a simulation under that force
    double time = 0.0;     ///< [h]
};

/// Of the node of a stop, or of that of a gap relative to the next one.
struct ContactReach {
    ForcePeak leastVelocity = {};
    ForcePeak mostVelocity = {};
    ForcePeak leastDisplacement = {};
    ForcePeak mostDisplacement = {};
};

struct ForceReach {
    double duration = 0.0;  ///< [h], until the end or until a contact can first close
    std::optional<std::size_t> closes = {};  ///< which then can
    std::vector<ContactReach> contacts = {};
};

/// Most steps of it.
inline constexpr std::int64_t maxReachSteps = 1'000'000;

/// From rest under constant forces, with any force in [low, high] on the driven nodes from then on.
/// O(steps * channels), and four simulations for each contact.
/// \pre finite low <= high, 0 < duration <= maxReachSteps [h], a valid network.
/// \throws std::invalid_argument if nothing is driven, a contact is closed at rest, or as restOf.
[[nodiscard]] ForceReach reachUnder(const Network& network, double low, double high,
                                    double duration);

}  // namespace signorini
