#pragma once
/// \file
/// Forced motions of one contact phase whose tip never leaves its stop.
///
/// If n_f < G some classes of steps are always in contact, and any other flies in one step. A wave
/// of such a class comes back to that step as it left it, so p = -(rho p + F/(1 + eta)), R = F + 2p
/// = 0 and v = 0: the tip rests. The waves of the other classes have amplitudes z of their own.
/// Where the bar presses on the stop at rest
///
///     R_m = r_m . (C, S) + 2 z >= 0,    (2/G) sum z = 1 + u(L, 0) of the waves with z = 0,
///
/// so in a direction of (C, S) excitations go from 0 to where the sum of the least z takes all of
/// that: a polygon, whose corners lie where the step of least R changes. docs/theory.md,
/// section 17.

#include "forced_polytope.hpp"

namespace signorini {

/// \pre tipRests, and a gap < 0. O(n^2).
[[nodiscard]] ForcedPolytope restingTip(const ForcedWaves& waves, const Schedule& schedule,
                                        bool isPlane);

}  // namespace signorini
