#pragma once
/// \file
/// A forced motion of a bar of several segments, walked along its schedule and marched.

#include <span>
#include <vector>

#include "forced_line.hpp"
#include "signorini/response.hpp"
#include "stepped_bar.hpp"

namespace signorini {

/// v of the tip in flight, p arriving.
[[nodiscard]] double tipSpeed(const SteppedBar& bar, const Damping& damping, double p,
                              double force);

/// What is to be moved; a cosine and a sine of size 1.
struct SteppedCase {
    const SteppedBar& bar;
    const Schedule& schedule;
    const Damping& damping;
    std::span<const Excitation> shapes;
};

/// C times the cosine and S times the sine.
[[nodiscard]] Excitation combined(std::span<const Excitation> shapes, Plane place);

/// The motion from a state at the start of contact. Its residual is the worst that a walk along the
/// schedule and a simulation that decides contact by itself saw. O(n N).
[[nodiscard]] ForcedMotion steppedMotion(const SteppedCase& all, Plane place, State state);

}  // namespace signorini
