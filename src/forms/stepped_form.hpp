#pragma once
/// \file
/// The rows of a bar of several segments over the waves at joints and tip, in whole numbers: what
/// absence and least energies are proved with in rationals, where they are few
/// (docs/certificates.md).
///
/// A schedule in blocks, those of network_blocks.hpp in the order of the tip's time; of d residues
/// the sum is taken. With r^j the wave that arrives at joint j (the tip being the last, p = r^s) in
/// blocks of M_i = 2 N_i/G steps:
///
///     u(L, 0)/g = -(1/N) sum_i sum_{k < M_i} r^i_k
///
/// x = (r^j_k, p_k of each block, waves between joints, prefix sums). With left : right : all the
/// whole numbers Z_1 : Z_2 : Z_1 + Z_2 + d of a joint, e_k = -1 in contact and 1 in flight what the
/// tip makes of p, and l = e p where no further joint lies between,
///
///     all r^{j+1}_{k+M} = 2 left r^j_k + (2 right - all) l^j_k
///     all l^{j-1}_k     = (2 left - all) r^j_k + 2 right l^j_k,   l^0_k = -r^1_{k+M_1}
///     p >= 0 in contact,  y_k = y_{k-1} + p_k <= 0 in flight, 0 at its end
///     sum_i sum_{k < M_i} r^i_k = -N g/|g|

#include <optional>
#include <utility>
#include <vector>

#include "network_blocks.hpp"
#include "program.hpp"
#include "signorini/certificate.hpp"
#include "signorini/schedule.hpp"
#include "stepped_bar.hpp"

namespace signorini {

/// One type in one stretch of G steps.
struct StepBlock {
    std::size_t type = 0;
    std::int64_t turn = 0;  ///< k in 0..n/G-1
    bool isContact = false;
    bool isFlightEnd = false;  ///< the last of its flight
    double bound = 0.0;        ///< in flight, prefix sum at its end <= bound
    double floor = 0.0;        ///< and >= floor, perhaps -infinity
    double landing = 0.0;      ///< at the end of a flight, = landing
    int push = 1;              ///< in contact, push p >= 0: 1 at the right stop, -1 at the left
};

/// The schedule of a stepped bar.
struct SteppedBlocks {
    SteppedBar bar;
    Schedule schedule;
    NetworkBlocks network;
    std::vector<StepBlock> blocks;  ///< in order of time

    /// M_i.
    [[nodiscard]] std::int64_t delay(std::size_t segment) const
    {
        return network.delay(2 * segment);
    }
    /// -1 or 1, what the tip makes of a wave.
    [[nodiscard]] int echoOf(std::size_t type, std::int64_t turn) const
    {
        return network.closed(type, turn) != 0 ? -1 : 1;
    }
};

/// `tipFloor` [g]: the tip may not be lower. O(blocks). \throws std::invalid_argument if the cells
/// of segments and schedule differ.
[[nodiscard]] SteppedBlocks blocksOf(const SteppedBar& bar, const Schedule& schedule,
                                     double tipFloor);

/// What a schedule asks of waves that is no equality: a number >= 0.
enum class SteppedRule {
    push,   ///< of a block of contact, the sum of the waves that press
    bound,  ///< of a block of flight, bound - prefix sum
    floor,  ///< prefix sum - floor
};

/// A rule for a block.
struct SteppedCondition {
    SteppedRule rule = SteppedRule::push;
    std::size_t block = 0;  ///< number

    friend bool operator==(const SteppedCondition&, const SteppedCondition&) = default;
};

/// A program, and how to read a motion out of its unknowns.
struct SteppedProgram {
    Program program;
    std::vector<SteppedCondition> conditions;  ///< one for each inequality
    /// Unknowns that are prefix sums, each with the number of its block.
    std::vector<std::pair<Eigen::Index, std::size_t>> prefixes;
};

/// The joints form. Row k determines unknown k, waves first, then prefix sums; the gap is last.
/// O(blocks joints).
[[nodiscard]] SteppedProgram jointsForm(const SteppedBlocks& blocks);

/// Multipliers over the rows of jointsForm(blocks), whichever form found the conflict. They have
/// passed isProof. Empty if they are no proof, or where more than `mostExactRows` rows close upon
/// themselves. O(rows^3) rational operations.
[[nodiscard]] std::optional<RationalProof> proofOf(const std::vector<SteppedCondition>& conflict,
                                                   const SteppedBlocks& blocks);

/// Most open rows of a proof: sum of 2 N_i/G for each type.
inline constexpr std::int64_t mostExactRows = 96;

}  // namespace signorini
