#pragma once
/// \file
/// A row of several contact phases, from the exact sums.

#include <cstddef>

#include "signorini/atlas.hpp"

namespace signorini {

/// Of the rotations of a list of phases: is it the first, and how long is the list it repeats?
struct Rotation {
    bool isFirst = true;
    std::size_t length = 0;  ///< of the shortest list that it repeats
};

[[nodiscard]] Rotation rotationOf(const std::vector<Phase>& phases);

/// What `lumpedSet` says of a schedule; beyond the limits of exact arithmetic the row stays
/// undecided. `length` is that of its rotation.
[[nodiscard]] AtlasRow decideSeveral(const Schedule& schedule, std::size_t length,
                                     std::int64_t number);

}  // namespace signorini
