#include <fmt/format.h>

#include "contact_spans.hpp"
#include "find_command.hpp"
#include "progress.hpp"
#include "reports.hpp"
#include "scene_find.hpp"
#include "scene_harmonic_answer.hpp"
#include "scene_report.hpp"

namespace signorini::cli {

namespace {

std::string asText(const answers::SceneHarmonicAnswer& answer)
{
    std::string text = fmt::format(
        "{:<12}{} in {} steps, {}{} of amplitude {:.6g} {}\n", name(answer.status()),
        answer.contacts == 1 ? "one contact" : fmt::format("{} contacts", answer.contacts),
        answer.steps, answer.place == Excited::tip ? "force on what is driven" : "moving base",
        answer.cycles == 1 ? "" : fmt::format(", {} cycles", answer.cycles), answer.amplitude,
        answer.place == Excited::tip ? "N" : "m");
    text += fmt::format("frequency   {:.6g} Hz", answer.frequency());
    if (const auto ratio = answer.frequencyRatio()) {
        text += fmt::format(", {:.6g} ω₁", *ratio);
    }
    text += answer.question().nearest() + "\n";
    for (const answers::SceneHarmonicMotion& motion : answer.motions) {
        const NetworkHarmonicMotion& value = motion.value;
        const NetworkScales& scales = motion.scales;
        for (const NetworkHarmonicContact& one : value.contacts) {
            text += fmt::format("{:<12}contact {} for {:.6g} s{}, ended {}{}",
                                &one == &value.first() ? "motion" : "", one.contact + 1,
                                (one.end - one.begin) * scales.time,
                                value.contacts.size() == 1
                                    ? ""
                                    : fmt::format(" from {:.6g} s", one.begin * scales.time),
                                one.isPinned ? "by a wave front" : "smoothly",
                                &one == &value.contacts.back() ? "; " : "\n");
        }
        text += fmt::format("phase {:.6g} rad, residual {:.2g}\n", value.phase, value.residual);
        text += fmt::format("force       at most {:.6g} N, impulse {:.6g} N s; met at {:.6g} m/s\n",
                            value.peakForce * scales.force(),
                            value.impulse * scales.force() * scales.time,
                            value.speed * scales.velocity());
        text += cli::asText(motion.strains) + growthText(value.growth, motion.attracts());
    }
    text += limitText(answer.limit);
    if (const auto detail = answer.detail()) {
        text += fmt::format("why         {}\n", *detail);
    }
    return text;
}

}  // namespace

ExitStatus findHarmonicInBars(const FindCommand& call, const Assembly& assembly)
{
    refuseIf(call.given.has("--certificate"), "--certificate", call.given.text("--certificate"),
             "none with --period, --frequency and --hertz of several bars or segments");
    requireOfBars(call, assembly);
    FindOutputs files(call);
    const auto question = answers::harmonicAsked(call.given, assembly);
    const answers::SceneHarmonicAnswer answer = watched(call.common, "finding motions", question);
    if (answer.motions.empty()) {
        files.lackMotion();
    } else {  // the last one has the largest impulse
        files.writeHarmonic(answer);
    }
    for (const answers::SceneHarmonicMotion& motion : answer.motions) {
        warnOf(motion.strains, call);
    }
    call.common.useOneThread();
    report(call.common, answer, assembly, asText(answer));
    return exitStatusOf(answer.status());
}

}  // namespace signorini::cli
