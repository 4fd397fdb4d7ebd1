#pragma once
/// \file
/// Linear systems in integers, one digit of the solution after the other in the base of a prime.
///
/// Elimination carries numbers as long as the solution through n^3 operations; here they are as
/// long as those of the matrix (Dixon, Exact solution of linear equations using p-adic expansions,
/// Numerische Mathematik 40, 1982). With x = x_0 + x_1 p + ..., M x_0 = rhs in remainders of p, and
/// (rhs - M x_0)/p is the right side of what follows. Fractions come back by Euclid's algorithm,
/// and are a solution if they solve the equations.

#include <cstddef>
#include <vector>

#include "rational.hpp"

namespace signorini {

/// Rows and columns, as many of both, where a matrix is regular in remainders of p = 2^31 - 1, and
/// so regular.
struct RegularCore {
    std::vector<std::size_t> rows;
    std::vector<std::size_t> columns;
};

/// As many as there are. O(rows columns^2). \pre there is a row.
[[nodiscard]] RegularCore regularCore(const std::vector<IntegerVector>& rows);

/// x with M x = rhs. O(n^2) products of a number of M and a digit for each digit of x.
/// \pre M is square and regular in remainders of p.
[[nodiscard]] RationalVector liftedSolution(std::vector<IntegerVector> rows, IntegerVector rhs);

}  // namespace signorini
