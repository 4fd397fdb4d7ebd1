#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>
#include <vector>

#include "gnuplot.hpp"
#include "palette.hpp"
#include "signorini/figures.hpp"
#include "signorini/modes.hpp"
#include "text.hpp"

namespace signorini {

namespace {

constexpr double plotWidth = 14.0;  ///< [cm]

/// Longest flight drawn: beyond, there are only repetitions of linear motions.
constexpr double longestFlight = 4.0;

/// Families whose tents are named, and how far apart the names stand.
constexpr std::int64_t maxNamedOrder = 7;
constexpr double nameDistance = 0.11;  ///< [L/c]

/// Families of any grid that the frequency-energy plot shows.
constexpr std::int64_t maxShadedOrder = 60;

/// What the map shows of an atlas.
struct Map {
    Text pressing;              ///< flight, contact, least energy
    Text grazing;               ///< flight, contact
    std::vector<Family> tents;  ///< those to be named, by ascending order
    double contactTime = 0.0;   ///< [L/c], longest drawn
    double flightTime = 0.0;    ///< [L/c], longest drawn
    double energy = 1.0;        ///< [E_1], the largest of the least ones
    double cells = 1.0;         ///< of the finest grid

    Map(const AtlasDatabase& atlas, std::optional<std::int64_t> of)
    {
        atlas.forEachFound(of, [this](const AtlasEntry& entry) { add(entry); });
        if (pressing.size() == 0 && grazing.size() == 0) {
            contactTime = 2.0;  // the usual range
            flightTime = longestFlight;
        }
        std::sort(tents.begin(), tents.end(), [](const Family& x, const Family& y) {
            return std::tie(x.order, x.blocks, x.contactBlocks) <
                   std::tie(y.order, y.blocks, y.contactBlocks);
        });
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
            print(grazing, "{:.6g} {:.6g}\n", flight, contact);
            return;
        }
        print(pressing, "{:.6g} {:.6g} {:.4g}\n", flight, contact, entry.row.energy.least);
        energy = std::max(energy, entry.row.energy.least);
        const std::optional<TentPlace> place = familyOf(entry.schedule);
        if (place && place->offset == 0 && place->family.order <= maxNamedOrder) {
            tents.push_back(place->family);
        }
    }
};

/// Names at the upper ends of tents, t_c = (2k + 2)/w: left of those that end at t_f = 2, above
/// the others; of names that would meet the first.
void printNames(Text& script, std::span<const Family> tents)
{
    Text left;
    Text above;
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
            print(flight < 2.01 ? left : above, "{:.6g} {:.6g} \"{{/*0.8 ({}, {}, {})}}\"\n",
                  flight, contact, family.order, family.blocks, family.contactBlocks);
        }
    }
    print(script, "$left << EOD\n{0}{2}EOD\n$above << EOD\n{1}{2}EOD\n", fmt::to_string(left),
          fmt::to_string(above), offThePlot);
}

}  // namespace

void drawFrequencyEnergyPlot(const AtlasDatabase& atlas, std::optional<std::int64_t> cells,
                             FigureFormat format, const std::string& path)
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
    const std::vector<Family> families = findFamilies(maxShadedOrder);
    writeFrequencyEnergyFigure(
        path, {.modes = modes, .families = families, .onGrid = onGrid, .bars = bars},
        {.format = format, .maxFrequencyRatio = {}});
}

void drawExistenceMap(const AtlasDatabase& atlas, std::optional<std::int64_t> cells,
                      FigureFormat format, const std::string& path)
{
    const Map map(atlas, cells);
    Text script;
    const auto table = [&script](const char* name, const Text& rows) {
        print(script, "${} << EOD\n{}EOD\n", name, fmt::to_string(rows));
    };
    table("pressing", map.pressing);
    table("grazing", map.grazing);
    printNames(script, map.tents);
    // Both times to one scale, so that lines of equal period run at 45 degrees.
    const double height = std::clamp(plotWidth * map.contactTime / map.flightTime, 2.0, plotWidth);
    const double dot = std::clamp(60.0 / map.cells, 0.18, 1.0);
    print(script,
          "set size ratio -1\nset border lw 0.8\nset tics out nomirror scale 0.6\n"
          "set grid lw 0.4 lc '{}'\nset xrange [0:{}]\nset yrange [0:{}]\n"
          "set xlabel 'flight time  t_f  [L/c]'\nset ylabel 'contact time  t_c  [L/c]'\n"
          "{}set logscale cb\nset cbrange [1:{}]\nset format cb '10^{{%L}}'\n"
          "set cblabel 'least energy  E_{{min}}/E_1' offset 1,0\n"
          "set key above left Left reverse samplen 1\nplot NaN notitle, ",
          palette::grid, map.flightTime * 1.01, map.contactTime * 1.01,
          palette::sequential(palette::onPaper), std::max(map.energy, 10.0));
    if (map.grazing.size() > 0) {
        print(script,
              "$grazing using 1:2 with points pt 7 ps {0} lc '{1}' notitle, "
              "NaN with points pt 7 ps 1 lc '{1}' title 'grazing: contact without force', ",
              0.6 * dot, palette::faint);
    }
    if (map.pressing.size() > 0) {
        print(script,
              "$pressing using 1:2:3 with points pt 7 ps {} lc palette notitle, "
              "NaN with points pt 7 ps 1 lc '{}' title 'pressing: tents of families (w, ν, k)', "
              "$left using 1:2:3 with labels right offset -0.5,0 notitle, "
              "$above using 1:2:3 with labels left rotate by 45 offset 0,0.4 notitle",
              dot, palette::sequence.at(3));
    }
    print(script, "\n");
    runGnuplot(fmt::to_string(script), format, plotWidth + 5.0, height + 2.6, path);
}

}  // namespace signorini
