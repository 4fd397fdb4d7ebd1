#pragma once
/// \file
/// Does a schedule of a stepped bar have motions? Decided by a simplex method, proved in rationals.

#include <optional>
#include <string>

#include "signorini/certificate.hpp"
#include "solver.hpp"
#include "stepped_form.hpp"

namespace signorini {

/// What the simplex method says of a schedule.
struct SteppedExistence {
    Status status = Status::undecided;
    std::string detail = {};                      ///< why undecided
    std::vector<SteppedCondition> conflict = {};  ///< none: conditions that contradict each other
    Eigen::VectorXd x = {};                       ///< found: a solution
    std::int64_t iterations = 0;
};

/// By one linear program (homogeneous.hpp) for a back end that returns duals. Status none is its
/// word only, until there is a proof.
[[nodiscard]] SteppedExistence existence(const SteppedProgram& posed, const Solver& simplex,
                                         const SolverOptions& options);

/// Multipliers over the rows of jointsForm(blocks), whichever form found the conflict. They have
/// passed isProof. Empty if they are no proof, or where more than `mostExactRows` rows close upon
/// themselves. O(rows^3) rational operations.
[[nodiscard]] std::optional<RationalProof> proofOf(const std::vector<SteppedCondition>& conflict,
                                                   const SteppedBlocks& blocks);

/// Most open rows of a proof: sum of 2 N_i/G for each type.
inline constexpr std::int64_t mostExactRows = 96;

/// Why there is no motion, from what the proof needs.
[[nodiscard]] Reason reasonOf(const std::vector<SteppedCondition>& conflict,
                              const SteppedBlocks& blocks,
                              std::optional<std::int64_t> kernelDimension);

}  // namespace signorini
