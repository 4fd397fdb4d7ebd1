#pragma once
/// \file
/// That a schedule of a stepped bar has no motion, proved in rationals.

#include <optional>
#include <vector>

#include "signorini/certificate.hpp"
#include "stepped_form.hpp"

namespace signorini {

/// Multipliers over the rows of jointsForm(blocks), whichever form found the conflict. They have
/// passed isProof. Empty if they are no proof, or where more than `mostExactRows` rows close upon
/// themselves. O(rows^3) rational operations.
[[nodiscard]] std::optional<RationalProof> proofOf(const std::vector<SteppedCondition>& conflict,
                                                   const SteppedBlocks& blocks);

/// Most open rows of a proof: sum of 2 N_i/G for each type.
inline constexpr std::int64_t mostExactRows = 96;

}  // namespace signorini
