#pragma once
/// \file
/// Linear systems in integers, one digit of the solution after the other in the base of a prime.
///
/// Elimination carries numbers as long as the solution through n^3 operations; here they are as
/// long as those of the matrix (Dixon, Exact solution of linear equations using p-adic expansions,
/// Numerische Mathematik 40, 1982). With x = x_0 + x_1 p + ..., M x_0 = rhs in remainders of p, and
/// (rhs - M x_0)/p is the right side of what follows. Fractions come back by Euclid's algorithm,
/// and are a solution if they solve the equations.

#include <optional>
#include <vector>

#include "rational.hpp"

namespace signorini {

/// Some x with M x = rhs, 0 but for as many unknowns as M has rank in remainders of p = 2^31 - 1.
/// Empty if what solves as many rows, regular there, does not solve the others: there may be none,
/// or p divides what should not vanish. O(rows columns^2), and O(n^2) products of a number of M and
/// a digit for each digit of x, at rank n. \pre there is a row.
[[nodiscard]] std::optional<RationalVector> liftedSolution(const std::vector<IntegerVector>& rows,
                                                           const IntegerVector& rhs);

}  // namespace signorini
