#include <fmt/format.h>

#include <cmath>

#include "progress.hpp"
#include "scene_find.hpp"
#include "scene_forced_answer.hpp"

namespace signorini::cli {

namespace {

std::string asText(const answers::SceneForcedAnswer& answer, const SceneFind& of)
{
    const bool isForce = answer.forcing.place == Excited::tip;
    const char* unit = isForce ? "N" : "m";
    std::string text = of.lines(answer.status());
    text += fmt::format("excitation  {}, {:.6g} Hz\n",
                        isForce ? "force on what is driven" : "displacement of the base",
                        answer.frequency());
    text += limitText(answer.schedule.strainLimit);
    if (answer.range) {
        const auto [least, most] = *answer.range;
        text += fmt::format("amplitudes  {:.6g} {} to {}\n", least, unit,
                            std::isfinite(most) ? fmt::format("{:.6g} {}", most, unit) : "any");
    }
    for (const answers::SceneForcedMotion& one : answer.motions) {
        text += fmt::format("motion      amplitude {:.6g} {}, phase {:.6g}\n", one.amplitude, unit,
                            one.phase);
        text += cli::asText(one.contacts) + cli::asText(one.physical.strains);
        text += fmt::format("residual    {:.2g}\n{}", one.residuals.worst(),
                            cli::asText(one.stability));
    }
    if (answer.status() == Status::none) {
        text += fmt::format(
            "proof       none of {} amplitude; verified by stepping backwards in time\n",
            answer.cuts->isOfAmplitude ? "this" : "any");
    } else if (answer.status() == Status::undecided) {
        text += fmt::format("why         {}\n", answer.detail);
    }
    return text;
}

}  // namespace

ExitStatus findForcedInScene(const FindCommand& command)
{
    command.common.requireOwnDamping();
    command.force.requirePlace();
    SceneFind scene(command);
    const answers::SceneForcedAnswer answer =
        watched(command.common, "finding motions", answers::forcedAsked(command.given, scene.bars));
    for (const answers::SceneForcedMotion& one : answer.motions) {
        warnOf(one.physical.strains, command);
    }
    const NetworkClaim* last = answer.motions.empty() ? nullptr : &answer.motions.back().claim;
    return scene.finish(answer, last, answer.status() == Status::none, asText(answer, scene));
}

}  // namespace signorini::cli
