#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "echo.hpp"
#include "faults.hpp"
#include "forced_case.hpp"
#include "forced_check.hpp"
#include "names.hpp"
#include "signorini/response.hpp"

namespace signorini {

namespace {

constexpr auto forcedKindNames = std::to_array<Named<ForcedKind>>({
    {ForcedKind::empty, "empty"},
    {ForcedKind::point, "point"},
    {ForcedKind::segment, "segment"},
    {ForcedKind::ray, "ray"},
});

void validate(const Schedule& schedule, const Forcing& forcing)
{
    Faults faults;
    const std::int64_t n = steps(schedule);
    if (schedule.phases.size() != 1) {
        faults.add("phases", schedule.phases.size(), "1");
    }
    if (n > maxForcedSteps) {
        faults.add("steps", n, fmt::format("at most {}", maxForcedSteps));
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

std::vector<ForcedRow> rowsOf(const ForcedLine& line, std::int64_t contact)
{
    std::vector<ForcedRow> rows;
    const bool isShape = line.low == 0.0 && line.high == 0.0;
    const auto steps = isShape ? std::array{line.blocking, std::int64_t{-1}}
                               : std::array{line.lowRow, line.highRow};
    for (const std::int64_t step : steps) {
        if (step >= 0) {
            rows.push_back({step < contact, step});
        }
    }
    return rows;
}

void explainAbsence(ForcedSet& set, const ForcedLine& line, std::span<const Excitation> shapes)
{
    const Phase& phase = set.schedule.phases.front();
    std::vector<ForcedRow> rows = rowsOf(line, phase.contact);
    const auto proves = [&](std::span<const ForcedRow> some) {
        return forbidsContact(set.schedule.cells, phase.contact, set.damping.rho(), shapes, some);
    };
    if (!line.hasLine) {
        set.detail = "the excitation leaves u(L, 0) at 0, but for rounding";
        return;
    }
    if (!proves(rows)) {
        set.detail = "two conditions exclude each other by no more than rounding can do";
        return;
    }
    set.status = Status::none;
    for (const ForcedRow& row : rows) {
        set.conflict.push_back({row.isContact, row.step});
    }
    set.reason =
        std::all_of(rows.begin(), rows.end(), [](const ForcedRow& row) { return row.isContact; })
            ? Reason::contactSign
            : Reason::penetration;
}

void describeLine(ForcedSet& set, const ForcedLine& line)
{
    set.foot[0] = line.foot.c;
    set.foot[1] = line.foot.s;
    if (set.forcing.shape.empty()) {
        set.direction[0] = line.direction.c;
        set.direction[1] = line.direction.s;
    }
    set.low = line.low;
    set.high = line.high;
    const double offset = std::hypot(line.foot.c, line.foot.s);
    set.leastAmplitude = std::hypot(offset, std::clamp(0.0, line.low, line.high));
    set.mostAmplitude = std::hypot(offset, std::max(std::abs(line.low), std::abs(line.high)));
    set.kind = std::isinf(set.mostAmplitude) ? ForcedKind::ray
               : line.low < line.high        ? ForcedKind::segment
                                             : ForcedKind::point;
}

}  // namespace

std::string_view name(ForcedKind kind)
{
    return nameIn(forcedKindNames, kind);
}

std::vector<Excitation> shapesOf(const Forcing& forcing, std::int64_t cells, std::int64_t steps)
{
    if (forcing.shape.empty()) {
        Harmonic harmonic{.place = forcing.place,
                          .cycles = forcing.cycles,
                          .steps = steps,
                          .stepsPerCrossing = static_cast<double>(cells)};
        Excitation cosine = excitationOf(harmonic);
        harmonic.phase = 0.5 * std::numbers::pi;
        return {std::move(cosine), excitationOf(harmonic)};
    }
    Excitation excitation{forcing.place, {}, static_cast<double>(cells)};
    while (excitation.steps() < steps) {
        excitation.values.insert(excitation.values.end(), forcing.shape.begin(),
                                 forcing.shape.end());
    }
    return {std::move(excitation)};
}

ForcedMotion forcedMotion(const ForcedCase& all, Plane place)
{
    const std::int64_t cells = all.schedule.cells;
    ForcedMotion motion;
    motion.schedule = all.schedule;
    motion.damping = all.damping;
    motion.amplitude = std::hypot(place.c, place.s);
    const auto value = [place](Plane x) { return x.dot(place); };
    motion.excitation = {all.shapes.front().place, {}, static_cast<double>(cells)};
    const bool isHarmonic = all.shapes.size() > 1;
    for (std::size_t m = 0; m < all.shapes.front().values.size(); ++m) {
        motion.excitation.values.push_back(
            value({all.shapes.front().values[m], isHarmonic ? all.shapes.back().values[m] : 0.0}));
    }
    motion.phase = isHarmonic ? std::atan2(place.s, place.c) : 0.0;
    const std::int64_t n = motion.excitation.steps();
    motion.state =
        stateOfWaves(cells, [&](std::int64_t m) { return value(all.waves.wave(m % n)); });
    for (std::int64_t i = 0; i < cells; ++i) {
        motion.state.b[i] += motion.excitation.baseVelocity(i);
    }
    const ForcedWalk walk = walkForced(motion.state, all.schedule.phases.front().contact,
                                       all.damping, motion.excitation);
    motion.impulse = walk.impulse;
    motion.peakForce = walk.peakForce;
    motion.lowest = walk.lowest;
    motion.residual = walk.worst();
    return motion;
}

ForcedSet forcedMotions(const Schedule& schedule, const Damping& damping, const Forcing& forcing)
{
    signorini::validate(schedule);
    signorini::validate(damping);
    validate(schedule, forcing);
    ForcedSet set;
    set.schedule = schedule;
    set.damping = damping;
    set.forcing = forcing;
    const std::vector<Excitation> shapes = shapesOf(forcing, schedule.cells, steps(schedule));
    ForcedWaves waves(schedule.cells, damping.rho(), shapes);
    waves.setContact(schedule.phases.front().contact);
    if (waves.undampedClasses() > 0) {
        set.detail =
            fmt::format("nothing damps the waves of {} classes of steps: their amplitudes are free",
                        waves.undampedClasses());
        return set;
    }
    const ForcedLine line = waves.line(false);
    if (line.isEmpty()) {
        explainAbsence(set, line, shapes);
        return set;
    }
    if (waves.heldClasses() > 0) {
        set.detail = fmt::format(
            "{} classes of steps never fly: nothing damps their waves, their amplitudes are free",
            waves.heldClasses());
        return set;
    }
    describeLine(set, line);
    const ForcedMotion least = forcedMotion({set.schedule, damping, shapes, waves},
                                            line.at(std::clamp(0.0, line.low, line.high)));
    if (least.residual <= forcedTolerance) {
        set.status = Status::found;
    } else {
        set.kind = ForcedKind::empty;
        set.detail =
            fmt::format("the motion that was found leaves a residual of {:.3g}", least.residual);
    }
    return set;
}

ForcedMotion motionAt(const ForcedSet& set, double t)
{
    if (set.status != Status::found || !(t >= set.low && t <= set.high)) {
        Faults faults;
        faults.add("t", t,
                   set.status == Status::found ? fmt::format("{}..{}", set.low, set.high)
                                               : "nothing: the set holds no motion");
        faults.throwIfAny();
    }
    const std::vector<Excitation> shapes =
        shapesOf(set.forcing, set.schedule.cells, steps(set.schedule));
    ForcedWaves waves(set.schedule.cells, set.damping.rho(), shapes);
    waves.setContact(set.schedule.phases.front().contact);
    return forcedMotion({set.schedule, set.damping, shapes, waves},
                        {set.foot[0] + t * set.direction[0], set.foot[1] + t * set.direction[1]});
}

ForcedMotion leastAmplitudeMotion(const ForcedSet& set)
{
    return motionAt(set, set.status == Status::found ? std::clamp(0.0, set.low, set.high) : 0.0);
}

std::vector<double> placesOfAmplitude(double offset, double low, double high, double amplitude)
{
    const double squares = (amplitude - offset) * (amplitude + offset);
    std::vector<double> places;
    if (squares >= 0.0) {
        const double t = std::sqrt(squares);
        for (const double place : {-t, t}) {
            if (place >= low && place <= high && (places.empty() || places.front() != place)) {
                places.push_back(place);
            }
        }
    }
    return places;
}

std::vector<ForcedMotion> motionsOfAmplitude(const ForcedSet& set, double amplitude)
{
    Faults faults;
    faults.requirePositive("amplitude", amplitude, "EA g/L or g");
    faults.throwIfAny();
    std::vector<ForcedMotion> motions;
    if (set.status == Status::found) {
        for (const double t : placesOfAmplitude(std::hypot(set.foot[0], set.foot[1]), set.low,
                                                set.high, amplitude)) {
            motions.push_back(motionAt(set, t));
        }
    }
    std::sort(motions.begin(), motions.end(),
              [](const ForcedMotion& x, const ForcedMotion& y) { return x.impulse < y.impulse; });
    return motions;
}

bool isCertain(const ForcedSet& set)
{
    std::vector<ForcedRow> rows;
    for (const ForcedCondition& condition : set.conflict) {
        rows.push_back({condition.isContact, condition.step});
    }
    return set.status == Status::none &&
           forbidsContact(set.schedule.cells, set.schedule.phases.front().contact,
                          set.damping.rho(),
                          shapesOf(set.forcing, set.schedule.cells, steps(set.schedule)), rows);
}

}  // namespace signorini
