#pragma once
/// \file
/// Orbits: motions up to a shift in time.
///
/// A motion is known by the waves p_0 ... p_{n-1} that arrive at the tip in one period (theory.md,
/// section 2), its orbit by the same numbers in a ring. Periods are folded first (schedule.hpp):
/// that only leaves out what an orbit goes through twice.

#include <vector>

#include "signorini/schedule.hpp"
#include "signorini/state.hpp"

namespace signorini {

/// p_0 ... p_{n-1} [g/L] of a motion that follows the schedule, n counted after folding. O(n).
/// \throws std::invalid_argument on an invalid schedule or a state with other cells.
[[nodiscard]] std::vector<double> arrivals(const State& state, const Schedule& schedule);

/// The same state for all motions of an orbit, equal to the last bit: the orbit as force on the
/// wall begins. Of several such instants it is the first in a lexicographic order that puts steps
/// where force begins before others and larger p before smaller; a grazing motion is taken where
/// that order says. O(n).
/// \pre The state is a motion of the schedule.
/// \throws std::invalid_argument on an invalid schedule or a state with other cells.
[[nodiscard]] State orbitRepresentative(const State& state, const Schedule& schedule);

/// Are two motions of one schedule the same but for a shift in time, each p within `tolerance`
/// times the largest |p|? O(n) for tolerance 0, which suits motions that the library wrote, as
/// propagation does not round. Otherwise O(n) for each shift that brings the largest |p| into
/// place, mostly given up early. \pre Both states are motions of the schedule.
/// \throws std::invalid_argument on an invalid schedule, states with other cells, or a tolerance
/// that is not a number >= 0.
[[nodiscard]] bool isSameOrbit(const State& first, const State& second, const Schedule& schedule,
                               double tolerance = 0.0);

}  // namespace signorini
