#include <algorithm>
#include <cmath>

#include "faults.hpp"
#include "forced_case.hpp"
#include "forced_check.hpp"
#include "forced_set.hpp"
#include "network_forced.hpp"
#include "resting_tip.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

void validate(const Schedule& schedule, const Forcing& forcing, const ForcedLimits& limits)
{
    Faults faults;
    const std::int64_t n = steps(schedule);
    if (n > maxForcedSteps) {
        faults.add("steps", n, fmt::format("at most {}", maxForcedSteps));
    }
    if (!(limits.strain > 0.0)) {
        faults.add("strain limit", limits.strain, "> 0 [g/L]");
    }
    if (forcing.shape.empty()) {
        if (const std::int64_t most = (n - 1) / 2; forcing.cycles < 1 || forcing.cycles > most) {
            faults.add("cycles", forcing.cycles,
                       fmt::format("whole numbers 1..{}, below half of the steps", most));
        }
        faults.throwIfAny();
        return;
    }
    const auto length = static_cast<std::int64_t>(forcing.shape.size());
    if (n % length != 0) {
        faults.add("shape: steps", length, fmt::format("divisors of the {} steps of a period", n));
    }
    if (!std::all_of(forcing.shape.begin(), forcing.shape.end(),
                     [](double value) { return std::isfinite(value); })) {
        faults.add("shape", "not finite", "finite numbers");
    }
    if (std::all_of(forcing.shape.begin(), forcing.shape.end(),
                    [](double value) { return value == 0.0; })) {
        faults.add("shape", 0, "a value other than 0");
    }
    faults.throwIfAny();
}

/// A set with its waves solved once.
struct Solved {
    const ForcedSet& set;
    std::vector<Excitation> shapes;
    ForcedWaves waves;

    explicit Solved(const ForcedSet& of)
        : set(of),
          shapes(shapesOf(of.forcing, of.schedule.cells, steps(of.schedule))),
          waves(of.schedule.cells, of.damping.rho(), shapes, of.schedule.stops)
    {
        waves.setPhases(of.schedule.phases);
    }

    [[nodiscard]] bool isPlane() const { return shapes.size() > 1; }
    [[nodiscard]] double waveLimit() const { return 0.5 * set.limits.strain; }
    [[nodiscard]] ForcedCase motions() const { return {set.schedule, set.damping, shapes, waves}; }
    [[nodiscard]] MotionAt motionAt() const
    {
        return [this](Plane place, std::span<const double> free) {
            return forcedMotion(motions(), place, free);
        };
    }
    [[nodiscard]] ForcedQuestion question() const
    {
        return {set.schedule, set.damping.rho(), shapes, waveLimit()};
    }
};

/// What leaves nothing of the line; the waves that are always held are at the least there can be.
std::vector<ForcedCondition> conflictOf(const ForcedLine& line, const ForcedWaves& waves)
{
    std::vector<ForcedCondition> conflict;
    if (line.blocking && !(line.low > line.high)) {
        conflict.push_back(*line.blocking);
    } else {
        for (const auto& row : {line.lowRow, line.highRow}) {
            if (row) {
                conflict.push_back(*row);
            }
        }
    }
    for (const std::int64_t j : waves.freeClasses()) {
        conflict.push_back({ForcedRule::held, j});
    }
    return conflict;
}

void explainAbsence(ForcedSet& set, std::vector<ForcedCondition> conflict,
                    const ForcedQuestion& question)
{
    if (!forbidsContact(question, conflict)) {
        set.detail = "conditions exclude each other by no more than rounding can do";
        return;
    }
    set.status = Status::none;
    set.reason = reasonOf(conflict);
    set.conflict = std::move(conflict);
}

