#pragma once
/// \file
/// A proof in rationals for programs whose equalities say how unknowns follow from others.
///
/// A simplex method tells which conditions contradict each other, and hardly more: where hundreds
/// of equalities lie between them the multipliers have denominators that no rounding finds. But row
/// k of such a program determines unknown k, so its multiplier follows from those of the rows that
/// use this unknown, and what remains is a linear system in the conditions and a few rows where the
/// chain of equalities closes upon itself. It is solved in rational numbers.

#include <cstdint>
#include <optional>
#include <vector>

#include "program.hpp"
#include "signorini/certificate.hpp"

namespace signorini {

/// A finite bound of an unknown.
struct UsedBound {
    Eigen::Index unknown = 0;
    double value = 0.0;
};

/// What a proof is sought in.
struct ProofSupport {
    /// For each unknown: is row k to be an unknown of the system, not to follow from others?
    std::vector<bool> isOpen;
    std::vector<Eigen::Index> inequalities;  ///< rows that may have a multiplier
    std::vector<UsedBound> bounds;           ///< that may be used
};

/// The rows that are not open, each after all that use the unknown it determines. O(entries).
/// \pre as for exactMultipliers.
[[nodiscard]] std::vector<Eigen::Index> followingRows(const Program& program,
                                                      const std::vector<bool>& isOpen);

/// The equalities, by their unknowns.
using ProgramColumns = Eigen::SparseMatrix<double, Eigen::ColMajor>;

/// equalities^T y + given in one column.
template <typename Number>
[[nodiscard]] Number columnOf(const ProgramColumns& equalities, Eigen::Index unknown,
                              const std::vector<Number>& given, const std::vector<Number>& y)
{
    Number sum = given[static_cast<std::size_t>(unknown)];
    for (ProgramColumns::InnerIterator entry(equalities, unknown); entry; ++entry) {
        sum += Number(entry.value()) * y[static_cast<std::size_t>(entry.row())];
    }
    return sum;
}

/// Those y of `followingRows` with which the columns of the unknowns they determine vanish.
/// O(entries) operations. \pre they are 0.
template <typename Number>
void followRows(const ProgramColumns& equalities, const std::vector<Eigen::Index>& order,
                const std::vector<Number>& given, std::vector<Number>& y)
{
    for (const Eigen::Index row : order) {
        y[static_cast<std::size_t>(row)] =
            -columnOf(equalities, row, given, y) / Number(equalities.coeff(row, row));
    }
}

/// Multipliers with equalities^T y + inequalities^T mu = 0 but for the bounds in use, and a right
/// side of -1. Not yet a proof: signs are as the system has them. Empty if it has no solution.
/// \pre row k of the equalities has a coefficient at unknown k for every unknown, and every circle
/// of rows that use each other's unknowns has an open one.
[[nodiscard]] std::optional<RationalProof> exactMultipliers(const Program& program,
                                                            const ProofSupport& support);

}  // namespace signorini
