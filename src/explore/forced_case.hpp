#pragma once
/// \file
/// What forced motions of one schedule and the response share.

#include <span>
#include <vector>

#include "forced_line.hpp"
#include "signorini/response.hpp"

namespace signorini {

/// The excitations of size 1 that a forcing is made of: cosine and sine, or one shape.
[[nodiscard]] std::vector<Excitation> shapesOf(const Forcing& forcing, std::int64_t cells,
                                               std::int64_t steps);

/// A schedule with its waves solved.
struct ForcedCase {
    const Schedule& schedule;
    const Damping& damping;
    std::span<const Excitation> shapes;
    const ForcedWaves& waves;
};

/// The motion at a point of the plane, walked and marched. O(n).
[[nodiscard]] ForcedMotion forcedMotion(const ForcedCase& all, Plane place);

/// The t with low <= t <= high and hypot(offset, t) = amplitude, at most two.
[[nodiscard]] std::vector<double> placesOfAmplitude(double offset, double low, double high,
                                                    double amplitude);

}  // namespace signorini
