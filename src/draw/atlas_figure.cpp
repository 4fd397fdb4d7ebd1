#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "atlas_scene.hpp"
#include "infinity.hpp"
#include "signorini/figures.hpp"
#include "signorini/modes.hpp"

namespace signorini {

namespace {

using namespace plot;

constexpr double plotWidth = 14.0;  ///< [cm]

/// Longest flight drawn of a bar with families: beyond, there are only repetitions of linear
/// motions.
constexpr double longestFlight = 4.0;

/// Families whose tents are named, and how far apart the names stand.
constexpr std::int64_t maxNamedOrder = 7;
constexpr double nameDistance = 0.11;  ///< [L/c]

/// What a map shows of an atlas: of bars in a row the schedules of one contact alone.
struct Map {
    Series pressing = plot::dots(Role::ink);
    Series grazing = plot::dots(Role::faint);
    Series undecided = plot::dots(Role::ink, 1.0, Marker::cross);
    std::vector<Family> tents;  ///< those to be named, by ascending order
    double contactTime = 0.0;   ///< [L/c], longest drawn
    double flightTime = 0.0;    ///< [L/c], longest drawn
    double cells = 1.0;         ///< of the finest grid

    Map(const AtlasDatabase& atlas, std::optional<std::int64_t> of, Stop contact, bool isOfFamilies)
        : contact_(contact)
    {
        if (isOfFamilies) {
            longest_ = longestFlight;
        }
        const auto show = [this](const AtlasEntry& entry) { add(entry); };
        // Of one contact families leave nothing undecided.
        isOfFamilies ? atlas.forEachFound(of, show) : atlas.forEachSchedule(of, show);
        if (flightTime == 0.0) {
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
        undecided.size = dot;
    }

private:
    void add(const AtlasEntry& entry)
    {
        if (entry.schedule.phases.size() != 1 || entry.row.status == Status::none ||
            (entry.isOfBars && entry.schedule.phases.front().stop != contact_)) {
            return;
        }
        const auto size = static_cast<double>(entry.schedule.cells);
        const Phase& phase = entry.schedule.phases.front();
        const double contact = static_cast<double>(phase.contact) / size;
        const double flight = static_cast<double>(phase.free) / size;
        if (flight > longest_) {
            return;
        }
        contactTime = std::max(contactTime, contact);
        flightTime = std::max(flightTime, flight);
        cells = std::max(cells, size);
        if (entry.row.status == Status::undecided) {
            undecided.add(flight, contact);
            return;
        }
        if (entry.row.contact != Contact::pressing) {
            grazing.add(flight, contact);
            return;
        }
        pressing.add(flight, contact);
        pressing.z.push_back(entry.row.energy.least);
        if (!entry.family) {
            return;
        }
        const std::optional<TentPlace> place = familyOf(entry.schedule);
        if (place && place->offset == 0 && place->family.order <= maxNamedOrder) {
            tents.push_back(place->family);
        }
    }

    Stop contact_;
    double longest_ = infinity;  ///< flight
};

/// The maps of an atlas, to one scale: one of one bar, whose stops share it, and one for each
/// contact of bars in a row.
struct Maps {
    std::vector<Map> all;
    bool areOfFamilies = false;
    std::string caption;
    double contactTime = 0.0;  ///< [L/c], longest drawn
    double flightTime = 0.0;   ///< [L/c], longest drawn
    Axis energy{.label = "least energy  E_{min}/E_1", .isLogarithmic = true};

    Maps(const AtlasDatabase& atlas, std::optional<std::int64_t> cells)
    {
        const std::vector<AtlasRun> runs = atlas.runs();
        const std::optional<Assembly> bars = barsOf(runs);
        areOfFamilies = hasFamilies(runs);
        caption = captionOf(runs, cells);
        const std::int64_t count = bars ? contactsOf(runs.front().range) : 1;
        const bool isRatio = unitsOf(runs, {}).isRatio;
        if (!isRatio) {
            energy.label = "least energy  E_{min}  [J]";
        }
        double lowest = isRatio ? 1.0 : infinity;
        double highest = isRatio ? 10.0 : 0.0;
        for (std::int64_t k = 0; k < count; ++k) {
            const Map& map = all.emplace_back(atlas, cells, static_cast<Stop>(k), areOfFamilies);
            contactTime = std::max(contactTime, map.contactTime);
            flightTime = std::max(flightTime, map.flightTime);
            for (const double least : map.pressing.z) {
                lowest = std::min(lowest, least);
                highest = std::max(highest, least);
            }
        }
        energy.low = std::isfinite(lowest) ? lowest : 1.0;
        energy.high = std::max(highest, 10.0 * *energy.low);
    }

