#pragma once
/// \file
/// The names of formulations and objectives.

#include "names.hpp"
#include "signorini/demands.hpp"

namespace signorini {

inline constexpr Named<Formulation> formulationNames[] = {
    {Formulation::automatic, "auto"},
    {Formulation::state, "state"},
    {Formulation::reduced, "reduced"},
    {Formulation::lumped, "lumped"},
};

inline constexpr Named<Objective> objectiveNames[] = {
    {Objective::automatic, "auto"},
    {Objective::any, "any"},
    {Objective::minEnergy, "min-energy"},
    {Objective::maxEnergy, "max-energy"},
    {Objective::minPeakStrain, "min-peak-strain"},
    {Objective::maxImpulse, "max-impulse"},
    {Objective::nearest, "nearest"},
};

}  // namespace signorini
