#pragma once
/// \file
/// The bar as ordinary differential equations for a stiff solver: SUNDIALS, if it is there.

#include <memory>

#include "schemes.hpp"

namespace signorini::bench {

/// Lumped masses, the wall a stiff spring; backward differences (CVODE) with a relative tolerance
/// of 1e-6, begun anew wherever the tip crosses the wall.
/// \throws BackendUnavailable if this build does not contain it.
[[nodiscard]] std::unique_ptr<Scheme> cvodeScheme(const MarchedBar& bar, int elements);

}  // namespace signorini::bench
