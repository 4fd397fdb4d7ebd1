#pragma once
/// \file
/// Forced motions of a schedule of any network: a harmonic force on its driven nodes, or shaken
/// clamps. The rows are those of network_forced.hpp; what is left of the plane (C, S) is described
/// as for a bar (forced_set.hpp). docs/theory.md, sections 15, 19 and 20.

#include <vector>

#include "contact_spans.hpp"
#include "network_walk.hpp"
#include "signorini/response.hpp"

namespace signorini {

/// Decides a schedule. Amplitudes are in units of the network, energies of motions at most
/// `hugeEnergyRatio` times `usualEnergy`. O(waves^3 + n waves); with waves that nothing damps a few
/// dozen linear programs. Questions about the set (response.hpp) take it: leastAmplitudeMotion,
/// motionsOfAmplitude, exclusionOf, isCertain.
/// \throws std::invalid_argument as `leastMotion` does (network_find.hpp), if nothing is driven, or
/// cycles unless 1 <= K < n/2.
[[nodiscard]] ForcedSet forcedScene(const Network& network,
                                    const std::vector<ContactSpan>& schedule,
                                    const Forcing& forcing, double usualEnergy);

/// A motion of such a set as what is walked.
[[nodiscard]] NetworkClaim claimOf(const ForcedSet& set, const ForcedMotion& motion);

}  // namespace signorini
