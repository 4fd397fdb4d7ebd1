#pragma once
/// \file
/// Curves by nonlinear programs: for sets without a geometry of their own.

#include "continuum_record.hpp"
#include "energy_section.hpp"

namespace signorini {

/// From one end to the other, or without ends between two members: `member` and one that the
/// engine chooses. Neighbours on the curve are at most options.resolution apart, and the motion
/// nearest to the middle between two neighbours is near the middle: isolated motions never pass for
/// a curve. `section`, null if nothing is known, keeps the engine from ends in other components.
/// \throws BackendUnavailable if the engine is not in this build.
void traceWithPrograms(ContinuumRecord& record, const EnergySection* section, const State& member);

}  // namespace signorini
