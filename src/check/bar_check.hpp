#pragma once
/// \file
/// Checks a motion of one bar, of one segment or several, as that of a network (network_walk.hpp).

#include <span>

#include "network_walk.hpp"
#include "signorini/bar.hpp"
#include "signorini/motion.hpp"
#include "signorini/simulation.hpp"
#include "signorini/verification.hpp"

namespace signorini {

/// What is seen of a state.
struct BarVerification {
    Verification seen;  ///< as `verify` of a uniform bar
    Extremes extremes;  ///< over the motion's own period, or that of an excitation; forces in EA
                        ///< g/L of the first segment
};

/// A bar's motion as one of its network, and what drives it. \pre as many cells.
[[nodiscard]] NetworkClaim claimOf(const Network& network, const State& state,
                                   const Schedule& schedule, const Excitation& excitation = {});

/// Walks a state along the schedule, and steps it in time without telling the schedule. Damping and
/// excitation, one period of it, drive the tip or the base; without a gap a driven bar's lengths
/// are relative to its amplitude. A single phase may be without flight. O(N + n segments).
/// `tolerance` as for `march`. \throws std::invalid_argument on an invalid schedule, or unless
/// state, segments (none: a uniform bar), schedule and excitation fit.
[[nodiscard]] BarVerification verifyBar(const State& state, const Schedule& schedule,
                                        std::span<const Segment> segments, double tolerance = 1e-9,
                                        const Damping& damping = {},
                                        const Excitation& excitation = {});

}  // namespace signorini
