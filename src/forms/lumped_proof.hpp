#pragma once
/// \file
/// The exact verdict on several contact phases as a proof over the rows of a program.

#include "program.hpp"
#include "signorini/certificate.hpp"
#include "signorini/lumped_set.hpp"

namespace signorini {

/// The proof of absence in terms of the program formulate(schedule, Formulation::lumped).
/// O(rows of the program). \throws std::invalid_argument if there are motions.
[[nodiscard]] InfeasibilityProof proofOf(const LumpedSet& set, const Program& program);

}  // namespace signorini
