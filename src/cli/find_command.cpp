#include "find_command.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <span>

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

/// The options with what needs several of them.
FindOptions completed(const FindCommand& call)
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
        options.target = forFile("--target", call.targetFile, [&] {
            return readStateCsv(call.targetFile, options.bar, call.common.usualCells());
        });
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

bool isVtk(const std::string& path)
{
    return path.ends_with(".vtk");
}

/// Names that are wrong before any work is done.
void validateFiles(const FindCommand& words)
{
    if (!words.figureFile.empty()) {
        (void)figureFormat(words.figureFile);
    }
    Faults faults;
    if (!words.motionFile.empty() && !words.motionFile.ends_with(".csv") &&
        !isVtk(words.motionFile)) {
        faults.add("--motion", words.motionFile, "a name ending in .csv or .vtk");
    }
    faults.throwIfAny();
    validateOutputs({{"--state", words.stateFile},
                     {"--motion", words.motionFile},
                     {"--figure", words.figureFile}});
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
                    "state to come nearest to, as --state writes it; may be a pipe")
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
    command.add_option("--motion", motionFile, "write u, v, s over one period")
        ->type_name("FILE.csv|.vtk");
    command.add_option("--figure", figureFile, "draw the motion (needs gnuplot)")
        ->type_name("FILE.svg|.png|.pdf");
    common.addTo(command);
}

ExitStatus FindCommand::run() const
{
    const Schedule schedule{common.usualCells(), parsePhases(steps)};
    const FindOptions request = completed(*this);
    validate(schedule);
    validateFiles(*this);

    OutputFiles files;
    const std::string state = stage(files, {"--state", stateFile});
    const std::string motion = stage(files, {"--motion", motionFile});
    const std::string figure = stage(files, {"--figure", figureFile});

    const PeriodicResult result = search(schedule, request, common.quiet);
    const bool wantsFiles = !state.empty() || !motion.empty() || !figure.empty();
    if (result.status == Status::found) {
        if (!state.empty()) {
            forFile("--state", stateFile,
                    [&] { writeStateCsv(state, result.motion->state, request.bar); });
        }
        if (!motion.empty()) {
            const Motion field(result.motion->state, schedule);
            if (field.steps() < signorini::steps(schedule) && !common.quiet) {
                tell(
                    fmt::format("signorini find: --motion holds {} of {} steps: the others repeat "
                                "free oscillations\n",
                                field.steps(), signorini::steps(schedule)));
            }
            forFile("--motion", motionFile, [&] {
                (isVtk(motionFile) ? writeMotionVtk : writeMotionCsv)(motion, field, request.bar);
            });
        }
        if (!figure.empty()) {
            forFile("--figure", figureFile,
                    [&] { drawMotion(result, figureFormat(figureFile), figure); });
        }
        files.commit();
    } else if (wantsFiles && !common.quiet) {
        tell("signorini find: no motion to write, so no file was written\n");
    }
    writeOut(common.wantsJson ? asJson(result) : asText(result));
    common.useOneThread("find");
    return exitStatusOf(result.status);
}

}  // namespace signorini::cli
