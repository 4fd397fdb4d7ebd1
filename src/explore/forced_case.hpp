#pragma once
/// \file
/// What forced motions of one schedule and the response share.

#include <functional>
#include <optional>
#include <span>
#include <string>
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

/// Does the tip rest at its stop all the time in every motion? So it does with one contact phase
/// and a class of steps without flight, unless a base works on such classes: n_f < G, each other
/// class flies in one step, and what comes back to it unchanged does not move the tip there.
[[nodiscard]] bool tipRests(const Schedule& schedule, const Forcing& forcing,
                            const ForcedWaves& waves);

/// Adds the motion whose tip never leaves the wall and that has no other waves than its excitation
/// makes: none unless the bar presses on the wall at rest, and by more than the amplitude takes
/// away. O(n).
void addPermanent(FrequencyResponse& response, const ResponseRange& range);

/// A motion at a place of the plane, its state still to be found.
[[nodiscard]] ForcedMotion drivenMotion(const Schedule& schedule, const Damping& damping,
                                        std::span<const Excitation> shapes, Plane place);

/// Enters the state of a bar of segments, what it reaches over the period, and how far it breaks
/// what a walk along the schedule and time stepping that is not told it ask for. O(n segments
/// + N).
void enterState(ForcedMotion& motion, std::span<const Segment> segments, State state);

/// The motion at a place of the plane, with the amplitudes of the waves that nothing damps, walked
/// and marched. O(n).
[[nodiscard]] ForcedMotion forcedMotion(const ForcedCase& all, Plane place,
                                        std::span<const double> free = {});

/// The motions of one amplitude on what is left of the line, by ascending impulse.
[[nodiscard]] std::vector<ForcedMotion> motionsOnLine(
    const ForcedLine& line, double amplitude,
    const std::function<ForcedMotion(double t)>& motionAt);

/// The amplitudes on what is left of a line. On both sides of the foot they grow along it.
void addBranches(FrequencyResponse& response, std::int64_t contact, const ForcedLine& line);

/// What is said of a motion with too large a residual.
[[nodiscard]] std::string doubtOf(double residual);

/// Counts a schedule that was not decided, and keeps the reason of the first.
void addUndecided(FrequencyResponse& response, const std::string& why);

/// Motions whose residual says so; the others count as undecided.
void addBelievable(FrequencyResponse& response, std::vector<ForcedMotion> motions);

}  // namespace signorini
