#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "faults.hpp"
#include "gnuplot.hpp"
#include "palette.hpp"
#include "signorini/figures.hpp"
#include "text.hpp"

namespace signorini {

namespace {

constexpr int periods = 60;

/// The period at a part of the interval; parts near 0 and 1 stand for the ends.
double periodAt(const ModePolytope& polytope, int k)
{
    const double part = std::clamp(static_cast<double>(k) / periods, 1e-6, 1.0 - 1e-6);
    return std::lerp(polytope.lowest.value(), polytope.highest.value(), part);
}

/// The least and the most that the first contact may last.
std::pair<double, double> firstContact(const ModePolytope& polytope, double period)
{
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const ModePoint& corner : slice(polytope, period)) {
        const double contact = std::max(0.0, stretches(polytope, corner).front());
        least = std::min(least, contact);
        most = std::max(most, contact);
    }
    return {least, most};
}

std::int64_t contactSum(const ModePolytope& polytope)
{
    std::int64_t sum = 0;
    for (const ModeChain& chain : polytope.chains) {
        sum += 2 * chain.k;
    }
    return sum;
}

/// A block for each sort: T, omega/omega_1, E/E_1, first contact from, to.
void printCurves(Text& script, const char* name, std::span<const ModePolytope> polytopes,
                 bool areIsolated)
{
    print(script, "${} << EOD\n{}", name, "NaN NaN NaN NaN NaN\n\n");
    for (const ModePolytope& polytope : polytopes) {
        if ((polytope.dimension == 0) != areIsolated) {
            continue;
        }
        for (int k = 0; k <= periods; ++k) {
            const double period = periodAt(polytope, k);
            const auto [least, most] = firstContact(polytope, period);
            print(script, "{:.7g} {:.7g} {:.6g} {:.6g} {:.6g}\n", period, 4.0 / period,
                  energyRatio(polytope, period), least, most);
        }
        print(script, "\n");
    }
    print(script, "EOD\n");
}

/// One-contact modes for comparison: omega/omega_1, E/E_1, and where run K times.
void printModes(Text& script, double phases, double maxEnergyRatio)
{
    ModeBounds bounds;
    bounds.maxEnergyRatio = maxEnergyRatio;
    print(script, "$modes << EOD\nNaN NaN NaN\n\n");
    for (const Mode& mode : findModes(bounds)) {
        for (int k = 0; k <= periods; ++k) {
            const double part = std::clamp(static_cast<double>(k) / periods, 1e-6, 1.0 - 1e-6);
            const double period = std::lerp(mode.lowest.value(), mode.highest.value(), part);
            print(script, "{:.7g} {:.6g} {:.7g}\n", 4.0 / period, energyRatio(mode, period),
                  4.0 / (phases * period));
        }
        print(script, "\n");
    }
    print(script, "EOD\n");
}

/// The contact of the widest types, where it begins; of several that begin there the first.
void printLabels(Text& script, std::span<const ModePolytope> polytopes, double width)
{
    constexpr double least = 0.02;
    std::set<std::pair<double, double>> places;
    for (const ModePolytope& polytope : polytopes) {
        const double low = polytope.lowest.value();
        const double contact = firstContact(polytope, periodAt(polytope, 0)).second;
        const bool isNew = places.emplace(low, std::round(1e3 * contact)).second;
        if (isNew && polytope.highest.value() - low > least * width) {
            print(script,
                  "set label \"{} − {}T\" at {:.6g},{:.6g} right offset -0.4,0 front "
                  "font ',9'\n",
                  contactSum(polytope), polytope.order, low, contact);
        }
    }
}

}  // namespace

void drawPolytopes(std::span<const ModePolytope> polytopes, const FrequencyEnergyOptions& options,
                   const std::string& path)
{
    if (polytopes.empty()) {
        throw std::invalid_argument("figure: the list holds no motion to draw");
    }
    if (!(options.maxEnergyRatio > 1.0)) {
        throw std::invalid_argument(fmt::format("maxEnergyRatio = {} is out of range: allowed > 1",
                                                options.maxEnergyRatio));
    }
    const auto phases = static_cast<double>(polytopes.front().chains.size());
    double low = std::numeric_limits<double>::infinity();
    double high = 0.0;
    double longest = 0.0;
    for (const ModePolytope& polytope : polytopes) {
        low = std::min(low, polytope.lowest.value());
        high = std::max(high, polytope.highest.value());
        longest = std::max(longest, firstContact(polytope, periodAt(polytope, 0)).second);
    }
    const double margin = 0.06 * (high - low) + 0.05;
    Text script;
    printCurves(script, "continua", polytopes, false);
    printCurves(script, "isolated", polytopes, true);
    printModes(script, phases, options.maxEnergyRatio);
    const char* free = palette::sequence[3];
    print(script,
          "set multiplot\nset border lw 0.8\nset tics out nomirror scale 0.6\n"
          "set grid lw 0.4 lc '{}'\nset lmargin at screen 0.13\nset rmargin at screen 0.97\n"
          "set style fill transparent solid 0.35 noborder\n",
          palette::grid);
    printLabels(script, polytopes, high - low);
    print(script,
          "set tmargin at screen 0.96\nset bmargin at screen 0.60\nset xrange [{:.6g}:{:.6g}]\n"
          "set yrange [0:{:.6g}]\nset xlabel 'period  T  [L/c]' offset 0,0.4\n"
          "set ylabel 'first contact  [L/c]'\n"
          "set key top right reverse Left samplen 2 spacing 1.1\n"
          "plot $continua using 1:4:5 with filledcurves lc '{}' title "
          "'contact shared freely', $continua using 1:4 with lines lw 1 lc '{}' notitle, "
          "$continua using 1:5 with lines lw 1 lc '{}' notitle, "
          "$isolated using 1:4 with lines lw 2 dt (8,3) lc '{}' title 'isolated at each T'\n",
          low - margin, high + margin, 1.3 * longest, free, free, free, palette::contact);
    // Beyond 2 omega_1 the same comes again, higher.
    const double right = options.maxFrequencyRatio.value_or(std::min(2.0, 4.0 / low));
    print(
        script,
        "unset label\nset key top left font ',9'\nset tmargin at screen 0.50\nset bmargin at "
        "screen "
        "0.09\n"
        "set xrange [0:{:.6g}]\nset yrange [1:{:.6g}]\nset logscale y\n"
        "set xlabel 'frequency  ω/ω_1 = 4L/(cT)' offset 0,0.4\nset ylabel 'energy  E/E_1'\n"
        "plot $modes using 1:2 with lines lw 1 lc '{}' title 'one contact', "
        "$modes using 3:2 with lines lw 1.2 dt (1.5,3) lc '{}' title 'one contact, {:.0f} times', "
        "$continua using 2:3 with lines lw 3 lc '{}' title '{:.0f} contacts: shared freely', "
        "$isolated using 2:3 with lines lw 2 dt (8,3) lc '{}' title "
        "'{:.0f} contacts: isolated'\nunset multiplot\n",
        1.04 * right, options.maxEnergyRatio, palette::faint, palette::ink, phases, free, phases,
        palette::contact, phases);
    runGnuplot(fmt::to_string(script), options.format ? *options.format : figureFormat(path), 16.0,
               17.0, path);
}

}  // namespace signorini
