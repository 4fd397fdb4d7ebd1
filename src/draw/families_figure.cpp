#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "axes.hpp"
#include "signorini/figures.hpp"
#include "signorini/modes.hpp"

namespace signorini {

namespace {

using namespace plot;

/// Orders up to which cells have room for a label, and beyond which dots merge.
constexpr std::int64_t maxLabelledOrder = 16;
constexpr std::int64_t maxDrawnOrder = 120;
constexpr int pointsPerRung = 60;

constexpr double figureHeight = 14.0;  ///< [cm], of the figure
constexpr double bandsTop = 12.8;      ///< [cm]
constexpr double bandsHeight = 11.4;   ///< [cm], of all panels with the gaps between them
constexpr double bandGap = 0.3;        ///< [cm]
constexpr double cellHeight = 0.72;    ///< [cm], two lines
constexpr double nameHeight = 0.5;     ///< [cm], of a mode
constexpr std::size_t maxNamedModes = 9;
constexpr double longestGap = 0.3;   ///< [L/c], without a family in a panel
constexpr double bandMargin = 0.09;  ///< [L/c]

/// A family in its column.
struct Cell {
    Family family;
    double left;        ///< [-], order
    double right;       ///< [-], order
    std::size_t place;  ///< among the families of its order and period
    std::size_t count;  ///< of them
    double period;
    double energy;
};

/// Families of equal order and period share the width of the column.
std::vector<Cell> cellsOf(std::span<const Family> families)
{
    const auto sameAs = [](const Family& one) {
        return [&one](const Family& other) {
            return one.order == other.order && one.blocks == other.blocks;
        };
    };
    std::vector<Cell> cells;
    for (auto first = families.begin(); first != families.end();) {
        const auto last = std::find_if_not(first, families.end(), sameAs(*first));
        const auto count = static_cast<std::size_t>(last - first);
        const double width = 0.88 / static_cast<double>(count);
        double left = static_cast<double>(first->order) - 0.44;
        for (std::size_t place = 0; place < count; ++place, ++first, left += width) {
            cells.push_back({*first, left, left + width, place, count, exactPeriod(*first).value(),
                             leastEnergy(*first).value()});
        }
    }
    return cells;
}

/// Periods that are drawn in one panel.
struct Band {
    double low;   ///< [L/c]
    double high;  ///< [L/c]
};

/// What of the plane is drawn. The axis of T is broken where there is no family for long.
struct Frame {
    double left = 2.5;
    double right = 3.5;
    std::vector<Band> bands;   ///< from the top down, all to one scale
    double centimetres = 1.0;  ///< of T = 1 L/c
    double energy = 10.0;      ///< [E_1], top of the scale

