#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "axes.hpp"
#include "excited_amplitude.hpp"
#include "faults.hpp"
#include "gnuplot.hpp"
#include "palette.hpp"
#include "signorini/figures.hpp"
#include "stepped_bar.hpp"
#include "text.hpp"

namespace signorini {

namespace {

/// A sort of dots, and how it is drawn.
struct Sort {
    const char* block;
    const char* title;
    const char* style;
    std::optional<Stability> stability;
};

/// What the tip touches in a period.
struct Touched {
    const char* block;
    const char* title;
    const char* colour;
    std::size_t phases;
    Stop first;
    Stop last;
};

constexpr auto sorts = std::to_array<Sort>({
    {"repels", ": repels", "pt 2 ps 0.45 lw 1", Stability::repels},
    {"unclear", ": not clear", "pt 4 ps 0.6 lw 1.2", Stability::unclear},
    {"attracts", ": attracts", "pt 7 ps 0.7", Stability::attracts},
    {"untried", "", "pt 7 ps 0.6", std::nullopt},
});

constexpr auto touches = std::to_array<Touched>({
    {"wall", "one contact", palette::contact, 1, Stop::right, Stop::right},
    {"second", "one, on the second stop", palette::strain, 1, Stop::left, Stop::left},
    {"both", "one on each stop", palette::ink, 2, Stop::right, Stop::left},
    {"two", "two contacts", palette::strain, 2, Stop::right, Stop::right},
    {"beyond", "two, on the second stop", palette::velocity, 2, Stop::left, Stop::left},
});

/// omega/omega_1, impulse, swing of each motion of one sort that touches these stops. \return are
/// there any?
bool printMotions(Text& script, const Touched& touched, const Sort& sort,
                  std::span<const FrequencyResponse> frequencies)
{
    bool any = false;
    print(script, "${}{} << EOD\n", touched.block, sort.block);
    for (const FrequencyResponse& response : frequencies) {
        for (const ForcedMotion& motion : response.motions) {
            const std::vector<Phase>& phases = motion.schedule.phases;
            if (motion.stability == sort.stability && phases.size() == touched.phases &&
                phases.front().stop == touched.first && phases.back().stop == touched.last) {
                any = true;
                print(script, "{:.8g} {:.6g} {:.6g}\n", response.frequencyRatio,
                      motion.extremes.impulse, -motion.extremes.lowestTip);
            }
        }
    }
    print(script, "EOD\n");
    return any;
}

/// The bar without a wall, in two columns: where it stays clear, and where the wall is in its way.
void printLinear(Text& script, std::span<const FrequencyResponse> frequencies)
{
    print(script, "$linear << EOD\n");
    for (std::size_t k = 0; k < frequencies.size(); ++k) {
        const FrequencyResponse& response = frequencies[k];
        const bool isNear = k > 0 && frequencies[k - 1].touches != response.touches;
        const std::string value = fmt::format("{:.6g}", response.linearPeak);
        print(script, "{:.8g} {} {}\n", response.frequencyRatio,
              !response.touches || isNear ? value : "NaN",
              response.touches || isNear ? value : "NaN");
    }
    print(script, "EOD\n");
}

/// The backbones: frequency, impulse and swing of the free motions of each mode, over the range of
/// frequencies, `cycles` cycles of the excitation in a period of the motion; without a gap a mode
/// has one period only. \return are there any?
bool printModes(Text& script, double least, double most, const ResponseRange& range, double height)
{
    bool any = false;
    print(script, "$modes << EOD\n");
    // Known of a uniform bar.
    const std::vector<Backbone> backbones =
        isUniform(range.segments) ? backbonesOf(least, most, range.cycles, range.stops)
                                  : std::vector<Backbone>{};
    for (const Backbone& backbone : backbones) {
        bool isDrawn = false;
        for (const BackbonePoint& point : backbone.points) {
            if (-point.extremes.lowestTip <= 1.5 * height) {
                print(script, "{:.8g} {:.6g} {:.6g}\n", point.frequencyRatio,
                      point.extremes.impulse, -point.extremes.lowestTip);
                isDrawn = true;
            }
        }
        any = any || isDrawn;
        print(script, "{}", isDrawn ? "\n" : "");
    }
    print(script, "NaN NaN NaN\nEOD\n");
    return any;
}

/// The height of the lower panel: what motions and the second stop need, and twice the gap for the
/// linear motion, or all of that where there is none.
double heightOf(std::span<const FrequencyResponse> frequencies, const ResponseRange& range)
{
    double most = range.stops.right != 0 ? 2.0 : 0.0;
    if (range.stops.left) {
        most = std::max(most, range.stops.left->value());
    }
    for (const FrequencyResponse& response : frequencies) {
        most = std::max(most, range.stops.right != 0 ? 0.0 : response.linearPeak);
    }
    for (const FrequencyResponse& response : frequencies) {
        for (const ForcedMotion& motion : response.motions) {
            most = std::max(most, -motion.extremes.lowestTip);
        }
    }
    return 1.08 * most;
}

/// "150:1, 150:1.3": cells and impedance of each; the first of many.
std::string segmentsOf(const ResponseRange& range)
{
    constexpr std::size_t most = 4;
    std::string text;
    for (std::size_t k = 0; k < std::min(most, range.segments.size()); ++k) {
        const Segment& segment = range.segments[k];
        text += fmt::format("{}{}:{:.4g}", k == 0 ? "" : ", ", segment.cells,
                            segment.impedance / range.segments.front().impedance);
    }
    return text + (range.segments.size() > most ? ", …" : "");
}

std::string titleOf(const ResponseRange& range, const Bar& bar)
{
    const bool hasUnit = range.stops.right != 0;
    const double amplitude = range.amplitude * amplitudeUnit(range.place, bar, range.derivative);
    return fmt::format("{} of amplitude {},  ζ = {:.4g},  N = {}{}{}{}",
                       range.place == Excited::tip ? "force on the tip" : "base moving",
                       withUnit(amplitude, amplitudeUnitName(range.place, range.derivative)),
                       range.damping.ratio, range.cells,
                       range.stops.right < 0 ? ",  g < 0"
                       : hasUnit             ? ""
                                             : ",  g = 0",
                       range.cycles > 1
                           ? fmt::format(",  period of {} cycles of the excitation", range.cycles)
                           : "",
                       isUniform(range.segments) ? "" : ",  segments " + segmentsOf(range));
}

}  // namespace

void drawResponse(std::span<const FrequencyResponse> frequencies, const ResponseRange& range,
                  const Bar& bar, FigureFormat format, const std::string& path)
{
    if (frequencies.empty()) {
        throw std::invalid_argument("figure: the response holds no frequency to draw");
    }
    const char* unit = range.stops.right < 0 ? "|g|" : range.stops.right > 0 ? "g" : "L";
    Text script;
    printLinear(script, frequencies);
    const auto [least, most] =
        std::minmax(frequencies.front().frequencyRatio, frequencies.back().frequencyRatio);
    const double margin = most > least ? 0.01 * (most - least) : 0.05;
    const bool hasModes =
        printModes(script, least - margin, most + margin, range, heightOf(frequencies, range));
    std::string upper;
    std::string lower;
    for (const Touched& touched : touches) {
        for (const Sort& sort : sorts) {
            if (printMotions(script, touched, sort, frequencies)) {
                const bool isFaint = sort.stability == Stability::unclear;
                const char* colour = isFaint ? palette::faint : touched.colour;
                upper += fmt::format(", ${}{} using 1:2 with points {} lc '{}' title '{}{}'",
                                     touched.block, sort.block, sort.style, colour, touched.title,
                                     sort.title);
                lower += fmt::format(", ${}{} using 1:3 with points {} lc '{}' notitle",
                                     touched.block, sort.block, sort.style, colour);
            }
        }
    }
    if (const auto& second = range.stops.left) {
        lower += fmt::format(", {} with lines lw 1 dt (2,2) lc '{}' notitle", second->value(),
                             palette::ink);
        print(script, "secondStop = {}\n", second->value());
    }
    double pushed = 0.0;
    for (const FrequencyResponse& response : frequencies) {
        for (const ForcedMotion& motion : response.motions) {
            pushed = std::max(pushed, motion.extremes.impulse);
        }
    }
    const double highest = pushed > 0.0 ? 1.15 * pushed : 1.0;
    const double impulseInSi = bar.axialStiffness * scales(bar).strain * scales(bar).time;
    const Unit impulses = unitFor(highest * impulseInSi, "N s");
    const double height = heightOf(frequencies, range);
    const Unit swings = unitFor(height * scales(bar).displacement, "m");
    print(script,
          "set multiplot\nset border lw 0.8\nset tics out scale 0.6\n{}{}"
          "set grid lw 0.4 lc '{}'\nset xrange [{}:{}]\nset lmargin at screen 0.12\n"
          "set rmargin at screen 0.88\nset label 1 \"{}\" at screen 0.5,0.965 center\n"
          "set tmargin at screen 0.89\nset bmargin at screen 0.54\nset format x ''\n"
          "set ylabel 'impulse  [EA {}/c]'\nset yrange [0:{:.4g}]\n"
          "set key top left reverse Left samplen 2 spacing 1.1\n"
          "plot $linear using 1:(-1) with lines notitle, {}NaN with lines lw 2 lc '{}' title 'no "
          "contact', "
          "NaN with lines lw 1.5 dt (6,3) lc '{}' title 'no stop in its way'{}\n",
          hertzAxis(most - least + 2.0 * margin, bar),
          linkedAxis("y", highest, impulseInSi * impulses.factor, impulses.name), palette::grid,
          least - margin, most + margin, titleOf(range, bar), unit, highest,
          hasModes ? fmt::format("$modes using 1:2 with lines lw 5 lc '{}' title 'modes: free, "
                                 "undamped', ",
                                 palette::fading.back())
                   : std::string(),
          palette::ink, palette::faint, upper);
    print(script,
          "unset label 1\n{}{}unset key\nunset x2tics\nset format x '%g'\nset tmargin "
          "at screen 0.49\n"
          "set bmargin at screen 0.12\nset xlabel 'frequency of the excitation  ω/ω_1'\n"
          "set ylabel 'swing  −min u(L)/{}'\nset yrange [0:{:.4g}]\n"
          "plot $modes using 1:3 with lines lw 5 lc '{}', $linear using 1:2 with lines lw 2 lc "
          "'{}', $linear using 1:3 with lines lw 1.5 dt (6,3) lc '{}'{}\nunset multiplot\n",
          range.stops.left ? "set label 2 'second stop' at graph 0.01,first secondStop left "
                             "offset 0,0.5\n"
                           : "",
          linkedAxis("y", height, scales(bar).displacement * swings.factor, swings.name), unit,
          height, palette::fading.back(), palette::ink, palette::faint, lower);
    runGnuplot(fmt::to_string(script), format, 16.0, 12.0, path);
}

}  // namespace signorini
