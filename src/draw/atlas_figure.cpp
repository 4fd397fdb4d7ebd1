#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>
#include <vector>

#include "signorini/figures.hpp"
#include "signorini/modes.hpp"

namespace signorini {

namespace {

using namespace plot;

constexpr double plotWidth = 14.0;  ///< [cm]

/// Longest flight drawn: beyond, there are only repetitions of linear motions.
constexpr double longestFlight = 4.0;

/// Families whose tents are named, and how far apart the names stand.
constexpr std::int64_t maxNamedOrder = 7;
constexpr double nameDistance = 0.11;  ///< [L/c]

/// What the map shows of an atlas.
struct Map {
    Series pressing = plot::dots(Role::ink);
    Series grazing = plot::dots(Role::faint);
    std::vector<Family> tents;  ///< those to be named, by ascending order
    double contactTime = 0.0;   ///< [L/c], longest drawn
    double flightTime = 0.0;    ///< [L/c], longest drawn
    double energy = 10.0;       ///< [E_1], the largest of the least ones
    double cells = 1.0;         ///< of the finest grid

    Map(const AtlasDatabase& atlas, std::optional<std::int64_t> of)
    {
        atlas.forEachFound(of, [this](const AtlasEntry& entry) { add(entry); });
        if (pressing.x.empty() && grazing.x.empty()) {
            contactTime = 2.0;  // the usual range
            flightTime = longestFlight;
        }
        std::sort(tents.begin(), tents.end(), [](const Family& x, const Family& y) {
            return std::tie(x.order, x.blocks, x.contactBlocks) <
                   std::tie(y.order, y.blocks, y.contactBlocks);
        });
        const double dot = std::clamp(60.0 / cells, 0.18, 1.0);
        pressing.size = 1.25 * dot;
        grazing.size = 0.75 * dot;
    }

private:
    void add(const AtlasEntry& entry)
    {
        if (entry.schedule.phases.size() != 1) {
            return;
        }
        const auto size = static_cast<double>(entry.schedule.cells);
        const Phase& phase = entry.schedule.phases.front();
        const double contact = static_cast<double>(phase.contact) / size;
        const double flight = static_cast<double>(phase.free) / size;
        if (flight > longestFlight) {
            return;
        }
        contactTime = std::max(contactTime, contact);
        flightTime = std::max(flightTime, flight);
        cells = std::max(cells, size);
        if (entry.row.contact != Contact::pressing) {
            grazing.add(flight, contact);
            return;
        }
        pressing.add(flight, contact);
        pressing.z.push_back(entry.row.energy.least);
        energy = std::max(energy, entry.row.energy.least);
        const std::optional<TentPlace> place = familyOf(entry.schedule);
        if (place && place->offset == 0 && place->family.order <= maxNamedOrder) {
            tents.push_back(place->family);
        }
    }
};

/// Names at the upper ends of tents, t_c = (2k + 2)/w: left of those that end at t_f = 2, above
/// the others; of names that would meet the first.
void addNames(Panel& panel, std::span<const Family> tents)
{
    Series left = plot::labels(0.8, Align::right);
    Series above{.kind = Kind::words, .size = 0.8, .turn = 45.0};
    std::vector<std::array<double, 2>> taken;
    for (const Family& family : tents) {
        const auto order = static_cast<double>(family.order);
        const double contact = 2.0 * static_cast<double>(family.contactBlocks + 1) / order;
        const double flight = exactPeriod(family).value() - contact;
        const bool isFree = std::none_of(taken.begin(), taken.end(), [&](const auto& other) {
            return std::hypot(flight - other[0], contact - other[1]) < nameDistance;
        });
        if (isFree) {
            taken.push_back({flight, contact});
            (flight < 2.01 ? left : above)
                .add(flight, contact,
                     fmt::format(" ({}, {}, {}) ", family.order, family.blocks,
                                 family.contactBlocks));
        }
    }
    panel.add(std::move(left));
    panel.add(std::move(above));
}

}  // namespace

FigureData frequencyEnergyFigure(const AtlasDatabase& atlas, std::optional<std::int64_t> cells,
                                 const FrequencyEnergyOptions& options)
{
    std::set<std::array<std::int64_t, 3>> seen;  // on several grids, each once
    std::vector<Family> onGrid;
    std::vector<EnergyBar> bars;
    const auto addBar = [&bars](const auto& row, const EnergyRange& energy, Contact contact) {
        bars.push_back({.frequencyRatio = frequencyRatio(row),
                        .least = energy.least,
                        .most = energy.most,
                        .contact = contact});
    };
    atlas.forEachFamily(cells, [&](const AtlasFamily& all) {
        if (!all.family) {
            addBar(all, all.energy, Contact::grazing);
        } else if (seen.insert({all.family->order, all.family->blocks, all.family->contactBlocks})
                       .second) {
            onGrid.push_back(*all.family);
        }
    });
    atlas.forEachFound(
        cells, [&](const AtlasEntry& entry) { addBar(entry, entry.row.energy, entry.row.contact); },
        AtlasSchedules::withoutFamily);
    const std::vector<Mode> modes = findModes();
    const std::vector<Family> families = findFamilies(options.maxOrder);
    return frequencyEnergyFigure(
        {.modes = modes, .families = families, .onGrid = onGrid, .bars = bars}, options);
}

FigureData existenceFigure(const AtlasDatabase& atlas, std::optional<std::int64_t> cells)
{
    Map map(atlas, cells);
    // Both times to one scale, so that lines of equal period run at 45 degrees.
    const double height = std::clamp(plotWidth * map.contactTime / map.flightTime, 2.0, plotWidth);
    FigureData figure{.width = plotWidth + 5.0, .height = height + 3.2};
    const double bottom = 1.7 / figure.height;
    const double top = bottom + height / figure.height;
    const double right = (1.8 + plotWidth) / figure.width;
    Panel& panel = figure.add({.name = "map", .place = {1.8 / figure.width, right, bottom, top}});
    panel.isEqual = true;
    panel.legend = Legend::above;
    panel.x = {.label = "flight time  t_f  [L/c]", .low = 0.0, .high = map.flightTime * 1.01};
    panel.y = {.label = "contact time  t_c  [L/c]", .low = 0.0, .high = map.contactTime * 1.01};
    panel.map = ColourMap::onPaper;
    panel.colour = {.label = "least energy  E_{min}/E_1",
                    .low = 1.0,
                    .high = map.energy,
                    .isLogarithmic = true};
    panel.colourBar = Place{right + 0.03, right + 0.05, bottom, top};
    if (!map.grazing.x.empty()) {
        panel.explain(dots(Role::faint), "grazing: contact without force");
    }
    if (!map.pressing.x.empty()) {
        panel.explain(dots(Role::shade2), "pressing: tents of families (w, ν, k)");
    }
    panel.add(std::move(map.grazing));
    panel.add(std::move(map.pressing));
    addNames(panel, map.tents);
    return figure;
}

}  // namespace signorini
