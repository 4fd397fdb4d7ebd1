#include "scene_find_answer.hpp"

#include <algorithm>

#include "forced_case.hpp"

namespace signorini::answers {

SceneStability stabilityIn(const Network& network, const NetworkClaim& motion, const Cancel& cancel)
{
    StabilityOptions options;
    options.cancel = cancel;
    return {options.periods, stabilityOf(network, motion, options)};
}

SceneSchedule scheduleOf(const Assembly& assembly, const Network& network,
                         const std::vector<ContactSpan>& spans)
{
    return {severalOf(assembly, network),
            spans,
            network.scales,
            network.cells(),
            firstEnergy(network),
            strainLimitOf(network, assembly)};
}

std::optional<double> SceneSchedule::frequencyRatio() const
{
    const double first = firstHertz(bars.reference);
    return first > 0.0 ? std::optional(static_cast<double>(cycles) / (period() * first))
                       : std::nullopt;
}

std::vector<ContactInPeriod> contactsOf(const SceneSchedule& schedule,
                                        const NetworkResiduals* residuals)
{
    const NetworkScales& scales = schedule.scales;
    std::vector<ContactInPeriod> all;
    for (const SceneContact& contact : schedule.bars.contacts) {
        const std::size_t j = all.size();
        ContactInPeriod& one = all.emplace_back(ContactInPeriod{contact});
        if (residuals == nullptr) {
            continue;
        }
        double steps = 0.0;
        for (const ContactSpan& span : schedule.spans) {
            steps += contains(span.closed, j) ? static_cast<double>(span.steps) : 0.0;
        }
        one.speed = residuals->extremes.contacts[j].approach * scales.velocity();
        one.peakForce = residuals->peakForces[j] * scales.force();
        one.impulse = std::max(0.0, residuals->impulses[j]) * scales.force() * scales.time;
        one.time = scales.time * steps;
    }
    return all;
}

double strainUnit(const Assembly& assembly, const NetworkScales& scales)
{
    return scales.displacement / (scales.time * assembly.waveSpeed);
}

std::optional<double> strainLimitOf(const Network& network, const Assembly& assembly)
{
    return known(network.strainLimit * strainUnit(assembly, network.scales));
}

SceneStrains strainsOf(const Assembly& assembly, const NetworkScales& scales, double least,
                       double most)
{
    const double unit = strainUnit(assembly, scales);
    SceneStrains strains{0.0 - least * unit, 0.0 + most * unit};  // no -0
    if (const auto modulus = modulusOf(assembly)) {
        strains.stress = *modulus * strains.largest();
    }
    return strains;
}

ScenePhysical physicalOf(const SceneSchedule& schedule, const NetworkResiduals& residuals)
{
    ScenePhysical all;
    all.frequency = 1.0 / schedule.period();
    for (const ContactInPeriod& one : contactsOf(schedule, &residuals)) {
        all.contactTime += *one.impulse > 0.0 ? *one.time : 0.0;
        all.peakForce = std::max(all.peakForce, *one.peakForce);
        all.impulse += *one.impulse;
        all.approachSpeed = std::max(all.approachSpeed, *one.speed);
    }
    all.strains = strainsOf(schedule.bars.assembly, schedule.scales, residuals);
    return all;
}

const NetworkClaim& SceneFindAnswer::claim(std::size_t) const
{
    refuseIf(!isFound(), "no motion was found: there is nothing to draw or write");
    return *motions.motion;
}

std::optional<double> SceneFindAnswer::provedCompression() const
{
    const auto& proved = motions.provedStrain;
    return proved ? std::optional(*proved * strainUnit(schedule.bars.assembly, schedule.scales))
                  : std::nullopt;
}

SceneFloor floorOf(const SceneSchedule& schedule, const LeastMotion& known)
{
    return {known.multipliers, schedule.joules(known.provedEnergy),
            schedule.ratio(known.provedEnergy), schedule.strainLimit};
}

std::optional<SceneFloor> SceneFindAnswer::certificate() const
{
    if (!isProof() || motions.provedEnergy == 0.0) {
        return std::nullopt;
    }
    return floorOf(schedule, motions);
}

BarsAsked::BarsAsked(const Call& call, Assembly ofBars)
    : assembly(std::move(ofBars)), network(networkOf(assembly))
{
    if (const auto limit = call.number("--strain-limit")) {
        network.strainLimit = *limit / strainUnit(assembly, network.scales);
    }
}

SearchInBars::SearchInBars(const Call& call, const BarsAsked& bars, const WavesOf& wavesOf)
    : options(searchAsked(call)),
      wish{options.objective, energyAsked(call, bars.network), wavesOf("--target", bars)}
{
}

SceneFindAnswer SearchInBars::of(const BarsAsked& bars, const std::vector<ContactSpan>& spans,
                                 const Cancel& cancel) const
{
    const double most = hugeEnergyRatio * usualEnergy(bars.network, spans);
    return {scheduleOf(bars.assembly, bars.network, spans), wish.isOfLeast(),
            wishedMotion(bars.network, spans, most, wish, Watch{cancel}.on(options))};
}

Question<SceneFindAnswer> motionAsked(const Call& call, const BarsAsked& bars,
                                      const WavesOf& wavesOf)
{
    const SearchInBars search(call, bars, wavesOf);
    return tried<SceneFindAnswer>(call, stepsOf(bars.spans), [=](const Watch& watch) {
        return search.of(bars, bars.spans, watch.cancel);
    });
}

void tryStability(SceneFindAnswer& answer, const Cancel& cancel)
{
    const auto& motion = answer.motions.motion;
    if (motion && answer.motions.energy > 0.0) {
        answer.stability = stabilityIn(answer.schedule.network(), *motion, cancel);
    }
}

}  // namespace signorini::answers
