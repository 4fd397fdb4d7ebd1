#pragma once
/// \file
/// All vertices and directions of a small polyhedron, in exact integers.
///
/// Motzkin's double description: the cone over the polyhedron, {(x, t): row . x - rhs t >= 0,
/// t >= 0}, is cut by one row after the other while the list of its extreme rays is kept. Rays
/// with t > 0 are vertices x/t, those with t = 0 directions in which the polyhedron is unbounded.
/// Two rays span an edge if no third one lies on all the rows that both lie on.

#include <optional>
#include <vector>

#include "exact_projection.hpp"

namespace signorini {

/// A polyhedron as the sum of the convex hull of vertices and the cone of directions.
struct Generators {
    std::vector<Homogeneous> vertices;
    std::vector<Homogeneous> directions;  ///< denominator 0; a line counts as two
};

/// Empty if more than `maxRays` rays appear on the way. O(rows rays^3 unknowns) at worst.
[[nodiscard]] std::optional<Generators> generatorsOf(const RowSource& source, std::size_t maxRays);

}  // namespace signorini
