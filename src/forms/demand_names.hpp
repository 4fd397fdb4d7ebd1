#pragma once
/// \file
/// The names of formulations and objectives.

#include "names.hpp"
#include "signorini/demands.hpp"

namespace signorini {

inline constexpr auto formulationNames = std::to_array<Named<Formulation>>({
    {Formulation::automatic, "auto"},
    {Formulation::state, "state"},
    {Formulation::reduced, "reduced"},
    {Formulation::lumped, "lumped"},
    {Formulation::joints, "joints"},
    {Formulation::kernel, "kernel"},
});

inline constexpr auto objectiveNames = std::to_array<Named<Objective>>({
    {Objective::automatic, "auto"},
    {Objective::any, "any"},
    {Objective::minEnergy, "min-energy"},
    {Objective::maxEnergy, "max-energy"},
    {Objective::minPeakStrain, "min-peak-strain"},
    {Objective::maxImpulse, "max-impulse"},
    {Objective::nearest, "nearest"},
});

}  // namespace signorini
