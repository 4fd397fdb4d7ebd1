#include "continuum_command.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "continuum_report.hpp"
#include "engine_names.hpp"
#include "faults.hpp"
#include "files.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "report.hpp"
#include "signorini/continuum.hpp"
#include "signorini/figures.hpp"
#include "signorini/output.hpp"

namespace signorini::cli {

namespace {

constexpr std::int64_t maxSeed = std::int64_t{1} << 62;

/// [E_1], whichever way it was given.
double energyOf(const ContinuumCommand& call, const Bar& bar)
{
    if (call.energy && call.energyRatio) {
        throw std::invalid_argument("--energy clashes with --energy-ratio: allowed one of them");
    }
    if (!call.energy && !call.energyRatio) {
        throw std::invalid_argument(
            "--energy-ratio is missing: allowed finite numbers > 0 [E_1], or --energy in joules");
    }
    return call.energy ? *call.energy / scales(bar).energy : *call.energyRatio;
}

Trace traceOf(const ContinuumCommand& call, const Bar& bar)
{
    const int ends = (call.toFile.empty() ? 0 : 1) + (call.directionFile.empty() ? 0 : 1);
    if ((call.fromFile.empty() ? 0 : 1) != ends) {
        throw std::invalid_argument(
            "--from: allowed only together with one of --to and --direction");
    }
    if (call.fromFile.empty()) {
        return call.sample ? Trace(trace::Sample{call.seed.value_or(trace::Sample{}.seed)})
               : call.seed ? Trace(trace::RandomPath{*call.seed})
                           : Trace(trace::SplitPulse{});
    }
    if (call.seed || call.sample) {
        throw std::invalid_argument("--seed and --sample clash with --from: allowed one of them");
    }
    const auto read = [&](const char* option, const std::string& path) {
        return forFile(option, path,
                       [&] { return readState(path, bar, call.common.usualCells()).state; });
    };
    State from = read("--from", call.fromFile);
    if (!call.toFile.empty()) {
        return trace::Path{std::move(from), read("--to", call.toFile)};
    }
    return trace::Walk{std::move(from), read("--direction", call.directionFile)};
}

/// The options with what needs several of them.
ContinuumOptions completed(const ContinuumCommand& call)
{
    ContinuumOptions options = call.options;
    options.scene = call.common.sceneOfOneBar();
    options.trace = traceOf(call, options.scene.bar);
    return options;
}

/// Of the member that is compressed most.
void warnOfWorst(const Continuum& curve)
{
    const auto worst = std::max_element(
        curve.points.begin(), curve.points.end(),
        [](const auto& one, const auto& other) { return one.peakStrain < other.peakStrain; });
    if (worst != curve.points.end()) {
        warnUnlessAdmissible("continuum",
                             physicalOf(extremesOf(worst->state, curve.schedule), curve.scene.bar));
    }
}

}  // namespace

void ContinuumCommand::addTo(CLI::App& command)
{
    addWords(command, "steps", "NC NF ...", steps, "contact and free steps of each phase");
    addPositive(command, "--energy-ratio", "E_1", energyRatio, "X",
                "E/E_1 of every motion; this or");
    addPositive(command, "--energy", "J", energy, "J", "their energy in joules");
    addWhole(command, "--points", 2, maxContinuumPoints, options.points, "M",
             "motions along the curve (201)");
    addFile(command, "--from", fromFile, "state to start from, as find --state writes it");
    addFile(command, "--to", toFile, "state to end at");
    addFile(command, "--direction", directionFile,
            "or the direction to take from there, as a state file");
    addFlag(command, "--sample", sample, "motions spread over the whole set instead of a curve");
    addWhole(command, "--seed", 0, maxSeed, seed, "K",
             "join two members drawn at random; with --sample, which ones");
    addWord(command, "--engine", "auto|geometric|ipopt|nlopt",
            "method that traces the curve, or a back end (auto)",
            [this](const std::string& text) { options.solver = solverOfEngine(text, "--engine"); });
    addPositive(command, "--strain-limit", "-", options.strainLimit, "S",
                "strain >= -S everywhere, always");
    addPositive(
        command, "--resolution", "-", options.resolution, "X",
        "largest distance between neighbours on a curve found by solvers, in √(E/E₁) (0.05)");
    addPositive(command, "--tolerance", "-", options.tolerance, "X",
                "largest relative residual (1e-7)");
    addFile(command, "--csv", csvFile, "write lambda, a_1..a_N, b_1..b_N, a row per motion");
    addWord(command, "--member", "LAMBDA", "one motion of the curve, for --state",
            [this](const std::string& text) { member = parseReal("--member", text, "lambda"); });
    addFile(command, "--state", stateFile, "write the state of that motion at t = 0");
    addFigure(command, "--figure", figureFile, "draw the curve");
    addAnimation(command, animationFile);
    common.addTo(command);
}

ExitStatus ContinuumCommand::run() const
{
    Schedule schedule{common.usualCells(), parsePhases(steps)};
    ContinuumOptions request = completed(*this);
    const double ratio = energyOf(*this, request.scene.bar);
    schedule.stops = stopsOf(request.scene);
    validate(schedule);
    if (member.has_value() == stateFile.empty()) {
        throw std::invalid_argument("--member and --state: allowed both or neither");
    }
    Outputs outputs({{"--csv", csvFile},
                     {"--state", stateFile},
                     {"--figure", figureFile},
                     {"--animate", animationFile}});

    std::optional<Interrupt> interrupt(std::in_place);
    request.cancel = interrupt->cancel();
    std::optional<Progress> progress(std::in_place, !common.quiet, "tracing");
    request.progress = [&progress](double done, double total) { progress->show(done, total); };
    const Continuum curve = traceContinuum(schedule, ratio, request);
    progress.reset();
    interrupt.reset();
    std::optional<Member> chosen;
    if (!curve.points.empty()) {
        if (member) {
            chosen = memberAt(curve, *member);
        }
        outputs.put("--state", [&](const std::string& path) {
            writeStateCsv(path, chosen->point.state, request.scene.bar);
        });
        outputs.put("--csv", [&](const std::string& path) { writeContinuumCsv(path, curve); });
        outputs.put("--figure", [&](const std::string& path) {
            drawFigure(continuumFigure(curve), figureFormat(figureFile), path);
        });
        outputs.put("--animate", [&](const std::string& path) {
            drawFigures(continuumFrames(curve), animationFormat(animationFile), path);
        });
        outputs.commit();
    } else if (outputs.areWanted() && !common.quiet) {
        tell("signorini continuum: no motion to write, so no file was written\n");
    }
    writeOut(common.wantsJson ? asJson(curve, chosen) : common.restated() + asText(curve, chosen));
    if (!common.quiet) {
        warnOfWorst(curve);
    }
    common.useOneThread("continuum");
    return exitStatusOf(curve.status);
}

}  // namespace signorini::cli
