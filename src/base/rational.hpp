#pragma once
/// \file
/// Exact numbers, and the little linear algebra in them that tiny systems need.

#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <optional>
#include <vector>

namespace signorini {

using Integer = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;
using RationalVector = std::vector<Rational>;
using IntegerVector = std::vector<Integer>;

/// The point numerators / denominator, or, with denominator 0, a direction.
struct Homogeneous {
    IntegerVector numerators;
    Integer denominator = 1;
};

/// x over one common denominator > 0. O(n) gcds.
[[nodiscard]] Homogeneous overCommonDenominator(const RationalVector& x);

/// Back again. \pre a point, no direction.
[[nodiscard]] RationalVector asRationals(const Homogeneous& point);

/// x with M x = rhs for a square matrix given by rows, by elimination. O(n^3).
/// \pre M is regular.
[[nodiscard]] RationalVector solveRegular(std::vector<RationalVector> rows, RationalVector rhs);

/// Gauss-Jordan: afterwards row k has a 1 in column pivots[k], and that column is 0 elsewhere.
/// Of the first `columns` columns. Rows without a pivot end last, of any scale. O(rows size rank).
std::vector<std::size_t> reduceRows(std::vector<RationalVector>& rows, std::size_t columns);

/// Some x with M x = rhs for a matrix given by rows of `size` entries, 0 where it is free; empty if
/// there is none. Rows that share no unknowns are solved apart. O(rows^2 size).
[[nodiscard]] std::optional<RationalVector> solveSome(std::vector<RationalVector> rows,
                                                      RationalVector rhs, std::size_t size);

/// Some c != 0 of integers with row . c = 0 for all rows of `size` entries; empty if there is none.
/// O(rows size^2).
[[nodiscard]] std::optional<IntegerVector> nullVector(std::vector<RationalVector> rows,
                                                      std::size_t size);

}  // namespace signorini
