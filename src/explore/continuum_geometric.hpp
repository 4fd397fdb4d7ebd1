#pragma once
/// \file
/// Curves and members by geometry alone: exact points of a sphere section.

#include "continuum_record.hpp"
#include "energy_section.hpp"

namespace signorini {

/// What the options ask for, in the simplex (or the box, for samples) of the section.
/// \pre section.facts().simplex; two ends lie in one component.
void traceGeometrically(ContinuumRecord& record, const EnergySection& section);

/// The same without a gap, on great circles of a cone. A direction is not among them.
void traceInCone(ContinuumRecord& record, const ConeSection& section);

/// Keeps the split pulse with this pause [L/c]; false if the trace ends there.
bool keepSplitPulse(ContinuumRecord& record, const EnergySection& section, double pause);

/// The split pulse in that simplex.
void splitPulse(ContinuumRecord& record, const EnergySection& section);

/// Why no curve joins two members of one simplex, given as shares with different dominant ones.
[[nodiscard]] std::string wordsForApart(const EnergySection& section,
                                        const std::vector<double>& from,
                                        const std::vector<double>& to);

/// Where only finitely many motions have the energy: all of them, one of them, or draws.
void listIsolated(ContinuumRecord& record, const EnergySection& section);

}  // namespace signorini
