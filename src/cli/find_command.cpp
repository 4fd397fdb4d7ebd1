#include "find_command.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

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

/// The value whose name is `text`; `preset` when nothing was given.
template <typename Value>
Value parseName(const char* option, const std::string& text, Value preset,
                std::initializer_list<Value> values)
{
    if (text.empty()) {
        return preset;
    }
    std::string allowed;
    for (const Value value : values) {
        if (name(value) == text) {
            return value;
        }
        allowed += fmt::format("{}{}", allowed.empty() ? "" : "|", name(value));
    }
    Faults faults;
    faults.add(option, text, allowed);
    faults.throwIfAny();
    return preset;
}

FindOptions parseOptions(const FindCommand& words)
{
    FindOptions options;
    options.bar = words.common.parseBar();
    if (!words.solver.empty()) {
        options.solver = words.solver;
    }
    options.formulation = parseName(
        "--formulation", words.formulation, Formulation::automatic,
        {Formulation::automatic, Formulation::state, Formulation::reduced, Formulation::lumped});
    options.objective =
        parseName("--objective", words.objective, Objective::automatic,
                  {Objective::any, Objective::minEnergy, Objective::maxEnergy,
                   Objective::minPeakStrain, Objective::maxImpulse, Objective::nearest});
    if (!words.energyRatio.empty()) {
        options.energyRatio = parsePositive("--energy-ratio", words.energyRatio, "E_1");
    }
    if (!words.strainLimit.empty()) {
        options.strainLimit = parsePositive("--strain-limit", words.strainLimit, "-");
    }
    if (!words.tipFloor.empty()) {
        options.tipFloor = parseReal("--tip-floor", words.tipFloor, "m");
    }
    if (options.objective == Objective::nearest && words.targetFile.empty()) {
        throw std::invalid_argument("--target is missing: --objective nearest needs a state file");
    }
    if (!words.targetFile.empty()) {
        if (options.objective != Objective::nearest) {
            throw std::invalid_argument("--target clashes with --objective: allowed only nearest");
        }
        options.target = forFile("--target", words.targetFile, [&] {
            return readStateCsv(words.targetFile, options.bar, words.common.parseCells());
        });
    }
    if (!words.tolerance.empty()) {
        options.tolerance = parsePositive("--tolerance", words.tolerance, "-");
    }
    if (!words.timeLimit.empty()) {
        options.timeLimit = parsePositive("--time-limit", words.timeLimit, "s");
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
    command.add_option("--solver", solver, "a back end listed by signorini --version (auto)")
        ->type_name("NAME");
    command.add_option("--formulation", formulation, "unknowns of the problem (auto)")
        ->type_name("auto|state|reduced|lumped");
    command.add_option("--objective", objective, "which motion of the set (least energy)")
        ->type_name("any|min-energy|max-energy|min-peak-strain|max-impulse|nearest");
    command
        .add_option("--target", targetFile,
                    "state to come nearest to, as --state writes it; may be a pipe")
        ->type_name("FILE.csv");
    command.add_option("--energy-ratio", energyRatio, "hold E/E_1 = X")->type_name("X");
    command.add_option("--strain-limit", strainLimit, "strain >= -S everywhere, always")
        ->type_name("S");
    command.add_option("--tip-floor", tipFloor, "lowest displacement of the tip")->type_name("M");
    command.add_option("--tolerance", tolerance, "largest relative residual (1e-7)")
        ->type_name("X");
    command.add_option("--time-limit", timeLimit, "for the solver")->type_name("S");
    command.add_option("--state", stateFile, "write the state at t = 0")->type_name("FILE.csv");
    command.add_option("--motion", motionFile, "write u, v, s over one period")
        ->type_name("FILE.csv|.vtk");
    command.add_option("--figure", figureFile, "draw the motion (needs gnuplot)")
        ->type_name("FILE.svg|.png|.pdf");
    common.addTo(command);
}

ExitStatus FindCommand::run() const
{
    const Schedule schedule{common.parseCells(), parsePhases(steps)};
    const bool json = common.wantsJson();
    common.useOneThread("find");
    const FindOptions options = parseOptions(*this);
    validate(schedule);
    validateFiles(*this);

    OutputFiles files;
    const std::string state = stage(files, {"--state", stateFile});
    const std::string motion = stage(files, {"--motion", motionFile});
    const std::string figure = stage(files, {"--figure", figureFile});

    const PeriodicResult result = search(schedule, options, common.quiet);
    const bool wantsFiles = !state.empty() || !motion.empty() || !figure.empty();
    if (result.status == Status::found) {
        if (!state.empty()) {
            forFile("--state", stateFile, [&] { writeStateCsv(state, result.state, options.bar); });
        }
        if (!motion.empty()) {
            const Motion field(result.state, schedule);
            if (field.steps() < signorini::steps(schedule) && !common.quiet) {
                tell(
                    fmt::format("signorini find: --motion holds {} of {} steps: the others repeat "
                                "free oscillations\n",
                                field.steps(), signorini::steps(schedule)));
            }
            forFile("--motion", motionFile, [&] {
                (isVtk(motionFile) ? writeMotionVtk : writeMotionCsv)(motion, field, options.bar);
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
    writeOut(json ? asJson(result) : asText(result));
    return exitStatusOf(result.status);
}

}  // namespace signorini::cli