    void explain(Panel& panel) const
    {
        const auto shows = [this](Series Map::*dots) {
            return std::any_of(all.begin(), all.end(),
                               [dots](const Map& map) { return !(map.*dots).x.empty(); });
        };
        if (shows(&Map::grazing)) {
            panel.explain(dots(Role::faint), "grazing: contact without force");
        }
        if (shows(&Map::pressing)) {
            panel.explain(dots(Role::shade2),
                          areOfFamilies ? "pressing: tents of families (w, ν, k)" : "pressing");
        }
        if (shows(&Map::undecided)) {
            panel.explain(dots(Role::ink, 1.0, Marker::cross), "undecided");
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

std::string captionOf(const std::vector<AtlasRun>& runs, std::optional<std::int64_t> cells)
{
    constexpr std::size_t longest = 60;  ///< words of a scene
    if (hasFamilies(runs)) {
        return {};
    }
    const AtlasRange& range = runs.front().range;
    std::string scene =
        range.bars ? textOf(range.bars->parts) : fmt::format("segments {}", sceneText(range));
    if (scene.size() > longest) {
        scene = scene.substr(0, longest) + "…";
    }
    if (range.gapSign < 0) {
        scene += ",  pressed at rest";
    }
    if (range.bars && range.bars->gravity != 0.0) {
        scene += fmt::format(",  gravity {:.4g} m/s²", range.bars->gravity);
    }
    return fmt::format("{},  N = {}", scene, cells.value_or(range.cells));
}

answers::AtlasUnits unitsOf(const std::vector<AtlasRun>& runs, const Bar& bar)
{
    const std::optional<Assembly> bars = barsOf(runs);
    return bars ? answers::atlasUnitsOf(*bars) : answers::atlasUnitsOf(bar);
}

FigureData existenceFigure(const AtlasDatabase& atlas, std::optional<std::int64_t> cells)
{
    constexpr double below = 1.7;  // [cm], for the axis of each
    Maps maps(atlas, cells);
    const double above = maps.caption.empty() ? 1.5 : 2.3;  // [cm], for legend and caption
    // Both times to one scale, so that lines of equal period run at 45 degrees, where there is
    // room.
    constexpr double lowest = 3.5;  // [cm], for the numbers of an axis
    const double toScale = plotWidth * maps.contactTime / maps.flightTime;
    const double height = std::clamp(toScale, lowest, plotWidth);
    const auto count = static_cast<double>(maps.all.size());
    FigureData figure{.width = plotWidth + 5.0,
                      .height = count * (height + below) + above,
                      .title = maps.caption};
    const double right = (1.8 + plotWidth) / figure.width;
    double top = figure.height - above;
    bool hasColours = false;
    for (std::size_t k = 0; k < maps.all.size(); ++k, top -= height + below) {
        Map& map = maps.all[k];
        const Place place{1.8 / figure.width, right, (top - height) / figure.height,
                          top / figure.height};
        const bool isOne = maps.all.size() == 1;
        Panel& panel =
            figure.add({.name = k == 0 ? "map" : fmt::format("map{}", k + 1), .place = place});
        panel.isEqual = toScale >= lowest;
        panel.x = {.label = "flight time  t_f  [L/c]", .low = 0.0, .high = maps.flightTime * 1.01};
        panel.y = {.label = isOne ? "contact time  t_c  [L/c]"
                                  : fmt::format("t_c at contact {}  [L/c]", k + 1),
                   .low = 0.0,
                   .high = maps.contactTime * 1.01};
        panel.map = ColourMap::onPaper;
        panel.colour = maps.energy;
        if (!hasColours && !map.pressing.x.empty()) {
            hasColours = true;
            panel.colourBar = Place{right + 0.03, right + 0.05, place.bottom, place.top};
        }
        if (k == 0) {
            panel.legend = Legend::above;
            maps.explain(panel);
        }
        panel.add(std::move(map.grazing));
        panel.add(std::move(map.pressing));
        panel.add(std::move(map.undecided));
        addNames(panel, map.tents);
    }
    return figure;
}

}  // namespace signorini
