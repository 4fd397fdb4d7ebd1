#pragma once
/// \file
/// The nearest point of a polyhedron of few dimensions and many rows, in exact rationals.
///
/// Goldfarb and Idnani's dual active-set method (Mathematical Programming 27, 1983): start at the
/// centre, as if there were no rows, and enforce one violated row after the other, each time
/// moving to the nearest point of the rows enforced so far. The squared distance grows with every
/// row, so no set of rows comes twice and the method ends, without any tolerance: at the nearest
/// point, or at a combination of rows that says 0 > 0. Rows are asked for one at a time, so
/// their number only matters to the source.

#include <cstdint>
#include <optional>
#include <vector>

#include "rational.hpp"

namespace signorini {

/// coefficients . x >= rhs, or = rhs.
struct ExactRow {
    std::vector<std::int64_t> coefficients;
    std::int64_t rhs = 0;
    bool isEquality = false;
    std::int64_t tag = 0;  ///< what the row is, for its source
};

/// Where rows come from.
class RowSource {
public:
    RowSource() = default;
    RowSource(const RowSource&) = delete;
    RowSource& operator=(const RowSource&) = delete;
    virtual ~RowSource() = default;

    [[nodiscard]] virtual std::size_t unknowns() const = 0;

    /// A row that the point breaks, or nothing. Of a direction (denominator 0): a row that it
    /// leaves sooner or later.
    [[nodiscard]] virtual std::optional<ExactRow> violatedRow(const Homogeneous& point) const = 0;
};

/// A row as its source gave it and its multiplier, >= 0 unless it is an equality.
struct WeightedRow {
    ExactRow row;
    Rational weight;
};

/// Where the search ended.
struct Projection {
    bool isFeasible = false;
    RationalVector point;  ///< the nearest point
    /// Feasible: the rows that hold the point, point - centre = diag(d) sum weight coefficients.
    /// Otherwise sum weight coefficients = 0 while sum weight rhs > 0.
    std::vector<WeightedRow> rows;
};

/// The point x of least sum (x_i - centre_i)^2 / d_i, d_i > 0.
[[nodiscard]] Projection project(const RowSource& source, const RationalVector& centre,
                                 const std::vector<std::int64_t>& d);

}  // namespace signorini
