#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "find_command.hpp"
#include "network_forced.hpp"

namespace signorini::cli {

namespace {

/// A motion and what is seen of it.
struct Seen {
    ForcedMotion motion;
    NetworkClaim claim;
    NetworkResiduals residuals;
};

struct SceneForcedAnswer {
    const SceneFind& of;
    ForcedSet set = {};
    std::optional<double> amplitude = {};  ///< as asked, a displacement of the base [N or m]
    std::optional<AmplitudeExclusion> exclusion = {};
    std::vector<Seen> motions = {};

    /// [N] or [m] of an amplitude of 1.
    [[nodiscard]] double unit() const
    {
        return set.forcing.place == Excited::tip ? of.network.scales.force()
                                                 : of.network.scales.displacement;
    }
    [[nodiscard]] const char* unitName() const
    {
        return set.forcing.place == Excited::tip ? "N" : "m";
    }
    [[nodiscard]] double hertz() const
    {
        return static_cast<double>(set.forcing.cycles) / of.period();
    }
    [[nodiscard]] Status status() const
    {
        if (set.status != Status::found || !motions.empty()) {
            return set.status;
        }
        return exclusion && exclusion->isCertain ? Status::none : Status::undecided;
    }
    [[nodiscard]] std::string detail() const
    {
        return set.status == Status::found && status() == Status::undecided
                   ? "conditions exclude this amplitude by no more than rounding can do"
                   : set.detail;
    }
};

Json certificateAsJson(const SceneForcedAnswer& answer)
{
    if (answer.status() != Status::none) {
        return nullptr;
    }
    Json cuts = Json::array();
    for (const EnergyFloor& cut : answer.exclusion ? answer.exclusion->cuts : answer.set.cuts) {
        cuts.push_back(multipliersAsJson(cut));
    }
    return {{"kind", answer.exclusion ? "amplitude-range" : "forced"},
            {"verified", true},
            {"rows", "network"},
            {"cuts", std::move(cuts)}};
}

Json asJson(const SceneForcedAnswer& answer)
{
    const bool isFound = answer.set.status == Status::found;
    Json motions = Json::array();
    for (const Seen& one : answer.motions) {
        Json contacts = jsonOf(contactsOf(answer.of.network, answer.of.assembly.length));
        addForces(contacts, answer.of.network, answer.of.schedule, one.residuals);
        motions.push_back({{"amplitude", one.motion.amplitude * answer.unit()},
                           {"phase", one.motion.phase},
                           {"contacts", std::move(contacts)},
                           {"residual", one.residuals.worst()}});
    }
    const double most = answer.set.mostAmplitude * answer.unit();
    Json json = answer.of.keys(answer.status());
    json.update(Json{{"force", answer.set.forcing.place == Excited::tip ? "tip" : "base"},
                     {"cycles", answer.set.forcing.cycles},
                     {"frequency", answer.hertz()},
                     {"amplitude", answer.amplitude ? Json(*answer.amplitude) : Json()},
                     {"kind", name(answer.set.kind)},
                     {"free_waves", answer.set.freeWaves},
                     {"amplitude_range", isFound ? Json{answer.set.leastAmplitude * answer.unit(),
                                                        std::isfinite(most) ? Json(most) : Json()}
                                                 : Json()},
                     {"contacts", jsonOf(contactsOf(answer.of.network, answer.of.assembly.length))},
                     {"motions", std::move(motions)},
                     {"certificate", certificateAsJson(answer)},
                     {"detail", answer.detail()}});
    return json;
}

std::string asText(const SceneForcedAnswer& answer)
{
    std::string text = answer.of.lines(answer.status());
    text += fmt::format("excitation  {}, {:.6g} Hz\n",
                        answer.set.forcing.place == Excited::tip ? "force on what is driven"
                                                                 : "displacement of the base",
                        answer.hertz());
    if (answer.set.status == Status::found) {
        const double most = answer.set.mostAmplitude * answer.unit();
        text += fmt::format(
            "amplitudes  {:.6g} {} to {}\n", answer.set.leastAmplitude * answer.unit(),
            answer.unitName(),
            std::isfinite(most) ? fmt::format("{:.6g} {}", most, answer.unitName()) : "any");
    }
    for (const Seen& one : answer.motions) {
        text +=
            fmt::format("motion      amplitude {:.6g} {}, phase {:.6g}\n",
                        one.motion.amplitude * answer.unit(), answer.unitName(), one.motion.phase);
        text += forcesAsText(answer.of.network, one.residuals);
        text += fmt::format("residual    {:.2g}\n", one.residuals.worst());
    }
    if (answer.status() == Status::none) {
        text += fmt::format(
            "proof       none of {} amplitude; verified by stepping backwards in time\n",
            answer.exclusion ? "this" : "any");
    } else if (answer.status() == Status::undecided) {
        text += fmt::format("why         {}\n", answer.detail());
    }
    return text;
}

/// The least amplitude, or those of the one that is asked for.
void choose(SceneForcedAnswer& answer)
{
    if (answer.set.status != Status::found) {
        return;
    }
    std::vector<ForcedMotion> motions;
    if (answer.amplitude) {
        const double amplitude = *answer.amplitude / answer.unit();
        motions = motionsOfAmplitude(answer.set, amplitude);
        if (motions.empty()) {
            answer.exclusion = exclusionOf(answer.set, amplitude);
        }
    } else {
        motions.push_back(leastAmplitudeMotion(answer.set));
    }
    for (ForcedMotion& motion : motions) {
        NetworkClaim claim = claimOf(answer.set, motion);
        NetworkResiduals residuals = walk(answer.of.network, claim);
        answer.motions.push_back({std::move(motion), std::move(claim), std::move(residuals)});
    }
}

}  // namespace

ExitStatus findForcedInScene(const FindCommand& command)
{
    const ForceOptions& force = command.force;
    refuseIf(force.ratio.has_value(),
             "--damping clashes with --scene: allowed dash=D among its words");
    force.requirePlace();
    SceneFind scene(command);
    const Forcing forcing{*force.place, command.cycles, {}};
    SceneForcedAnswer answer{scene};
    if (force.amplitude) {
        const double first = referenceOf(scene.network).frequency / (2.0 * std::numbers::pi);
        const double hertz = static_cast<double>(forcing.cycles) / scene.period();
        answer.amplitude = first > 0.0 ? force.at(hertz / first, first).amplitude : force.amplitude;
    }
    answer.set = forcedScene(scene.network, scene.schedule, forcing,
                             usualEnergy(scene.network, scene.schedule));
    choose(answer);
    const NetworkClaim* last = answer.motions.empty() ? nullptr : &answer.motions.back().claim;
    return scene.finish(answer.status(), last, answer.status() == Status::none, asJson(answer),
                        asText(answer));
}

}  // namespace signorini::cli
