#pragma once
/// \file
/// The point of least norm of a polyhedron, or multipliers that say it is empty.
///
/// min |z|^2 subject to a_i . z = b_i (i < equalities) and a_i . z >= b_i, by the dual active-set
/// method of Goldfarb and Idnani (Mathematical Programming 27, 1983): from z = 0, the point of
/// least norm of no rows at all, it enforces the row that is broken most, each time moving to the
/// nearest point of the rows in force. |z| grows with each row, and z = sum u_i a_i all the time,
/// so by Cauchy and Schwarz every point of the polyhedron has
///
///     |z| >= sum u_i b_i / |sum u_i a_i|,
///
/// whatever was rounded in finding u. The polyhedron is empty if u can be chosen with sum u_i a_i =
/// 0 < sum u_i b_i; then these u are returned.

#include <Eigen/Core>
#include <cstdint>

#include "dense.hpp"
#include "signorini/control.hpp"

namespace signorini {

/// Rows a_i and numbers b_i, equalities first.
template <typename Number>
struct RowSystemOf {
    MatrixOf<Number> rows;
    VectorOf<Number> rhs;
    Eigen::Index equalities = 0;
};
using RowSystem = RowSystemOf<double>;

/// How a search for the least norm ended.
enum class LeastNormEnd {
    found,    ///< z meets all rows, but for rounding
    empty,    ///< sum u a = 0 but for rounding, sum u b > 0; or |z| exceeds the largest asked for
    stopped,  ///< neither after many steps: rows that rounding cannot tell apart
};

/// z and the multipliers of the rows, those of inequalities >= 0.
template <typename Number>
struct LeastNormOf {
    LeastNormEnd end = LeastNormEnd::stopped;
    VectorOf<Number> z;
    VectorOf<Number> multipliers;
    std::int64_t steps = 0;
};
using LeastNorm = LeastNormOf<double>;

/// `tolerance`: a row broken by less than this times |a_i| |z| is met. Above `largest` the norm is
/// taken for infinite. Rows of which only rounding is left have to be 0. O(rows d + d^3) a step for
/// d unknowns, and about as many steps as rows are in force at the end. `Number`: double or
/// FineNumber.
template <typename Number>
[[nodiscard]] LeastNormOf<Number> leastNorm(const RowSystemOf<Number>& system, double tolerance,
                                            double largest, const Cancel& cancel = {});

}  // namespace signorini
