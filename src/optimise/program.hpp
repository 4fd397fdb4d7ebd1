#pragma once
/// \file
/// A problem for a solver, with no mechanics in it.
///
///     minimise    linear . x + 1/2 sum quadratic_i x_i^2
///     subject to  equalities x = equalityRhs
///                 inequalities x <= inequalityRhs
///                 lower <= x <= upper
///                 sum weights_i x_i^2 = value            (optional)

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstdint>
#include <optional>

namespace signorini {

/// Coefficients, row by row.
using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// sum weights_i x_i^2 = value, with weights >= 0: holds the energy of a motion.
struct EnergyEquality {
    Eigen::VectorXd weights;  ///< n values >= 0
    double value = 0.0;       ///< > 0
};

/// Shapes: n variables, p equalities, q inequalities. Bounds may be infinite.
struct Program {
    SparseRows equalities;                 ///< p x n
    Eigen::VectorXd equalityRhs;           ///< p
    SparseRows inequalities;               ///< q x n
    Eigen::VectorXd inequalityRhs;         ///< q
    Eigen::VectorXd lower;                 ///< n
    Eigen::VectorXd upper;                 ///< n
    Eigen::VectorXd linear;                ///< n
    Eigen::VectorXd quadratic;             ///< n values >= 0, or empty: none
    std::optional<EnergyEquality> energy;  ///< empty: none

    /// n.
    [[nodiscard]] std::int64_t variables() const { return linear.size(); }
};

/// A program with n free variables, no rows and no objective.
[[nodiscard]] Program emptyProgram(std::int64_t variables);

/// Checks shapes, that no number is NaN, that bounds do not cross and that quadratic terms are
/// convex. O(entries). \throws std::invalid_argument naming each fault.
void validate(const Program& program);

/// linear . x + 1/2 sum quadratic_i x_i^2. O(n).
[[nodiscard]] double objective(const Program& program, const Eigen::VectorXd& x);

/// The size of the problem's own unit: no x with max |x_i| below it meets rows, bounds and energy.
/// That is the largest of |right side| / sum |coefficients| of the rows, of the |bounds| that 0
/// does not meet, and of sqrt(value / sum weights) of the energy; 1 if 0 meets them all.
/// O(entries).
[[nodiscard]] double naturalSize(const Program& program);

/// The largest violation of any row or bound at x, each divided by the larger of |right side| and
/// what one unit does to the row, naturalSize times its largest |coefficient|; for the energy
/// equality divided by its value. So rows and unknowns may be given in any units: x = 0 violates
/// sum x_i = 1e-10 by 1. Infinite if x is not finite or of the wrong length. O(entries).
[[nodiscard]] double violation(const Program& program, const Eigen::VectorXd& x);

}  // namespace signorini
