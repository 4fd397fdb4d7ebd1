#pragma once
/// \file
/// A program without its linear equalities: x = origin + directions u, with u free to choose.
///
/// u are the variables outside a basis of the equalities. Bounds of basic variables become rows.
/// Rows with one unknown become bounds, equal rows are kept once.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <optional>

#include "common/condensed.hpp"
#include "solver.hpp"

namespace signorini::nlopt {

/// minimise f(origin + directions u) subject to rows u <= rhs, lower <= u <= upper.
struct FreeProgram {
    Condensed condensed;                     ///< f, the energy, and the way back to x
    std::vector<Eigen::Index> outside;       ///< u_k is this condensed variable
    Eigen::VectorXd origin;                  ///< condensed variables at u = 0
    Eigen::SparseMatrix<double> directions;  ///< condensed variables x d
    SparseRows rows;                         ///< m x d
    Eigen::VectorXd rhs;                     ///< m
    Eigen::VectorXd lower;                   ///< d
    Eigen::VectorXd upper;                   ///< d
    std::optional<SolverResult> decided;     ///< set when nothing is left to search

    [[nodiscard]] Eigen::Index size() const { return lower.size(); }

    /// All variables of the program.
    [[nodiscard]] Eigen::VectorXd point(const Eigen::VectorXd& u) const
    {
        return condensed.expand(origin + directions * u);
    }
};

/// Refuses, before any dense work, programs with more than `mostUnknowns` unknowns left.
/// Cost: one sparse LU and d solutions with it.
/// \throws std::invalid_argument naming the size and its limit.
[[nodiscard]] FreeProgram withoutEqualities(const Program& program, double tolerance,
                                            Eigen::Index mostUnknowns);

}  // namespace signorini::nlopt
