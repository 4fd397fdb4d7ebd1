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

/// Multipliers with equalities^T y + inequalities^T mu = 0 but for the bounds in use, and a right
/// side of -1. Not yet a proof: signs are as the system has them. Empty if it has no solution.
/// \pre row k of the equalities has a coefficient at unknown k for every unknown, and every circle
/// of rows that use each other's unknowns has an open one.
[[nodiscard]] std::optional<RationalProof> exactMultipliers(const Program& program,
                                                            const ProofSupport& support);

}  // namespace signorini
