#pragma once
/// \file
/// From the integers of a verdict to its set.

#include "signorini/one_phase_set.hpp"

namespace signorini {

/// The set in z_j that the other fields of a verdict describe. O(1).
[[nodiscard]] AmplitudeSet solutionSet(const Verdict& verdict);

}  // namespace signorini
