#pragma once
/// \file
/// What a schedule asks of the waves that repeat: rows in coordinates of ker(W - 1) and in inputs
/// (network_kernel.hpp).
///
/// Pushes and distances are read off the waves, block by block. The displacement of a bar that
/// drifts appears in distances alone: one that closes, for each such bar, says what it is, and is
/// taken from the others; and in a period the bar moves by 0. docs/theory.md, section 20.

#include "network_kernel.hpp"
#include "signorini/certificate.hpp"

namespace signorini {

/// What a row is about: 0 or >= 0.
struct BlockCondition {
    enum class Kind {
        place,   ///< distance where a block begins, an equality where the contact closes
        push,    ///< mean over the steps of a block in contact
        tie,     ///< of bars held more than once (contact_spans.hpp), an equality
        drift,   ///< way in a period of a bar that drifts, an equality
        work,    ///< of all inputs on coordinate `turn` of the type, an equality
        strain,  ///< of two waves of a row (`contact`) that arrive at its right end in step `type`
                 ///< and at its left end in step `turn`, above the limit
    };
    Kind kind = Kind::place;
    std::size_t contact = 0;  ///< or number of the tie, or of the bar among those that drift
    std::size_t type = 0;
    std::int64_t turn = 0;
};

/// The rows a . z + d . shapes >= b, equalities first, and what they are about.
template <typename Number>
struct NetworkRows {
    RowSystemOf<Number> system;
    MatrixOf<Number> driven;  ///< d, one column for each shape
    std::vector<BlockCondition> conditions;
    VectorOf<Number> impulse;  ///< sum of all pushes over the period, of z
    bool isClear = true;       ///< no coefficient is 0 but for what may be rounding, or not
    /// Distances that close and say where bars that drift are, and by how much these move for them.
    std::vector<BlockCondition> tied;
    Eigen::MatrixXd driftBy;
};

/// O(rows coordinates). \throws std::invalid_argument if no contact that closes ties a bar that
/// drifts to what is held.
template <typename Number>
[[nodiscard]] NetworkRows<Number> rowsOf(const NetworkBlocks& blocks,
                                         const NetworkKernel<Number>& kernel);

/// Adds rows of strain >= -limit that the waves at z break, driven by inputs, the most broken ones
/// first; none: there is nothing to add. Rows that are there already are not added again.
/// O(n N) for each row of cells. \pre blocks of single residues.
template <typename Number>
[[nodiscard]] std::size_t addBrokenStrains(NetworkRows<Number>& rows, const NetworkBlocks& blocks,
                                           const NetworkKernel<Number>& kernel, double limit,
                                           const VectorOf<Number>& z,
                                           const VectorOf<Number>& inputs);

/// Multipliers of rows as those of distances and pushes, step by step; to be completed
/// (periodic_multipliers.hpp).
template <typename Number>
[[nodiscard]] EnergyFloor conditionsOf(const NetworkBlocks& blocks,
                                       const NetworkKernel<Number>& kernel,
                                       const NetworkRows<Number>& rows,
                                       const Eigen::VectorXd& multipliers);

/// Displacements of the nodes at the start of the schedule, for waves that meet the rows. O(n
/// channels) where a bar drifts.
template <typename Number>
[[nodiscard]] std::vector<double> displacementsAt(const NetworkBlocks& blocks,
                                                  const NetworkRows<Number>& rows,
                                                  std::span<const double> waves,
                                                  const StepDrive& drive = {});

}  // namespace signorini