/// The two waves that nothing damps whose rows are least alike; empty if there are none.
std::vector<ForcedCondition> mostDifferentWork(const Solved& solved)
{
    std::vector<ForcedCondition> conflict;
    double most = 0.0;
    const std::vector<ForcedRow> rows = solved.waves.rows(solved.waveLimit());
    for (const ForcedRow& row : rows) {
        for (const ForcedRow& other : rows) {
            const double area = std::abs(row.plane.c * other.plane.s - row.plane.s * other.plane.c);
            if (row.condition.rule == ForcedRule::work &&
                other.condition.rule == ForcedRule::work && area > most) {
                most = area;
                conflict = {row.condition, other.condition};
            }
        }
    }
    return conflict;
}

/// Beside waves that nothing damps: is there no motion, for a reason that asks no program? Without
/// a gap a tip that rests does not press; and an excitation that may do no work on two such waves
/// is none, so that no tip meets a wall beyond a gap.
bool isExcluded(ForcedSet& set, const Solved& solved)
{
    const ForcedWaves& waves = solved.waves;
    std::vector<ForcedCondition> conflict;
    if (canRest(set)) {
        if (!tipRests(set.schedule, set.forcing, waves)) {
            return false;
        }
        conflict.push_back({ForcedRule::rest, 0});
    } else if (waves.undampedClasses() == 0 && waves.boundsHeld()) {
        conflict = mostDifferentWork(solved);
        if (conflict.empty()) {
            return false;
        }
        for (const std::int64_t j : waves.freeClasses()) {
            conflict.push_back({ForcedRule::held, j});
        }
    }
    if (!conflict.empty()) {
        explainAbsence(set, std::move(conflict), solved.question());
    }
    return set.status == Status::none;
}

void decide(ForcedSet& set, Solved& solved)
{
    ForcedWaves& waves = solved.waves;
    set.freeWaves = waves.heldClasses() + waves.undampedClasses();
    if (waves.undampedClasses() == 0 && (set.freeWaves == 0 || waves.boundsHeld())) {
        const ForcedLine line = waves.line(false, solved.waveLimit());
        if (!line.hasLine && set.freeWaves == 0) {
            explainAbsence(set, {}, solved.question());  // by that row alone
            if (set.status != Status::none) {
                set.detail = "the excitation leaves u(L, 0) at 0, but for rounding";
            }
            return;
        }
        if (line.isEmpty() && line.hasLine) {
            explainAbsence(set, conflictOf(line, waves), solved.question());
            if (set.status == Status::none) {
                return;
            }
            if (set.freeWaves == 0 && !describeTouch(set, line)) {
                return;
            }
        } else if (set.freeWaves == 0) {
            describeLine(set, line);
        }
    }
    if (set.freeWaves > 0) {
        if (isExcluded(set, solved)) {
            return;
        }
        // A harmonic with whole cycles in 2N steps and waves that go with it may have any size.
        const bool isAnySize =
            solved.isPlane() &&
            2 * set.schedule.cells * set.forcing.cycles % steps(set.schedule) == 0;
        const bool rests = tipRests(set.schedule, set.forcing, waves) && !isAnySize &&
                           set.schedule.stops.right < 0 && !std::isfinite(set.limits.strain);
        ForcedPolytope polytope =
            rests ? restingTip(waves, set.schedule, solved.isPlane())
                  : forcedPolytope(
                        waves.rows(solved.waveLimit()),
                        {solved.isPlane(), static_cast<std::int64_t>(waves.freeClasses().size())});
        set.detail = polytope.detail;
        if (polytope.conflict) {
            explainAbsence(set, std::move(*polytope.conflict), solved.question());
        }
        if (polytope.corners.empty()) {
            return;
        }
        describePolytope(set, std::move(polytope));
        if (canRest(set) && set.mostAmplitude <= leastOfCone) {
            set.kind = ForcedKind::empty;
            set.corners.clear();
            explainAbsence(set, mostDifferentWork(solved), solved.question());
            return;
        }
    }
    believe(set, solved.motionAt());
}

