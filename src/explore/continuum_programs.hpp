#pragma once
/// \file
/// Curves by nonlinear programs: for sets without a geometry of their own.

#include "continuum_record.hpp"
#include "energy_section.hpp"
#include "solver.hpp"

namespace signorini {

/// What a back end must be able to do here.
inline constexpr Capabilities continuumNeeds{
    .quadraticObjective = true, .energyEquality = true, .start = true};

/// From one end to the other, or without ends between two members: `member` and one that the
/// solver chooses. Neighbours on the curve are at most options.resolution apart, and the motion
/// nearest to the middle between two neighbours is near the middle: isolated motions never pass for
/// a curve. `section`, null if nothing is known, keeps the solver from ends in other components.
void traceWithPrograms(ContinuumRecord& record, const EnergySection* section, const State& member,
                       const Solver& solver);

}  // namespace signorini
