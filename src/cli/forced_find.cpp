
#include "find_command.hpp"
#include "progress.hpp"
#include "reports.hpp"
#include "stepped_bar.hpp"

namespace signorini::cli {

namespace {

/// The motion of the largest impulse, or the proof that there is none.
void writeFiles(FindOutputs& files, const answers::ForcedAnswer& answer)
{
    if (answer.motions.empty()) {
        files.lackMotion();
    } else {
        const ForcedMotion& last = answer.motions.back().value;
        files.writeMotion({last.state, answer.scene, answer.bar, last.schedule,
                           [&] { return answers::fieldOf(last, answer.scene.segments); },
                           [&] { return motionFigure(last, answer.scene); }, last.damping,
                           last.excitation});
    }
    if (answer.status() == Status::none) {
        files.writeProof([&](TextFile& file) { file.write(asLine(wholeJsonOf(answer))); });
    } else {
        files.lackProof();
    }
}

ExitStatus finish(const FindCommand& call, const auto& answer)
{
    report(call.common, answer, {}, call.force.ratio);
    for (const auto& motion : answer.motions) {
        call.warn(motion.physical());
    }
    return exitStatusOf(answer.status());
}

}  // namespace

ExitStatus answerHarmonic(const FindCommand& call)
{
    const CommonOptions& common = call.common;
    const ForceOptions& force = call.force;
    const Scene scene = common.scene();
    force.requireDamping();
    force.requirePlace();
    if (*force.ratio == 0.0) {
        refuse("--damping", "0", fmt::format("numbers > 0, at most {} [-]", maxDampingRatio));
    }
    force.requireAmplitude();
    if (!isUniform(scene.segments)) {
        return findHarmonicInBars(call,
                                  answers::assemblyOf(scene, common.usualCells(), force.damping()));
    }
    FindOutputs files(call);
    const auto question = answers::harmonicAsked(call.given, scene, common.usualCells());
    const answers::HarmonicAnswer answer = watched(common, "finding motions", question);
    if (answer.motions.empty()) {
        files.lackMotion();
    } else if (files.areOfMotion()) {
        const HarmonicField field(answer.given(), answer.motions.back().value);
        files.writeHarmonic(field, scene, common.usualCells());
    }
    return finish(call, answer);
}

ExitStatus answerForced(const FindCommand& call, const Schedule& schedule)
{
    const CommonOptions& common = call.common;
    const auto question = answers::forcedAsked(call.given, common.scene(), schedule);
    FindOutputs files(call);
    const answers::ForcedAnswer answer = watched(common, "finding motions", question);
    writeFiles(files, answer);
    return finish(call, answer);
}

}  // namespace signorini::cli
