#include "scene_forced_answer.hpp"

namespace signorini::answers {

void tryStability(SceneForcedAnswer& answer, const Cancel& cancel)
{
    const Network network = answer.schedule.network();
    for (SceneForcedMotion& motion : answer.motions) {
        motion.stability = stabilityIn(network, motion.claim, cancel);
    }
}

namespace {

/// Of an amplitude if it is given, a displacement of the base.
SceneForcedAnswer forcedOf(const BarsAsked& bars, const Forcing& forcing,
                           std::optional<double> amplitude)
{
    const auto& [assembly, network, schedule] = bars;
    const ForcedSet set = forcedScene(network, schedule, forcing, usualEnergy(network, schedule));
    const double unit =
        forcing.place == Excited::tip ? network.scales.force() : network.scales.displacement;
    SceneForcedAnswer answer{.schedule = scheduleOf(assembly, network, schedule),
                             .forcing = forcing,
                             .asked = amplitude,
                             .kind = set.kind,
                             .freeWaves = set.freeWaves,
                             .range = {},
                             .decided = set.status,
                             .detail = set.detail,
                             .cuts = {},
                             .motions = {}};
    answer.schedule.cycles = forcing.cycles;
    if (set.status == Status::none) {
        answer.cuts = SceneCuts{false, set.cuts};
    }
    if (set.status != Status::found) {
        return answer;
    }
    answer.range = {set.leastAmplitude * unit, set.mostAmplitude * unit};
    const std::vector<ForcedMotion> motions =
        amplitude ? motionsOfAmplitude(set, *amplitude / unit)
                  : std::vector<ForcedMotion>{leastAmplitudeMotion(set)};
    for (const ForcedMotion& motion : motions) {
        if (!(motion.residual <= forcedTolerance)) {  // large programs can leave as much
            answer.decided = Status::undecided;
            answer.detail = doubtOf(motion.residual);
            continue;
        }
        NetworkClaim claim = claimOf(set, motion);
        NetworkResiduals residuals = walk(network, claim);
        auto contacts = contactsOf(answer.schedule, &residuals);
        const ScenePhysical physical = physicalOf(answer.schedule, residuals);
        answer.motions.push_back({motion.amplitude * unit, motion.phase, std::move(claim),
                                  std::move(residuals), std::move(contacts), physical});
    }
    if (motions.empty()) {
        const AmplitudeExclusion exclusion = exclusionOf(set, *amplitude / unit);
        answer.decided = exclusion.isCertain ? Status::none : Status::undecided;
        if (exclusion.isCertain) {
            answer.cuts = SceneCuts{true, exclusion.cuts};
        } else {
            answer.detail = "conditions exclude this amplitude by no more than rounding can do";
        }
    }
    return answer;
}

}  // namespace

Question<SceneForcedAnswer> forcedAsked(const Call& call, const BarsAsked& bars)
{
    const ForceOptions force(call);
    force.requirePlace();
    const Forcing forcing{*force.place, call.whole("--cycles").value_or(1), {}};
    return tried<SceneForcedAnswer>(call, stepsOf(bars.spans), [=](const Watch&) {
        const double hertz =
            static_cast<double>(forcing.cycles) / periodOf(bars.network, bars.spans);
        return forcedOf(bars, forcing, force.at(hertz).amplitude);
    });
}

}  // namespace signorini::answers
