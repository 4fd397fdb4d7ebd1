#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "faults.hpp"
#include "forced_case.hpp"
#include "forced_polytope.hpp"
#include "names.hpp"
#include "portable.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

constexpr auto forcedKindNames = std::to_array<Named<ForcedKind>>({
    {ForcedKind::empty, "empty"},
    {ForcedKind::point, "point"},
    {ForcedKind::segment, "segment"},
    {ForcedKind::ray, "ray"},
    {ForcedKind::polytope, "polytope"},
});

// Without a gap: amplitudes of a polygon that are 0 but for rounding.
constexpr double leastOfCone = 1e-7;

void validate(const Schedule& schedule, const Forcing& forcing, const ForcedLimits& limits)
{
    Faults faults;
    const std::int64_t n = steps(schedule);
    if (n > maxForcedSteps) {
        faults.add("steps", n, fmt::format("at most {}", maxForcedSteps));
    }
    if (!(limits.strain > 0.0)) {
        faults.add("strain limit", limits.strain, "> 0 [g/L]");
    } else if (std::isfinite(limits.strain) && forcing.place == Excited::base) {
        faults.add("strain limit", limits.strain, "none with a base that moves");
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
    [[nodiscard]] bool canRest() const
    {
        return signorini::canRest(set.schedule.phases, set.schedule.stops);
    }
    [[nodiscard]] double waveLimit() const { return 0.5 * set.limits.strain; }
    [[nodiscard]] ForcedCase motions() const { return {set.schedule, set.damping, shapes, waves}; }
    [[nodiscard]] ForcedMotion at(const std::array<double, 2>& place) const
    {
        const ForcedCorner corner = meanAt(set.corners, place);
        return forcedMotion(motions(), {corner.place[0], corner.place[1]}, corner.free);
    }
    [[nodiscard]] ForcedQuestion question() const
    {
        return {set.schedule, set.damping.rho(), shapes, waveLimit()};
    }
    /// What the set says of its line.
    [[nodiscard]] ForcedLine line() const
    {
        ForcedLine line;
        line.foot = {set.foot[0], set.foot[1]};
        line.direction = {set.direction[0], set.direction[1]};
        line.low = set.low;
        line.high = set.high;
        line.canRest = canRest();
        return line;
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

Reason reasonOf(const std::vector<ForcedCondition>& conflict)
{
    const auto has = [&conflict](ForcedRule rule) {
        return std::any_of(conflict.begin(), conflict.end(),
                           [rule](const ForcedCondition& c) { return c.rule == rule; });
    };
    return has(ForcedRule::strain)                              ? Reason::constraints
           : has(ForcedRule::penetration)                       ? Reason::penetration
           : has(ForcedRule::pressure) || has(ForcedRule::held) ? Reason::contactSign
                                                                : Reason::gap;
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

void describeLine(ForcedSet& set, const ForcedLine& line)
{
    set.foot = {line.foot.c, line.foot.s};
    if (set.forcing.shape.empty()) {
        set.direction = {line.direction.c, line.direction.s};
    }
    set.low = line.low;
    set.high = line.high;
    const double offset = portable::hypot(line.foot.c, line.foot.s);
    set.leastAmplitude = portable::hypot(offset, std::clamp(0.0, line.low, line.high));
    set.mostAmplitude = portable::hypot(offset, std::max(std::abs(line.low), std::abs(line.high)));
    set.kind = std::isinf(set.mostAmplitude) ? ForcedKind::ray
               : line.low < line.high        ? ForcedKind::segment
                                             : ForcedKind::point;
}

void describePolytope(ForcedSet& set, ForcedPolytope polytope)
{
    std::tie(set.leastAmplitude, set.mostAmplitude) = amplitudesOf(polytope);
    set.corners = std::move(polytope.corners);
    set.kind = ForcedKind::polytope;
}

/// Conditions that miss each other by no more than rounding meet in a point: a motion if its
/// residual says so. Without a gap it is the bar at rest. \return is there one?
bool describeTouch(ForcedSet& set, ForcedLine line)
{
    if (line.canRest || line.blocking || !std::isfinite(line.low) || !std::isfinite(line.high)) {
        return false;
    }
    set.detail.clear();
    line.low = line.high = 0.5 * (line.low + line.high);
    describeLine(set, line);
    return true;
}

/// Of a line the motion of least amplitude, of a polygon all corners have to be motions, but for
/// those that only stand for no end. Where the bar at rest is among them some other motion stands
/// for all: they are its multiples, as far as a second stop lets them.
double worstResidual(const ForcedSet& set, const Solved& solved)
{
    if (solved.canRest()) {
        ForcedSet tried = set;
        tried.status = Status::found;
        const auto motions = motionsOfAmplitude(tried, std::min(1.0, 0.5 * set.mostAmplitude));
        return motions.empty() ? std::numeric_limits<double>::infinity() : motions.front().residual;
    }
    if (set.kind != ForcedKind::polytope) {
        const ForcedLine line = solved.line();
        return forcedMotion(solved.motions(), line.at(std::clamp(0.0, line.low, line.high)))
            .residual;
    }
    double worst = solved.at(nearestPlace(set.corners)).residual;
    for (const ForcedCorner& corner : set.corners) {
        if (portable::hypot(corner.place[0], corner.place[1]) <=
            1e3 * std::max(1.0, set.leastAmplitude)) {
            worst = std::max(worst, forcedMotion(solved.motions(),
                                                 {corner.place[0], corner.place[1]}, corner.free)
                                        .residual);
        }
    }
    return worst;
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
        ForcedPolytope polytope = forcedPolytope(
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
        if (solved.canRest() && set.mostAmplitude <= leastOfCone) {
            set.kind = ForcedKind::empty;
            set.corners.clear();
            explainAbsence(set, mostDifferentWork(solved), solved.question());
            return;
        }
    }
    if (const double residual = worstResidual(set, solved); !(residual <= forcedTolerance)) {
        set.kind = ForcedKind::empty;
        set.corners.clear();
        set.detail = fmt::format("the motion that was found leaves a residual of {:.3g}", residual);
        return;
    }
    set.status = Status::found;
}

void requireMotions(const ForcedSet& set)
{
    if (set.status != Status::found) {
        throw std::invalid_argument("set: holds no motion: allowed one with status found");
    }
}

}  // namespace

std::string_view name(ForcedKind kind)
{
    return nameIn(forcedKindNames, kind);
}

ForcedSet forcedMotions(const Schedule& schedule, const Damping& damping, const Forcing& forcing,
                        const ForcedLimits& limits)
{
    signorini::validate(schedule);
    signorini::validate(damping);
    validate(schedule, forcing, limits);
    ForcedSet set;
    set.schedule = schedule;
    set.damping = damping;
    set.forcing = forcing;
    set.limits = limits;
    Solved solved(set);
    decide(set, solved);
    return set;
}

ForcedMotion motionAt(const ForcedSet& set, double t)
{
    requireMotions(set);
    if (set.kind == ForcedKind::polytope || !(t >= set.low && t <= set.high)) {
        Faults faults;
        faults.add("t", t,
                   set.kind == ForcedKind::polytope ? "nothing: a polytope has no line"
                                                    : fmt::format("{}..{}", set.low, set.high));
        faults.throwIfAny();
    }
    const Solved solved(set);
    return forcedMotion(solved.motions(), solved.line().at(t));
}

ForcedMotion leastAmplitudeMotion(const ForcedSet& set)
{
    requireMotions(set);
    if (canRest(set.schedule.phases, set.schedule.stops)) {
        throw std::invalid_argument(
            "set: without a gap motions are as small as one likes: allowed motionsOfAmplitude");
    }
    return set.kind == ForcedKind::polytope ? Solved(set).at(nearestPlace(set.corners))
                                            : motionAt(set, std::clamp(0.0, set.low, set.high));
}

std::vector<ForcedMotion> motionsOfAmplitude(const ForcedSet& set, double amplitude)
{
    Faults faults;
    faults.requirePositive("amplitude", amplitude, "EA g/L or g");
    faults.throwIfAny();
    if (set.status != Status::found) {
        return {};
    }
    const Solved solved(set);
    if (set.kind != ForcedKind::polytope) {
        return motionsOnLine(solved.motions(), solved.line(), amplitude);
    }
    if (amplitude < set.leastAmplitude || amplitude > set.mostAmplitude) {
        return {};
    }
    return {solved.at(placeOfAmplitude(set.corners, amplitude))};
}

AmplitudeExclusion exclusionOf(const ForcedSet& set, double amplitude)
{
    requireMotions(set);
    AmplitudeExclusion exclusion{amplitude, {}, false};
    Solved solved(set);
    if (set.kind == ForcedKind::polytope) {
        exclusion.conflict = mostDifferentWork(solved);
        exclusion.isCertain = !exclusion.conflict.empty() &&
                              forbidsAmplitude(solved.question(), amplitude, exclusion.conflict);
        return exclusion;
    }
    exclusion.conflict = conflictOf(solved.waves.line(false, solved.waveLimit()), solved.waves);
    exclusion.isCertain = forbidsAmplitude(solved.question(), amplitude, exclusion.conflict);
    return exclusion;
}

bool isCertain(const ForcedSet& set)
{
    return set.status == Status::none && forbidsContact(Solved(set).question(), set.conflict);
}

}  // namespace signorini
