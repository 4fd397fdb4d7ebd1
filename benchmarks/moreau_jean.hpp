#pragma once
/// \file
/// What a general code for nonsmooth mechanics does with the bar: linear elements, consistent mass,
/// the scheme of Moreau and Jean with theta = 1/2, an impact law with e = 0.

#include "siconos.hpp"

namespace signorini::bench {

/// The same steps as runSiconos, with tridiagonal matrices: O(elements) each.
[[nodiscard]] TimeSteps runMoreauJean(const SiconosRun& run);

}  // namespace signorini::bench
