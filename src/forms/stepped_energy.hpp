#pragma once
/// \file
/// A bound below the energy of all motions of a stepped bar, proved in rationals.
///
/// Multipliers of the joints form, those of inequalities >= 0, add up to c . x <= q. Each row but
/// the open ones follows from others (exact_multipliers.hpp), so c is 0 at all unknowns but the
/// state, which the energy sum w x^2 counts, and prefix sums, which have bounds. With these bounds
/// taken to the right side, q < 0 and by Cauchy and Schwarz
///
///     E/E_1 >= sum w x^2 >= q^2 / sum c^2/w
///
/// whatever the multipliers are (the first with equality if the residues of a block are alike).
/// Those of least sum c^2/w for q = -1 give the least energy itself. They are found in
/// numbers of 50 digits (Lawson and Hanson, least distance programming), taken for the fractions
/// they are, and what follows from them is computed exactly; then what they prove.

#include <optional>

#include "signorini/certificate.hpp"

namespace signorini {

struct SteppedBlocks;

/// Multipliers over the rows of jointsForm(blocks), and the bound they prove.
struct SteppedEnergyProof {
    RationalProof multipliers;
    double energyRatio = 0.0;  ///< no motion has less E/E_1, but for the rounding of this number
};

/// The best multipliers, as 50 digits tell them. Empty where there is no motion, for more than
/// mostExactRows open rows or mostProofRows rows. O(open^3 + rows open) and O(rows) operations on
/// rationals of up to n/G times 50 bits.
[[nodiscard]] std::optional<SteppedEnergyProof> leastEnergyProof(const SteppedBlocks& blocks);

/// Most rows of such a proof.
inline constexpr std::int64_t mostProofRows = 4096;

}  // namespace signorini
