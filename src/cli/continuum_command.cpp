#include "continuum_command.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "faults.hpp"
#include "files.hpp"
#include "interrupt.hpp"
#include "json.hpp"
#include "progress.hpp"
#include "report.hpp"
#include "signorini/continuum.hpp"
#include "signorini/figures.hpp"
#include "signorini/output.hpp"
#include "solver.hpp"

namespace signorini::cli {

namespace {

constexpr std::int64_t maxSeed = std::int64_t{1} << 62;

/// Words of --engine for solvers: the first are the command line's own.
constexpr std::array engines{
    std::pair<std::string_view, std::string_view>{"geometric", "closed-form"},
    std::pair<std::string_view, std::string_view>{"nlopt", "nlopt-auglag"},
};

std::string parseEngine(const std::string& text)
{
    for (const auto& [engine, solver] : engines) {
        if (text == engine) {
            return std::string(solver);
        }
    }
    const auto table = backends();
    if (text != "auto" && std::none_of(table.begin(), table.end(), [&text](const Backend& backend) {
            return backend.name == text;
        })) {
        refuse("--engine", text, "auto|geometric|ipopt|nlopt, or a back end");
    }
    return text;
}

std::string engineOf(const Continuum& curve)
{
    for (const auto& [engine, solver] : engines) {
        if (curve.solver == solver) {
            return std::string(engine);
        }
    }
    return curve.solver;
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
    options.bar = call.common.bar();
    options.trace = traceOf(call, options.bar);
    return options;
}

/// No motions have no dimension.
bool hasDimension(const Continuum& curve)
{
    return curve.dimension >= 0 && curve.components != 0;
}

/// How many different motions the points are.
std::string orbitsAsText(const Continuum& curve)
{
    const auto points = static_cast<std::int64_t>(curve.points.size());
    if (curve.orbits == points) {
        return points == 1 ? "1 motion" : "all different motions, none a shift in time of another";
    }
    return fmt::format("{} different motion{}: the other points are the same at other instants",
                       curve.orbits, curve.orbits == 1 ? "" : "s");
}

const char* unitOf(Parameter parameter)
{
    switch (parameter) {
        case Parameter::arcLength:
            return " [√E₁]";
        case Parameter::pause:
            return " between the two pulses of force [L/c]";
        case Parameter::number:
            return "";
    }
    return "";
}

std::string asText(const Continuum& curve, const std::optional<Member>& member)
{
    std::string text = fmt::format("{:<12}{}, E = {:.10g} E₁, {} motions by the {} engine\n",
                                   name(curve.status), describe(curve.schedule), curve.energyRatio,
                                   curve.points.size(), engineOf(curve));
    if (curve.energyRange) {
        text += fmt::format("range       {:.10g} … {:.10g} E₁\n", curve.energyRange->least,
                            curve.energyRange->most);
    }
    if (curve.components) {
        text += fmt::format(
            "set         {} component{}{} at this energy\n", *curve.components,
            *curve.components == 1 ? "" : "s",
            hasDimension(curve) ? fmt::format(" of dimension {}", curve.dimension) : "");
    }
    text += fmt::format("connected   {}\n", !curve.connected   ? "not known"
                                            : *curve.connected ? "yes"
                                                               : "no");
    if (!curve.points.empty()) {
        double residual = 0.0;
        double least = curve.points.front().peakStrain;
        double most = least;
        for (const ContinuumPoint& point : curve.points) {
            residual = std::max(residual, point.residual);
            least = std::min(least, point.peakStrain);
            most = std::max(most, point.peakStrain);
        }
        text += fmt::format("curve       {}, λ = {}{} from {:.6g} to {:.6g}\n", curve.family,
                            name(curve.parameter), unitOf(curve.parameter),
                            curve.points.front().lambda, curve.points.back().lambda);
        text += fmt::format("orbits      {}\n", orbitsAsText(curve));
        if (curve.resolution) {
            text +=
                fmt::format("resolution  neighbours at most {:.3g} √E apart\n", *curve.resolution);
        }
        text += fmt::format("strain      at most {:.6g} … {:.6g} in compression along it\n", least,
                            most);
        text += fmt::format("residuals   at most {:.3g}\n", residual);
    }
    if (member) {
        text += fmt::format(
            "member      λ = {:.10g}, {}; {:.6g} in compression\n", member->point.lambda,
            member->isExact ? "exactly the one asked for" : "the nearest point of the curve",
            member->point.peakStrain);
    }
    if (!curve.detail.empty()) {
        text +=
            fmt::format("{:<12}{}\n", curve.status == Status::found ? "note" : "why", curve.detail);
    }
    return text;
}

Physical physicalOf(const ContinuumPoint& point, const Continuum& curve)
{
    return signorini::physicalOf(extremesOf(point.state, curve.schedule), curve.bar);
}

/// Of the member that is compressed most.
void warnOfWorst(const Continuum& curve)
{
    const auto worst = std::max_element(
        curve.points.begin(), curve.points.end(),
        [](const auto& one, const auto& other) { return one.peakStrain < other.peakStrain; });
    if (worst != curve.points.end()) {
        warnUnlessAdmissible("continuum", physicalOf(*worst, curve));
    }
}

Json asJson(const ContinuumPoint& point, const Continuum& curve)
{
    const Physical physical = physicalOf(point, curve);
    return {{"lambda", point.lambda},
            {"energy_ratio", point.energyRatio},
            {"residual", point.residual},
            {"peak_strain", point.peakStrain},
            {"physical", physicalAsJson(physical)},
            {"admissible", physical.isAdmissible()}};
}

std::string asJson(const Continuum& curve, const std::optional<Member>& member)
{
    Json json = newAnswer();
    json.update(Json{{"status", name(curve.status)},
                     {"cells", curve.schedule.cells},
                     {"schedule", phasesAsJson(curve.schedule.phases)},
                     {"bar", barAsJson(curve.bar)},
                     {"period", period(curve.schedule) * scales(curve.bar).time},
                     {"period_ratio", period(curve.schedule)},
                     {"frequency_ratio", frequencyRatio(curve.schedule)},
                     {"energy_ratio", curve.energyRatio},
                     {"connected", nullptr},
                     {"components", nullptr},
                     {"dimension", nullptr},
                     {"energy_ratio_range", nullptr},
                     {"resolution", nullptr},
                     {"engine", engineOf(curve)},
                     {"family", curve.family},
                     {"parameter", name(curve.parameter)},
                     {"reason", nullptr},
                     {"orbits", curve.orbits},
                     {"points", Json::array()}});
    if (curve.connected) {
        json["connected"] = *curve.connected;
    }
    if (curve.components) {
        json["components"] = *curve.components;
    }
    if (hasDimension(curve)) {
        json["dimension"] = curve.dimension;
    }
    if (curve.energyRange) {
        json["energy_ratio_range"] = {curve.energyRange->least, curve.energyRange->most};
    }
    if (curve.resolution) {
        json["resolution"] = *curve.resolution;
    }
    if (curve.reason) {
        json["reason"] = name(*curve.reason);
    }
    for (const ContinuumPoint& point : curve.points) {
        json["points"].push_back(asJson(point, curve));
    }
    if (member) {
        json["member"] = asJson(member->point, curve);
        json["member"]["exact"] = member->isExact;
    }
    if (!curve.detail.empty()) {
        json["detail"] = curve.detail;
    }
    return asLine(json);
}

}  // namespace

void ContinuumCommand::addTo(CLI::App& command)
{
    command.add_option("steps", steps, "contact and free steps of each phase")
        ->type_name("NC NF ...");
    addPositive(command, "--energy-ratio", "E_1", energyRatio, "X",
                "E/E_1 of every motion; required");
    addWhole(command, "--points", 2, maxContinuumPoints, options.points, "M",
             "motions along the curve (201)");
    command.add_option("--from", fromFile, "state to start from, as find --state writes it")
        ->type_name("FILE.csv");
    command.add_option("--to", toFile, "state to end at")->type_name("FILE.csv");
    command
        .add_option("--direction", directionFile, "or the way to go from there, as a state file")
        ->type_name("FILE.csv");
    command.add_flag("--sample", sample, "motions spread over the whole set instead of a curve");
    addWhole(command, "--seed", 0, maxSeed, seed, "K",
             "join two members drawn at random; with --sample, which ones");
    addWord(command, "--engine", "auto|geometric|ipopt|nlopt", "who traces; or a back end (auto)",
            [this](const std::string& text) { options.solver = parseEngine(text); });
    addPositive(command, "--strain-limit", "-", options.strainLimit, "S",
                "strain >= -S everywhere, always");
    addPositive(command, "--resolution", "-", options.resolution, "X",
                "how far neighbours on a curve by programs may be apart, in √(E/E₁) (0.05)");
    addPositive(command, "--tolerance", "-", options.tolerance, "X",
                "largest relative residual (1e-7)");
    command.add_option("--csv", csvFile, "write lambda, a_1..a_N, b_1..b_N, a row per motion")
        ->type_name("FILE.csv");
    addWord(command, "--member", "LAMBDA", "one motion of the curve, for --state",
            [this](const std::string& text) { member = parseReal("--member", text, "lambda"); });
    command.add_option("--state", stateFile, "write the state of that motion at t = 0")
        ->type_name("FILE.csv");
    command.add_option("--figure", figureFile, "draw the curve (needs gnuplot)")
        ->type_name("FILE.svg|.png|.pdf");
    command
        .add_option("--animate", animationFile,
                    "draw it moving (needs gnuplot, and ffmpeg for .mp4)")
        ->type_name("FILE.gif|.mp4");
    common.addTo(command);
}

ExitStatus ContinuumCommand::run() const
{
    const Schedule schedule{common.usualCells(), parsePhases(steps)};
    if (!energyRatio) {
        throw std::invalid_argument("--energy-ratio is missing: allowed finite numbers > 0 [E_1]");
    }
    ContinuumOptions request = completed(*this);
    validate(schedule);
    if (!figureFile.empty()) {
        (void)figureFormat(figureFile);
    }
    if (!animationFile.empty()) {
        (void)animationFormat(animationFile);
    }
    if (member.has_value() == stateFile.empty()) {
        throw std::invalid_argument("--member and --state: allowed both or neither");
    }
    const OutputOption csvOption{"--csv", csvFile};
    const OutputOption stateOption{"--state", stateFile};
    const OutputOption figureOption{"--figure", figureFile};
    const OutputOption animationOption{"--animate", animationFile};
    validateOutputs({csvOption, stateOption, figureOption, animationOption});
    OutputFiles files;
    const std::string csv = stage(files, csvOption);
    const std::string state = stage(files, stateOption);
    const std::string figure = stage(files, figureOption);
    const std::string animation = stage(files, animationOption);

    std::optional<Interrupt> interrupt(std::in_place);
    request.cancel = interrupt->cancel();
    std::optional<Progress> progress(std::in_place, !common.quiet, "tracing");
    request.progress = [&progress](double done, double total) { progress->show(done, total); };
    const Continuum curve = traceContinuum(schedule, *energyRatio, request);
    progress.reset();
    interrupt.reset();
    std::optional<Member> chosen;
    if (!curve.points.empty()) {
        if (member) {
            chosen = memberAt(curve, *member);
            forFile("--state", stateFile,
                    [&] { writeStateCsv(state, chosen->point.state, request.bar); });
        }
        if (!csv.empty()) {
            forFile("--csv", csvFile, [&] { writeContinuumCsv(csv, curve); });
        }
        if (!figure.empty()) {
            forFile("--figure", figureFile,
                    [&] { drawContinuum(curve, figureFormat(figureFile), figure); });
        }
        if (!animation.empty()) {
            forFile("--animate", animationFile,
                    [&] { animateContinuum(curve, animationFormat(animationFile), animation); });
        }
        files.commit();
    } else if ((!csv.empty() || !state.empty() || !figure.empty() || !animation.empty()) &&
               !common.quiet) {
        tell("signorini continuum: no motion to write, so no file was written\n");
    }
    writeOut(common.wantsJson ? asJson(curve, chosen) : asText(curve, chosen));
    if (!common.quiet) {
        warnOfWorst(curve);
    }
    common.useOneThread("continuum");
    return exitStatusOf(curve.status);
}

}  // namespace signorini::cli
