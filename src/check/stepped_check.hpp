#pragma once
/// \file
/// Checks of motions of a stepped bar, by a march of its own: plain cells, moved one by one, that
/// know nothing of delays, of the programs that find motions, or of their numbers.

#include <span>

#include "signorini/bar.hpp"
#include "signorini/motion.hpp"
#include "signorini/verification.hpp"

namespace signorini {

/// What is seen of a state.
struct SteppedVerification {
    Verification seen;  ///< as `verify` of a uniform bar
    Extremes extremes;  ///< over the motion's own period; forces in EA g/L of the first segment
};

/// Walks a state along the schedule, and marches it, which decides contact by itself: in each step
/// a tip at a stop that would be pushed into it is held. O(N n). `tolerance` as for `march`.
/// \throws std::invalid_argument on an invalid schedule, or unless state, segments and schedule
/// have as many cells.
[[nodiscard]] SteppedVerification verifyStepped(const State& state, const Schedule& schedule,
                                                std::span<const Segment> segments,
                                                double tolerance = 1e-9);

}  // namespace signorini
