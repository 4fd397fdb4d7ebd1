#include "scene_harmonic_answer.hpp"

#include <algorithm>
#include <cmath>

#include "faults.hpp"
#include "harmonic_network_contact.hpp"
#include "harmonic_network_settled.hpp"
#include "late_contacts.hpp"

namespace signorini::answers {

AskedPeriod askedOfBars(const Call& call, const Assembly& assembly, std::int64_t cycles)
{
    const Network network = networkOf(assembly);
    const double second = 1.0 / network.scales.time;
    const double crossing = assembly.length / assembly.waveSpeed * second;
    const double first = firstHertz(referenceOf(network));
    const auto periods = static_cast<double>(cycles);
    const auto [option, word] = call.period();
    AskedPeriod asked = askedAs(option, word);
    const std::string& name = asked.option;
    const bool isPeriod = name == "period";
    const bool isHertz = name == "hertz";
    const double value = isHertz ? parsePositive(option, word, "Hz")
                                 : parseNumber(option, word, isPeriod ? "L/c" : "ω₁").value;
    const double wanted = isPeriod  ? value * crossing
                          : isHertz ? periods * second / value
                                    : periods * second / (first * value);
    const double nearest = std::round(wanted);
    Faults faults;
    if (!isPeriod && !isHertz && !(first > 0.0)) {
        faults.add(name, value, "bars that vibrate with their contacts open; hertz is of any");
    } else if (!(nearest >= 2.0 && nearest <= static_cast<double>(maxHarmonicSteps)) ||
               (isPeriod && std::abs(wanted - nearest) > 1e-9 * nearest)) {
        const std::string steps = fmt::format("periods of 2..{} steps of {:.6g} s",
                                              maxHarmonicSteps, network.scales.time);
        const double most = 0.5 * periods * second;
        faults.add(name, value,
                   isPeriod  ? fmt::format("{}, {:.10g} to L/c", steps, crossing)
                   : isHertz ? fmt::format("{:.6g}..{:.6g} Hz for these bars (L = {:.6g} m, c = "
                                           "{:.6g} m/s): {}",
                                           2.0 * most / static_cast<double>(maxHarmonicSteps), most,
                                           assembly.length, assembly.waveSpeed, steps)
                             : steps);
    }
    faults.throwIfAny();
    asked.steps = static_cast<std::int64_t>(nearest);
    asked.isRounded = !isPeriod;
    return asked;
}

namespace {

bool mayPress(const Network& network)
{
    for (std::size_t contact = 0; contact < network.contacts.size(); ++contact) {
        if (meanPushOf(network, contact)) {
            return true;
        }
    }
    return false;
}

}  // namespace

Question<SceneHarmonicAnswer> harmonicAsked(const Call& call, const Assembly& assembly)
{
    const ForceOptions force(call);
    force.requirePlace();
    force.requireAmplitude();
    const std::int64_t contacts = call.whole("--contacts").value_or(1);
    const std::int64_t cycles = call.whole("--cycles").value_or(1);
    return [=, asked = askedOfBars(call, assembly, cycles),
            limit = call.number("--strain-limit")](const Watch& watch) {
        SceneHarmonicAnswer answer =
            answerOf(assembly, *force.place, cycles, asked.steps, *force.amplitude,
                     force.derivative, contacts, watch.cancel);
        answer.asked = asked;
        return within(limit, std::move(answer));
    };
}

SceneHarmonicAnswer answerOf(const Assembly& assembly, Excited place, std::int64_t cycles,
                             std::int64_t steps, double amplitude, int derivative,
                             std::int64_t contacts, const Cancel& cancel)
{
    const Network network = networkOf(assembly);
    SceneHarmonicAnswer answer{
        place,    cycles, amplitude, steps, network.scales, severalOf(assembly, network),
        contacts, {}};
    answer.amplitude = displacementAt(answer.frequency(), amplitude, derivative);
    if (contacts > 1) {
        SettlingSearch search;
        search.mostCycles = std::max(search.mostCycles, cycles);
        search.cancel = cancel;
        SettledNetwork settled = settledHarmonic(answer.given(), search);
        answer.mayPress = settled.mayRest;
        answer.settledContacts = settled.contacts;
        answer.settledCycles = settled.cycles;
        if (settled.motion && settled.contacts == contacts) {
            answer.motions.push_back(
                motionOf(assembly, network.scales, std::move(*settled.motion)));
        }
        return answer;
    }
    for (NetworkHarmonicMotion& motion : harmonicContacts(answer.given())) {
        answer.motions.push_back(motionOf(assembly, network.scales, std::move(motion)));
    }
    answer.mayPress = mayPress(network);
    return answer;
}

SceneHarmonicMotion motionOf(const Assembly& assembly, const NetworkScales& scales,
                             NetworkHarmonicMotion motion)
{
    const SceneStrains strains = strainsOf(assembly, scales, motion.leastStrain, motion.mostStrain);
    return {std::move(motion), scales, strains};
}

std::optional<std::vector<SceneHarmonicContact>> SceneHarmonicMotion::contacts() const
{
    if (inSteps) {
        return std::nullopt;
    }
    std::vector<SceneHarmonicContact> all;
    all.reserve(value.contacts.size());
    for (const NetworkHarmonicContact& one : value.contacts) {
        all.push_back({one, scales});
    }
    return all;
}

std::optional<bool> SceneHarmonicMotion::attracts() const
{
    if (inSteps) {
        const Stability tried =
            inSteps->stability ? inSteps->stability->result.stability : Stability::unclear;
        return tried == Stability::unclear ? std::nullopt
                                           : std::optional(tried == Stability::attracts);
    }
    return value.growth && std::abs(*value.growth - 1.0) > sameGrowth
               ? std::optional(*value.growth < 1.0)
               : std::nullopt;
}

HarmonicNetwork SceneHarmonicAnswer::given() const
{
    const double unit = place == Excited::tip ? scales.force() : scales.displacement;
    return {networkOf(bars.assembly), place, amplitude / unit, steps, cycles};
}

void SceneHarmonicAnswer::watch(std::size_t motion, const HarmonicWatch& by) const
{
    NetworkHarmonicMotion one = motions.at(motion).value;
    HarmonicNetwork driven = given();
    const StillNetwork still = underConstantForces(driven.network);
    driven.network = still.network;
    HarmonicWatch seeing = by;
    if (by.state) {
        seeing.state = [&](std::int64_t step, NetworkStart now) {
            still.addShape(now);
            by.state(step, now);
        };
    }
    measure(driven, one, seeing);
}

std::optional<double> SceneHarmonicAnswer::frequencyRatio() const
{
    const double first = bars.reference.frequency;
    return first > 0.0 ? std::optional(2.0 * std::numbers::pi * frequency() / first) : std::nullopt;
}

QuestionPart SceneHarmonicAnswer::question() const
{
    return {asked, period(), period() * bars.assembly.waveSpeed / bars.assembly.length, frequency(),
            frequencyRatio()};
}

std::optional<std::string> SceneHarmonicAnswer::detail() const
{
    if (status() == Status::found) {
        return std::nullopt;
    }
    if (status() == Status::none) {
        return fmt::format(
            "over a period the pushes of {} have to balance the constant forces on "
            "bars that nothing holds, and cannot",
            contacts == 1 ? "one contact" : "contacts");
    }
    const auto beyond = limit.detail();
    if (!beyond && contacts > 1) {
        return settledDetail("bars at rest settle", settledContacts, settledCycles);
    }
    return beyond ? beyond : "no motion with one contact in a period: computed, not proved";
}

}  // namespace signorini::answers
