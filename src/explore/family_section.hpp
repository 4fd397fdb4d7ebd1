#pragma once
/// \file
/// The motions of an atlas' set of orbits that have one energy.

#include <cstdint>
#include <optional>

#include "signorini/atlas.hpp"

namespace signorini {

/// The motions of one energy, the nearest to the one asked for that the set has.
struct FamilySection {
    std::int64_t dimension = 0;
    std::optional<bool> isConnected;  ///< empty: not known

    friend bool operator==(const FamilySection&, const FamilySection&) = default;
};

/// Of an energy [E_1]. Cost as connectivityOf.
[[nodiscard]] FamilySection sectionOf(const AtlasFamily& family, double energyRatio);

}  // namespace signorini
