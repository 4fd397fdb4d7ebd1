#include "dual.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace signorini {

namespace {

using Entries = std::vector<Eigen::Triplet<double>>;

void addTransposed(Entries& entries, const SparseRows& rows, Eigen::Index firstColumn)
{
    for (Eigen::Index row = 0; row < rows.rows(); ++row) {
        for (SparseRows::InnerIterator entry(rows, row); entry; ++entry) {
            entries.emplace_back(entry.col(), firstColumn + row, entry.value());
        }
    }
}

std::vector<Eigen::Index> finite(const Eigen::VectorXd& bounds)
{
    std::vector<Eigen::Index> places;
    for (Eigen::Index i = 0; i < bounds.size(); ++i) {
        if (std::isfinite(bounds[i])) {
            places.push_back(i);
        }
    }
    return places;
}

}  // namespace

Program dualOf(const Program& program)
{
    const std::vector<Eigen::Index> lower = finite(program.lower);
    const std::vector<Eigen::Index> upper = finite(program.upper);
    const Eigen::Index firstMu = program.equalities.rows();
    const Eigen::Index firstZ = firstMu + program.inequalities.rows();
    const Eigen::Index firstW = firstZ + static_cast<Eigen::Index>(lower.size());
    const Eigen::Index count = firstW + static_cast<Eigen::Index>(upper.size());

    Program dual = emptyProgram(count);
    dual.linear.head(firstMu) = -program.equalityRhs;
    dual.linear.segment(firstMu, firstZ - firstMu) = -program.inequalityRhs;
    dual.upper.segment(firstMu, firstZ - firstMu).setZero();
    dual.lower.segment(firstZ, firstW - firstZ).setZero();
    dual.upper.tail(count - firstW).setZero();

    Entries entries;
    addTransposed(entries, program.equalities, 0);
    addTransposed(entries, program.inequalities, firstMu);
    // Units of z and w in which a bound that stands for infinity is no large number.
    const auto addBound = [&](Eigen::Index place, double bound, Eigen::Index column) {
        const double unit = 1.0 / std::max(1.0, std::abs(bound));
        dual.linear[column] = -unit * bound;
        entries.emplace_back(place, column, unit);
    };
    Eigen::Index column = firstZ;
    for (const Eigen::Index place : lower) {
        addBound(place, program.lower[place], column++);
    }
    for (const Eigen::Index place : upper) {
        addBound(place, program.upper[place], column++);
    }
    dual.equalities.resize(program.variables(), count);
    dual.equalities.setFromTriplets(entries.begin(), entries.end());
    dual.equalityRhs = program.linear;
    return dual;
}

SolverResult ofProgram(const Program& program, const SolverResult& ofDual)
{
    SolverResult result = ofDual;
    result.x.resize(0);
    result.equalityDuals.resize(0);
    result.inequalityDuals.resize(0);
    if (ofDual.status == SolverStatus::optimal) {
        const Eigen::Index equalities = program.equalities.rows();
        result.x = -ofDual.equalityDuals;
        result.equalityDuals = ofDual.x.head(equalities);
        result.inequalityDuals = ofDual.x.segment(equalities, program.inequalities.rows());
    } else if (ofDual.status == SolverStatus::unbounded) {
        result.status = SolverStatus::infeasible;
    } else if (ofDual.status == SolverStatus::infeasible) {
        result.status = SolverStatus::failed;
    }
    result.detail += ", of the dual";
    return result;
}

}  // namespace signorini
