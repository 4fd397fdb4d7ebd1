#pragma once
/// \file
/// Free motions of a schedule of any network: that of least energy, or a proof that there is none.
///
/// In coordinates z of ker(W - 1), orthonormal in the norm sum Z x^2, pushes and distances are rows
/// (network_forced.hpp), and the point of least norm that meets them, or multipliers that say that
/// none does, come from least_norm.hpp. A motion is verified independently; absence,
/// and that no motion has less energy, is what a march backwards makes of the multipliers.
/// docs/theory.md, section 20.

#include <optional>
#include <string>

#include "contact_spans.hpp"
#include "network_walk.hpp"
#include "signorini/certificate.hpp"
#include "signorini/control.hpp"
#include "signorini/schedule.hpp"

namespace signorini {

/// What is known of a schedule.
struct NetworkMotions {
    Status status = Status::undecided;
    std::string detail = {};  ///< why not decided
    std::int64_t kernelDimension = 0;
    /// found: the motion of least energy, its displacements among it.
    std::optional<NetworkClaim> motion = {};
    NetworkResiduals residuals = {};
    double energy = 0.0;           ///< of the motion [Z_1 delta^2/h]
    EnergyFloor multipliers = {};  ///< no motion has less energy than `provedEnergy`
    double provedEnergy = 0.0;     ///< rounded downwards
};

/// Largest residual of a motion.
inline constexpr double networkTolerance = 1e-9;

/// \throws std::invalid_argument as `leastMotion` does.
void requireKnown(const Network& network, const std::vector<ContactSpan>& schedule);

/// O(waves^3 + n waves). None: no motion has less than `largest` [Z_1 delta^2/h].
/// \throws std::invalid_argument on an invalid network or schedule, more than mostForcedWaves
/// waves, a schedule whose first step closes no contact that was open before, one that does not tie
/// a bar that drifts to what is held, or where held bars at rest are a motion. Bars that drift may
/// rest where they touch: a motion without energy.
[[nodiscard]] NetworkMotions leastMotion(const Network& network,
                                         const std::vector<ContactSpan>& schedule, double largest,
                                         const Cancel& cancel = {});

/// Is there no pressing motion, as one would press a bar that drifts one way and nothing the other?
/// Its place is the same a period later, so on average pushes and forces balance; dashpots do by
/// themselves. O(contacts).
[[nodiscard]] bool pushesBalance(const Network& network, const std::vector<ContactSpan>& schedule);

}  // namespace signorini
