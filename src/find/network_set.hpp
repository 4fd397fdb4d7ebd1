#pragma once
/// \file
/// How many parameters the motions of a schedule of a network have.

#include <optional>
#include <vector>

#include "network_rows.hpp"

namespace signorini {

/// Of the polyhedron of all motions: the dimension of ker(W - 1), less the rank of all that are
/// equalities. Inequalities that no motion meets strictly are: asked to be met with some room, they
/// contradict others, and those that do so are in force in every motion; again, until the rest
/// leave room. Pushes of a block are of each of its residues; none where both ends of a wide
/// block in flight touch, as its distances then bound residues one by one, or where rounding
/// hides it. \pre there is a motion, the dimension of the kernel is known, and the rows are those
/// of `rowsOf`. O(rows^2 d + rows d^3) at worst, for d coordinates.
[[nodiscard]] std::optional<std::int64_t> dimensionOfSet(const NetworkBlocks& blocks,
                                                         const NetworkKernel<double>& kernel,
                                                         const NetworkRows<double>& rows,
                                                         const Cancel& cancel);

}  // namespace signorini
