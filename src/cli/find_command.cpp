#include "find_command.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <array>
#include <optional>
#include <span>
#include <utility>

#include "demand_names.hpp"
#include "faults.hpp"
#include "files.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "question_report.hpp"
#include "report.hpp"
#include "signorini/figures.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/motion.hpp"
#include "signorini/output.hpp"

namespace signorini::cli {

/// The options with what needs several of them, and how the target was read.
struct FindRequest {
    FindOptions options;
    std::string reading;

    [[nodiscard]] std::optional<TargetReport> target() const
    {
        return options.target ? std::optional<TargetReport>({*options.target, reading})
                              : std::nullopt;
    }
};

namespace {

FindRequest completed(const FindCommand& call)
{
    FindRequest request{call.options, {}};
    FindOptions& options = request.options;
    options.bar = call.common.bar();
    if (call.energy) {
        if (options.energyRatio) {
            throw std::invalid_argument(
                "--energy clashes with --energy-ratio: allowed one of them");
        }
        options.energyRatio = *call.energy / scales(options.bar).energy;
    }
    if (call.yieldStress && !options.bar.young) {
        throw std::invalid_argument(
            "--yield-stress: allowed only with --young, --density and --area");
    }
    options.strainLimit /= scales(options.bar).strain;
    if (!(options.tipFloor < options.bar.gap)) {
        refuse("--tip-floor", fmt::format("{}", options.tipFloor), "below the gap [m]");
    }
    options.tipFloor /= options.bar.gap;
    if (options.objective == Objective::nearest && call.targetFile.empty()) {
        throw std::invalid_argument("--target is missing: --objective nearest needs a state file");
    }
    if (!call.targetFile.empty()) {
        if (options.objective != Objective::nearest) {
            throw std::invalid_argument("--target clashes with --objective: allowed only nearest");
        }
        StateReading read = forFile("--target", call.targetFile, [&] {
            return readState(call.targetFile, options.bar, call.common.usualCells());
        });
        options.target = std::move(read.state);
        request.reading = std::move(read.how);
    }
    return request;
}

/// findPeriodic, with signals listened to and a line on a terminal.
PeriodicResult search(const Schedule& schedule, FindOptions options, bool isQuiet)
{
    const Interrupt interrupt;
    const Progress progress(!isQuiet, "finding a motion");
    options.cancel = interrupt.cancel();
    PeriodicResult result = findPeriodic(schedule, options);
    if (result.status == Status::undecided && isRequested(options.cancel) && !isQuiet) {
        tell("signorini find: interrupted\n");
    }
    return result;
}

/// The files that a call names: checked before any work, staged, and written together.
class MotionFiles {
public:
    explicit MotionFiles(const FindCommand& words)
        : words_(checked(words)),
          state_(stage(files_, {"--state", words.stateFile})),
          motion_(words.motionFile, files_),
          figure_(stage(files_, {"--figure", words.figureFile})),
          animation_(stage(files_, {"--animate", words.animationFile}))
    {
    }

    [[nodiscard]] bool areWanted() const
    {
        return !state_.empty() || words_.motionFile.isWanted() || !figure_.empty() ||
               !animation_.empty();
    }

    void sayNone() const
    {
        if (areWanted() && !words_.common.quiet) {
            tell("signorini find: no motion to write, so no file was written\n");
        }
    }

    /// \pre a motion was found.
    void write(const PeriodicResult& result)
    {
        if (!state_.empty()) {
            forFile("--state", words_.stateFile,
                    [&] { writeStateCsv(state_, result.motion->state, result.bar); });
        }
        if (!figure_.empty()) {
            forFile("--figure", words_.figureFile,
                    [&] { drawMotion(result, figureFormat(words_.figureFile), figure_); });
        }
        if (words_.motionFile.isWanted() || !animation_.empty()) {
            writeMotion(result);
        }
        files_.commit();
    }

private:
    static const FindCommand& checked(const FindCommand& words)
    {
        if (!words.figureFile.empty()) {
            (void)figureFormat(words.figureFile);
        }
        if (!words.animationFile.empty()) {
            (void)animationFormat(words.animationFile);
        }
        words.motionFile.validate();
        validateOutputs({{"--state", words.stateFile},
                         words.motionFile.option(),
                         words.motionFile.folderOption(),
                         {"--figure", words.figureFile},
                         {"--animate", words.animationFile}});
        return words;
    }

    void writeMotion(const PeriodicResult& result)
    {
        const Motion field(result.motion->state, result.schedule);
        const std::int64_t all = signorini::steps(result.schedule);
        if (!animation_.empty()) {
            forFile("--animate", words_.animationFile, [&] {
                animateMotion(MotionSamples(field, result.bar),
                              animationFormat(words_.animationFile), animation_);
            });
        }
        if (words_.motionFile.isWanted() && field.steps() < all && !words_.common.quiet) {
            tell(
                fmt::format("signorini find: --motion holds {} of {} steps: the others repeat "
                            "free oscillations\n",
                            field.steps(), all));
        }
        motion_.write([&](std::int64_t most) { return MotionSamples(field, result.bar, most); });
    }

