#pragma once
/// \file
/// The programs of a stepped bar: over the waves at joints and tip, or over the kernel of W - 1.
///
/// **joints**: x = (r^j_k, p_k of each block, waves between joints, prefix sums). With left : right
/// : all the whole numbers Z_1 : Z_2 : Z_1 + Z_2 + d of a joint, e_k = -1 in contact and 1 in
/// flight what the tip makes of p, and l = e p where no further joint lies between,
///
///     all r^{j+1}_{k+M} = 2 left r^j_k + (2 right - all) l^j_k
///     all l^{j-1}_k     = (2 left - all) r^j_k + 2 right l^j_k,   l^0_k = -r^1_{k+M_1}
///     p >= 0 in contact,  y_k = y_{k-1} + p_k <= 0 in flight, 0 at its end
///     sum_i sum_{k < M_i} r^i_k = -N g/|g|
///
/// **kernel**: x = coordinates of ker(W - 1), orthonormal in the norm of the energy; few, but with
/// full rows, and rounded.
///
/// Both find motions, and multipliers of what contradicts itself; what these prove is seen by a
/// march backwards (energy_floor.hpp).

#include <optional>
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
    /// Flights' last blocks, one for each equality after the gap's; kernel form only.
    std::vector<std::size_t> landings;
    /// Unknowns that are prefix sums, each with the number of its block; joints form only.
    std::vector<std::pair<Eigen::Index, std::size_t>> prefixes;
    /// Of the unknowns, E/E_1 = sum weight x^2.
    Eigen::VectorXd energyWeights;
    /// Impulse on the stops [EA g/c], as a linear function of x.
    Eigen::VectorXd impulse;
    /// Row j of the sums = reading[j] x.
    std::vector<Eigen::SparseMatrix<double, Eigen::RowMajor>> reading;
};

/// The sums of a solution. O(entries).
[[nodiscard]] ArrivalSums sumsOf(const SteppedProgram& posed, const SteppedBlocks& blocks,
                                 const Eigen::VectorXd& x);

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

/// ker(W - 1) of each type, orthonormal in the norm of the energy.
struct SteppedKernel {
    /// For each type its r^j_k: row j * turns + k, one column for each dimension.
    std::vector<Eigen::MatrixXd> waves;
    /// sum of width times columns.
    std::int64_t dimension = 0;
    /// No pivot lies between `noPivot` and `clearPivot`: rounding does not hide the dimension.
    bool isClear = true;
};

/// Pivots of W - 1, whose singular values are at most 2, that are 0 but for rounding; and those
/// that are not.
inline constexpr double noPivot = 1e-12;
inline constexpr double clearPivot = 1e-8;

/// Pivots up to `zero` are taken for 0. Empty if the state is larger than `mostKernelState`, or the
/// waves do not fit in 320 MB. O(turns state^2 + state^3) for each type.
[[nodiscard]] std::optional<SteppedKernel> kernelOf(const SteppedBlocks& blocks,
                                                    double zero = noPivot);

/// Largest state of a block whose kernel is computed.
inline constexpr std::int64_t mostKernelState = 1500;

/// The kernel form. O(blocks unknowns).
[[nodiscard]] SteppedProgram kernelForm(const SteppedBlocks& blocks, const SteppedKernel& kernel);

}  // namespace signorini
