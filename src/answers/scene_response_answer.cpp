#include "scene_response_answer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact_response.hpp"
#include "faults.hpp"
#include "harmonic_network_contact.hpp"
#include "harmonic_network_settled.hpp"
#include "infinity.hpp"
#include "two_contacts.hpp"

namespace signorini::answers {

bool SceneFrequency::touches() const
{
    return !distance || std::any_of(distance->begin(), distance->end(),
                                    [](double least) { return least < 0.0; });
}

Status SceneResponse::status() const
{
    const bool isKnown = std::none_of(frequencies.begin(), frequencies.end(),
                                      [](const SceneFrequency& at) { return at.reason; });
    return isComplete && isKnown ? Status::found : Status::undecided;
}

std::vector<std::int64_t> stepsOf(const SceneResponse& asked)
{
    const SceneRange& range = asked.range;
    // A frequency that is one of the grid may be given in few digits.
    constexpr double near = 1e-9;
    const double second = static_cast<double>(range.cycles) / asked.scales.time;
    const double least = std::ceil(second / range.mostHertz * (1.0 - near));
    const double most = std::floor(second / range.leastHertz * (1.0 + near));
    const auto shortest = static_cast<double>(std::max<std::int64_t>(2, 2 * range.cycles));
    const auto longest = static_cast<double>(range.isExact ? maxHarmonicSteps : maxStaircaseSteps);
    if (!(std::max(least, shortest) <= most && most <= longest)) {
        const bool isLow = most > longest;
        throwFault(isLow ? "leastFrequencyRatio" : "mostFrequencyRatio",
                   isLow ? range.leastHertz : range.mostHertz,
                   fmt::format("a range that holds {:.6g}/n Hz of some whole n = {}..{}", second,
                               shortest, longest));
    }
    std::vector<std::int64_t> all;
    double schedules = 0.0;
    for (auto n = static_cast<std::int64_t>(std::max(least, shortest));
         n <= static_cast<std::int64_t>(most); ++n) {
        all.push_back(n);
        schedules += range.contacts > 1 && !range.isExact
                         ? twoContactSchedules(n, asked.bars.contacts.size())
                         : 0.0;
    }
    const bool drifts = !driftingBars(networkOf(asked.bars.assembly)).empty();
    requireFewPairs(schedules, drifts ? maxDecidedPairs : maxNetworkPairs);
    return all;
}

namespace {

/// --from to --to, in ω₁ of these bars, which may not vibrate, or in Hz.
void takeHertz(const Call& call, const Network& network, SceneRange& range)
{
    const ResponseRange usual;
    const double first = firstHertz(referenceOf(network));
    const double unit = first > 0.0 ? first : 1.0;  // [Hz], that of ratios
    const auto read = [&](const char* name, const char* twin, double otherwise) {
        const FrequencyOption option(call, name, twin);
        if (!option.hertz && !(first > 0.0)) {
            refuse(name, option.ratio ? fmt::format("{}", *option.ratio) : "missing",
                   fmt::format("in Hz, as by {}: these bars do not vibrate",
                               call.with(name, "530Hz")));
        }
        return option.ratioFor(unit, otherwise);
    };
    const double least = read("--from", "--from-hertz", usual.leastFrequencyRatio);
    const double most = read("--to", "--to-hertz", usual.mostFrequencyRatio);
    requireOrder(call, least, most);
    range.leastHertz = unit * least;
    range.mostHertz = unit * most;
}

}  // namespace

SceneResponse responseAsked(const Call& call, const Assembly& assembly)
{
    const ForceOptions force(call);
    const Bar bar{
        .length = assembly.length, .waveSpeed = assembly.waveSpeed, .young = modulusOf(assembly)};
    const auto yieldStress = yieldStressOf(call, bar);
    force.requirePlace();
    force.requireAmplitude();
    SceneRange range{*force.place, *force.amplitude, force.derivative};
    call.read("--cycles", range.cycles);
    takeContacts(call, range);
    range.isExact = call.has("--exact");
    range.triesStability = call.has("--stability");
    const Network network = networkOf(assembly);
    refuseIf(range.isExact && call.has("--band"), "--band", call.text("--band"),
             "only of a harmonic in steps, where each schedule has an amplitude of its own");
    takeHertz(call, network, range);
    SceneResponse answer{range, network.scales, severalOf(assembly, network)};
    answer.yieldStress = yieldStress;
    const FrequencyOption to(call, "--to", "--to-hertz");
    hinting(call, "--to", to.ratio, firstHertz(referenceOf(network)), bar,
            [&] { (void)stepsOf(answer); });
    return answer;
}

namespace {

/// The one that a span closes.
std::size_t contactOf(const ContactSpan& span)
{
    return static_cast<std::size_t>(numbersOf(span.closed).front() - 1);
}

/// A motion of a staircase, walked once more for all that is said of it.
SceneHarmonicMotion motionOf(const ForcedMotion& motion, const std::vector<ContactSpan>& spans,
                             const HarmonicNetwork& given, const SceneResponse& asked,
                             const Cancel& cancel)
{
    const NetworkClaim claim = claimOf(spans, motion);
    const NetworkResiduals seen = walk(given.network, claim);
    SceneHarmonicMotion made{{}, asked.scales};
    made.value.phase = motion.phase;
    made.value.residual = motion.residual;
    made.strains = strainsOf(asked.bars.assembly, asked.scales, seen);
    std::vector<bool> isSeen(seen.impulses.size(), false);
    std::int64_t begin = 0;
    for (const ContactSpan& span : spans) {
        const std::int64_t end = begin + span.steps;
        if (span.closed != 0) {
            made.value.contacts.push_back({.contact = contactOf(span),
                                           .begin = static_cast<double>(begin),
                                           .end = static_cast<double>(end)});
        }
        begin = end;
        const std::size_t contact = made.value.contacts.back().contact;
        if (!isSeen[contact]) {
            isSeen[contact] = true;
            made.value.impulse += std::max(0.0, seen.impulses[contact]);  // but for rounding
            made.value.peakForce = std::max(made.value.peakForce, seen.peakForces[contact]);
            made.value.speed = std::max(made.value.speed, seen.extremes.contacts[contact].approach);
        }
    }
    made.inSteps = {made.value.contactTime() < static_cast<double>(given.steps)};
    if (asked.range.triesStability) {
        made.inSteps->stability = stabilityIn(given.network, claim, cancel);
    }
    return made;
}

/// Adds what one contact has of any amplitude. \param unit of amplitudes of the network
void addAmplitudes(SceneAmplitudes& all, std::size_t contact, const ContactResponse& response,
                   double unit)
{
    const FrequencyResponse& found = response.found;
    all.open = all.open && response.distance
                   ? std::optional(std::min(*all.open, found.openUpTo * unit))
                   : std::nullopt;
    for (const AmplitudeBranch& branch : found.branches) {
        all.closed.push_back({contact, {branch.contact, branch.least * unit, branch.most * unit}});
    }
    if (found.permanentUpTo > 0.0) {
        all.closed.push_back({contact, {found.steps, 0.0, found.permanentUpTo * unit}});
    }
}

/// The same with two contacts in a period.
bool addPairs(SceneFrequency& at, const HarmonicNetwork& given, const SceneResponse& asked,
              const Cancel& cancel)
{
    auto found = pairResponse(given, asked.range.band, cancel);
    if (!found) {
        return false;
    }
    const double unit = at.amplitude / given.amplitude;
    for (TwoContactBranch& branch : found->twoContacts) {
        branch.least *= unit;
        branch.most *= unit;
    }
    at.amplitudes->pairs = std::move(found->twoContacts);
    for (const ForcedMotion& motion : found->motions) {
        const std::vector<ContactSpan> spans = spansOf(motion.schedule);
        SceneHarmonicMotion& made =
            at.motions.emplace_back(motionOf(motion, spans, given, asked, cancel));
        made.inSteps->spans = spans;
        made.inSteps->amplitude = motion.amplitude * unit;
    }
    if (found->undecided > 0 && at.undecided == 0) {
        at.reason = found->detail;
    }
    at.undecided += found->undecided;
    return true;
}

/// What the harmonic in steps has. \return was it done, not cancelled?
bool addInSteps(SceneFrequency& at, const HarmonicNetwork& given, const SceneResponse& asked,
                const Cancel& cancel)
{
    const auto contacts = contactResponses(given, cancel);
    if (!contacts) {
        return false;
    }
    at.distance.emplace();
    at.amplitudes = {infinity};
    for (std::size_t contact = 0; contact < contacts->size(); ++contact) {
        addAmplitudes(*at.amplitudes, contact, (*contacts)[contact],
                      at.amplitude / given.amplitude);
        const auto& [found, permanent, leastPush, distance] = (*contacts)[contact];
        for (const ForcedMotion& motion : found.motions) {
            const std::int64_t closed = motion.schedule.phases.front().contact;
            at.motions.push_back(
                motionOf(motion, spansOf(contact, closed, given.steps), given, asked, cancel));
        }
        if (permanent) {
            at.motions.push_back(motionOf(*permanent, spansOf(contact, given.steps, given.steps),
                                          given, asked, cancel));
        }
        if (distance && at.distance) {
            at.distance->push_back(*distance * asked.scales.displacement);
        } else {
            at.distance.reset();
        }
        if (found.undecided > 0 && at.undecided == 0) {
            at.reason = found.detail;
        }
        at.undecided += found.undecided;
    }
    return (asked.range.contacts == 1 || addPairs(at, given, asked, cancel)) &&
           !isRequested(cancel);
}

/// The motion with two contacts on which bars at rest settle, if there is one.
void addSettled(SceneFrequency& at, const HarmonicNetwork& given, const SceneResponse& asked,
                const Cancel& cancel)
{
    SettledNetwork settled = settledHarmonic(
        given, {.cycles = responseCycles, .mostCycles = given.cycles, .cancel = cancel});
    if (settled.motion && settled.contacts == 2) {
        at.motions.push_back(
            answers::motionOf(asked.bars.assembly, asked.scales, std::move(*settled.motion)));
    }
}

}  // namespace

std::optional<SceneFrequency> frequencyAt(const SceneResponse& asked, std::int64_t steps,
                                          const Cancel& cancel)
{
    if (isRequested(cancel)) {
        return std::nullopt;
    }
    const SceneRange& range = asked.range;
    const NetworkScales& scales = asked.scales;
    SceneFrequency at;
    at.steps = steps;
    at.hertz = static_cast<double>(range.cycles) / (static_cast<double>(steps) * scales.time);
    if (const double first = asked.bars.reference.frequency; first > 0.0) {
        at.ratio = 2.0 * std::numbers::pi * at.hertz / first;
    }
    at.amplitude = displacementAt(at.hertz, range.amplitude, range.derivative);
    const double unit = range.place == Excited::tip ? scales.force() : scales.displacement;
    const HarmonicNetwork given{networkOf(asked.bars.assembly), range.place, at.amplitude / unit,
                                steps, range.cycles};
    if (!range.isExact) {
        return addInSteps(at, given, asked, cancel) ? std::optional(at) : std::nullopt;
    }
    try {
        at.distance = openDistances(given);
        if (at.distance) {
            for (double& distance : *at.distance) {
                distance *= scales.displacement;
            }
        }
        for (NetworkHarmonicMotion& motion : harmonicContacts(given)) {
            at.motions.push_back(motionOf(asked.bars.assembly, scales, std::move(motion)));
        }
        if (range.contacts > 1 && at.touches()) {
            addSettled(at, given, asked, cancel);
        }
    } catch (const Resonance& fault) {
        at.reason = fault.what();
    }
    return isRequested(cancel) ? std::nullopt : std::optional(std::move(at));
}

}  // namespace signorini::answers