    const FindCommand& words_;
    OutputFiles files_;
    std::string state_;
    MotionFile::Staged motion_;
    std::string figure_;
    std::string animation_;
};

}  // namespace

void FindCommand::addTo(CLI::App& command)
{
    command.add_option("steps", steps, "contact and free steps of each phase")
        ->type_name("NC NF ...");
    command
        .add_option("--solver", options.solver, "a back end listed by signorini --version (auto)")
        ->type_name("NAME");
    addName(command, "--formulation", std::span(formulationNames), options.formulation,
            "unknowns of the problem (auto)");
    addName(command, "--objective", std::span(objectiveNames).subspan(1), options.objective,
            "which motion of the set (least energy; of an energy to hold, least peak strain)");
    command
        .add_option("--target", targetFile,
                    "state to come nearest to: as --state writes it, or measured (columns x, "
                    "velocity and strain or displacement); may be a pipe")
        ->type_name("FILE.csv");
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
    command.add_option("--state", stateFile, "write the state at t = 0")->type_name("FILE.csv");
    motionFile.addTo(command);
    command.add_option("--figure", figureFile, "draw the motion (needs gnuplot)")
        ->type_name("FILE.svg|.png|.pdf");
    command
        .add_option("--animate", animationFile,
                    "draw it moving (needs gnuplot, and ffmpeg for .mp4)")
        ->type_name("FILE.gif|.mp4");
    common.addTo(command);
}

/// Where a motion is not what a bar could do.
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

/// Forced motions are what conditions leave of a line: nothing is to be chosen but the amplitude.
void FindCommand::requireNothingFree() const
{
    const FindOptions usual;
    const std::array<std::pair<const char*, bool>, 13> others{{
        {"--period, --frequency, --hertz", question.isAsked()},
        {"--energy", energy.has_value()},
        {"--energy-ratio", options.energyRatio.has_value()},
        {"--objective", options.objective != usual.objective},
        {"--target", !targetFile.empty()},
        {"--solver", options.solver != usual.solver},
        {"--formulation", options.formulation != usual.formulation},
        {"--strain-limit", options.strainLimit != usual.strainLimit},
        {"--yield-stress", yieldStress.has_value()},
        {"--tip-floor", options.tipFloor != usual.tipFloor},
        {"--motion", motionFile.isWanted()},
        {"--figure", !figureFile.empty()},
        {"--animate", !animationFile.empty()},
    }};
    for (const auto& [option, isGiven] : others) {
        if (isGiven) {
            throw std::invalid_argument(
                fmt::format("{} clashes with --damping, --force and --amplitude: allowed with them "
                            "--cycles and --state",
                            option));
        }
    }
}

ExitStatus FindCommand::run() const
{
    if (!forced.isAsked() && forced.cycles != 1) {
        throw std::invalid_argument("--cycles: allowed only together with --damping and --force");
    }
    if (question.isAsked() && !steps.empty()) {
        throw std::invalid_argument(
            "NC NF clash with --period, --frequency and --hertz: allowed one of them");
    }
    ExitStatus status = exitUndecided;
    if (forced.isAsked()) {
        requireNothingFree();
        status = forced.answer({common.usualCells(), parsePhases(steps)}, common, stateFile);
    } else if (question.isAsked()) {
        const AskedPeriod asked = question.on(common.usualCells(), common.bar());
        status = answerQuestion(asked, completed(*this));
    } else {
        const Schedule schedule{common.usualCells(), parsePhases(steps)};
        status = answerSchedule(schedule, completed(*this));
    }
    common.useOneThread("find");
    return status;
}

ExitStatus FindCommand::answerSchedule(const Schedule& schedule, const FindRequest& request) const
{
    validate(schedule);
    MotionFiles files(*this);
    const PeriodicResult result = search(schedule, request.options, common.quiet);
    if (result.motion) {
        files.write(result);
    } else {
        files.sayNone();
    }
    writeOut(common.wantsJson ? asLine(answerOf(result, request.target()))
                              : asText(result, request.target()));
    if (result.motion) {
        warn(result.motion->physical);
    }
    return exitStatusOf(result.status);
}

ExitStatus FindCommand::answerQuestion(const AskedPeriod& asked, const FindRequest& request) const
{
    const std::int64_t cells = common.usualCells();
    MotionFiles files(*this);
    QuestionReport report(asked, cells, request.options, request.target());
    std::optional<PeriodicResult> first;
    std::vector<Physical> measured;
    for (const Schedule& schedule : setsOfPeriod(cells, asked.steps)) {
        PeriodicResult result = search(schedule, request.options, common.quiet);
        report.add(result);
        if (result.motion) {
            measured.push_back(result.motion->physical);
        }
        if (result.motion && !first) {
            first = std::move(result);
        }
    }
    if (files.areWanted() && measured.size() > 1) {
        throw std::invalid_argument(
            fmt::format("--state, --motion, --figure: {} motions answer: allowed one, by its NC NF",
                        measured.size()));
    }
    if (first) {
        files.write(*first);
    } else {
        files.sayNone();
    }
    writeOut(common.wantsJson ? asLine(report.json()) : report.text());
    for (const Physical& physical : measured) {
        warn(physical);
    }
    return exitStatusOf(report.status());
}

}  // namespace signorini::cli
