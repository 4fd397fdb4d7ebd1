#include "modes_command.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "files.hpp"
#include "interrupt.hpp"
#include "json.hpp"
#include "mode_report.hpp"
#include "progress.hpp"
#include "signorini/figures.hpp"
#include "signorini/modes.hpp"

namespace signorini::cli {

namespace {

/// The outcome of one call.
struct Listing {
    ModeBounds bounds;
    Bar bar;
    std::vector<Mode> modes;
    bool isComplete = true;
};

double hertz(const ExactPeriod& period, const Scales& unit)
{
    return 1.0 / (period.value() * unit.time);
}

std::string asText(const Listing& listing)
{
    std::string text = fmt::format(
        "{} modes with |b| ≤ {}, T ≤ {} L/c, E ≤ {} E₁{}\n", listing.modes.size(),
        listing.bounds.maxOrder, listing.bounds.maxPeriod, listing.bounds.maxEnergyRatio,
        listing.isComplete ? "" : ": interrupted, the list is not complete");
    if (listing.modes.empty()) {
        return text;
    }
    const Scales unit = scales(listing.bar);
    text += fmt::format("\n{:<14}{:<18}{:<20}{:<24}{:<14}{:<22}{:<26}{:<17}{}\n", "t_c [L/c]",
                        "T in [L/c]", "ω/ω₁ in", "frequency in [Hz]", "1/√(E/E₁)", "E/E₁ in",
                        "energy in [J]", "lowest T", "family");
    for (const Mode& mode : listing.modes) {
        const EnergyRange energy = energyRange(mode);
        text += fmt::format(
            "{:<14}{:<18}{:<20}{:<24}{:<14}{:<22}{:<26}{:<17}{}\n", contactAsText(mode),
            fmt::format("]{}, {}[", fractionAsText(mode.lowest), fractionAsText(mode.highest)),
            fmt::format("]{:.6g}, {:.6g}[", 4.0 / mode.highest.value(), 4.0 / mode.lowest.value()),
            fmt::format("]{:.6g}, {:.6g}[", hertz(mode.highest, unit), hertz(mode.lowest, unit)),
            rootAsText(mode), fmt::format("]{:.6g}, {:.6g}[", energy.least, energy.most),
            fmt::format("]{:.6g}, {:.6g}[", energy.least * unit.energy, energy.most * unit.energy),
            name(mode.lowestEnd), familyName(mode));
    }
    return text;
}

Json asJson(const Mode& mode, const Scales& unit)
{
    const EnergyRange energy = energyRange(mode);
    Json json = identityAsJson(mode);
    json["ends"] = {name(mode.lowestEnd), name(mode.highestEnd)};
    json["energy_ratio_range"] = {energy.least, nullptr};
    if (std::isfinite(energy.most)) {
        json["energy_ratio_range"][1] = energy.most;
    }
    json["frequency_range"] = {hertz(mode.highest, unit), hertz(mode.lowest, unit)};
    json["energy_range"] = {energy.least * unit.energy, energy.most * unit.energy};
    return json;
}

std::string asJson(const Listing& listing)
{
    const Scales unit = scales(listing.bar);
    Json json = newAnswer();
    json.update(Json{{"bar", barAsJson(listing.bar)},
                     {"complete", listing.isComplete},
                     {"max_order", listing.bounds.maxOrder},
                     {"max_period_ratio", listing.bounds.maxPeriod},
                     {"max_energy_ratio", listing.bounds.maxEnergyRatio},
                     {"modes", Json::array()}});
    for (const Mode& mode : listing.modes) {
        json["modes"].push_back(asJson(mode, unit));
    }
    return asLine(json);
}

/// The periods of a mode with E/E_1 <= most: kappa T - mu >= 1/sqrt(most).
std::pair<double, double> periodsUpTo(const Mode& mode, double most)
{
    double low = mode.lowest.value();
    double high = mode.highest.value();
    const double end =
        (static_cast<double>(mode.mu) + 1.0 / std::sqrt(most)) / static_cast<double>(mode.kappa);
    (mode.kappa > 0 ? low : high) = mode.kappa > 0 ? std::max(low, end) : std::min(high, end);
    return {low, high};
}

/// Motions inside the interval of each mode, evenly in T, with no more than the energy asked for.
void writeCurves(const std::string& path, const Listing& listing)
{
    constexpr int motions = 100;
    TextFile file(path);
    file.write("a4,b,period_ratio,frequency_ratio,contact_time_ratio,energy_ratio\n");
    for (const Mode& mode : listing.modes) {
        const auto [low, high] = periodsUpTo(mode, listing.bounds.maxEnergyRatio);
        for (int k = 0; k < motions; ++k) {
            const double period = low + (k + 0.5) / motions * (high - low);
            file.write(fmt::format("{},{},{},{},{},{}\n", 4 * mode.a, mode.b, period, 4.0 / period,
                                   contactTime(mode, period), energyRatio(mode, period)));
        }
    }
    file.close();
}

}  // namespace

void ModesCommand::addTo(CLI::App& command)
{
    addPositive(command, "--max-energy-ratio", "E_1", bounds.maxEnergyRatio, "X",
                "only modes with a motion of E/E_1 <= X (50)");
    addWhole(command, "--max-order", 1, maxModeOrder, bounds.maxOrder, "B",
             "only contact times 4a + b T with |b| <= B (25)");
    addPositive(command, "--max-period", "L/c", bounds.maxPeriod, "T",
                "only modes with a motion of T <= X, in L/c (8)");
    command
        .add_option("--csv", csvFile,
                    "write their curves: T, ω/ω₁, t_c and E/E₁ of motions along each")
        ->type_name("FILE.csv");
    command
        .add_option("--figure", figureFile, "draw them, energy against frequency (needs gnuplot)")
        ->type_name("FILE.svg|.png|.pdf");
    common.addTo(command);
    command.footer(
        "Times are in units of L/c and energies in E_1: the list holds for every bar and every "
        "grid. JSON adds frequencies in Hz and energies in J of the bar that the options name.");
}

ExitStatus ModesCommand::run() const
{
    Listing listing{bounds, common.bar(), {}};
    FrequencyEnergyOptions drawing;
    if (!figureFile.empty()) {
        drawing.format = figureFormat(figureFile);
        // From the lowest energy there is to where curves are upright lines.
        drawing.maxEnergyRatio = std::clamp(listing.bounds.maxEnergyRatio, 2.0, 1e6);
    }
    const OutputOption csvOption{"--csv", csvFile};
    const OutputOption figureOption{"--figure", figureFile};
    validateOutputs({csvOption, figureOption});
    OutputFiles files;
    const std::string csv = stage(files, csvOption);
    const std::string figure = stage(files, figureOption);

    {
        const Interrupt interrupt;
        Progress progress(!common.quiet, "listing modes");
        listing.bounds.cancel = interrupt.cancel();
        listing.bounds.progress = [&progress](double done, double total) {
            progress.show(done, total);
        };
        listing.modes = findModes(listing.bounds);
        listing.isComplete = !isRequested(interrupt.cancel());
    }
    if (!listing.isComplete && !common.quiet) {
        tell(fmt::format("signorini modes: interrupted; the list is not complete{}\n",
                         csv.empty() && figure.empty() ? "" : ", so no file was written"));
    }
    if (listing.isComplete) {
        if (!csv.empty()) {
            forFile("--csv", csvFile, [&] { writeCurves(csv, listing); });
        }
        if (!figure.empty()) {
            forFile("--figure", figureFile,
                    [&] { writeFrequencyEnergyFigure(figure, {.modes = listing.modes}, drawing); });
        }
        files.commit();
    }
    writeOut(common.wantsJson ? asJson(listing) : asText(listing));
    common.useOneThread("modes");
    return listing.isComplete ? exitFound : exitUndecided;
}

}  // namespace signorini::cli