    Frame(std::span<const Cell> cells, std::int64_t lastOrder, bool isWhole)
    {
        std::vector<double> periods{4.0};
        for (const Cell& cell : cells) {
            periods.push_back(cell.period);
            energy = std::max(energy, cell.energy);
        }
        if (!cells.empty()) {
            left = static_cast<double>(cells.front().family.order) - 0.5;
            right = static_cast<double>(lastOrder) + 0.5;
        }
        std::sort(periods.rbegin(), periods.rend());
        double total = 0.0;
        for (auto first = periods.begin(); first != periods.end();) {
            const auto last = std::adjacent_find(
                first, periods.end(),
                [isWhole](double x, double y) { return !isWhole && x - y > longestGap; });
            const double low = last == periods.end() ? periods.back() : *last;
            bands.push_back({low - bandMargin, *first + bandMargin});
            total += bands.back().high - bands.back().low;
            first = last == periods.end() ? last : last + 1;
        }
        const double room = bandsHeight - bandGap * static_cast<double>(bands.size() - 1);
        centimetres = room / total;
    }
};

/// A mode that carries families, and with which contacts.
struct Rung {
    Mode mode;
    std::set<std::int64_t> contacts;
};

/// The modes of least |b| that carry families and have room for a name beside those before them.
std::vector<Rung> ladderOf(std::span<const Family> families, const Frame& frame)
{
    std::map<std::pair<std::int64_t, std::int64_t>, Rung> all;
    for (const Family& family : families) {
        const Mode mode = modeThrough(family);
        Rung& rung = all[{-mode.b, mode.a}];
        rung.mode = mode;
        rung.contacts.insert(family.contactBlocks);
    }
    std::vector<Rung> named;
    for (const auto& [key, rung] : all) {
        const double period = rung.mode.highest.value();
        const bool hasRoom = std::none_of(named.begin(), named.end(), [&](const Rung& other) {
            return std::abs(period - other.mode.highest.value()) < nameHeight / frame.centimetres;
        });
        if (hasRoom && named.size() < maxNamedModes) {
            named.push_back(rung);
        }
    }
    return named;
}

/// T = (4a - 2k/w)/|b| for each k of a mode, in w from its lowest T to the edge of the figure; and
/// the periods at which contact vanishes.
void addRungs(Panel& panel, std::span<const Rung> ladder, const Frame& frame)
{
    Series rungs = plot::line(Role::faint, 0.8);
    Series ends = plot::strokes(Role::faint, 1.0, Dash::dotted);
    for (const auto& [mode, contacts] : ladder) {
        const auto turns = static_cast<double>(-mode.b);
        const double top = 4.0 * static_cast<double>(mode.a);
        for (const std::int64_t k : contacts) {
            const double blocks = 2.0 * static_cast<double>(k);
            const double first = std::max(blocks / (top - turns * mode.lowest.value()), 1.0);
            for (int i = 0; first < frame.right && i <= pointsPerRung; ++i) {
                const double w = first + (frame.right - first) * i / pointsPerRung;
                rungs.add(w, (top - blocks / w) / turns);
            }
            rungs.breakOff();
        }
        const double period = mode.highest.value();
        ends.add(frame.left, period, frame.right, period);
    }
    panel.add(std::move(ends));
    panel.add(std::move(rungs));
}

/// The names of the modes, beyond the axis of frequencies.
Series namesOf(std::span<const Rung> ladder, const Band& band)
{
    Series names = notes(Align::left, Role::faint);
    for (const auto& [mode, contacts] : ladder) {
        const double place = (mode.highest.value() - band.low) / (band.high - band.low);
        if (place > 0.0 && place < 1.0) {
            names.add(
                1.1, place,
                fmt::format("{}−{}T", 4 * mode.a, mode.b == -1 ? "" : fmt::format("{}", -mode.b)));
        }
    }
    return names;
}

/// The cells, and their labels: white on dark cells, black on light ones.
void addCells(Panel& panel, std::span<const Cell> cells, const Frame& frame)
{
    const double half = 0.5 * cellHeight / frame.centimetres;
    Series boxes{.kind = Kind::boxes};
    Series dark = plot::labels(1.0, Align::centre, Role::paper);
    Series light = plot::labels(1.0, Align::centre);
    Series smallDark = dark;
    Series smallLight = light;
    smallDark.size = smallLight.size = 0.75;
    for (const Cell& cell : cells) {
        const double centre = 0.5 * (cell.left + cell.right);
        if (cell.period < *panel.y.low || cell.period > *panel.y.high) {
            continue;
        }
        boxes.add(cell.left, cell.period - half, cell.right, cell.period + half);
        boxes.z.push_back(cell.energy);
        const bool isDark = std::log(cell.energy) < 0.6 * std::log(frame.energy);
        if (cell.count == 1) {
            (isDark ? dark : light)
                .add(centre, cell.period,
                     fmt::format("{},{}", cell.family.blocks, cell.family.contactBlocks));
            continue;
        }
        // They have one nu: above, in the middle, and k below.
        Series& labels = isDark ? smallDark : smallLight;
        labels.add(centre, cell.period - 0.5 * half, fmt::format("{}", cell.family.contactBlocks));
        if (cell.place == cell.count / 2) {
            labels.add(static_cast<double>(cell.family.order), cell.period + 0.5 * half,
                       fmt::format("{}", cell.family.blocks));
        }
    }
    for (Series* series : {&boxes, &dark, &light, &smallDark, &smallLight}) {
        panel.add(std::move(*series));
    }
}

Series dotsOf(std::span<const Cell> cells, std::int64_t lastOrder)
{
    Series dots = plot::dots(Role::ink, std::min(1.0, 37.0 / static_cast<double>(lastOrder)));
    for (const Cell& cell : cells) {
        dots.add(0.5 * (cell.left + cell.right), cell.period);
        dots.z.push_back(cell.energy);
    }
    return dots;
}

/// What all panels share, and what stands above the first.
Panel bandOf(const Frame& frame, const Band& band, std::int64_t lastOrder, bool isFirst,
             bool isLast)
{
    Panel panel{.place = {0.08, 0.73, 0.0, 0.0}, .hasGrid = false};
    panel.x = {.low = frame.left, .high = frame.right, .hasNumbers = isLast};
    panel.x.step = lastOrder <= 2 * maxLabelledOrder ? 1.0 : 0.0;
    if (isLast) {
        panel.x.label = "order  w: equal blocks of time in 2L/c";
    }
    panel.y = {.low = band.low, .high = band.high, .step = niceStep(0.6 / frame.centimetres)};
    panel.y.other = OtherSide{.factor = 4.0,
                              .isInverse = true,
                              .ticks = {1, 1.05, 1.1, 1.15, 1.2, 1.25, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8,
                                        2, 2.5, 3, 4, 5, 7, 10}};
    panel.map = lastOrder <= maxLabelledOrder ? ColourMap::sequence : ColourMap::onPaper;
    panel.colour = {.label = "least energy of the family  E_{min}/E_1",
                    .low = 1.0,
                    .high = frame.energy,
                    .isLogarithmic = true};
    if (isFirst) {
        const double bottom = (bandsTop - bandsHeight) / figureHeight;
        panel.colourBar = Place{0.90, 0.918, bottom, bandsTop / figureHeight};
    }
    return panel;
}

}  // namespace

FigureData familiesFigure(std::span<const Family> families, std::int64_t maxOrder, bool isWhole)
{
    const std::int64_t lastOrder = std::min(maxOrder, maxDrawnOrder);
    const auto beyond =
        std::find_if(families.begin(), families.end(),
                     [lastOrder](const Family& family) { return family.order > lastOrder; });
    families = families.first(static_cast<std::size_t>(beyond - families.begin()));
    const std::vector<Cell> cells = cellsOf(families);
    const Frame frame(cells, lastOrder, isWhole);
    const std::vector<Rung> ladder = ladderOf(families, frame);
    const bool isLabelled = lastOrder <= maxLabelledOrder;
    FigureData figure{.width = 18.0, .height = figureHeight};
    figure.title = fmt::format("{} families of w ≤ {}{}:  T = 2ν/w,  t_c ≤ 2k/w", families.size(),
                               lastOrder, isLabelled ? ", ν,k (or k below ν)" : "");
    double top = bandsTop;
    for (std::size_t k = 0; k < frame.bands.size(); ++k) {
        const Band& band = frame.bands[k];
        const double bottom = top - (band.high - band.low) * frame.centimetres;
        Panel& panel =
            figure.add(bandOf(frame, band, lastOrder, k == 0, k + 1 == frame.bands.size()));
        panel.name = k == 0 ? "families" : fmt::format("families {}", k + 1);
        panel.place.bottom = bottom / figureHeight;
        panel.place.top = top / figureHeight;
        addRungs(panel, ladder, frame);
        if (isLabelled) {
            addCells(panel, cells, frame);
        } else {
            panel.add(dotsOf(cells, lastOrder));
        }
        if (k == 0) {
            const double above = 1.0 + 0.4 / (top - bottom);
            Series words = notes();
            words.add(-0.1, above, "T [L/c]");
            words.add(1.01, above, "ω/ω_1");
            panel.add(std::move(words));
            Series modes = notes(Align::left, Role::faint);
            modes.add(1.1, above, "mode t_c");
            panel.add(std::move(modes));
        }
        panel.add(namesOf(ladder, band));
        top = bottom - bandGap;
    }
    return figure;
}

}  // namespace signorini
