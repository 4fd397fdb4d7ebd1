#include "reports.hpp"

#include <fmt/ranges.h>

#include <cmath>

#include "printing.hpp"

namespace signorini::cli {

namespace {

std::string asText(double low, double high)
{
    return fmt::format("]{:.6g}, {:.6g}[", low, high);
}

std::string rootAsText(const ModePolytope& polytope)
{
    std::string form = linearAsText(polytope.kappa, polytope.mu);
    if (polytope.divisor == 1) {
        return form;
    }
    return polytope.kappa == 0 ? fmt::format("{}/{}", form, polytope.divisor)
                               : fmt::format("({})/{}", form, polytope.divisor);
}

}  // namespace

std::string chainsAsText(const std::vector<ModeChain>& chains)
{
    std::string text;
    for (const ModeChain& chain : chains) {
        text += fmt::format("{}{}/{}→{}", text.empty() ? "" : " ", chain.k, chain.turns,
                            chain.release + 1);
    }
    return text;
}

std::string asText(const answers::PolytopeList& listing)
{
    std::string text = fmt::format(
        "{} types of motions with {} contacts of order ≤ {}, T ≤ {} L/c, E ≤ {} E₁{}\n",
        listing.polytopes.size(), listing.phases, listing.bounds.maxOrder, listing.bounds.maxPeriod,
        listing.bounds.maxEnergyRatio, unlessComplete(listing.isComplete));
    if (listing.polytopes.empty()) {
        return text;
    }
    const Scales unit = scales(listing.bar);
    const auto width = static_cast<int>(8 * listing.phases + 3);
    text += fmt::format("\n{:<{}}{:<6}{:<18}{:<22}{:<24}{:<14}{:<15}{:<22}{}\n", "k/turns→release",
                        width, "free", "T in [L/c]", "ω/ω₁ in", "frequency in [Hz]",
                        "contact [L/c]", "1/√(E/E₁)", "E/E₁ in", "lowest T");
    for (const ModePolytope& polytope : listing.polytopes) {
        const EnergyRange energy = energyRange(polytope);
        const double low = polytope.lowest.value();
        const double high = polytope.highest.value();
        text += fmt::format(
            "{:<{}}{:<6}{:<18}{:<22}{:<24}{:<14}{:<15}{:<22}{}\n", chainsAsText(polytope.chains),
            width, polytope.dimension,
            fmt::format("]{}, {}[", fractionAsText(polytope.lowest),
                        fractionAsText(polytope.highest)),
            asText(4.0 / high, 4.0 / low),
            asText(1.0 / (high * unit.time), 1.0 / (low * unit.time)),
            linearAsText(-polytope.order, -std::get<0>(answers::contactOf(polytope))),
            rootAsText(polytope), asText(energy.least, energy.most), name(polytope.lowestEnd));
    }
    return text;
}

void writePolytopesCsv(const std::string& path, const answers::PolytopeList& listing)
{
    constexpr int periods = 20;
    std::string header = "type,free_times,period_ratio,frequency_ratio,energy_ratio,frequency";
    const double unit = scales(listing.bar).time;
    for (std::int64_t l = 1; l <= listing.phases; ++l) {
        header += fmt::format(",contact_{}_ratio,flight_{}_ratio", l, l);
    }
    writeCsv(path, header, [&](CsvRows& row) {
        for (const ModePolytope& polytope : listing.polytopes) {
            for (int k = 0; k < periods; ++k) {
                const double period = std::lerp(polytope.lowest.value(), polytope.highest.value(),
                                                (k + 0.5) / periods);
                for (const ModePoint& corner : slice(polytope, period)) {
                    std::vector<double> times = stretches(polytope, corner);
                    for (double& time : times) {
                        time = std::max(time, 0.0);  // 0 but for rounding
                    }
                    row(chainsAsText(polytope.chains), polytope.dimension, period, 4.0 / period,
                        energyRatio(polytope, period), 1.0 / (period * unit),
                        fmt::format("{}", fmt::join(times, ",")));
                }
            }
        }
    });
}

}  // namespace signorini::cli
