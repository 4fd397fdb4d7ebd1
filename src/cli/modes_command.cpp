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
#include "signorini/frequency_energy_figure.hpp"
#include "signorini/modes.hpp"

namespace signorini::cli {

namespace {

/// The outcome of one call.
struct Listing {
    ModeBounds bounds;
    std::vector<Mode> modes;
    bool isComplete = true;
};

ModeBounds parseBounds(const ModesCommand& words)
{
    ModeBounds bounds;
    if (!words.maxEnergyRatio.empty()) {
        bounds.maxEnergyRatio = parsePositive("--max-energy-ratio", words.maxEnergyRatio, "E_1");
    }
    if (!words.maxOrder.empty()) {
        bounds.maxOrder = parseWhole("--max-order", words.maxOrder, 1, maxModeOrder);
    }
    if (!words.maxPeriod.empty()) {
        bounds.maxPeriod = parsePositive("--max-period", words.maxPeriod, "L/c");
    }
    return bounds;
}

std::string asText(const ExactPeriod& period)
{
    return period.denominator == 1 ? fmt::format("{}", period.numerator)
                                   : fmt::format("{}/{}", period.numerator, period.denominator);
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
    text += fmt::format("\n{:<14}{:<18}{:<20}{:<14}{:<22}{:<17}{}\n", "t_c [L/c]", "T in [L/c]",
                        "ω/ω₁ in", "1/√(E/E₁)", "E/E₁ in", "lowest T", "family");
    for (const Mode& mode : listing.modes) {
        const EnergyRange energy = energyRange(mode);
        text += fmt::format(
            "{:<14}{:<18}{:<20}{:<14}{:<22}{:<17}{}\n",
            fmt::format("{} - {}", 4 * mode.a, timesT(-mode.b)),
            fmt::format("]{}, {}[", asText(mode.lowest), asText(mode.highest)),
            fmt::format("]{:.6g}, {:.6g}[", 4.0 / mode.highest.value(), 4.0 / mode.lowest.value()),
            rootAsText(mode), fmt::format("]{:.6g}, {:.6g}[", energy.least, energy.most),
            name(mode.lowestEnd), familyName(mode));
    }
    return text;
}

Json asJson(const Mode& mode)
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
    if (const std::string family = familyName(mode); !family.empty()) {
        json["family"] = family;
    }
    return json;
}

std::string asJson(const Listing& listing)
{
    Json json{{"complete", listing.isComplete},
                                {"max_order", listing.bounds.maxOrder},
                                {"max_period", listing.bounds.maxPeriod},
                                {"max_energy_ratio", listing.bounds.maxEnergyRatio},
                                {"modes", Json::array()}};
    for (const Mode& mode : listing.modes) {
        json["modes"].push_back(asJson(mode));
    }
    return json.dump() + "\n";
}

}  // namespace

void ModesCommand::addTo(CLI::App& command)
{
    command
        .add_option("--max-energy-ratio", maxEnergyRatio,
                    "only modes with a motion of E/E_1 <= X (50)")
        ->type_name("X");
    command.add_option("--max-order", maxOrder, "only contact times 4a + b T with |b| <= B (25)")
        ->type_name("B");
    command.add_option("--max-period", maxPeriod, "only modes with a motion of T <= X, in L/c (8)")
        ->type_name("T");
    command
        .add_option("--figure", figureFile, "draw them, energy against frequency (needs gnuplot)")
        ->type_name("FILE.svg|.png|.pdf");
    common.addTo(command);
    command.footer(
        "Everything is in units of L/c and E_1: it holds for every bar and every grid, whatever "
        "their "
        "options.");
}

ExitStatus ModesCommand::run() const
{
    (void)common.parseCells();
    (void)common.parseBar();
    (void)common.parseThreads();
    const bool json = common.wantsJson();
    Listing listing{parseBounds(*this), {}};
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
        listing.bounds.cancel = interrupt.token();
        listing.modes = findModes(listing.bounds);
        listing.isComplete = !interrupt.token().stop_requested();
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
    writeOut(json ? asJson(listing) : asText(listing));
    return listing.isComplete ? exitFound : exitUndecided;
}

}  // namespace signorini::cli
