#include "continuum_command.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <optional>

#include "faults.hpp"
#include "files.hpp"
#include "interrupt.hpp"
#include "json.hpp"
#include "progress.hpp"
#include "signorini/continuum.hpp"
#include "signorini/figures.hpp"
#include "signorini/output.hpp"

namespace signorini::cli {

namespace {

constexpr std::int64_t maxSeed = std::int64_t{1} << 62;

Engine parseEngine(const std::string& text)
{
    for (const Engine engine :
         {Engine::automatic, Engine::geometric, Engine::ipopt, Engine::nlopt}) {
        if (text == name(engine)) {
            return engine;
        }
    }
    Faults faults;
    faults.add("--engine", text, "auto|geometric|ipopt|nlopt");
    faults.throwIfAny();
    return Engine::automatic;
}

ContinuumOptions parseOptions(const ContinuumCommand& words)
{
    ContinuumOptions options;
    options.bar = words.common.parseBar();
    if (!words.points.empty()) {
        options.points = parseWhole("--points", words.points, 2, maxContinuumPoints);
    }
    if (!words.seed.empty()) {
        options.seed = static_cast<std::uint64_t>(parseWhole("--seed", words.seed, 0, maxSeed));
    }
    if (!words.engine.empty()) {
        options.engine = parseEngine(words.engine);
    }
    if (!words.strainLimit.empty()) {
        options.strainLimit = parsePositive("--strain-limit", words.strainLimit, "-");
    }
    if (!words.tolerance.empty()) {
        options.tolerance = parsePositive("--tolerance", words.tolerance, "-");
    }
    if (!words.resolution.empty()) {
        options.resolution = parsePositive("--resolution", words.resolution, "-");
    }
    options.sample = words.sample;
    const int ends = (words.toFile.empty() ? 0 : 1) + (words.directionFile.empty() ? 0 : 1);
    if ((words.fromFile.empty() ? 0 : 1) != ends) {
        throw std::invalid_argument(
            "--from: allowed only together with one of --to and --direction");
    }
    if (!words.fromFile.empty()) {
        if (options.seed || words.sample) {
            throw std::invalid_argument(
                "--seed and --sample clash with --from: allowed one of them");
        }
        const auto read = [&](const char* option, const std::string& path) {
            return forFile(option, path, [&] {
                return readStateCsv(path, options.bar, words.common.parseCells());
            });
        };
        options.from = read("--from", words.fromFile);
        if (!words.toFile.empty()) {
            options.to = read("--to", words.toFile);
        } else {
            options.direction = read("--direction", words.directionFile);
        }
    }
    return options;
}

/// No motions have no dimension.
bool hasDimension(const Continuum& curve)
{
    return curve.dimension >= 0 && curve.components != 0;
}

std::string asText(const Continuum& curve)
{
    std::string text = fmt::format("{:<12}{}, E = {:.10g} E₁, {} motions by the {} engine\n",
                                   name(curve.status), describe(curve.schedule), curve.energyRatio,
                                   curve.points.size(), name(curve.engine));
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
        text += fmt::format("curve       {}, λ = {} from {:.6g} to {:.6g}\n", curve.family,
                            name(curve.parameter), curve.points.front().lambda,
                            curve.points.back().lambda);
        if (curve.resolution) {
            text +=
                fmt::format("resolution  neighbours at most {:.3g} √E apart\n", *curve.resolution);
        }
        text += fmt::format("strain      at most {:.6g} … {:.6g} in compression along it\n", least,
                            most);
        text += fmt::format("residuals   at most {:.3g}\n", residual);
    }
    if (!curve.detail.empty()) {
        text += fmt::format("why         {}\n", curve.detail);
    }
    return text;
}

std::string asJson(const Continuum& curve)
{
    Json json = newAnswer();
    json.update(Json{{"status", name(curve.status)},
                     {"cells", curve.schedule.cells},
                     {"schedule", phasesAsJson(curve.schedule.phases)},
                     {"bar", barAsJson(curve.bar)},
                     {"energy_ratio", curve.energyRatio},
                     {"connected", nullptr},
                     {"components", nullptr},
                     {"dimension", nullptr},
                     {"energy_ratio_range", nullptr},
                     {"resolution", nullptr},
                     {"engine", name(curve.engine)},
                     {"family", curve.family},
                     {"parameter", name(curve.parameter)},
                     {"reason", nullptr},
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
        json["points"].push_back({{"lambda", point.lambda},
                                  {"energy_ratio", point.energyRatio},
                                  {"residual", point.residual},
                                  {"peak_strain", point.peakStrain}});
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
    command.add_option("--energy-ratio", energyRatio, "E/E_1 of every motion; required")
        ->type_name("X");
    command.add_option("--points", points, "motions along the curve (201)")->type_name("M");
    command.add_option("--from", fromFile, "state to start from, as find --state writes it")
        ->type_name("FILE.csv");
    command.add_option("--to", toFile, "state to end at")->type_name("FILE.csv");
    command
        .add_option("--direction", directionFile, "or the way to go from there, as a state file")
        ->type_name("FILE.csv");
    command.add_flag("--sample", sample, "motions spread over the whole set instead of a curve");
    command
        .add_option("--seed", seed, "join two members drawn at random; with --sample, which ones")
        ->type_name("K");
    command.add_option("--engine", engine, "who traces (auto)")
        ->type_name("auto|geometric|ipopt|nlopt");
    command.add_option("--strain-limit", strainLimit, "strain >= -S everywhere, always")
        ->type_name("S");
    command
        .add_option("--resolution", resolution,
                    "how far neighbours on a curve by programs may be apart, in √(E/E₁) (0.05)")
        ->type_name("X");
    command.add_option("--tolerance", tolerance, "largest relative residual (1e-7)")
        ->type_name("X");
    command.add_option("--csv", csvFile, "write lambda, a_1..a_N, b_1..b_N, a row per motion")
        ->type_name("FILE.csv");
    command.add_option("--figure", figureFile, "draw the curve (needs gnuplot)")
        ->type_name("FILE.svg|.png|.pdf");
    common.addTo(command);
}

ExitStatus ContinuumCommand::run() const
{
    const Schedule schedule{common.parseCells(), parsePhases(steps)};
    const bool json = common.wantsJson();
    common.useOneThread("continuum");
    if (energyRatio.empty()) {
        throw std::invalid_argument("--energy-ratio is missing: allowed finite numbers > 0 [E_1]");
    }
    const double energy = parsePositive("--energy-ratio", energyRatio, "E_1");
    ContinuumOptions options = parseOptions(*this);
    validate(schedule);
    if (!figureFile.empty()) {
        (void)figureFormat(figureFile);
    }
    const OutputOption csvOption{"--csv", csvFile};
    const OutputOption figureOption{"--figure", figureFile};
    validateOutputs({csvOption, figureOption});
    OutputFiles files;
    const std::string csv = stage(files, csvOption);
    const std::string figure = stage(files, figureOption);

    std::optional<Interrupt> interrupt(std::in_place);
    options.cancel = interrupt->cancel();
    std::optional<Progress> progress(std::in_place, !common.quiet, "tracing");
    options.progress = [&progress](double done, double total) { progress->show(done, total); };
    const Continuum curve = traceContinuum(schedule, energy, options);
    progress.reset();
    interrupt.reset();
    if (!curve.points.empty()) {
        if (!csv.empty()) {
            forFile("--csv", csvFile, [&] { writeContinuumCsv(csv, curve); });
        }
        if (!figure.empty()) {
            forFile("--figure", figureFile,
                    [&] { drawContinuum(curve, figureFormat(figureFile), figure); });
        }
        files.commit();
    } else if ((!csv.empty() || !figure.empty()) && !common.quiet) {
        tell("signorini continuum: no motion to write, so no file was written\n");
    }
    writeOut(json ? asJson(curve) : asText(curve));
    return exitStatusOf(curve.status);
}

}  // namespace signorini::cli
