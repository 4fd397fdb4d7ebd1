#include "commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "files.hpp"
#include "given.hpp"
#include "interrupt.hpp"
#include "json.hpp"
#include "mode_report.hpp"
#include "polytopes_report.hpp"
#include "progress.hpp"
#include "report.hpp"
#include "signorini/figures.hpp"
#include "signorini/modes.hpp"

namespace signorini::cli {

namespace {

double hertz(const ExactPeriod& period, const Scales& unit)
{
    return 1.0 / (period.value() * unit.time);
}

std::string asText(const answers::ModeList& listing)
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

/// The periods of a mode with E/E_1 <= most: |kappa T - mu| >= 1/sqrt(most).
std::pair<double, double> periodsUpTo(const Mode& mode, double most)
{
    double low = mode.lowest.value();
    double high = mode.highest.value();
    const double end = (static_cast<double>(mode.mu) + mode.gapSign / std::sqrt(most)) /
                       static_cast<double>(mode.kappa);
    const bool isFromBelow = mode.gapSign * mode.kappa > 0;
    (isFromBelow ? low : high) = isFromBelow ? std::max(low, end) : std::min(high, end);
    return {low, high};
}

/// Motions inside the interval of each mode, evenly in T, with no more than the energy asked for.
void writeCurves(const std::string& path, const answers::ModeList& listing)
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

/// Runs search(bounds) with progress on stderr until it ends or is interrupted. \returns was it let
/// finish?
template <typename Search>
bool runSearch(ModeBounds& bounds, const CommonOptions& common, Search search)
{
    const Interrupt interrupt;
    Progress progress(!common.quiet, "listing modes", common.progressFile);
    bounds.cancel = interrupt.cancel();
    bounds.progress = [&progress](double done, double total) { progress.show(done, total); };
    search(bounds);
    return !isRequested(interrupt.cancel());
}

/// Orders that a few seconds list, by number of contacts.
std::int64_t usualOrder(std::int64_t phases)
{
    constexpr std::array<std::int64_t, maxPolytopePhases> orders{25, 25, 9, 5, 3};
    return orders[static_cast<std::size_t>(phases - 1)];
}

}  // namespace

ExitStatus runModes(const Given& given)
{
    const CommonOptions common(given);
    const std::int64_t phases = given.whole("--phases").value_or(1);
    const auto maxOrder = given.whole("--max-order");
    // Several contacts are known for a gap > 0.
    const Bar bar = phases == 1 ? common.barOfAnyGap() : common.bar();
    if (phases > 1 && maxOrder && *maxOrder > maxPolytopeOrder) {
        refuse("--max-order", fmt::format("{}", *maxOrder),
               fmt::format("whole numbers 1..{} with several contacts", maxPolytopeOrder));
    }
    ModeBounds all;
    all.maxEnergyRatio = given.number("--max-energy-ratio").value_or(all.maxEnergyRatio);
    all.maxOrder = maxOrder.value_or(usualOrder(phases));
    all.maxPeriod =
        given.number("--max-period").value_or(std::max(8.0, 4.0 * static_cast<double>(phases)));
    all.gapSign = gapSignOfModes(bar);
    FrequencyEnergyOptions drawing;
    if (given.has("--figure")) {
        if (bar.gap < 0.0) {
            throw std::invalid_argument(
                "--figure: allowed with a gap > 0, whose plot it is; --csv holds the curves");
        }
        drawing.bar = bar;
        // From the lowest energy there is to where curves are upright lines.
        drawing.maxEnergyRatio = std::clamp(all.maxEnergyRatio, 2.0, 1e6);
    }
    answers::ModeList listing{all, bar, {}};
    answers::PolytopeList polytopes{phases, all, bar, {}};
    Outputs outputs(given, {"--csv", "--figure"});
    const bool isComplete = runSearch(all, common, [&](const ModeBounds& searched) {
        if (phases == 1) {
            listing.modes = findModes(searched);
        } else {
            polytopes.polytopes = findPolytopes(phases, searched);
        }
    });
    listing.isComplete = isComplete;
    polytopes.isComplete = isComplete;
    if (!isComplete && !common.quiet) {
        tell(fmt::format("signorini modes: interrupted; the list is not complete{}\n",
                         outputs.areWanted() ? ", so no file was written" : ""));
    }
    if (isComplete) {
        outputs.put("--csv", [&](const std::string& path) {
            phases == 1 ? writeCurves(path, listing) : writePolytopes(path, polytopes);
        });
        outputs.put("--figure", [&](const std::string& path) {
            if (phases == 1) {
                drawFigure(frequencyEnergyFigure({.modes = listing.modes}, drawing),
                           figureFormat(given.text("--figure")), path);
            } else {
                drawFigure(polytopesFigure(polytopes.polytopes, drawing),
                           figureFormat(given.text("--figure")), path);
            }
        });
        outputs.commit();
    }
    if (phases == 1) {
        writeOut(common.wantsJson ? asLine(wholeJsonOf(listing))
                                  : common.restated() + asText(listing));
    } else {
        writeOut(common.wantsJson ? asLine(wholeJsonOf(polytopes))
                                  : common.restated() + asText(polytopes));
    }
    common.useOneThread("modes");
    return isComplete ? exitFound : exitUndecided;
}

}  // namespace signorini::cli
