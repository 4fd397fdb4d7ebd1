#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "faults.hpp"
#include "gnuplot.hpp"
#include "palette.hpp"
#include "signorini/figures.hpp"
#include "text.hpp"

namespace signorini {

namespace {

/// A sort of dots, and how it is drawn.
struct Sort {
    const char* block;
    const char* title;
    const char* style;
    const char* colour;
    std::size_t contacts;
    std::optional<Stability> stability;
};

constexpr auto sorts = std::to_array<Sort>({
    {"repels", "one contact: repels", "pt 2 ps 0.45 lw 1", palette::contact, 1, Stability::repels},
    {"unclear", "one contact: not clear", "pt 4 ps 0.6 lw 1.2", palette::faint, 1,
     Stability::unclear},
    {"attracts", "one contact: attracts", "pt 7 ps 0.7", palette::contact, 1, Stability::attracts},
    {"untried", "one contact", "pt 7 ps 0.6", palette::contact, 1, std::nullopt},
    {"tworepel", "two contacts: repels", "pt 12 ps 0.6 lw 1", palette::strain, 2,
     Stability::repels},
    {"twounclear", "two contacts: not clear", "pt 14 ps 0.6 lw 1", palette::faint, 2,
     Stability::unclear},
    {"twoattract", "two contacts: attracts", "pt 13 ps 0.9", palette::strain, 2,
     Stability::attracts},
    {"twountried", "two contacts", "pt 13 ps 0.8", palette::strain, 2, std::nullopt},
});

/// omega/omega_1, impulse, swing of each motion of one sort. \return are there any?
bool printMotions(Text& script, const Sort& sort, std::span<const FrequencyResponse> frequencies)
{
    bool any = false;
    print(script, "${} << EOD\n", sort.block);
    for (const FrequencyResponse& response : frequencies) {
        for (const ForcedMotion& motion : response.motions) {
            if (motion.stability == sort.stability &&
                motion.schedule.phases.size() == sort.contacts) {
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
/// frequencies. One cycle of the excitation in a period of the motion, or `cycles`. \return are
/// there any?
bool printModes(Text& script, double least, double most, std::int64_t cycles, double height)
{
    bool any = false;
    print(script, "$modes << EOD\n");
    for (const Backbone& backbone : backbonesOf(least, most, cycles)) {
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

/// The height of the lower panel: what motions need, and twice the gap for the linear one.
double heightOf(std::span<const FrequencyResponse> frequencies)
{
    double most = 2.0;
    for (const FrequencyResponse& response : frequencies) {
        for (const ForcedMotion& motion : response.motions) {
            most = std::max(most, -motion.extremes.lowestTip);
        }
    }
    return 1.08 * most;
}

std::string titleOf(const ResponseRange& range)
{
    return fmt::format(
        "{} of amplitude {:.4g} {},  ζ = {:.4g},  N = {}{}",
        range.place == Excited::tip ? "force on the tip" : "base moving", range.amplitude,
        range.place == Excited::tip ? "EA g/L" : "g", range.damping.ratio, range.cells,
        range.cycles > 1 ? fmt::format(",  period of {} cycles of the excitation", range.cycles)
                         : "");
}

}  // namespace

void drawResponse(std::span<const FrequencyResponse> frequencies, const ResponseRange& range,
                  FigureFormat format, const std::string& path)
{
    if (frequencies.empty()) {
        throw std::invalid_argument("figure: the response holds no frequency to draw");
    }
    Text script;
    printLinear(script, frequencies);
    const auto [least, most] =
        std::minmax(frequencies.front().frequencyRatio, frequencies.back().frequencyRatio);
    const double margin = most > least ? 0.01 * (most - least) : 0.05;
    const bool hasModes =
        printModes(script, least - margin, most + margin, range.cycles, heightOf(frequencies));
    std::string upper;
    std::string lower;
    for (const Sort& sort : sorts) {
        if (printMotions(script, sort, frequencies)) {
            upper += fmt::format(", ${} using 1:2 with points {} lc '{}' title '{}'", sort.block,
                                 sort.style, sort.colour, sort.title);
            lower += fmt::format(", ${} using 1:3 with points {} lc '{}' notitle", sort.block,
                                 sort.style, sort.colour);
        }
    }
    double pushed = 0.0;
    for (const FrequencyResponse& response : frequencies) {
        for (const ForcedMotion& motion : response.motions) {
            pushed = std::max(pushed, motion.extremes.impulse);
        }
    }
    print(script,
          "set multiplot\nset border lw 0.8\nset tics out nomirror scale 0.6\n"
          "set grid lw 0.4 lc '{}'\nset xrange [{}:{}]\nset lmargin at screen 0.12\n"
          "set rmargin at screen 0.97\nset label 1 \"{}\" at screen 0.54,0.965 center\n"
          "set tmargin at screen 0.92\nset bmargin at screen 0.54\nset format x ''\n"
          "set ylabel 'impulse  [EA g/c]'\nset yrange [0:{}]\n"
          "set key top left reverse Left samplen 2 spacing 1.1\n"
          "plot {}NaN with lines lw 2 lc '{}' title 'no contact', "
          "NaN with lines lw 1.5 dt (6,3) lc '{}' title 'no wall in its way'{}\n",
          palette::grid, least - margin, most + margin, titleOf(range),
          pushed > 0.0 ? fmt::format("{:.4g}", 1.15 * pushed) : std::string("*"),
          hasModes ? fmt::format("$modes using 1:2 with lines lw 5 lc '{}' title 'modes: free, "
                                 "undamped', ",
                                 palette::fading.back())
                   : std::string(),
          palette::ink, palette::faint, upper);
    print(script,
          "unset label 1\nunset key\nset format x '%g'\nset tmargin at screen 0.49\n"
          "set bmargin at screen 0.12\nset xlabel 'frequency of the excitation  ω/ω_1'\n"
          "set ylabel 'swing  −min u(L)/g'\nset yrange [0:{:.4g}]\n"
          "plot $modes using 1:3 with lines lw 5 lc '{}', $linear using 1:2 with lines lw 2 lc "
          "'{}', $linear using 1:3 with lines lw 1.5 dt (6,3) lc '{}'{}\nunset multiplot\n",
          heightOf(frequencies), palette::fading.back(), palette::ink, palette::faint, lower);
    runGnuplot(fmt::to_string(script), format, 16.0, 12.0, path);
}

}  // namespace signorini
