#pragma once
/// \file
/// The rows of a bar of several segments over the waves at joints and tip, in whole numbers: what
/// absence and least energies are proved with in rationals, where they are few
/// (docs/certificates.md).
///
/// x = (r^j_k, p_k of each block, waves between joints, prefix sums). With left : right : all the
/// whole numbers Z_1 : Z_2 : Z_1 + Z_2 + d of a joint, e_k = -1 in contact and 1 in flight what the
/// tip makes of p, and l = e p where no further joint lies between,
///
///     all r^{j+1}_{k+M} = 2 left r^j_k + (2 right - all) l^j_k
///     all l^{j-1}_k     = (2 left - all) r^j_k + 2 right l^j_k,   l^0_k = -r^1_{k+M_1}
///     p >= 0 in contact,  y_k = y_{k-1} + p_k <= 0 in flight, 0 at its end
///     sum_i sum_{k < M_i} r^i_k = -N g/|g|

#include <utility>
#include <vector>

#include "program.hpp"
#include "stepped_blocks.hpp"

namespace signorini {

/// What a schedule asks of waves. Each is a number that is 0 or, for pushes and bounds, >= 0.
enum class SteppedRule {
    gap,      ///< sum r + N times the place of the first contact
    push,     ///< of a block of contact, the sum of the waves that press
    bound,    ///< of a block of flight, bound - prefix sum
    floor,    ///< prefix sum - floor
    landing,  ///< of the last block of a flight, prefix sum - landing
};

/// A rule for a block.
struct SteppedCondition {
    SteppedRule rule = SteppedRule::gap;
    std::size_t block = 0;  ///< number; none of the gap

    friend bool operator==(const SteppedCondition&, const SteppedCondition&) = default;
};

/// A program, and how to read a motion out of its unknowns.
struct SteppedProgram {
    Program program;
    std::vector<SteppedCondition> conditions;  ///< one for each inequality
    /// Unknowns that are prefix sums, each with the number of its block.
    std::vector<std::pair<Eigen::Index, std::size_t>> prefixes;
    /// Of the unknowns, E/E_1 = sum weight x^2.
    Eigen::VectorXd energyWeights;
};

/// Where the unknowns and rows of the joints form stand.
class JointsLayout {
public:
    explicit JointsLayout(const SteppedBlocks& blocks);

    /// r^j of a block, j = 0 for the first joint, or for the tip where there is none.
    [[nodiscard]] Eigen::Index arrival(std::size_t joint, std::size_t type,
                                       std::int64_t turn) const;
    /// What arrives from the right at joint j < last.
    [[nodiscard]] Eigen::Index between(std::size_t joint, std::size_t type,
                                       std::int64_t turn) const;
    /// The sum at the end of flight block number k.
    [[nodiscard]] Eigen::Index prefix(std::int64_t k) const { return waves_ + k; }
    [[nodiscard]] Eigen::Index unknowns() const { return waves_ + flights_; }
    /// Number of unknowns that are waves.
    [[nodiscard]] Eigen::Index waves() const { return waves_; }

private:
    Eigen::Index turns_;
    Eigen::Index joints_;
    Eigen::Index perStep_;
    Eigen::Index waves_;
    Eigen::Index flights_ = 0;
};

/// The joints form. Row k determines unknown k, waves first, then prefix sums; the gap is last.
/// O(blocks joints).
[[nodiscard]] SteppedProgram jointsForm(const SteppedBlocks& blocks);

}  // namespace signorini
