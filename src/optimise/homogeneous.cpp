#include "homogeneous.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace signorini {

namespace {

using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using Entries = std::vector<Eigen::Triplet<double>>;

/// rows x - rhs theta.
void append(Entries& entries, const SparseRows& rows, const Eigen::VectorXd& rhs, int theta)
{
    for (Eigen::Index k = 0; k < rows.rows(); ++k) {
        for (SparseRows::InnerIterator entry(rows, k); entry; ++entry) {
            entries.emplace_back(static_cast<int>(k), static_cast<int>(entry.col()), entry.value());
        }
        if (rhs[k] != 0.0) {
            entries.emplace_back(static_cast<int>(k), theta, -rhs[k]);
        }
    }
}

}  // namespace

Program homogeneous(const Program& program)
{
    const auto theta = static_cast<int>(program.variables());
    Program result = emptyProgram(program.variables() + 1);
    result.linear[theta] = -1.0;
    result.lower[theta] = 0.0;
    result.upper[theta] = 1.0;
    Entries equal;
    Entries below;
    append(equal, program.equalities, program.equalityRhs, theta);
    append(below, program.inequalities, program.inequalityRhs, theta);
    auto rows = static_cast<int>(program.inequalities.rows());
    for (int k = 0; k < theta; ++k) {
        for (const auto& [bound, sign] :
             {std::pair{program.lower[k], -1.0}, {program.upper[k], 1.0}}) {
            if (bound == 0.0) {
                (sign < 0.0 ? result.lower : result.upper)[k] = 0.0;
            } else if (std::isfinite(bound)) {
                below.emplace_back(rows, k, sign);
                below.emplace_back(rows++, theta, -sign * bound);
            }
        }
    }
    result.equalities.resize(program.equalities.rows(), theta + 1);
    result.equalities.setFromTriplets(equal.begin(), equal.end());
    result.equalityRhs.setZero(program.equalities.rows());
    result.inequalities.resize(rows, theta + 1);
    result.inequalities.setFromTriplets(below.begin(), below.end());
    result.inequalityRhs.setZero(rows);
    return result;
}

}  // namespace signorini
