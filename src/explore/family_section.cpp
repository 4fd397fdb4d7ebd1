#include "family_section.hpp"

#include <algorithm>

#include "energy_section.hpp"

namespace signorini {

FamilySection sectionOf(const AtlasFamily& family, double energyRatio)
{
    const EnergyRange& range = family.energy;
    const double energy = std::clamp(energyRatio, range.least, range.most);
    const bool isInside = range.least < energy && energy < range.most;
    FamilySection section{isInside ? family.dimension - 1 : 0, {}};
    if (family.family) {
        section.isConnected =
            connectivityOf(onePhaseSet({family.cells, {family.top}}), energy).isConnected;
    }
    return section;
}

}  // namespace signorini
