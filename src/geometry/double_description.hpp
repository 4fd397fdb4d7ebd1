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

/// The cone over a polyhedron, to be cut row by row.
class PolyhedralCone {
public:
    /// An extreme ray (x, t), t >= 0 last, in least integers.
    struct Ray {
        IntegerVector at;
        std::vector<bool> tight;  ///< which of the rows so far it lies on
        bool isChecked = false;   ///< for the owner's use; false on a new ray
    };

    /// All of space.
    explicit PolyhedralCone(std::size_t unknowns);

    /// Keeps what meets the row. O(rays^3 rows) at worst.
    void cut(const ExactRow& row);

    [[nodiscard]] std::vector<Ray>& rays() { return rays_; }
    [[nodiscard]] const std::vector<Ray>& rays() const { return rays_; }
    /// Lines in the cone; none once it is pointed.
    [[nodiscard]] const std::vector<IntegerVector>& lines() const { return lines_; }

private:
    void cutLine(const ExactRow& row, IntegerVector line);
    void cutRays(const ExactRow& row);
    [[nodiscard]] std::vector<bool> commonRows(std::size_t i, std::size_t j) const;
    [[nodiscard]] bool areAdjacent(std::size_t i, std::size_t j) const;

    std::size_t rows_ = 0;
    std::vector<Ray> rays_;
    std::vector<IntegerVector> lines_;
};

/// row . x - rhs t at (x, t).
[[nodiscard]] Integer valueAt(const ExactRow& row, const IntegerVector& at);

/// A polyhedron as the sum of the convex hull of vertices and the cone of directions.
struct Generators {
    std::vector<Homogeneous> vertices;
    std::vector<Homogeneous> directions;  ///< denominator 0; a line counts as two
};

/// Empty if more than `maxRays` rays appear on the way. O(rows rays^3 unknowns) at worst.
[[nodiscard]] std::optional<Generators> generatorsOf(const RowSource& source, std::size_t maxRays);

}  // namespace signorini
