#include "find_command.hpp"

#include <array>
#include <optional>
#include <span>
#include <utility>

#include "certificate_report.hpp"
#include "demand_names.hpp"
#include "faults.hpp"
#include "files.hpp"
#include "find_outputs.hpp"
#include "forced_find.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "report.hpp"
#include "scene_find.hpp"
#include "scene_options.hpp"
#include "signorini/figures.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/motion.hpp"
#include "signorini/output.hpp"
#include "stepped_bar.hpp"

namespace signorini::cli {

/// The options with what needs several of them, and how the target was read.
struct FindRequest {
    FindOptions options;
    std::string reading;
};

namespace {

FindRequest completed(const FindCommand& call)
{
    FindRequest request{call.options, {}};
    FindOptions& options = request.options;
    options.scene = call.common.scene();
    if (call.energy) {
        if (options.energyRatio) {
            throw std::invalid_argument(
                "--energy clashes with --energy-ratio: allowed one of them");
        }
        options.energyRatio = *call.energy / scales(firstMaterial(options.scene)).energy;
    }
    options.strainLimit /= scales(options.scene.bar).strain;
    if (std::isfinite(options.tipFloor) && !(options.tipFloor < options.scene.bar.gap)) {
        refuse("--tip-floor", fmt::format("{}", options.tipFloor), "below the gap [m]");
    }
    options.tipFloor /= scales(options.scene.bar).displacement;
    if (options.objective == Objective::nearest && call.targetFile.empty()) {
        throw std::invalid_argument("--target is missing: --objective nearest needs a state file");
    }
    if (!call.targetFile.empty()) {
        if (options.objective != Objective::nearest) {
            throw std::invalid_argument("--target clashes with --objective: allowed only nearest");
        }
        StateReading read = forFile("--target", call.targetFile, [&] {
            return readState(call.targetFile, options.scene.bar, call.common.usualCells());
        });
        options.target = std::move(read.state);
        request.reading = std::move(read.how);
    }
    return request;
}

/// findPeriodic, with signals listened to and a line on a terminal.
answers::FindAnswer search(const Schedule& schedule, const FindRequest& request, bool isQuiet)
{
    const Interrupt interrupt;
    const Progress progress(!isQuiet, "finding a motion");
    FindOptions options = request.options;
    options.cancel = interrupt.cancel();
    PeriodicResult result = findPeriodic(schedule, options);
    if (result.status == Status::undecided && isRequested(options.cancel) && !isQuiet) {
        tell("signorini find: interrupted\n");
    }
    return answers::answerOf(std::move(result), options, request.reading);
}

constexpr std::int64_t maxStableSteps = 1'000'000;

/// What becomes of a free motion beside it: as it is, and with a little damping.
std::vector<answers::StabilityReport> stabilityReports(const FoundMotion& motion,
                                                       const Schedule& schedule, const Bar& bar)
{
    const Interrupt interrupt;
    std::vector<answers::StabilityReport> reports;
    for (const double ratio : {0.0, 0.001}) {
        answers::StabilityReport report{{ratio}, {}, {}, bar};
        report.options.cancel = interrupt.cancel();
        report.result = stabilityOf(motion.state, schedule, report.damping, report.options);
        reports.push_back(std::move(report));
    }
    return reports;
}

Motion fieldOf(const PeriodicResult& result)
{
    const std::vector<Segment>& segments = result.scene.segments;
    return isUniform(segments) ? Motion(result.motion->state, result.schedule)
                               : Motion(result.motion->state, result.schedule, segments);
}

/// A motion, or the proof that there is none.
void writeFiles(FindOutputs& files, const FindOptions& options, const PeriodicResult& result,
                const Json& answer)
{
    if (result.motion) {
        files.writeMotion({result.motion->state, result.scene, result.scene.bar,
                           signorini::steps(result.schedule), [&] { return fieldOf(result); },
                           [&](FigureFormat format, const std::string& path) {
                               drawFigure(motionFigure(result), format, path);
                           }});
    } else {
        files.lackMotion();
    }
    const auto energies = files.wantsProof() ? energyCertificate(result, options) : std::nullopt;
    if (!result.absence && !energies) {
        files.lackProof();
        return;
    }
    files.writeProof([&](TextFile& file) {
        // Of an answer with the certificate in place there is none to write.
        writeAnswer(claimOf(answer, energies), result,
                    [&](std::string_view text) { file.write(text); });
    });
}

}  // namespace

void FindCommand::addTo(CLI::App& command)
{
    addWords(
        command, "steps", "NC NF ...", steps,
        "contact and free steps of each phase; of a scene with several contacts SET:STEPS ..., "
        "SET those that are closed, as in 1+2:6 -:35");
    addWord(command, "--solver", "NAME", "a back end listed by signorini --version (auto)",
            [this](const std::string& text) { options.solver = text; });
    addName(command, "--formulation", std::span(formulationNames), options.formulation,
            "unknowns of the problem (auto)");
    addName(command, "--objective", std::span(objectiveNames).subspan(1), options.objective,
            "which motion of the set (least energy; at a given energy, least peak strain)");
    addFile(command, "--target", targetFile,
            "state to come nearest to: as --state writes it, or measured (columns x, velocity and "
            "strain or displacement); may be a pipe");
    question.addTo(command);
    forced.addTo(command);
    addPositive(command, "--energy-ratio", "E_1", options.energyRatio, "X",
                "hold E/E_1 = X: the motion of least peak compression");
    addPositive(command, "--energy", "J", energy, "J", "hold the energy, in joules");
    addPositive(command, "--strain-limit", "-", options.strainLimit, "S",
                "strain >= -S everywhere, always");
    addPositive(command, "--yield-stress", "Pa", yieldStress, "PA",
                "warn where the stress exceeds it (needs --young)");
    addWord(command, "--tip-floor", "M", "lowest displacement of the tip",
            [this](const std::string& text) {
                options.tipFloor = parseReal("--tip-floor", text, "m");
            });
    addPositive(command, "--tolerance", "-", options.tolerance, "X",
                "largest relative residual (1e-7)");
    addPositive(command, "--time-limit", "s", options.timeLimit, "S", "for the solver");
    addFile(command, "--state", stateFile, "write the state at t = 0");
    motionFile.addTo(command);
    addFigure(command, "--figure", figureFile, "draw the motion");
    addFlag(command, "--stability", wantsStability,
            "perturb the motion to test its stability, undamped and with a damping ratio of 0.001");
    addAnimation(command, animationFile);
    addFile(command, "--certificate", certificateFile,
            "write the proof that there is no motion, or of the least energy, for "
            "tools/check-certificate, or of a forced bar tools/check-forced",
            "FILE.json");
    common.addTo(command);
}

void FindCommand::warn(const Physical& physical) const
{
    if (common.quiet) {
        return;
    }
    warnUnlessAdmissible("find", physical);
    if (yieldStress && *physical.peakStress > *yieldStress) {
        tell(fmt::format(
            "signorini find: the stress reaches {:.6g} Pa, beyond --yield-stress {:.6g} "
            "Pa\n",
            *physical.peakStress, *yieldStress));
    }
}

/// Forced motions are chosen by amplitude alone, within a limit on strain; those of a scene that is
/// no bar by their energy, and nothing but their states is written.
const char* FindCommand::otherDemand(bool isScene) const
{
    const FindOptions usual;
    const std::array<std::pair<const char*, bool>, 15> others{{
        {"--period, --frequency, --hertz", isScene && question.isAsked()},
        {"--damping", isScene && forced.force.ratio},
        {"--strain-limit", isScene && std::isfinite(options.strainLimit)},
        {"--energy", energy.has_value()},
        {"--energy-ratio", options.energyRatio.has_value()},
        {"--objective", options.objective != usual.objective},
        {"--target", !targetFile.empty()},
        {"--solver", options.solver != usual.solver},
        {"--formulation", options.formulation != usual.formulation},
        {"--yield-stress", isScene && yieldStress.has_value()},
        {"--tip-floor", options.tipFloor != usual.tipFloor},
        {"--motion", isScene && motionFile.isWanted()},
        {"--figure", isScene && !figureFile.empty()},
        {"--animate", isScene && !animationFile.empty()},
        {"--stability", isScene && wantsStability},
    }};
    const auto* other =
        std::find_if(others.begin(), others.end(), [](const auto& one) { return one.second; });
    return other == others.end() ? nullptr : other->first;
}

ExitStatus FindCommand::run() const
{
    if (common.hasScene()) {
        const char* other = otherDemand(true);
        if (other == nullptr) {
            return findInScene(*this);
        }
        if (!barOf(common.assembly())) {
            throw std::invalid_argument(fmt::format(
                "{} clashes with --scene '{}': allowed of one bar, clamped on the left, "
                "with stops at its tip; of other scenes only motions of least energy and forced "
                "ones are known, their --state and --certificate",
                other, shortened(common.sceneText)));
        }
    }
    if (!forced.isAsked() && forced.cycles != 1) {
        throw std::invalid_argument("--cycles: allowed only together with --damping and --force");
    }
    if (question.isAsked() && (wantsStability || !certificateFile.empty())) {
        throw std::invalid_argument("--stability, --certificate: allowed only together with NC NF");
    }
    const Scene bar = common.scene();
    if (yieldStress && !bar.bar.young) {
        throw std::invalid_argument(
            "--yield-stress: allowed only with --young, --density and --area");
    }
    if (!haveOneSpeed(bar.segments) && FindOutputs(*this).areOfMotion()) {
        throw std::invalid_argument(
            "--state, --motion, --figure, --animate: allowed only for segments in which waves have "
            "one speed");
    }
    if (question.isAsked() && !steps.empty()) {
        throw std::invalid_argument(
            "NC NF clash with --period, --frequency and --hertz: allowed one of them");
    }
    if (question.isAsked() && !isUniform(bar.segments)) {
        throw std::invalid_argument("--segments: allowed only together with NC NF");
    }
    ExitStatus status = exitUndecided;
    if (forced.isAsked()) {
        if (const char* other = otherDemand(false)) {
            throw std::invalid_argument(
                fmt::format("{} clashes with --damping, --force and --amplitude: allowed with them "
                            "--cycles, --strain-limit, --yield-stress, --stability and files",
                            other));
        }
        status = question.isAsked()
                     ? answerHarmonic(*this)
                     : answerForced(*this, {common.usualCells(), parsePhases(steps), stopsOf(bar)});
    } else if (question.isAsked()) {
        const answers::AskedPeriod asked = question.on(common.usualCells(), bar.bar);
        status = answerQuestion(asked, completed(*this));
    } else {
        const Schedule schedule{common.usualCells(), parsePhases(steps), stopsOf(bar)};
        status = answerSchedule(schedule, completed(*this));
    }
    common.useOneThread("find");
    return status;
}

/// The simulation that stability is seen in knows one bar.
void FindCommand::requireStable(const Schedule& schedule) const
{
    if (wantsStability && !common.scene().segments.empty()) {
        throw std::invalid_argument("--stability: allowed without --segments");
    }
    if (wantsStability && signorini::steps(schedule) > maxStableSteps) {
        refuse("--stability", fmt::format("{} steps", signorini::steps(schedule)),
               fmt::format("periods of at most {} steps", maxStableSteps));
    }
}

ExitStatus FindCommand::answerSchedule(const Schedule& schedule, const FindRequest& request) const
{
    validate(schedule);
    requireStable(schedule);
    FindOutputs files(*this);
    answers::FindAnswer answer = search(schedule, request, common.quiet);
    const PeriodicResult& result = answer.result;
    writeFiles(files, request.options, result, wholeJsonOf(answer, "certificate"));
    if (wantsStability && result.motion) {
        answer.stability = stabilityReports(*result.motion, schedule, result.scene.bar);
    }
    if (common.wantsJson) {
        writeAnswer(wholeJsonOf(answer, "certificate"), result, writeOut);
    } else {
        writeOut(common.restated() + asText(answer, common.isVerbose));
    }
    if (result.motion) {
        warn(result.motion->physical);
    }
    return exitStatusOf(result.status);
}

ExitStatus FindCommand::answerQuestion(const answers::AskedPeriod& asked,
                                       const FindRequest& request) const
{
    const std::int64_t cells = common.usualCells();
    FindOutputs files(*this);
    answers::QuestionAnswer answer = answers::questionOf(asked, cells, request.options);
    std::optional<PeriodicResult> first;
    std::vector<Physical> measured;
    for (const Schedule& schedule :
         schedulesOfPeriod(cells, asked.steps, stopsOf(request.options.scene).right)) {
        answers::FindAnswer& found =
            answer.answers.emplace_back(search(schedule, request, common.quiet));
        PeriodicResult& result = found.result;
        if (!result.motion) {
            continue;
        }
        measured.push_back(result.motion->physical);
        if (!first) {
            first = result;
        }
        found.keptSpeeds = found.approachSpeeds();
        result.motion->state = {};  // there may be many, each as long as the grid is fine
    }
    if (files.areOfMotion() && measured.size() > 1) {
        throw std::invalid_argument(
            fmt::format("--state, --motion, --figure: {} motions answer: allowed one, by its NC NF",
                        measured.size()));
    }
    writeFiles(files, request.options, first.value_or(PeriodicResult{}), {});
    writeOut(common.wantsJson ? asLine(wholeJsonOf(answer))
                              : common.restated() + asText(answer, common.isVerbose));
    for (const Physical& physical : measured) {
        warn(physical);
    }
    return exitStatusOf(answer.status());
}

}  // namespace signorini::cli
