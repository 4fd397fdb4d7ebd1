#pragma once
/// \file
/// Which rows of a matrix follow from the others, decided without rounding.
///
/// Ipopt and NLopt need independent equalities; (30) and (31) are not. Elimination runs modulo a
/// prime near 2^61. Rows found independent there are independent, because a minor that is not zero
/// modulo p is not zero. Rows found dependent could be independent only if p divides one particular
/// minor; whoever leaves them out checks them at the end, as `Solver::solve` does.
///
/// Rows are first peeled: a row with a column that no other row has is independent of the rest and
/// needs no arithmetic. When none is left, the longest row is torn out and peeling goes on. Only
/// the torn rows are eliminated, each along the chain of peeled rows it meets. On signed
/// permutations, prefix sums and a few long rows this is linear in the number of entries.

#include <Eigen/SparseCore>
#include <vector>

namespace signorini {

/// The square submatrix of `rows` and `pivots` is regular, and `rows` span all rows.
struct IndependentRows {
    std::vector<Eigen::Index> rows;    ///< in order of elimination
    std::vector<Eigen::Index> pivots;  ///< a column for each of them
};

/// \pre all entries are finite.
[[nodiscard]] IndependentRows independentRows(
    const Eigen::SparseMatrix<double, Eigen::RowMajor>& matrix);

}  // namespace signorini
