#pragma once
/// \file
/// What is said of the forced motions of a schedule once its waves are known, whoever solved them.

#include <functional>
#include <span>
#include <vector>

#include "forced_line.hpp"
#include "forced_polytope.hpp"
#include "signorini/response.hpp"

namespace signorini {

/// The motion at a place (C, S), with the amplitudes of the waves that nothing damps.
using MotionAt = std::function<ForcedMotion(Plane place, std::span<const double> free)>;

/// Without a gap: amplitudes of a polygon that are 0 but for rounding.
inline constexpr double leastOfCone = 1e-7;

/// Is the bar at rest one of the motions?
[[nodiscard]] bool canRest(const ForcedSet& set);

/// What the set says of its line.
[[nodiscard]] ForcedLine lineOf(const ForcedSet& set);

void describeLine(ForcedSet& set, const ForcedLine& line);
void describePolytope(ForcedSet& set, ForcedPolytope polytope);
/// Conditions that miss each other by no more than rounding meet in a point: a motion if its
/// residual says so. Without a gap it is the bar at rest. \return is there one?
bool describeTouch(ForcedSet& set, ForcedLine line);

/// Of a line the motion of least amplitude, of a polygon all corners have to be motions, but for
/// those that only stand for no end. Where the bar at rest is among them some other motion stands
/// for all: they are its multiples, as far as a second stop lets them.
[[nodiscard]] double worstResidual(const ForcedSet& set, const MotionAt& motionAt);

/// Found, if that residual says so. Else undecided.
void believe(ForcedSet& set, const MotionAt& motionAt);

/// The motion at a place of a polygon.
[[nodiscard]] ForcedMotion motionIn(const ForcedSet& set, const std::array<double, 2>& place,
                                    const MotionAt& motionAt);

/// Those of one amplitude.
[[nodiscard]] std::vector<ForcedMotion> motionsOf(const ForcedSet& set, double amplitude,
                                                  const MotionAt& motionAt);

/// Why there is none, from what contradicts itself.
[[nodiscard]] Reason reasonOf(const std::vector<ForcedCondition>& conflict);

}  // namespace signorini
