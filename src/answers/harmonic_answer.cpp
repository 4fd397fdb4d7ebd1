#include "harmonic_answer.hpp"

#include <fmt/format.h>

#include "exact_response.hpp"
#include "harmonic_contact.hpp"
#include "harmonic_settled.hpp"

namespace signorini::answers {

Question<HarmonicAnswer> harmonicAsked(const Call& call, const Scene& scene, std::int64_t cells)
{
    const ForceOptions force(call);
    const std::int64_t cycles = call.whole("--cycles").value_or(1);
    const auto [option, word] = call.period();
    const ExactPeriod period = periodExactly(option, word, cells, scene.bar, cycles);
    force.requirePlace();
    force.requireAmplitude();
    const double frequencyRatio = 4.0 * static_cast<double>(cycles) / period.value();
    const ForceOptions displaced = force.at(frequencyRatio * firstHertz(scene.bar));
    (void)displaced.scaledAmplitude(scene.bar);
    AskedPeriod asked = askedAs(option, word);
    asked.isRounded = asked.option == "hertz";
    return [=, contacts = call.whole("--contacts").value_or(1),
            limit = call.number("--strain-limit")](const Watch& watch) {
        HarmonicAnswer answer = answerOf(period, force.damping(), *force.place, cycles,
                                         *displaced.amplitude, scene, contacts, watch.cancel);
        answer.asked = asked;
        return within(limit, std::move(answer));
    };
}

HarmonicAnswer answerOf(const ExactPeriod& period, const Damping& damping, Excited place,
                        std::int64_t cycles, double amplitude, const Scene& scene,
                        std::int64_t contacts, const Cancel& cancel)
{
    HarmonicAnswer answer{period, damping,        place,    cycles, amplitude,
                          scene,  unitsOf(scene), contacts, {}};
    const auto add = [&](const HarmonicCase& given, HarmonicMotion motion) {
        const ExactStability stability = exactStability(given, motion);
        const HarmonicProof proof = enclosed(given, motion);
        answer.motions.push_back(
            {std::move(motion), answer.bar, stability.growth, proof, stability.attracts});
    };
    const HarmonicCase given = answer.given();
    if (contacts == 1) {
        for (HarmonicMotion& motion : harmonicContacts(given)) {
            add(given, std::move(motion));
        }
        std::vector<ProvedHarmonic> known;
        for (const HarmonicMotionOf& motion : answer.motions) {
            known.push_back({&motion.value, motion.proof.aloneWithin});
        }
        answer.all = complete(given, known, cancel);
        return answer;
    }
    SettlingSearch search;
    search.mostCycles = std::max(search.mostCycles, cycles);
    search.cancel = cancel;
    if (auto settled = settledHarmonic(damping, answer.excitation(), stopsOf(scene), search)) {
        const auto found = static_cast<std::int64_t>(settled->motion.contacts.size());
        answer.settledContacts = found;
        answer.settledCycles = settled->given.cycles;
        if (found == contacts && settled->given.cycles == cycles) {
            add(settled->given, std::move(settled->motion));
        }
    }
    return answer;
}

std::string settledDetail(std::string_view who, std::int64_t contacts, std::int64_t cycles)
{
    return contacts > 0 ? fmt::format("{} on {} contact{} in {} cycle{}", who, contacts,
                                      contacts == 1 ? "" : "s", cycles, cycles == 1 ? "" : "s")
                        : fmt::format("{} on no contacts that repeat, as far as followed", who);
}

std::optional<std::string> HarmonicLimit::detail() const
{
    return beyond > 0 ? std::optional(fmt::format(
                            "{} motion{} not stay within the limit on strain: computed, not proved",
                            beyond, beyond == 1 ? " does" : "s do"))
                      : std::nullopt;
}

Harmonic HarmonicAnswer::excitation() const
{
    return {place,
            amplitude / amplitudeUnit(place, bar),
            0.0,
            cycles,
            period.numerator,
            static_cast<double>(period.denominator)};
}

HarmonicCase HarmonicAnswer::given() const
{
    return harmonicCase(damping, excitation(), stopsOf(scene));
}

QuestionPart HarmonicAnswer::question() const
{
    return {asked, period.value() * scales(bar).time, period.value(),
            frequencyRatio() * firstHertz(bar), frequencyRatio()};
}

std::optional<double> HarmonicAnswer::completeFrom() const
{
    return all.flight ? std::optional(*all.flight * scales(bar).time) : std::nullopt;
}

std::optional<std::string> HarmonicAnswer::detail() const
{
    if (status() != Status::undecided) {
        return std::nullopt;
    }
    if (limit.beyond > 0) {
        return limit.detail();
    }
    if (contacts > 1) {
        return settledDetail("a bar at rest settles", settledContacts, settledCycles);
    }
    const double flight = all.flight.value_or(given().step) * scales(bar).time;
    return fmt::format(
        "no motion with one contact in a period flies for {:.6g} s or more: {}", flight,
        all.flight ? "proved by interval arithmetic, but there may be shorter flights"
                   : fmt::format("computed, not proved ({})", all.why));
}

}  // namespace signorini::answers
