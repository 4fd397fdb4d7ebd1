#pragma once
/// \file
/// A program as interior-point and local methods need it: no fixed variables, and no equality that
/// follows from the others.

#include <Eigen/Core>
#include <Eigen/SparseLU>
#include <memory>
#include <optional>
#include <vector>

#include "solver.hpp"

namespace signorini {

/// False if every point that meets the rows will do.
[[nodiscard]] bool hasObjective(const Program& program);

/// Solves the equalities for their pivot variables.
class Basis {
public:
    /// \param columns as many as there are rows; together they are regular.
    Basis(const SparseRows& rows, std::vector<Eigen::Index> columns);

    /// The x with rows x = rhs that is 0 outside the basis, refined once.
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& rhs) const;

    [[nodiscard]] const std::vector<Eigen::Index>& columns() const { return columns_; }

private:
    Eigen::Index variables_;
    std::vector<Eigen::Index> columns_;
    Eigen::SparseMatrix<double> matrix_;
    std::unique_ptr<Eigen::SparseLU<Eigen::SparseMatrix<double>>> factors_;
};

/// Invariant: `program` has at least one variable and fewer equalities than variables unless
/// `decided` holds the answer.
struct Condensed {
    Program program;                      ///< in the variables that are left
    std::vector<Eigen::Index> variables;  ///< which ones these are
    std::vector<Eigen::Index> rows;       ///< which equalities are left
    std::vector<Eigen::Index> pivots;     ///< columns of a basis of them
    Eigen::VectorXd fixed;                ///< all variables: those that are fixed, else 0

    /// Set when nothing is left to search: there are no rows, or the equalities contradict each
    /// other or have one solution. "infeasible" then rests on a residual beyond the tolerance, not
    /// on a search.
    std::optional<SolverResult> decided;

    /// From the variables that are left to all of them, and back.
    [[nodiscard]] Eigen::VectorXd expand(const Eigen::VectorXd& x) const;
    [[nodiscard]] Eigen::VectorXd restrict(const Eigen::VectorXd& x) const;
};

/// Linear in the entries on the programs of this library, and one sparse LU factorisation when a
/// row is left out or the equalities have one solution.
[[nodiscard]] Condensed condense(const Program& program, double tolerance);

}  // namespace signorini
