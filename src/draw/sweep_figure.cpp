#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axes.hpp"
#include "excited_amplitude.hpp"
#include "gnuplot.hpp"
#include "palette.hpp"
#include "signorini/figures.hpp"
#include "text.hpp"

namespace signorini {

namespace {

/// The axis of what is varied: what 1 in the range is there, and its words.
struct SweepAxis {
    double unit = 1.0;
    std::string words;
};

SweepAxis axisOf(const SweepRange& range, const Bar& bar)
{
    const Scales unit = scales(bar);
    const auto scaled = [&](double one, const char* words, const char* base) {
        const Unit shown = unitFor(range.most * one, base);
        return SweepAxis{one * shown.factor, fmt::format("{}  [{}]", words, shown.name)};
    };
    switch (range.over) {
        case Swept::frequency:
            return {0.25 / unit.time, "frequency of the excitation  [Hz]"};
        case Swept::amplitude:
            return range.place == Excited::tip
                       ? scaled(bar.axialStiffness * unit.strain, "amplitude of the force", "N")
                       : scaled(unit.displacement, "amplitude of the base", "m");
        case Swept::gap:
            return scaled(unit.displacement, "gap", "m");
        case Swept::damping:
            return {1.0, "damping ratio ζ"};
    }
    return {};
}

/// Impulse [N s] and displacement [m] on the axes of a figure.
struct Measured {
    Unit impulse;
    Unit swing;
    double impulseOfOne;  ///< what 1 of a point is on the axis
    double swingOfOne;
};

Measured measuresOf(std::span<const SweepPoint> points, const Bar& bar)
{
    const Scales unit = scales(bar);
    const double one = bar.axialStiffness * unit.strain * unit.time;
    double pushed = 0.0;
    double swing = 0.0;
    for (const SweepPoint& point : points) {
        pushed = std::max(pushed, point.impulse[1] * one);
        swing = std::max(swing, std::abs(point.tip[0]) * unit.displacement);
    }
    Measured measured{unitFor(pushed, "N s"), unitFor(swing, "m"), 0.0, 0.0};
    measured.impulseOfOne = one * measured.impulse.factor;
    measured.swingOfOne = unit.displacement * measured.swing.factor;
    return measured;
}

/// Grid, borders, what is varied below, and ω/ω₁ above where that is a frequency.
void printAxes(Text& script, const SweepRange& range, const SweepAxis& axis)
{
    const double margin = range.most > range.least ? 0.01 * (range.most - range.least) : 0.05;
    print(script,
          "set border lw 0.8\nset tics out nomirror scale 0.6\nset grid lw 0.4 lc '{}'\n"
          "set xrange [{}:{}]\nset lmargin at screen 0.12\nset rmargin at screen 0.97\n",
          palette::grid, (range.least - margin) * axis.unit, (range.most + margin) * axis.unit);
    if (range.over == Swept::frequency) {
        print(script, "set x2range [{}:{}]\nset x2tics\nset x2label 'ω/ω_1' offset 0,-0.8\n",
              range.least - margin, range.most + margin);
    }
}

void printPoints(Text& script, std::span<const SweepPoint> points, SweepDirection direction,
                 const SweepAxis& axis, const Measured& unit)
{
    print(script, "${} << EOD\nNaN NaN NaN NaN NaN NaN\n", name(direction));
    for (const SweepPoint& point : points) {
        if (point.direction == direction) {
            print(script, "{:.8g} {:.6g} {:.6g} {:.6g} {:.6g} {}\n", point.value * axis.unit,
                  point.impulse[0] * unit.impulseOfOne, point.impulse[1] * unit.impulseOfOne,
                  point.meanImpulse * unit.impulseOfOne, -point.tip[0] * unit.swingOfOne,
                  point.settling.settled ? 1 : 0);
        }
    }
    print(script, "EOD\n");
}

/// Impulse and swing of the motions that theory has here.
void printExact(Text& script, std::span<const FrequencyResponse> exact, const SweepAxis& axis,
                const Measured& unit)
{
    print(script, "$exact << EOD\nNaN NaN NaN\n");
    for (const FrequencyResponse& response : exact) {
        for (const ForcedMotion& motion : response.motions) {
            print(script, "{:.8g} {:.6g} {:.6g}\n", response.frequencyRatio * axis.unit,
                  motion.extremes.impulse * unit.impulseOfOne,
                  -motion.extremes.lowestTip * unit.swingOfOne);
        }
    }
    print(script, "EOD\n");
}

std::string titleOf(const SweepRange& range, const Bar& bar)
{
    const Scales unit = scales(bar);
    std::string text = range.place == Excited::tip ? "force on the tip" : "base moving";
    if (range.over != Swept::amplitude) {
        text += fmt::format(",  {:.4g} {}",
                            range.amplitude * amplitudeUnit(range.place, bar, range.derivative),
                            amplitudeUnitName(range.place, range.derivative));
    }
    text += range.over == Swept::frequency
                ? ""
                : fmt::format(",  {:.6g} Hz", range.frequencyRatio / 4.0 / unit.time);
    text += range.over == Swept::damping ? "" : fmt::format(",  ζ = {:.4g}", range.damping.ratio);
    return text + fmt::format(",  N = {}", range.cells);
}

/// Both directions of one quantity: a line for the mean, a stroke where it does not repeat itself.
std::string curves(int mean, const char* least, const char* most, bool hasTitles)
{
    std::string text;
    for (const auto& [name, colour, words, dot] :
         {std::tuple("up", palette::contact, "upward", 7),
          std::tuple("down", palette::ink, "downward", 6)}) {
        text += fmt::format(
            ", ${0} using 1:(${6}) with linespoints lw 1 pt {7} ps 0.5 lc '{1}' {2}, ${0} using "
            "1:($6 == 0 ? {3} : NaN):({4}):({5}) with yerrorbars pt 0 lw 0.8 lc '{1}' notitle",
            name, colour, hasTitles ? fmt::format("title '{}'", words) : "notitle", least, least,
            most, mean, dot);
    }
    return text;
}

}  // namespace

void drawSweep(std::span<const SweepPoint> points, const SweepRange& range, const Bar& bar,
               std::span<const FrequencyResponse> exact, FigureFormat format,
               const std::string& path)
{
    if (points.empty()) {
        throw std::invalid_argument("figure: the sweep holds no value to draw");
    }
    const SweepAxis axis = axisOf(range, bar);
    const Measured unit = measuresOf(points, bar);
    Text script;
    printPoints(script, points, SweepDirection::up, axis, unit);
    printPoints(script, points, SweepDirection::down, axis, unit);
    printExact(script, exact, axis, unit);
    print(script, "set multiplot\n");
    printAxes(script, range, axis);
    const std::string under =
        fmt::format("$exact using 1:2 with points pt 7 ps 0.35 lc '{}' title '{}'", palette::faint,
                    exact.empty() ? "" : "exact motions with one contact");
    print(script,
          "set label 1 \"{}\" at screen 0.54,0.975 center\nset tmargin at screen 0.86\n"
          "set bmargin at screen 0.52\nset format x ''\nset ylabel 'impulse per period  [{}]'\n"
          "set yrange [0:*]\nset key top left reverse Left samplen 2 spacing 1.1\nplot {}{}\n",
          titleOf(range, bar), unit.impulse.name, under, curves(4, "$2", "$3", true));
    print(script,
          "unset label 1\nunset key\nset format x '%g'\nunset x2tics\nunset x2label\n"
          "set tmargin at screen 0.47\nset bmargin at screen 0.12\nset xlabel '{}'\n"
          "set ylabel 'swing  −min u(L)  [{}]'\nset yrange [0:*]\n"
          "plot $exact using 1:3 with points pt 7 ps 0.35 lc '{}'{}\nunset multiplot\n",
          axis.words, unit.swing.name, palette::faint, curves(5, "$5", "$5", false));
    runGnuplot(fmt::to_string(script), format, 16.0, 12.0, path);
}

void drawBifurcation(std::span<const SweepPoint> points, const SweepRange& range, const Bar& bar,
                     FigureFormat format, const std::string& path)
{
    if (points.empty()) {
        throw std::invalid_argument("figure: the sweep holds no value to draw");
    }
    constexpr std::size_t most = 400;  // dots at one value
    const SweepAxis axis = axisOf(range, bar);
    const Measured unit = measuresOf(points, bar);
    Text script;
    for (const SweepDirection direction : {SweepDirection::up, SweepDirection::down}) {
        print(script, "${} << EOD\nNaN NaN\n", name(direction));
        for (const SweepPoint& point : points) {
            const std::size_t stride = 1 + point.impulses.size() / most;
            for (std::size_t k = 0; point.direction == direction && k < point.impulses.size();
                 k += stride) {
                print(script, "{:.8g} {:.6g}\n", point.value * axis.unit,
                      point.impulses[k] * unit.impulseOfOne);
            }
        }
        print(script, "EOD\n");
    }
    printAxes(script, range, axis);
    print(script,
          "set label 1 \"{}\" at screen 0.54,0.97 center\nset tmargin at screen {}\n"
          "set bmargin at screen 0.14\nset xlabel '{}'\nset ylabel 'impulse of a contact  [{}]'\n"
          "set yrange [0:*]\nset key top left reverse Left samplen 1\n"
          "plot $up with points pt 7 ps 0.35 lc '{}' title 'upward', "
          "$down with points pt 6 ps 0.35 lc '{}' title 'downward'\n",
          titleOf(range, bar), range.over == Swept::frequency ? 0.82 : 0.92, axis.words,
          unit.impulse.name, palette::contact, palette::ink);
    runGnuplot(fmt::to_string(script), format, 16.0, 9.0, path);
}

}  // namespace signorini
