#include "signorini/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <tuple>
#include <vector>

#include "faults.hpp"
#include "gnuplot.hpp"
#include "palette.hpp"
#include "text.hpp"

namespace signorini {

namespace {

/// What print can show: the width of a column in the detail, and the relative height of a line.
constexpr double columnWidth = 5e-4;
constexpr double lineHeight = 1.004;
constexpr std::size_t pointsPerCurve = 60;
constexpr std::size_t pointsInAll = 60'000;
constexpr int maxLabels = 8;
constexpr int wholeLabels = 3;          ///< column of the names in the whole
constexpr int detailLabels = 4;         ///< in the detail
constexpr std::size_t maxMarked = 200;  // modes; beyond, no labels and smaller marks

/// Bottom of the ordinate: no motion that reaches the wall has less than E_1.
constexpr double lowest = 0.65;

/// The crowded part of the abscissa, T in ]3, 4], drawn once more.
constexpr double detailLeft = 0.985;
constexpr double detailRight = 1.295;

/// How a group of curves is drawn, told apart by width and dashes.
struct Style {
    const char* family;  ///< start of familyName
    const char* title;
    std::string line;
};

const std::array<Style, 5> styles{{
    {"main", "main mode  t_c = 4 − T", fmt::format("lw 3.5 lc '{}'", palette::ink)},
    {"subharmonic", "subharmonic p  t_c = 4p − (2p−1)T", fmt::format("lw 2 lc '{}'", palette::ink)},
    {"higher", "higher m  t_c = 4 − (2m+1)T", fmt::format("lw 2 dt (8,4) lc '{}'", palette::ink)},
    {"twin", "twins of the main mode", fmt::format("lw 1.5 dt (3,5) lc '{}'", palette::faint)},
    {"", "other modes", fmt::format("lw 1 dt (3,2) lc '{}'", palette::ink)},
}};

/// Half-lines of families, orders from the one above to `last`.
struct Shade {
    std::int64_t last;
    double width;
};

constexpr std::array<Shade, palette::fading.size()> shades{
    {{4, 4.0}, {6, 3.0}, {9, 2.2}, {15, 1.3}, {30, 0.9}, {maxFamilyOrder, 0.6}}};
constexpr std::int64_t maxNamedFamily = 7;

const Style& styleOf(const Mode& mode)
{
    const std::string family = familyName(mode);
    return *std::find_if(styles.begin(), styles.end(), [&family](const Style& style) {
        return family.starts_with(style.family);
    });
}

double frequencyAt(const ExactPeriod& period)
{
    return 4.0 / period.value();
}

void validate(std::span<const EnergyBar> bars, const FrequencyEnergyOptions& options)
{
    Faults faults;
    if (!(std::isfinite(options.maxEnergyRatio) && options.maxEnergyRatio > 1.0)) {
        faults.add("maxEnergyRatio", options.maxEnergyRatio, "finite and > 1 [E_1]");
    }
    if (options.maxFrequencyRatio) {
        faults.requirePositive("maxFrequencyRatio", *options.maxFrequencyRatio, "-");
    }
    for (const EnergyBar& bar : bars) {
        if (!(std::isfinite(bar.frequencyRatio) && bar.frequencyRatio > 0.0 && bar.least > 0.0 &&
              bar.least <= bar.most)) {
            faults.add("energy bar",
                       fmt::format("({}, {}…{})", bar.frequencyRatio, bar.least, bar.most),
                       "a frequency ratio finite and > 0, and energies 0 < least <= most");
            break;
        }
    }
    faults.throwIfAny();
}

/// The part of the plane that is drawn.
struct Extent {
    double left = 0.9;
    double right = 1.5;
    double top = 50.0;

