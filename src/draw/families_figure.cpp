#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "axes.hpp"
#include "gnuplot.hpp"
#include "palette.hpp"
#include "signorini/figures.hpp"
#include "signorini/modes.hpp"
#include "text.hpp"

namespace signorini {

namespace {

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

    Frame(std::span<const Cell> cells, std::int64_t lastOrder)
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
                first, periods.end(), [](double x, double y) { return x - y > longestGap; });
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

/// T = (4a - 2k/w)/|b| for each k of a mode, in w from its lowest T to the edge of the figure.
void printRungs(Text& script, std::span<const Rung> ladder, double edge)
{
    print(script, "$rungs << EOD\n");
    for (const auto& [mode, contacts] : ladder) {
        const auto turns = static_cast<double>(-mode.b);
        const double top = 4.0 * static_cast<double>(mode.a);
        for (const std::int64_t k : contacts) {
            const double blocks = 2.0 * static_cast<double>(k);
            const double first = std::max(blocks / (top - turns * mode.lowest.value()), 1.0);
            for (int i = 0; first < edge && i <= pointsPerRung; ++i) {
                const double w = first + (edge - first) * i / pointsPerRung;
                print(script, "{:.6g} {:.6g}\n", w, (top - blocks / w) / turns);
            }
            print(script, "\n");
        }
    }
    print(script, "EOD\n");
}

/// The periods at which contact vanishes, with the modes' names.
void printEnds(Text& script, std::span<const Rung> ladder, const Frame& frame)
{
    print(script, "$ends << EOD\n");
    for (const auto& [mode, contacts] : ladder) {
        const double period = mode.highest.value();
        const std::string turns = mode.b == -1 ? "" : fmt::format("{}", -mode.b);
        print(script, "{0} {1} \"\"\n{2} {1} \"{3}−{4}T\"\n\n", frame.left, period, frame.right,
              4 * mode.a, turns);
    }
    print(script, "EOD\n");
}

/// The cells, and their labels: white on dark cells, black on light ones.
void printCells(Text& script, std::span<const Cell> cells, const Frame& frame)
{
    const double half = 0.5 * cellHeight / frame.centimetres;
    Text dark;
    Text light;
    print(script, "$cells << EOD\n");
    for (const Cell& cell : cells) {
        const double centre = 0.5 * (cell.left + cell.right);
        print(script, "{} {:.8g} {} {} {:.8g} {:.8g} {:.6g}\n", centre, cell.period, cell.left,
              cell.right, cell.period - half, cell.period + half, cell.energy);
        const bool isDark = std::log(cell.energy) < 0.6 * std::log(frame.energy);
        Text& labels = isDark ? dark : light;
        if (cell.count == 1) {
            print(labels, "{} {:.8g} \"{},{}\"\n", centre, cell.period, cell.family.blocks,
                  cell.family.contactBlocks);
            continue;
        }
        // They have one nu: above, in the middle, and k below.
        print(labels, "{} {:.8g} \"{{/*0.75 {}}}\"\n", centre, cell.period - 0.5 * half,
              cell.family.contactBlocks);
        if (cell.place == cell.count / 2) {
            print(labels, "{} {:.8g} \"{{/*0.75 {}}}\"\n", cell.family.order,
                  cell.period + 0.5 * half, cell.family.blocks);
        }
    }
    print(script, "EOD\n$dark << EOD\n{0}{2}EOD\n$light << EOD\n{1}{2}EOD\n", fmt::to_string(dark),
          fmt::to_string(light), offThePlot);
}

/// Axes that all panels share, the words above and the scale of energies.
void printAxes(Text& script, const Frame& frame, std::int64_t lastOrder, std::size_t count)
{
    const double bottom = (bandsTop - bandsHeight) / figureHeight;
    const bool isLabelled = lastOrder <= maxLabelledOrder;
    print(script,
          "set multiplot\nset border 10 lw 0.8\nset tics out nomirror scale 0.6\n"
          "set lmargin at screen 0.08\nset rmargin at screen 0.73\nset xrange [{}:{}]\n"
          "set link y2 via 4.0/y inverse 4.0/y\nset y2tics (1, 1.05, 1.1, 1.15, 1.2, 1.25, 1.3, "
          "1.4, 1.5, 1.6, 1.7, 1.8, 2, 2.5, 3, 4, 5, 7, 10)\nset ytics {:.3g}\n"
          "set label 1 'T [L/c]' at screen 0.005,0.945 left\n"
          "set label 2 'ω/ω_1' at screen 0.74,0.945 left\n"
          "set label 3 'mode t_c' at screen 0.80,0.945 left textcolor '{}'\n"
          "set label 4 '{} families of w ≤ {}{}:  T = 2ν/w,  t_c ≤ 2k/w' at screen 0.10,0.945 "
          "left\n"
          "{}set logscale cb\nset cbrange [1:{}]\n"
          "set colorbox user origin screen 0.90,{} size screen 0.018,{}\n"
          "set cblabel 'least energy of the family  E_{{min}}/E_1'\nunset key\nset format x ''\n",
          frame.left, frame.right, niceStep(0.6 / frame.centimetres), palette::faint, count,
          lastOrder, isLabelled ? ", ν,k (or k below ν)" : "",
          palette::sequential(isLabelled ? palette::sequence.size() : palette::onPaper),
          frame.energy, bottom, bandsHeight / figureHeight);
    if (lastOrder <= 2 * maxLabelledOrder) {
        print(script, "set xtics 1\n");
    }
    if (frame.energy < 1000.0) {
        print(script, "set cbtics add (2, 5, 20, 50, 200, 500)\n");
    } else {
        print(script, "set format cb '10^{{%L}}'\n");
    }
}

void plotBand(Text& script, bool isEmpty, std::int64_t lastOrder)
{
    print(script,
          "plot $ends using 1:2 with lines lw 1 dt (2,4) lc '{0}', "
          "$rungs using 1:2 with lines lw 0.8 lc '{0}', "
          "$ends using 1:2:3 with labels left offset 6,0 textcolor '{0}'",
          palette::faint);
    if (!isEmpty && lastOrder <= maxLabelledOrder) {
        print(script,
              ", $cells using 1:2:3:4:5:6:7 with boxxyerror fillstyle solid noborder lc palette, "
              "$dark using 1:2:3 with labels textcolor 'white', "
              "$light using 1:2:3 with labels textcolor 'black'");
    } else if (!isEmpty) {
        print(script, ", $cells using 1:2:7 with points pt 7 ps {:.3g} lc palette",
              std::min(0.8, 30.0 / static_cast<double>(lastOrder)));
    }
    print(script, "\n");
}

std::string scriptFor(std::span<const Family> families, std::int64_t maxOrder)
{
    const std::int64_t lastOrder = std::min(maxOrder, maxDrawnOrder);
    const auto beyond =
        std::find_if(families.begin(), families.end(),
                     [lastOrder](const Family& family) { return family.order > lastOrder; });
    families = families.first(static_cast<std::size_t>(beyond - families.begin()));
    const std::vector<Cell> cells = cellsOf(families);
    const Frame frame(cells, lastOrder);
    const std::vector<Rung> ladder = ladderOf(families, frame);
    Text script;
    printCells(script, cells, frame);
    printRungs(script, ladder, frame.right);
    printEnds(script, ladder, frame);
    printAxes(script, frame, lastOrder, families.size());
    double top = bandsTop;
    for (std::size_t k = 0; k < frame.bands.size(); ++k) {
        const Band& band = frame.bands[k];
        const double bottom = top - (band.high - band.low) * frame.centimetres;
        if (k + 1 == frame.bands.size()) {
            print(script,
                  "set border 11\nset format x '%g'\n"
                  "set xlabel 'order  w: equal blocks of time in 2L/c'\n");
        }
        print(script,
              "set tmargin at screen {:.6g}\nset bmargin at screen {:.6g}\nset yrange [{}:{}]\n",
              top / figureHeight, bottom / figureHeight, band.low, band.high);
        plotBand(script, cells.empty(), lastOrder);
        print(script, "unset label\nunset colorbox\n");
        top = bottom - bandGap;
    }
    print(script, "unset multiplot\n");
    return fmt::to_string(script);
}

}  // namespace

void drawFamilies(std::span<const Family> families, std::int64_t maxOrder, FigureFormat format,
                  const std::string& path)
{
    runGnuplot(scriptFor(families, maxOrder), format, 18.0, figureHeight, path);
}

}  // namespace signorini
