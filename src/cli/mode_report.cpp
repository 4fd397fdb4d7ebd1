#include "reports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "printing.hpp"

namespace signorini::cli {

namespace {

/// "7T" or "T".
std::string timesT(std::int64_t factor)
{
    return factor == 1 ? "T" : fmt::format("{}T", factor);
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

}  // namespace

std::string contactAsText(const Mode& mode)
{
    return linearAsText(mode.b, -4 * mode.a);
}

std::string linearAsText(std::int64_t factor, std::int64_t less)
{
    if (factor == 0) {
        return fmt::format("{}", -less);
    }
    return factor > 0 ? fmt::format("{} - {}", timesT(factor), less)
                      : fmt::format("{} - {}", -less, timesT(-factor));
}

std::string rootAsText(const Mode& mode)
{
    return linearAsText(mode.kappa, mode.mu);
}

std::string asText(const answers::ModeAnswer& answer)
{
    const auto& [mode, bar, motion, gravity] = answer;
    const Scales unit = scales(bar);
    const Physical physical = physicalOf(motion.extremes(), bar);
    const std::string family = familyName(mode);
    const double energy = energyRatio(mode, motion.period());
    return fmt::format(
               "found       mode t_c = {}{}, T in ]{}, {}[ L/c\n"
               "period      {:.10g} s = {:.10g} L/c, ω/ω₁ = {:.10g}\n"
               "contact     {:.6g} s = {:.10g} L/c\n"
               "energy      {:.6g} J = {:.10g} E₁, 1/√(E/E₁) = {}\n"
               "waves       p = ±{:.6g} g/L with {} jumps in a period\n",
               contactAsText(mode), family.empty() ? "" : fmt::format(" ({})", family),
               fractionAsText(mode.lowest), fractionAsText(mode.highest),
               motion.period() * unit.time, motion.period(), 4.0 / motion.period(),
               motion.contactTime() * unit.time, motion.contactTime(), energy * unit.energy, energy,
               rootAsText(mode), motion.amplitude(), motion.jumpTimes().size()) +
           asText(physical);
}

std::string asText(const answers::ModeList& listing)
{
    std::string text =
        fmt::format("{} modes with |b| ≤ {}, T ≤ {} L/c, E ≤ {} E₁{}\n", listing.modes.size(),
                    listing.bounds.maxOrder, listing.bounds.maxPeriod,
                    listing.bounds.maxEnergyRatio, unlessComplete(listing.isComplete));
    if (listing.modes.empty()) {
        return text;
    }
    const Scales unit = scales(listing.bar);
    const auto hertz = [&unit](const ExactPeriod& period) {
        return 1.0 / (period.value() * unit.time);
    };
    text += fmt::format("\n{:<14}{:<18}{:<20}{:<24}{:<14}{:<22}{:<26}{:<17}{}\n", "t_c [L/c]",
                        "T in [L/c]", "ω/ω₁ in", "frequency in [Hz]", "1/√(E/E₁)", "E/E₁ in",
                        "energy in [J]", "lowest T", "family");
    for (const Mode& mode : listing.modes) {
        const EnergyRange energy = energyRange(mode);
        text += fmt::format(
            "{:<14}{:<18}{:<20}{:<24}{:<14}{:<22}{:<26}{:<17}{}\n", contactAsText(mode),
            fmt::format("]{}, {}[", fractionAsText(mode.lowest), fractionAsText(mode.highest)),
            fmt::format("]{:.6g}, {:.6g}[", 4.0 / mode.highest.value(), 4.0 / mode.lowest.value()),
            fmt::format("]{:.6g}, {:.6g}[", hertz(mode.highest), hertz(mode.lowest)),
            rootAsText(mode), fmt::format("]{:.6g}, {:.6g}[", energy.least, energy.most),
            fmt::format("]{:.6g}, {:.6g}[", energy.least * unit.energy, energy.most * unit.energy),
            name(mode.lowestEnd), familyName(mode));
    }
    return text;
}

void writeModesCsv(const std::string& path, const answers::ModeList& listing)
{
    constexpr int motions = 100;
    constexpr std::string_view header =
        "a4,b,period_ratio,frequency_ratio,contact_time_ratio,energy_ratio,frequency";
    const double unit = scales(listing.bar).time;
    writeCsv(path, header, [&](CsvRows& row) {
        for (const Mode& mode : listing.modes) {
            const auto [low, high] = periodsUpTo(mode, listing.bounds.maxEnergyRatio);
            for (int k = 0; k < motions; ++k) {
                const double period = low + (k + 0.5) / motions * (high - low);
                row(4 * mode.a, mode.b, period, 4.0 / period, contactTime(mode, period),
                    energyRatio(mode, period), 1.0 / (period * unit));
            }
        }
    });
}

}  // namespace signorini::cli
