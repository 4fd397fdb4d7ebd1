#include "signorini/response.hpp"

#include <algorithm>
#include <cmath>

#include "contact_response.hpp"
#include "excited_amplitude.hpp"
#include "faults.hpp"
#include "forced_case.hpp"
#include "portable.hpp"
#include "stepped_bar.hpp"
#include "two_contacts.hpp"

namespace signorini {

namespace {

void validate(const ResponseRange& range)
{
    Faults faults;
    faults.requireWhole("cells", range.cells, maxCells);
    faults.requirePositive("damping ratio", range.damping.ratio, "-");
    faults.requirePositive("amplitude", range.amplitude, "EA g/L or g");
    if (range.derivative < 0 || range.derivative > (range.place == Excited::base ? 2 : 0)) {
        faults.add("derivative", range.derivative, "0, or of a base 1 or 2");
    }
    faults.requireWhole("cycles", range.cycles, maxForcedSteps / 2);
    faults.requirePositive("leastFrequencyRatio", range.leastFrequencyRatio, "-");
    faults.requirePositive("mostFrequencyRatio", range.mostFrequencyRatio, "-");
    if (range.contacts < 1 || range.contacts > 2) {
        faults.add("contacts", range.contacts, "1 or 2");
    }
    if (!(range.band > 0.0 && range.band < 1.0)) {
        faults.add("band", range.band, "numbers > 0, below 1");
    }
    if (range.leastFrequencyRatio > range.mostFrequencyRatio) {
        faults.add("leastFrequencyRatio", range.leastFrequencyRatio,
                   fmt::format("at most {}, the largest", range.mostFrequencyRatio));
    }
    if (!(range.damping.rho() < 1.0)) {
        faults.add("damping ratio", range.damping.ratio, "numbers > 0 with exp(-pi zeta) < 1");
    }
    faults.throwIfAny();
    signorini::validate(range.damping);
    signorini::validate(Schedule{range.cells, {{1, 1}}, range.stops});
    if (!range.segments.empty()) {
        requireCells(steppedBar(range.segments), range.cells);
    }
}

/// The schedules of n steps that a response goes through.
enum class Pattern {
    onWall,
    onSecondStop,
    mirrored,  ///< on both, the second half the first on the other stop
};

std::vector<Pattern> patternsOf(const ResponseRange& range, std::int64_t steps)
{
    const auto& [right, left] = range.stops;
    std::vector<Pattern> patterns{Pattern::onWall};
    if (left) {
        patterns.push_back(Pattern::onSecondStop);
    }
    if (left && *left == Fraction{right, 1} && steps % 2 == 0 && range.cycles % 2 == 1) {
        patterns.push_back(Pattern::mirrored);
    }
    return patterns;
}

Schedule scheduleOf(const ResponseRange& range, Pattern pattern, std::int64_t steps,
                    std::int64_t contact)
{
    const Stop first = pattern == Pattern::onSecondStop ? Stop::left : Stop::right;
    Schedule schedule{range.cells, {{contact, steps - contact, first}}, range.stops};
    if (pattern == Pattern::mirrored) {
        schedule.phases = {{contact, steps / 2 - contact, Stop::right},
                           {contact, steps / 2 - contact, Stop::left}};
    }
    return schedule;
}

/// All motions of one schedule, whose phases the waves have.
void addMotions(FrequencyResponse& response, const ResponseRange& range, const Schedule& schedule,
                std::span<const Excitation> shapes, ForcedWaves& waves)
{
    const Forcing forcing{range.place, range.cycles, {}};
    if (tipRests(schedule, forcing, waves)) {
        return;  // said once, as permanent contact
    }
    ForcedLine line;
    const bool hasLine = waves.heldClasses() == 0 || waves.boundsHeld();
    if (hasLine) {
        line = waves.line(true);
    }
    if (hasLine && line.isEmpty()) {
        return;
    }
    const std::int64_t contact = schedule.phases.front().contact;
    std::vector<ForcedMotion> motions;
    if (waves.heldClasses() > 0) {
        const ForcedSet set = forcedMotions(schedule, range.damping, forcing);
        if (set.status == Status::undecided) {
            addUndecided(response, set.detail);
        }
        if (set.status == Status::found) {
            response.branches.push_back({contact, set.leastAmplitude, set.mostAmplitude});
        }
        motions = motionsOfAmplitude(set, range.amplitude);
    } else {
        addBranches(response, contact, line);
        motions = motionsOnLine(line, range.amplitude, [&](double t) {
            return forcedMotion({schedule, range.damping, shapes, waves}, line.at(t));
        });
    }
    addBelievable(response, std::move(motions));
}

}  // namespace

std::vector<std::int64_t> stepsOf(const ResponseRange& range)
{
    validate(range);
    const double unit = 4.0 * static_cast<double>(range.cells) * static_cast<double>(range.cycles);
    // 168/1.12 is 150, though not in doubles.
    constexpr double rounding = 1e-14;
    const double first = std::max({std::ceil(unit / range.mostFrequencyRatio * (1.0 - rounding)),
                                   2.0, 2.0 * static_cast<double>(range.cycles)});
    const double last = std::floor(unit / range.leastFrequencyRatio * (1.0 + rounding));
    const std::int64_t most = isUniform(range.segments) ? maxForcedSteps : maxStaircaseSteps;
    if (!(first <= last && last <= static_cast<double>(most))) {
        throwFault("frequency ratios",
                   fmt::format("{}..{}", range.leastFrequencyRatio, range.mostFrequencyRatio),
                   fmt::format("4NK/n for some whole n, 2K < n <= {}", most));
    }
    std::vector<std::int64_t> all;
    double schedules = 0.0;
    for (auto n = static_cast<std::int64_t>(first); n <= static_cast<std::int64_t>(last); ++n) {
        all.push_back(n);
        schedules += range.contacts > 1 ? twoContactSchedules(n, range.stops.left ? 2 : 1) : 0.0;
    }
    requireFewPairs(schedules,
                    isUniform(range.segments) ? maxTwoContactSchedules : maxNetworkPairs);
    return all;
}

std::optional<FrequencyResponse> responseAt(const ResponseRange& range, std::int64_t steps,
                                            const Cancel& cancel)
{
    validate(range);
    const double frequencyRatio = 4.0 * static_cast<double>(range.cells) *
                                  static_cast<double>(range.cycles) / static_cast<double>(steps);
    if (range.derivative > 0) {
        ResponseRange displaced = range;
        displaced.amplitude = displacementOf(range.amplitude, range.derivative, frequencyRatio);
        displaced.derivative = 0;
        return responseAt(displaced, steps, cancel);
    }
    if (!isUniform(range.segments)) {
        return steppedResponseAt(range, steps, cancel);
    }
    const std::vector<Excitation> shapes =
        shapesOf({range.place, range.cycles, {}}, range.cells, steps);
    ForcedWaves waves(range.cells, range.damping.rho(), shapes, range.stops);
    FrequencyResponse response;
    response.steps = steps;
    response.frequencyRatio = frequencyRatio;
    // Without contact the tip moves harmonically, and its size does not depend on the phase.
    const Plane tip = waves.tip(0);
    response.linearPeak = range.amplitude * portable::hypot(tip.c, tip.s);
    const auto& [right, left] = range.stops;
    const double nearest = left ? std::min<double>(right, left->value()) : right;
    response.touches = response.linearPeak >= nearest;
    response.openUpTo = std::max(nearest, 0.0) * range.amplitude / response.linearPeak;
    addPermanent(response, range);
    for (const Pattern pattern : patternsOf(range, steps)) {
        const std::int64_t most = pattern == Pattern::mirrored ? steps / 2 : steps;
        for (std::int64_t contact = 1; contact < most; ++contact) {
            if (contact % 16 == 0 && isRequested(cancel)) {
                return std::nullopt;
            }
            const Schedule schedule = scheduleOf(range, pattern, steps, contact);
            waves.setPhases(schedule.phases);
            addMotions(response, range, schedule, shapes, waves);
        }
    }
    if (range.contacts > 1 && !addTwoContacts(response, range, cancel)) {
        return std::nullopt;
    }
    return response;
}

std::vector<FrequencyResponse> frequencyResponse(const ResponseRange& range,
                                                 const ResponseControl& control)
{
    std::vector<FrequencyResponse> all;
    const std::vector<std::int64_t> steps = stepsOf(range);
    for (const std::int64_t n : steps) {
        std::optional<FrequencyResponse> response = responseAt(range, n, control.cancel);
        if (!response) {
            break;
        }
        all.push_back(std::move(*response));
        if (control.progress) {
            control.progress(static_cast<double>(all.size()), static_cast<double>(steps.size()));
        }
    }
    return all;
}

}  // namespace signorini
