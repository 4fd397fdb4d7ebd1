#include "find_command.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <optional>
#include <span>
#include <utility>

#include "demand_names.hpp"
#include "faults.hpp"
#include "files.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "report.hpp"
#include "signorini/figures.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/motion.hpp"
#include "signorini/output.hpp"

namespace signorini::cli {

namespace {

/// The options with what needs several of them, and how the target was read.
FindOptions completed(const FindCommand& call, std::string& how)
{
    FindOptions options = call.options;
    options.bar = call.common.bar();
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
        how = std::move(read.how);
    }
    return options;
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

/// Names that are wrong before any work is done.
void validateFiles(const FindCommand& words)
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
}

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
            "which motion of the set (least energy)");
    command
        .add_option("--target", targetFile,
                    "state to come nearest to: as --state writes it, or measured (columns x, "
                    "velocity and strain or displacement); may be a pipe")
        ->type_name("FILE.csv");
    addPositive(command, "--energy-ratio", "E_1", options.energyRatio, "X", "hold E/E_1 = X");
    addPositive(command, "--strain-limit", "-", options.strainLimit, "S",
                "strain >= -S everywhere, always");
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

ExitStatus FindCommand::run() const
{
    const Schedule schedule{common.usualCells(), parsePhases(steps)};
    std::string how;
    const FindOptions request = completed(*this, how);
    validate(schedule);
    validateFiles(*this);

    OutputFiles files;
    const std::string state = stage(files, {"--state", stateFile});
    MotionFile::Staged moving(motionFile, files);
    const std::string figure = stage(files, {"--figure", figureFile});
    const std::string animation = stage(files, {"--animate", animationFile});

    const PeriodicResult result = search(schedule, request, common.quiet);
    const bool wantsFiles =
        !state.empty() || motionFile.isWanted() || !figure.empty() || !animation.empty();
    if (result.status == Status::found) {
        if (!state.empty()) {
            forFile("--state", stateFile,
                    [&] { writeStateCsv(state, result.motion->state, request.bar); });
        }
        if (!figure.empty()) {
            forFile("--figure", figureFile,
                    [&] { drawMotion(result, figureFormat(figureFile), figure); });
        }
        std::optional<Motion> field;  // as large as several states
        if (motionFile.isWanted() || !animation.empty()) {
            field.emplace(result.motion->state, schedule);
        }
        if (!animation.empty()) {
            forFile("--animate", animationFile, [&] {
                animateMotion(MotionSamples(*field, request.bar), animationFormat(animationFile),
                              animation);
            });
        }
        if (motionFile.isWanted()) {
            if (field->steps() < signorini::steps(schedule) && !common.quiet) {
                tell(
                    fmt::format("signorini find: --motion holds {} of {} steps: the others repeat "
                                "free oscillations\n",
                                field->steps(), signorini::steps(schedule)));
            }
        }
        moving.write([&](std::int64_t most) { return MotionSamples(*field, request.bar, most); });
        files.commit();
    } else if (wantsFiles && !common.quiet) {
        tell("signorini find: no motion to write, so no file was written\n");
    }
    const std::optional<TargetReport> target =
        request.target ? std::optional<TargetReport>({*request.target, how}) : std::nullopt;
    writeOut(common.wantsJson ? asJson(result, target) : asText(result, target));
    common.useOneThread("find");
    return exitStatusOf(result.status);
}

}  // namespace signorini::cli
