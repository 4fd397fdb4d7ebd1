#pragma once
/// \file
/// `findPeriodic` for bars of several segments: there is no closed form, programs decide.

#include <optional>

#include "signorini/find_periodic.hpp"
#include "stepped_energy.hpp"

namespace signorini {

/// Do the options ask about joints? Equal segments are one bar, unless a formulation with joints is
/// asked for.
[[nodiscard]] bool isStepped(const FindOptions& options);

/// Decides a schedule of a stepped bar. \throws as `findPeriodic`; also where a demand is not known
/// for such bars.
[[nodiscard]] PeriodicResult findStepped(const Schedule& schedule, const FindOptions& options);

/// A bound below the energy of all motions of a stepped bar with the tip above its floor; see
/// stepped_energy.hpp. Empty where there is none, or more rows than exact arithmetic can take.
[[nodiscard]] std::optional<SteppedEnergyProof> leastSteppedEnergy(const Schedule& schedule,
                                                                   const FindOptions& options);

/// The same for a bar of any size, proved by a march backwards.
[[nodiscard]] std::optional<EnergyFloorProof> leastEnergyFloor(const Schedule& schedule,
                                                               const FindOptions& options);

/// Checks a proof of absence against rows made anew, or by a march backwards.
[[nodiscard]] bool holds(const SteppedProof& proof, const Schedule& schedule, const Scene& scene);
[[nodiscard]] bool holds(const EnergyFloorProof& proof, const Schedule& schedule,
                         const Scene& scene);

}  // namespace signorini
