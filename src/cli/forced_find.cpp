
#include "find_command.hpp"
#include "interrupt.hpp"
#include "reports.hpp"
#include "stepped_bar.hpp"
#include "stops.hpp"

namespace signorini::cli {

namespace {

void requireForce(const ForceOptions& force)
{
    if (!force.ratio) {
        refuse("--damping", "missing", fmt::format("numbers 0..{} [-]", maxDampingRatio));
    }
    force.requirePlace();
}

void validate(const FindCommand& call, const Schedule& schedule)
{
    requireForce(call.force);
    if (canRest(schedule.phases, schedule.stops) && !call.force.amplitude) {
        refuse("--amplitude", "missing",
               "numbers > 0 [N or m]: without a gap motions are as small as one likes");
    }
}

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
    requireForce(force);
    if (*force.ratio == 0.0) {
        refuse("--damping", "0", fmt::format("numbers > 0, at most {} [-]", maxDampingRatio));
    }
    force.requireAmplitude();
    if (!isUniform(scene.segments)) {
        return findHarmonicInBars(call,
                                  answers::assemblyOf(scene, common.usualCells(), force.damping()));
    }
    FindOutputs files(call);
    const auto [option, word] = call.period();
    const ExactPeriod period =
        answers::periodExactly(option, word, common.usualCells(), scene.bar, call.cycles);
    const double frequencyRatio = 4.0 * static_cast<double>(call.cycles) / period.value();
    const ForceOptions displaced = force.at(frequencyRatio * firstHertz(scene.bar));
    (void)displaced.scaledAmplitude(scene.bar);
    const Interrupt interrupt;
    const answers::HarmonicAnswer answer = answers::within(
        call.given.number("--strain-limit"),
        answers::answerOf(period, force.damping(), *force.place, call.cycles, *displaced.amplitude,
                          scene, call.given.whole("--contacts").value_or(1), interrupt.cancel()));
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
    const Scene scene = common.scene();
    validate(call, schedule);
    call.requireTried(steps(schedule));
    const ForceOptions& force = call.force;
    FindOutputs files(call);
    const ForcedLimits limits{call.options.strainLimit / scales(firstMaterial(scene)).strain};
    const Forcing forcing{*force.place, call.cycles};
    answers::ForcedAnswer answer =
        answers::answerOf(forcedMotions(schedule, force.damping(), forcing, limits, scene.segments),
                          scene, force.amplitude, force.derivative);
    call.tryIfAsked(answer);
    writeFiles(files, answer);
    return finish(call, answer);
}

}  // namespace signorini::cli