/// Of a network; where they are not kept (a set that was read from a file) anew.
std::shared_ptr<const NetworkForced> wavesOf(const ForcedSet& set)
{
    return set.waves || !set.isOfNetwork() ? set.waves : std::make_shared<const NetworkForced>(set);
}

/// Whoever solved the waves.
auto withMotions(const ForcedSet& set, auto make)
{
    const auto stepped = wavesOf(set);
    return stepped ? make(stepped->motionAt()) : make(Solved(set).motionAt());
}

void requireMotions(const ForcedSet& set)
{
    if (set.status != Status::found) {
        throw std::invalid_argument("set: holds no motion: allowed one with status found");
    }
}

}  // namespace

bool ForcedSet::isOfNetwork() const
{
    return !isUniform(segments) || (forcing.place == Excited::base && std::isfinite(limits.strain));
}

ForcedSet forcedMotions(const Schedule& schedule, const Damping& damping, const Forcing& forcing,
                        const ForcedLimits& limits, const std::vector<Segment>& segments)
{
    signorini::validate(schedule);
    signorini::validate(damping);
    validate(schedule, forcing, limits);
    ForcedSet set;
    set.schedule = schedule;
    set.damping = damping;
    set.forcing = forcing;
    set.limits = limits;
    set.segments = segments;
    if (set.isOfNetwork()) {
        set.waves = std::make_shared<const NetworkForced>(set);
        set.waves->decide(set);
        return set;
    }
    Solved solved(set);
    decide(set, solved);
    return set;
}

ForcedMotion motionAt(const ForcedSet& set, double t)
{
    requireMotions(set);
    if (set.kind == ForcedKind::polytope || !(t >= set.low && t <= set.high)) {
        throwFault("t", t,
                   set.kind == ForcedKind::polytope ? "nothing: a polytope has no line"
                                                    : fmt::format("{}..{}", set.low, set.high));
    }
    return withMotions(set,
                       [&](const MotionAt& motionAt) { return motionAt(lineOf(set).at(t), {}); });
}

ForcedMotion leastAmplitudeMotion(const ForcedSet& set)
{
    requireMotions(set);
    if (canRest(set)) {
        throw std::invalid_argument(
            "set: without a gap motions are as small as one likes: allowed motionsOfAmplitude");
    }
    if (set.kind != ForcedKind::polytope) {
        return motionAt(set, std::clamp(0.0, set.low, set.high));
    }
    return withMotions(set, [&](const MotionAt& motionAt) {
        return motionIn(set, nearestPlace(set.corners), motionAt);
    });
}

std::vector<ForcedMotion> motionsOfAmplitude(const ForcedSet& set, double amplitude)
{
    Faults faults;
    faults.requirePositive("amplitude", amplitude, "EA g/L or g");
    faults.throwIfAny();
    if (set.status != Status::found) {
        return {};
    }
    return withMotions(
        set, [&](const MotionAt& motionAt) { return motionsOf(set, amplitude, motionAt); });
}

AmplitudeExclusion exclusionOf(const ForcedSet& set, double amplitude)
{
    requireMotions(set);
    if (const auto stepped = wavesOf(set)) {
        return stepped->exclusion(set, amplitude);
    }
    AmplitudeExclusion exclusion{amplitude, {}, {}, false};
    Solved solved(set);
    exclusion.conflict =
        set.kind == ForcedKind::polytope
            ? mostDifferentWork(solved)
            : conflictOf(solved.waves.line(false, solved.waveLimit()), solved.waves);
    exclusion.isCertain = (set.kind != ForcedKind::polytope || !exclusion.conflict.empty()) &&
                          forbidsAmplitude(solved.question(), amplitude, exclusion.conflict);
    return exclusion;
}

bool isCertain(const ForcedSet& set)
{
    if (set.status != Status::none) {
        return false;
    }
    const auto stepped = wavesOf(set);
    return stepped ? stepped->isCertain(set.cuts)
                   : forbidsContact(Solved(set).question(), set.conflict);
}

}  // namespace signorini
