#include "forced_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bar_check.hpp"
#include "echo.hpp"
#include "portable.hpp"

namespace signorini {

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

bool tipRests(const Schedule& schedule, const Forcing& forcing, const ForcedWaves& waves)
{
    // Around a class a harmonic adds up to 0 unless it goes through whole cycles in 2N steps.
    const bool works =
        forcing.place == Excited::base &&
        (!forcing.shape.empty() || 2 * schedule.cells * forcing.cycles % steps(schedule) == 0);
    return schedule.phases.size() == 1 && waves.heldClasses() > 0 && !works;
}

void addPermanent(FrequencyResponse& response, const ResponseRange& range)
{
    const std::int64_t steps = response.steps;
    // A base moves with the frequencies of the bar between it and the wall where 2NK/n is whole.
    if (range.stops.right >= 0 ||
        (range.place == Excited::base && 2 * range.cells * range.cycles % steps == 0)) {
        return;
    }
    const auto cells = static_cast<double>(range.cells);
    const Harmonic harmonic{.place = range.place,
                            .amplitude = range.amplitude,
                            .cycles = range.cycles,
                            .steps = steps,
                            .stepsPerCrossing = cells};
    const Excitation excitation = excitationOf(harmonic);
    const auto angle = [steps](std::int64_t halfSteps) {  // of the harmonic, one cycle in n steps
        return std::numbers::pi * static_cast<double>(halfSteps % (2 * steps)) /
               static_cast<double>(steps);
    };
    // p_{m+2N} = p_m + V_{m+N}: beside the waves at rest, p = 1/2, the base makes a harmonic.
    const double made = range.place == Excited::tip
                            ? 0.0
                            : range.amplitude * cells * std::sin(angle(range.cycles)) /
                                  std::sin(angle(2 * range.cells * range.cycles));
    const double taken = range.place == Excited::tip ? range.amplitude : 2.0 * std::abs(made);
    response.permanentUpTo = range.amplitude / taken;
    if (!(taken <= 1.0)) {
        return;
    }
    PermanentContact& contact = response.permanent.emplace();
    contact.leastForce = 1.0 - taken;
    State state = stateOfWaves(range.cells, [&](std::int64_t m) {
        return 0.5 + made * std::cos(angle(range.cycles * (2 * m + 1)));
    });
    for (std::int64_t i = 0; i < range.cells; ++i) {
        state.b[i] += excitation.baseVelocity(i);
    }
    const Schedule schedule{range.cells, {{steps, 0}}, range.stops};
    const auto [seen, extremes] =
        verifyBar(state, schedule, {}, forcedTolerance, range.damping, excitation);
    contact.extremes = extremes;
    contact.residual = seen.residuals.worst();
}

ForcedMotion drivenMotion(const Schedule& schedule, const Damping& damping,
                          std::span<const Excitation> shapes, Plane place)
{
    const bool isHarmonic = shapes.size() > 1;
    ForcedMotion motion;
    motion.schedule = schedule;
    motion.damping = damping;
    motion.amplitude = portable::hypot(place.c, place.s);
    motion.phase = isHarmonic ? portable::atan2(place.s, place.c) : 0.0;
    motion.excitation = shapes.front();
    for (std::size_t m = 0; m < motion.excitation.values.size(); ++m) {
        motion.excitation.values[m] =
            place.dot({shapes.front().values[m], isHarmonic ? shapes.back().values[m] : 0.0});
    }
    return motion;
}

void enterState(ForcedMotion& motion, std::span<const Segment> segments, State state)
{
    motion.state = std::move(state);
    const auto [seen, extremes] = verifyBar(motion.state, motion.schedule, segments,
                                            forcedTolerance, motion.damping, motion.excitation);
    motion.extremes = extremes;
    motion.residual = seen.residuals.worst();
}

ForcedMotion forcedMotion(const ForcedCase& all, Plane place, std::span<const double> free)
{
    const std::int64_t cells = all.schedule.cells;
    ForcedMotion motion = drivenMotion(all.schedule, all.damping, all.shapes, place);
    const std::int64_t n = motion.excitation.steps();
    std::vector<double> amplitudes(static_cast<std::size_t>(all.waves.classes()), 0.0);
    const std::vector<std::int64_t> undamped = all.waves.freeClasses();
    for (std::size_t k = 0; k < free.size(); ++k) {
        amplitudes[static_cast<std::size_t>(undamped[k])] = free[k];
    }
    State state = stateOfWaves(cells, [&](std::int64_t m) {
        const std::int64_t at = m % n;
        const double own = amplitudes[static_cast<std::size_t>(at % all.waves.classes())];
        return all.waves.wave(at).dot(place) + (own != 0.0 ? own * all.waves.sign(at) : 0.0);
    });
    for (std::int64_t i = 0; i < cells; ++i) {
        state.b[i] += motion.excitation.baseVelocity(i);
    }
    enterState(motion, {}, std::move(state));
    return motion;
}

std::vector<ForcedMotion> motionsOnLine(const ForcedLine& line, double amplitude,
                                        const std::function<ForcedMotion(double t)>& motionAt)
{
    const double offset = portable::hypot(line.foot.c, line.foot.s);
    const double squares = (amplitude - offset) * (amplitude + offset);
    std::vector<ForcedMotion> motions;
    if (squares >= 0.0) {
        const double away = std::sqrt(squares);
        for (const double t : {-away, away}) {
            if (t >= line.low && t <= line.high && (motions.empty() || away > 0.0)) {
                motions.push_back(motionAt(t));
            }
        }
    }
    std::sort(motions.begin(), motions.end(), [](const ForcedMotion& x, const ForcedMotion& y) {
        return x.extremes.impulse < y.extremes.impulse;
    });
    return motions;
}

void addBranches(FrequencyResponse& response, std::int64_t contact, const ForcedLine& line)
{
    const double offset = portable::hypot(line.foot.c, line.foot.s);
    const auto add = [&](double from, double to) {
        if (from <= to && !(line.canRest && to <= 0.0)) {
            response.branches.push_back(
                {contact, portable::hypot(offset, from), portable::hypot(offset, to)});
        }
    };
    add(std::max(-line.high, 0.0), -line.low);
    add(std::max(line.low, 0.0), line.high);
}

void addUndecided(FrequencyResponse& response, const std::string& why)
{
    if (response.undecided++ == 0) {
        response.detail = why;
    }
}

std::string doubtOf(double residual)
{
    return fmt::format("the motion that was found leaves a residual of {:.3g}", residual);
}

void addBelievable(FrequencyResponse& response, std::vector<ForcedMotion> motions)
{
    for (ForcedMotion& motion : motions) {
        if (motion.residual <= forcedTolerance) {
            response.motions.push_back(std::move(motion));
        } else {
            addUndecided(response, doubtOf(motion.residual));
        }
    }
}

}  // namespace signorini
