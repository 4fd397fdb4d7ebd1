#pragma once
/// \file
/// One rule for demands and tolerance, on every route.
///
/// A demand that a motion breaks by at most the tolerance (`violation`, relative) is met. Absence
/// is claimed only if the demands, each relaxed by the tolerance, are proved impossible. So no
/// route can prove absent what another one finds.

#include <optional>

#include "infeasibility.hpp"
#include "signorini/demands.hpp"
#include "signorini/one_phase_set.hpp"

namespace signorini {

/// Limits on strain and tip moved outwards by the tolerance. Fixed values and a held energy are
/// equations and stay.
[[nodiscard]] Demands relaxed(Demands demands, double tolerance);

/// Does every energy of the range miss the one to hold by more than the tolerance? An end that is
/// not known (NaN) excludes nothing.
[[nodiscard]] bool isOutOfRange(double energyRatio, const EnergyRange& range, double tolerance);

/// Do the multipliers prove, over the rows of pose(schedule, demands, formulation), that no motion
/// meets the limits and fixed values even when all are relaxed by the tolerance? Other demands are
/// left out. \throws std::invalid_argument if such a program cannot be posed.
[[nodiscard]] bool isUnmet(const InfeasibilityProof& proof, const Schedule& schedule,
                           Demands demands, Formulation formulation, double tolerance);

/// An exact proof, over the rows of pose(schedule, demands, formulation), that no motion meets the
/// linear demands even when all are relaxed by the tolerance; empty if none can be had.
/// `simplex`: a solver with duals, or null.
[[nodiscard]] std::optional<InfeasibilityProof> proveUnmet(const Schedule& schedule,
                                                           Demands demands, Formulation formulation,
                                                           const Solver* simplex,
                                                           const SolverOptions& options);

}  // namespace signorini
