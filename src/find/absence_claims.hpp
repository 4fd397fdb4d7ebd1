#pragma once
/// \file
/// Absence as routes claim it, each with its proof.

#include <optional>

#include "request.hpp"

namespace signorini {

/// If the exact sets say that the schedule has no motion at all.
[[nodiscard]] std::optional<Absence> absenceOfAll(const Request& request);

/// If nothing but the bar at rest is a motion: where canRest, beside a second stop, motions can be
/// made small enough not to reach it, so the proof is that of one stop.
[[nodiscard]] std::optional<Absence> absenceBesideRest(const Request& request);

/// If every energy of the set, where it is known, misses the one to hold by more than the
/// tolerance; of one phase also those within the strain limit: -min s = 2 max p, so p <= limit/2.
[[nodiscard]] std::optional<Absence> absenceByEnergy(const Request& request);

/// If the limits and fixed values are proved impossible over the rows of a formulation.
[[nodiscard]] std::optional<Absence> absenceByProgram(const Request& request,
                                                      Formulation formulation);

}  // namespace signorini
