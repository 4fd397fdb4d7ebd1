#pragma once
/// \file
/// What the stops say of sums of waves, in integers: the right sides of (31) and (12).
///
/// In a free step the tip moves by 2p/N. So a flight that starts at u(L) = x and ends at y has a
/// sum of p of N(y - x)/2, and its prefix sums P keep x + 2P/N between the stops.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "signorini/schedule.hpp"

namespace signorini {

/// factor * (a sum of waves) is rhs, or is bounded by it, in integers. factor > 0.
struct WaveSum {
    std::int64_t factor = 1;
    std::int64_t rhs = 0;

    [[nodiscard]] double value() const
    {
        return static_cast<double>(rhs) / static_cast<double>(factor);
    }

    friend bool operator==(const WaveSum&, const WaveSum&) = default;
};

/// u(L) at a stop. \pre the stop is there.
[[nodiscard]] Fraction placeOf(const Stops& stops, Stop stop);

/// p_0 + ... + p_{2N-1} at the start of the first contact: the gap row (31).
/// \throws std::overflow_error if N times the place does not fit in 64 bits.
[[nodiscard]] WaveSum gapSum(const Schedule& schedule);

/// N(g + h)/2 in units of displacement, the sum of |p| that takes the tip from one stop to the
/// other; empty if there is one stop. \throws as above.
[[nodiscard]] std::optional<WaveSum> crossingSum(const Schedule& schedule);

/// The prefix sums P of a flight: factor P <= most, >= least (if there is a stop there), = end at
/// its end.
struct FlightLimits {
    WaveSum most;
    std::optional<WaveSum> least;
    WaveSum end;
};

/// Of the flight of each phase. O(K).
[[nodiscard]] std::vector<FlightLimits> flightLimits(const Schedule& schedule);

/// Has a motion of any size multiples that are motions, too: no gap, and one stop?
[[nodiscard]] inline bool isCone(const Stops& stops)
{
    return stops.right == 0 && !stops.left;
}

/// Is the bar at rest, which nothing pushes, one of its motions: no gap, and only the wall touched?
[[nodiscard]] bool canRest(std::span<const Phase> phases, const Stops& stops);

/// Are the second half of the phases the first, on the other stop each? Only stops at equal
/// distances mirror each other.
[[nodiscard]] bool isMirrored(std::span<const Phase> phases, const Stops& stops);

/// Mean strain [g/L] of a bar at rest whose base stands at `base` [g]: 0, or what a stop presses.
[[nodiscard]] double restingStrain(const Stops& stops, double base);

/// p >= 0 is a push on the stop if this is 1, p <= 0 if it is -1.
[[nodiscard]] constexpr int pushSign(Stop stop)
{
    return stop == Stop::right ? 1 : -1;
}

}  // namespace signorini
