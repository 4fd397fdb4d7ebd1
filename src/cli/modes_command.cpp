#include "modes_command.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cmath>
#include <optional>

#include "files.hpp"
#include "interrupt.hpp"
#include "json.hpp"
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

std::string asText(const ExactPeriod& period)
{
    return period.denominator == 1 ? fmt::format("{}", period.numerator)
                                   : fmt::format("{}/{}", period.numerator, period.denominator);
}

double hertz(const ExactPeriod& period, const Scales& unit)
{
    return 1.0 / (period.value() * unit.time);
}

/// "7T" or "T".
std::string timesT(std::int64_t factor)
{
    return factor == 1 ? "T" : fmt::format("{}T", factor);
}

/// kappa T - mu > 0 with its positive term first.
std::string rootAsText(const Mode& mode)
{
    return mode.kappa > 0 ? fmt::format("{} - {}", timesT(mode.kappa), mode.mu)
                          : fmt::format("{} - {}", -mode.mu, timesT(-mode.kappa));
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
            "{:<14}{:<18}{:<20}{:<24}{:<14}{:<22}{:<26}{:<17}{}\n",
            fmt::format("{} - {}", 4 * mode.a, timesT(-mode.b)),
            fmt::format("]{}, {}[", asText(mode.lowest), asText(mode.highest)),
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
    const auto fraction = [](const ExactPeriod& period) {
        return Json{period.numerator, period.denominator};
    };
    const EnergyRange energy = energyRange(mode);
    Json json{{"contact", {4 * mode.a, mode.b}},
              {"period_range", {fraction(mode.lowest), fraction(mode.highest)}},
              {"inverse_sqrt_energy", {mode.kappa, mode.mu}},
              {"ends", {name(mode.lowestEnd), name(mode.highestEnd)}},
              {"energy_ratio_range", {energy.least, nullptr}},
              {"family", nullptr}};
    if (std::isfinite(energy.most)) {
        json["energy_ratio_range"][1] = energy.most;
    }
    json["frequency_range"] = {hertz(mode.highest, unit), hertz(mode.lowest, unit)};
    json["energy_range"] = {energy.least * unit.energy, energy.most * unit.energy};
    if (const std::string family = familyName(mode); !family.empty()) {
        json["family"] = family;
    }
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
    const OutputOption figureOption{"--figure", figureFile};
    validateOutputs({figureOption});
    OutputFiles files;
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
                         figure.empty() ? "" : ", so no figure was drawn"));
    }
    if (!figure.empty() && listing.isComplete) {
        forFile("--figure", figureFile,
                [&] { writeFrequencyEnergyFigure(figure, listing.modes, {}, drawing); });
        files.commit();
    }
    writeOut(common.wantsJson ? asJson(listing) : asText(listing));
    common.useOneThread("modes");
    return listing.isComplete ? exitFound : exitUndecided;
}

}  // namespace signorini::cli
