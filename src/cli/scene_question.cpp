#include <fmt/format.h>

#include <algorithm>

#include "progress.hpp"
#include "scene_find.hpp"
#include "scene_harmonic_answer.hpp"
#include "scene_question_answer.hpp"
#include "scene_report.hpp"

namespace signorini::cli {

namespace {

using answers::SceneFindAnswer;
using answers::SceneQuestionAnswer;

std::string asText(const SceneQuestionAnswer& answer)
{
    std::string text = fmt::format(
        "{:<12}{} of {} schedules with one contact in {} steps have motions, {} proved to have "
        "none, {} undecided\n",
        name(answer.status()), answer.motions.size(), answer.sets.size(),
        stepsOf(answer.period.spans), answer.count(Status::none), answer.count(Status::undecided));
    text += limitText(answer.period.strainLimit);
    text += fmt::format("period      {:.6g} s, {:.6g} Hz{}\n", answer.period.period(),
                        1.0 / answer.period.period(), answer.question().nearest());
    for (const SceneFindAnswer& motion : answer.motions) {
        text += fmt::format("motion      {}, {}{}\n", textOf(motion.schedule.spans),
                            inWords(motion.schedule, motion.motions.energy),
                            motion.presses() ? "" : ", grazing: nothing presses") +
                cli::asText(*motion.strains()) + cli::asText(motion.stability);
    }
    const auto open = std::find_if(answer.sets.begin(), answer.sets.end(),
                                   [](const answers::SceneSet& set) { return set.detail; });
    if (open != answer.sets.end()) {
        text += fmt::format("why         contact {} for {} steps: {}\n", open->contact + 1,
                            open->steps, *open->detail);
    }
    return text;
}

}  // namespace

ExitStatus findPeriodInBars(const FindCommand& call, const Assembly& assembly)
{
    for (const char* option : {"--certificate", "--formulation", "--tip-floor"}) {
        refuseIf(
            call.given.has(option),
            fmt::format("{}: allowed of a period only with one bar of equal segments", option));
    }
    requireOfBars(call, assembly);
    FindOutputs files(call);
    const answers::BarsAsked bars(call.given, assembly);
    const SceneQuestionAnswer answer =
        watched(call.common, "deciding schedules",
                answers::periodAsked(call.given, bars, wavesIn(call.given)));
    if (answer.motions.empty()) {
        files.lackMotion();
    } else {
        files.writeBars(assembly, bars.network, *answer.motions.front().motions.motion);
    }
    call.common.useOneThread();
    for (const SceneFindAnswer& motion : answer.motions) {
        warnOf(*motion.strains(), call);
    }
    report(call.common, answer, assembly, asText(answer));
    return exitStatusOf(answer.status());
}

}  // namespace signorini::cli
