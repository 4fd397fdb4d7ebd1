#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "axes.hpp"
#include "faults.hpp"
#include "modes_answer.hpp"
#include "signorini/figures.hpp"

namespace signorini {

namespace {

using namespace plot;

constexpr int periods = 60;

/// The period at a part of the interval of a polytope or a mode; parts near 0 and 1 stand for the
/// ends.
double periodAt(const auto& of, int k)
{
    const double part = std::clamp(static_cast<double>(k) / periods, 1e-6, 1.0 - 1e-6);
    return std::lerp(of.lowest.value(), of.highest.value(), part);
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

/// Those of one sort: the first contact over T, from and to, and E/E_1 over ω/ω_1.
struct Curves {
    Series least;
    Series most;
    Series energy;
};

Curves curvesOf(std::span<const ModePolytope> polytopes, bool areIsolated, const Series& style)
{
    Curves curves{style, style, style};
    for (const ModePolytope& polytope : polytopes) {
        if ((polytope.dimension == 0) != areIsolated) {
            continue;
        }
        for (int k = 0; k <= periods; ++k) {
            const double period = periodAt(polytope, k);
            const auto [least, most] = firstContact(polytope, period);
            curves.least.add(period, least);
            curves.most.add(period, most);
            curves.energy.add(4.0 / period, energyRatio(polytope, period));
        }
        for (Series* series : {&curves.least, &curves.most, &curves.energy}) {
            series->breakOff();
        }
    }
    return curves;
}

/// One-contact modes for comparison, and where they run K times.
void addModes(Panel& panel, double phases, double maxEnergyRatio)
{
    ModeBounds bounds;
    bounds.maxEnergyRatio = maxEnergyRatio;
    Series once = plot::line(Role::faint, 1.0).named("one contact");
    Series often =
        line(Role::ink, 1.0, Dash::dotted).named(fmt::format("one contact, {:.0f} times", phases));
    for (const Mode& mode : findModes(bounds)) {
        for (int k = 0; k <= periods; ++k) {
            const double period = periodAt(mode, k);
            once.add(4.0 / period, energyRatio(mode, period));
            often.add(4.0 / (phases * period), energyRatio(mode, period));
        }
        once.breakOff();
        often.breakOff();
    }
    panel.add(std::move(once));
    panel.add(std::move(often));
}

/// The contact of the widest types, where it begins; of several that begin there the first.
Series labelsOf(std::span<const ModePolytope> polytopes, double width)
{
    constexpr double least = 0.02;
    Series labels = plot::labels(0.8, Align::right);
    std::set<std::pair<double, double>> places;
    for (const ModePolytope& polytope : polytopes) {
        const double low = polytope.lowest.value();
        const double contact = firstContact(polytope, periodAt(polytope, 0)).second;
        const bool isNew = places.emplace(low, std::round(1e3 * contact)).second;
        if (isNew && polytope.highest.value() - low > least * width) {
            labels.add(low, contact,
                       fmt::format("{} − {}T ", std::get<0>(answers::contactOf(polytope)),
                                   polytope.order));
        }
    }
    return labels;
}

}  // namespace

FigureData polytopesFigure(std::span<const ModePolytope> polytopes,
                           const FrequencyEnergyOptions& options)
{
    if (polytopes.empty()) {
        throw std::invalid_argument("figure: the list holds no motion to draw");
    }
    const double top = topOf(options);
    if (!(top > 1.0)) {
        throwFault("maxEnergyRatio", top, "> 1");
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
    FigureData figure{.width = 16.0, .height = 19.0};
    Panel above{.name = "contact", .place = {0.12, 0.96, 0.69, 0.97}, .legend = Legend::topRight};
    above.x = {.label = "period  T  [L/c]", .low = low - margin, .high = high + margin};
    above.y = {.label = "first contact  [L/c]", .low = 0.0, .high = 1.3 * longest};
    // Beyond 2 omega_1 the same comes again, higher.
    const double right = 1.04 * options.maxFrequencyRatio.value_or(std::min(2.0, 4.0 / low));
    Panel below{.name = "energy",
                .place = {0.12, 0.96, 0.19, 0.54},
                .legend = Legend::below,
                .legendRows = 2};
    below.x = frequencyAxis("frequency", std::min(0.93 * 4.0 / high, 0.96), right, options.bar);
    below.y = {.label = "energy  E/E_1", .low = 1.0, .high = top, .isLogarithmic = true};
    Curves free = curvesOf(polytopes, false, {.role = Role::strain, .width = 1.0});
    Curves alone = curvesOf(polytopes, true, {.role = Role::contact, .width = 0.8});
    if (!free.least.x.empty()) {
        Series band = free.least;
        band.kind = Kind::band;
        band.opacity = 0.35;
        band.y2 = free.most.y;
        band.legend = "contact shared freely";
        above.add(std::move(band));
    }
    free.energy.legend = fmt::format("{:.0f} contacts: shared freely", phases);
    alone.energy.legend = fmt::format("{:.0f} contacts: isolated", phases);
    alone.least.legend = "isolated at each T";
    above.add(std::move(free.least));
    above.add(std::move(free.most));
    above.add(std::move(alone.least));
    above.add(labelsOf(polytopes, high - low));
    addModes(below, phases, top);
    below.add(std::move(free.energy));
    below.add(std::move(alone.energy));
    figure.panels = {std::move(above), std::move(below)};
    return figure;
}

}  // namespace signorini