    Extent(const FrequencyEnergyPlot& plot, const FrequencyEnergyOptions& options)
        : top(options.maxEnergyRatio)
    {
        double last = 1.4;
        for (const Mode& mode : plot.modes) {
            last = std::max(last, frequencyAt(mode.lowest));
        }
        for (const EnergyBar& bar : plot.bars) {
            if (bar.least <= top) {
                last = std::max(last, bar.frequencyRatio);
                left = std::min(left, bar.frequencyRatio - 0.1);
            }
        }
        left = std::max(left, 0.3);
        right = options.maxFrequencyRatio.value_or(last + 0.1);
    }
};

/// The curve in the frame, from its highest to its lowest period. Evenly in the logarithm of E.
void printCurve(Text& script, const Mode& mode, const Extent& frame, std::size_t points)
{
    const auto root = [&mode](const ExactPeriod& end) {
        return static_cast<double>(mode.kappa * end.numerator - mode.mu * end.denominator) /
               static_cast<double>(end.denominator);
    };
    const double atTop = 1.0 / std::sqrt(frame.top);
    const double first = std::max(root(mode.highest), atTop);
    const double last = std::max(root(mode.lowest), atTop);
    for (std::size_t k = 0; k <= points; ++k) {
        const double w =
            first * std::pow(last / first, static_cast<double>(k) / static_cast<double>(points));
        const double period = (w + static_cast<double>(mode.mu)) / static_cast<double>(mode.kappa);
        print(script, "{:.6g} {:.6g}\n", 4.0 / period, 1.0 / (w * w));
    }
    print(script, "\n");
}

/// The modes of each style, and the points where modes leave linear motions, with labels for the
/// whole plot and for the detail, each where the other has none.
void printModes(Text& script, std::span<const Mode> modes, const Extent& frame)
{
    // Where curves crowd, those without a name of their own get fewer points.
    const std::size_t few =
        std::clamp<std::size_t>(pointsInAll / (modes.size() + 1), 4, pointsPerCurve);
    for (std::size_t k = 0; k < styles.size(); ++k) {
        print(script, "$modes{} << EOD\n", k);
        for (const Mode& mode : modes) {
            if (&styleOf(mode) == &styles[k]) {
                printCurve(script, mode, frame, k + 1 == styles.size() ? few : pointsPerCurve);
            }
        }
        print(script, "EOD\n");
    }
    print(script, "$starts << EOD\n");
    std::array<int, 2> labels{};
    for (const Mode& mode : modes) {
        const double frequency = frequencyAt(mode.highest);
        const std::int64_t energy = mode.b * mode.b;
        const std::size_t panel = frequency > detailRight ? 0 : 1;
        std::string label;
        if (modes.size() <= maxMarked && static_cast<double>(energy) < 0.8 * frame.top &&
            labels[panel]++ < maxLabels) {
            label = fmt::format("ω_{{{}}}", -mode.b);
            label += mode.a == 1 ? "" : fmt::format("/{}", mode.a);
        }
        print(script, "{:.6g} {} \"{}\" \"{}\"\n", frequency, energy, panel == 0 ? label : "",
              panel == 1 ? label : "");
    }
    print(script, "EOD\n");
}

/// The bars of one kind, those of one column that overlap made one.
void printBars(Text& script, std::span<const EnergyBar> bars, Contact contact, const Extent& frame)
{
    struct Stroke {
        double column;
        EnergyBar bar;
    };
    std::vector<Stroke> strokes;
    for (EnergyBar bar : bars) {
        if (bar.contact == contact && bar.least <= frame.top && bar.frequencyRatio <= frame.right) {
            bar.most = std::min(bar.most, frame.top) * lineHeight;
            strokes.push_back({std::round(bar.frequencyRatio / columnWidth), bar});
        }
    }
    std::sort(strokes.begin(), strokes.end(), [](const Stroke& x, const Stroke& y) {
        return std::tie(x.column, x.bar.least) < std::tie(y.column, y.bar.least);
    });
    print(script, "${} << EOD\n", name(contact));
    for (std::size_t k = 0; k < strokes.size();) {
        const double column = strokes[k].column;
        EnergyBar bar = strokes[k].bar;
        for (++k;
             k < strokes.size() && strokes[k].column == column && strokes[k].bar.least <= bar.most;
             ++k) {
            bar.most = std::max(bar.most, strokes[k].bar.most);
        }
        print(script, "{0:.6g} {1:.5g}\n{0:.6g} {2:.5g}\n\n", bar.frequencyRatio, bar.least,
              bar.most);
    }
    print(script, "EOD\n");
}

/// Half-lines in the shade of their order, names of the first ones, and dots.
void printFamilies(Text& script, const FrequencyEnergyPlot& plot, const Extent& frame)
{
    const auto foot = [&frame](const Family& family) -> std::optional<std::pair<double, double>> {
        const double energy = leastEnergy(family).value();
        const double frequency = frequencyAt(exactPeriod(family));
        if (energy > frame.top || frequency > frame.right) {
            return std::nullopt;
        }
        return std::pair{frequency, energy};
    };
    std::int64_t first = 0;
    for (std::size_t k = 0; k < shades.size(); ++k) {
        print(script, "$families{} << EOD\n", k);
        for (const Family& family : plot.families) {
            if (const auto at = foot(family);
                at && family.order > first && family.order <= shades[k].last) {
                print(script, "{0:.7g} {1:.6g}\n{0:.7g} {2}\n\n", at->first, at->second, frame.top);
            }
        }
        print(script, "{}EOD\n", offThePlot);
        first = shades[k].last;
    }
    print(script, "$names << EOD\n");
    for (const Family& family : plot.families) {
        const auto at = foot(family);
        if (at && family.order <= maxNamedFamily && at->second < 0.8 * frame.top) {
            print(script, "{:.7g} {:.6g} \"{{/*0.8 ({}, {}, {})}}\"\n", at->first, at->second,
                  family.order, family.blocks, family.contactBlocks);
        }
    }
    print(script, "{}EOD\n$dots << EOD\n", offThePlot);
    for (const Family& family : plot.onGrid) {
        if (const auto at = foot(family)) {
            print(script, "{:.7g} {:.6g}\n", at->first, at->second);
        }
    }
    print(script, "{}EOD\n", offThePlot);
}

template <typename Range, typename Condition>
bool any(const Range& range, Condition condition)
{
    return std::any_of(range.begin(), range.end(), condition);
}

void plotBars(Text& script, std::span<const EnergyBar> bars)
{
    if (any(bars, [](const EnergyBar& bar) { return bar.contact == Contact::grazing; })) {
        print(script,
              "$grazing with lines lw 1.2 dt (1,2) lc '{}' title 'linear motions that only graze "
              "the wall', ",
              palette::ink);
    }
    if (any(bars, [](const EnergyBar& bar) { return bar.contact == Contact::pressing; })) {
        print(script,
              "$pressing with lines lw 1.2 lc '{}' title 'several contacts, to E_{{max}} of the "
              "grid', ",
              palette::faint);
    }
}

/// From the highest orders, in the background, to the lowest.
void plotFamilies(Text& script, std::span<const Family> families)
{
    for (std::size_t k = shades.size(); k-- > 0;) {
        const std::int64_t first = k == 0 ? 0 : shades[k - 1].last;
        const auto [last, width] = shades[k];
        std::int64_t most = 0;
        for (const Family& family : families) {
            if (family.order > first && family.order <= last) {
                most = std::max(most, family.order);
            }
        }
        if (most > 0) {
            print(script, "$families{} with lines lw {} lc '{}' title 'families of order w ≤ {}', ",
                  k, width, palette::fading.at(k), most);
        }
    }
}

void plotModes(Text& script, std::span<const Mode> modes, int labelColumn)
{
    for (std::size_t k = 0; k < styles.size(); ++k) {
        if (any(modes, [k](const Mode& mode) { return &styleOf(mode) == &styles[k]; })) {
            print(script, "$modes{} with lines {} title '{}', ", k, styles[k].line,
                  styles[k].title);
        }
    }
    if (!modes.empty()) {
        print(script,
              "$starts using 1:2 with points pt 6 ps {0} lw 1.5 lc '{1}' title 'contact begins: "
              "linear motion of ω_{{|b|}}/a', "
              "$starts using 1:2:{2} with labels left offset 0.7,{3} notitle, ",
              modes.size() <= maxMarked ? 1.0 : 0.3, palette::ink, labelColumn,
              labelColumn == wholeLabels ? -0.4 : -1.3);
    }
}

/// Draws one panel from the back to the front; labels are in column 3 (whole) or 4 (detail).
void printPlot(Text& script, const FrequencyEnergyPlot& plot, int labelColumn)
{
    print(script, "plot ");
    plotBars(script, plot.bars);
    plotFamilies(script, plot.families);
    if (!plot.onGrid.empty()) {
        print(script, "$dots with points pt 7 ps 0.45 lc '{}' title 'families on the grid', ",
              palette::contact);
    }
    plotModes(script, plot.modes, labelColumn);
    if (labelColumn == detailLabels) {
        print(script, "$names using 1:2:3 with labels left offset 0.6,-0.5 notitle, ");
    }
    // Black on a white rim: it stands on a line.
    print(script,
          "$paper with points pt 13 ps 3.2 lc 'white' notitle, "
          "$paper with points pt 13 ps 2.2 lc '{}' title 'the paper’s motion, (8/7, 20)'\n",
          palette::ink);
}

std::string scriptFor(const FrequencyEnergyPlot& plot, const FrequencyEnergyOptions& options)
{
    const Extent frame(plot, options);
    Text script;
    print(script, "$paper << EOD\n{} 20\nEOD\n", 8.0 / 7.0);
    printModes(script, plot.modes, frame);
    printFamilies(script, plot, frame);
    printBars(script, plot.bars, Contact::grazing, frame);
    printBars(script, plot.bars, Contact::pressing, frame);
    print(script,
          "set multiplot\nset border lw 0.8\nset tics out nomirror scale 0.6\n"
          "set grid lw 0.4 lc '{}'\nset logscale y\nset yrange [{}:{}]\n"
          "set lmargin at screen 0.09\nset rmargin at screen 0.97\n"
          "set ylabel 'energy  E/E_1'\n",
          palette::grid, lowest, frame.top);
    if (frame.top < 1000.0) {
        print(script, "set ytics add (2, 5, 20, 50, 200, 500)\n");
    } else {
        print(script, "set format y '10^{{%L}}'\n");
    }
    print(
        script,
        "set tmargin at screen 0.985\nset bmargin at screen 0.765\nset xlabel 'frequency  ω/ω_1 "
        "= 4L/(cT)' offset 0,0.4\nset logscale x\nset xrange [{}:{}]\nset xtics (0.5, 0.7, 1, 1.2, "
        "1.5, 2, 3, 4, 5, 7, 10, 15, 20, 30, 50)\nunset key\n",
        frame.left, frame.right);
    printPlot(script, plot, wholeLabels);
    print(script,
          "unset logscale x\nset xtics autofreq\n"
          "set tmargin at screen 0.695\nset bmargin at screen 0.285\nset xrange [{}:{}]\n"
          "set key at screen 0.53,0.23 center top maxrows 8 Left reverse samplen 2.5 "
          "spacing 1.15 width 1\n",
          detailLeft, detailRight);
    if (!plot.families.empty()) {
        print(
            script,
            "set label 1 \"A family (w, ν, k) has every energy above its least one, on grids fine "
            "enough.\\nE_{{max}} is the grid’s: G times the least, G = 2N/w on N cells.\" at "
            "screen "
            "0.53,0.036 center\n");
    }
    printPlot(script, plot, detailLabels);
    print(script, "unset multiplot\n");
    return fmt::to_string(script);
}

}  // namespace

void writeFrequencyEnergyFigure(const std::string& path, const FrequencyEnergyPlot& plot,
                                const FrequencyEnergyOptions& options)
{
    validate(plot.bars, options);
    const FigureFormat format = options.format ? *options.format : figureFormat(path);
    runGnuplot(scriptFor(plot, options), format, 18.0, 20.0, path);
}

}  // namespace signorini
