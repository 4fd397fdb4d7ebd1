#pragma once
/// \file
/// What repeats after a period of a network, and what a schedule asks of it: rows in coordinates z
/// of ker(W - 1) that are orthonormal in the norm of the energy, sum Z x^2 = |z|^2.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "least_norm.hpp"
#include "network_blocks.hpp"
#include "signorini/certificate.hpp"

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
    std::vector<MatrixOf<Number>> waves;
    /// Of single residues.
    std::int64_t dimension = 0;
    /// No pivot lies between `noPivot` and `clearPivot`: rounding does not hide the dimension.
    bool isClear = true;

    [[nodiscard]] Eigen::Index coordinates() const;
};

/// Pivots up to `zero` are taken for 0. Empty if the state is too large, or the waves do not fit in
/// 320 MB. O(turns channels state + state^3) for each type.
template <typename Number>
[[nodiscard]] std::optional<NetworkKernel<Number>> kernelOf(const NetworkBlocks& blocks,
                                                            double zero = noPivot);

/// What a row is about: 0 or >= 0.
struct BlockCondition {
    enum class Kind {
        place,  ///< distance where a block begins, an equality where the contact closes
        push,   ///< mean over the steps of a block in contact
        tie,    ///< of bars held more than once (contact_spans.hpp), an equality
    };
    Kind kind = Kind::place;
    std::size_t contact = 0;  ///< or number of the tie
    std::size_t type = 0;
    std::int64_t turn = 0;
};

/// The rows a . z >= b, equalities first, and what they are about.
template <typename Number>
struct NetworkRows {
    RowSystemOf<Number> system;
    std::vector<BlockCondition> conditions;
    VectorOf<Number> impulse;  ///< sum of all pushes over the period, of z
    bool isClear = true;       ///< no coefficient is 0 but for what may be rounding, or not
};

/// \pre no bar drifts. O(rows coordinates).
template <typename Number>
[[nodiscard]] NetworkRows<Number> rowsOf(const NetworkBlocks& blocks,
                                         const NetworkKernel<Number>& kernel);

/// The waves at the start of the schedule. O(M coordinates).
template <typename Number>
[[nodiscard]] std::vector<double> wavesAt(const NetworkBlocks& blocks,
                                          const NetworkKernel<Number>& kernel,
                                          const VectorOf<Number>& z);

/// Multipliers of rows as those of distances and pushes, step by step; to be completed
/// (periodic_multipliers.hpp).
[[nodiscard]] EnergyFloor conditionsOf(const NetworkBlocks& blocks,
                                       const std::vector<BlockCondition>& conditions,
                                       const Eigen::VectorXd& multipliers);

}  // namespace signorini
