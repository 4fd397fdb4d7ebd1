#pragma once
/// \file
/// From what a route claims to an answer: nothing is believed that other code does not confirm.

#include "routes.hpp"

namespace signorini {

/// Verifies a claim: a motion by its residuals and demands, absence by its proof. What does not
/// hold becomes undecided. O(N + min(n, 12N)) for a motion.
[[nodiscard]] PeriodicResult accept(const Request& request, Claim claim);

}  // namespace signorini
