#pragma once
/// \file
/// Curves and members without a gap: great circles of a cone.

#include "continuum_record.hpp"
#include "energy_section.hpp"

namespace signorini {

/// What the options ask for, at the energy of the section. A direction is not among them.
void traceInCone(ContinuumRecord& record, const ConeSection& section);

}  // namespace signorini
