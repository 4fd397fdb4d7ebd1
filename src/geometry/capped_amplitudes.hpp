#pragma once
/// \file
/// Members of a simplex or box of which no amplitude exceeds a cap in size.

#include <optional>
#include <vector>

#include "signorini/amplitude_set.hpp"

namespace signorini {

/// The one of largest sum z^2, which is convex, hence largest at a vertex. Simplex: all amplitudes
/// but one are 0 or the cap. Box: between two places where the partial sums are at 0, S or a bound,
/// all amplitudes but one are +-cap. O(d), on a box O(d (1 + width/cap)). Empty if no member is
/// below the cap, or on a box if that is more than 10^7.
[[nodiscard]] std::optional<std::vector<double>> mostAmplitudesBelow(const AmplitudeSet& set,
                                                                     double cap);

}  // namespace signorini
