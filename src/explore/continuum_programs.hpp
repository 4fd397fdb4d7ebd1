#pragma once
/// \file
/// Curves by nonlinear programs: for sets without a geometry of their own.

#include "continuum_record.hpp"
#include "curve_march.hpp"
#include "energy_section.hpp"

namespace signorini {

/// From one end to the other, or without ends between two members: `member` and one that the
/// solver chooses. `section`, null if nothing is known, keeps the solver from ends in other
/// components.
void traceWithPrograms(ContinuumRecord& record, const EnergySection* section, const State& member,
                       const Solver& solver);

}  // namespace signorini
