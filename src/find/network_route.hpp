#pragma once
/// \file
/// `findPeriodic` for bars of several segments: networks, of which no closed form is known.

#include <optional>

#include "network_motions.hpp"
#include "routes.hpp"

namespace signorini {

/// Is the question one about joints? Equal segments are one bar, unless a formulation with joints
/// is asked for.
[[nodiscard]] bool asksOfJoints(const FindOptions& options);

/// What is known of such bars, and nothing else. \throws std::invalid_argument
void requireKnownOfJoints(const Schedule& schedule, const FindOptions& options);

/// Any request about a bar of several segments; enters what it learns of the set of motions.
/// \throws BackendUnavailable where a program is needed that this build cannot solve.
[[nodiscard]] Claim networkRoute(Request& request);

/// That no motion of such a bar has less energy than the one that has least. Empty where that is
/// not found.
[[nodiscard]] std::optional<EnergyFloorProof> leastEnergyFloor(const Schedule& schedule,
                                                               const FindOptions& options);

/// Checks a proof of absence against rows made anew, or by a march backwards.
[[nodiscard]] bool holds(const SteppedProof& proof, const Schedule& schedule, const Scene& scene);
[[nodiscard]] bool holds(const EnergyFloorProof& proof, const Schedule& schedule,
                         const Scene& scene);

}  // namespace signorini
