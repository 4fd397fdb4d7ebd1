#pragma once
/// \file
/// What repeats after a period of a network: coordinates z of ker(W - 1) that are orthonormal in
/// the norm of the energy, sum Z x^2 = |z|^2, and what drives the network makes of waves at rest.
///
/// A period takes the waves x to W x + sum of inputs i times f_i: the shapes of a drive, and
/// constant forces, i = 1. W is a contraction in the norm of the energy, so W^T has the same kernel
/// there: an input repeats if it does no work on waves that nothing damps, k . sum i f_i = 0, and x
/// = sum i x_i + kernel, x_i at right angles to it by the clocks of the nodes (network_blocks.hpp);
/// at t = 0 it is not. docs/theory.md, sections 19 and 20.

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "least_norm.hpp"
#include "network_blocks.hpp"

namespace signorini {

/// Pivots of W - 1, whose singular values are at most 2, that are 0 but for rounding; and those
/// that are not.
inline constexpr double noPivot = 1e-12;
inline constexpr double clearPivot = 1e-8;

/// Largest state of a block whose kernel is computed, in doubles and in 50 digits.
inline constexpr std::int64_t mostKernelState = 4000;
inline constexpr std::int64_t mostFineState = 64;

/// ker(W - 1) of all blocks.
template <typename Number>
struct NetworkKernel {
    /// For each type what arrives in the blocks of a period, mean over its residues: row channel *
    /// turns + turn, one column for each coordinate.
    std::vector<MatrixOf<Number>> waves = {};
    /// The same, one column for each input.
    std::vector<MatrixOf<Number>> driven = {};
    /// Work of each input (columns) on each coordinate of a type.
    std::vector<MatrixOf<Number>> work = {};
    /// First coordinate of each type, and how many there are.
    std::vector<Eigen::Index> firsts = {0};
    /// Of single residues.
    std::int64_t dimension = 0;
    /// No pivot lies between `noPivot` and `clearPivot`: rounding does not hide the dimension.
    bool isClear = true;

    /// Of 1 - W of each type, where nothing repeats undriven; not of fine numbers.
    std::vector<SquareFactors> factors = {};

    std::vector<StepDrive> shapes = {};  ///< the inputs,
    bool hasForces = false;              ///< and one more, constant forces

    [[nodiscard]] Eigen::Index coordinates() const { return firsts.back(); }
    /// Is 1 - W factored, whole?
    [[nodiscard]] bool isWhole() const
    {
        return !factors.empty() && factors.size() == waves.size();
    }
    [[nodiscard]] Eigen::Index inputs() const
    {
        return static_cast<Eigen::Index>(shapes.size()) + (hasForces ? 1 : 0);
    }
};

/// Pivots up to `zero` are taken for 0. `shapes`: as long as the schedule; residues are then
/// blocks of their own. Empty if the state is too large, or the waves do not fit in 320 MB.
/// O(turns channels state) for each type, and state^3 where contacts close in other turns.
template <typename Number>
[[nodiscard]] std::optional<NetworkKernel<Number>> kernelOf(
    const NetworkBlocks& blocks, double zero = noPivot, const std::vector<StepDrive>& shapes = {});

/// The waves at the start of the schedule, for some inputs. O(M (coordinates + inputs)).
template <typename Number>
[[nodiscard]] std::vector<double> wavesAt(const NetworkBlocks& blocks,
                                          const NetworkKernel<Number>& kernel,
                                          const VectorOf<Number>& z,
                                          const VectorOf<Number>& inputs);

/// y = given + W^T y, both in the order of `Network::waves`: what derivatives by the waves at the
/// start of the schedule come to, if the period goes on for ever. O(n channels + state^2 blocks).
/// \pre blocks of single residues, a kernel that `isWhole`, no row longer than the schedule.
[[nodiscard]] Eigen::VectorXd periodicBackwards(const NetworkBlocks& blocks,
                                                const NetworkKernel<double>& kernel,
                                                const Eigen::VectorXd& given);

/// With constant forces, if there are any, alone.
template <typename Number>
[[nodiscard]] VectorOf<Number> steadyInputs(const NetworkKernel<Number>& kernel)
{
    VectorOf<Number> inputs = VectorOf<Number>::Zero(kernel.inputs());
    if (kernel.hasForces) {
        inputs[inputs.size() - 1] = 1;
    }
    return inputs;
}

}  // namespace signorini
