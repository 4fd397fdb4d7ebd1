#pragma once
/// \file
/// Free motions of a schedule of bars that may drift, stand under forces, or be held
/// (network_motions.hpp): which questions have an answer, and that of least energy.

#include "network_motions.hpp"

namespace signorini {

/// Largest residual of a motion.
inline constexpr double networkTolerance = 1e-9;

/// \throws std::invalid_argument as `leastMotion` does.
void requireKnown(const Network& network, const std::vector<ContactSpan>& schedule);

/// None: no motion has less than `largest` [Z_1 delta^2/h]. Found: the multipliers say that none
/// has less than `provedEnergy`.
/// \throws std::invalid_argument on an invalid network or schedule, one whose first step closes no
/// contact that was open before, one that does not tie a bar that drifts to what is held, or where
/// held bars at rest are a motion. Bars that drift may rest where they touch: a motion without
/// energy.
[[nodiscard]] LeastMotion leastMotion(const Network& network,
                                      const std::vector<ContactSpan>& schedule, double largest,
                                      const Cancel& cancel = {});

/// Is there no pressing motion, as one would press a bar that drifts one way and nothing the other?
/// Its place is the same a period later, so on average pushes and forces balance; dashpots do by
/// themselves. O(contacts).
[[nodiscard]] bool pushesBalance(const Network& network, const std::vector<ContactSpan>& schedule);

}  // namespace signorini
