#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "axes.hpp"
#include "excited_amplitude.hpp"
#include "gnuplot.hpp"
#include "palette.hpp"
#include "signorini/figures.hpp"
#include "text.hpp"

namespace signorini {

namespace {

constexpr std::size_t mostTold = 4;  // motions at a place that are told apart

/// How many motions: none, one, ... ; the last stands for more as well.
struct Count {
    const char* title;
    const char* colour;
};

constexpr std::array<Count, mostTold + 1> counts{{{"none", "#ffffff"},
                                                  {"one", palette::fading[5]},
                                                  {"two", palette::fading[3]},
                                                  {"three", palette::fading[2]},
                                                  {"more", palette::fading[1]}}};

/// Between two amplitudes the same number of motions.
struct CountedBand {
    double from;
    double to;
    std::size_t count;
};

/// The amplitude from which the motion without contact meets the wall.
double edgeOfContact(const FrequencyResponse& response, const ResponseRange& range)
{
    const auto& [right, left] = range.stops;
    const double nearest = left ? std::min<double>(right, left->value()) : right;
    return std::max(nearest, 0.0) * range.amplitude / response.linearPeak;
}

/// The least one of a motion with contact; infinite if there is none.
double edgeOfMotions(const FrequencyResponse& response)
{
    double least = std::numeric_limits<double>::infinity();
    for (const AmplitudeBranch& branch : response.branches) {
        least = std::min(least, branch.least);
    }
    return least;
}

std::vector<CountedBand> bandsOf(const FrequencyResponse& response, const ResponseRange& range,
                                 double top)
{
    // Where a motion begins or ends, by amplitude.
    std::vector<std::pair<double, int>> events{{0.0, 1}, {edgeOfContact(response, range), -1}};
    for (const AmplitudeBranch& branch : response.branches) {
        events.emplace_back(branch.least, 1);
        events.emplace_back(branch.most, -1);
    }
    std::sort(events.begin(), events.end());
    std::vector<CountedBand> bands;
    int present = 0;
    double from = 0.0;
    for (const auto& [amplitude, change] : events) {
        const double to = std::min(amplitude, top);
        const std::size_t count =
            std::min(static_cast<std::size_t>(std::max(present, 0)), mostTold);
        if (!bands.empty() && bands.back().count == count) {
            bands.back().to = to;
        } else if (to > from) {
            bands.push_back({from, to, count});
        }
        from = std::max(from, to);
        present += change;
    }
    return bands;
}

}  // namespace

void drawResponseMap(std::span<const FrequencyResponse> frequencies, const ResponseRange& range,
                     const Bar& bar, FigureFormat format, const std::string& path)
{
    if (frequencies.empty()) {
        throw std::invalid_argument("figure: the response holds no frequency to draw");
    }
    const double top = 3.0 * range.amplitude;
    Text script;
    std::array<Text, mostTold + 1> boxes;
    std::array<bool, mostTold + 1> isUsed{};
    print(script, "$edges << EOD\n");
    for (std::size_t k = 0; k < frequencies.size(); ++k) {
        const FrequencyResponse& response = frequencies[k];
        const double x = response.frequencyRatio;
        // Half way to the neighbours.
        const double left = k > 0 ? 0.5 * (x + frequencies[k - 1].frequencyRatio) : x;
        const double right =
            k + 1 < frequencies.size() ? 0.5 * (x + frequencies[k + 1].frequencyRatio) : x;
        for (const CountedBand& band : bandsOf(response, range, top)) {
            print(boxes[band.count], "{:.8g} 0 {:.8g} {:.8g} {:.6g} {:.6g}\n", x,
                  std::min(left, right), std::max(left, right), band.from, band.to);
            isUsed[band.count] = true;
        }
        const double least = edgeOfMotions(response);
        print(script, "{:.8g} {:.6g} {}\n", x, edgeOfContact(response, range),
              std::isfinite(least) ? fmt::format("{:.6g}", least) : "NaN");
    }
    print(script, "EOD\n");
    print(script, "$pairs << EOD\n");
    bool hasPairs = false;
    for (const FrequencyResponse& response : frequencies) {
        for (const TwoContactBranch& branch : response.twoContacts) {
            if (branch.least <= top) {
                print(script, "{:.8g} {:.6g}\n", response.frequencyRatio, branch.least);
                hasPairs = true;
            }
        }
    }
    print(script, "EOD\n");
    std::string plots;
    for (std::size_t count = 0; count < boxes.size(); ++count) {
        if (isUsed[count]) {
            print(script, "$count{} << EOD\n{}EOD\n", count, fmt::to_string(boxes[count]));
            plots += fmt::format(
                "$count{0} using 1:2:3:4:5:6 with boxxyerror fillcolor '{1}' fillstyle solid "
                "noborder notitle, NaN with boxes fillcolor '{1}' fillstyle solid border lc '{2}' "
                "title '{3}', ",
                count, counts[count].colour, palette::faint, counts[count].title);
        }
    }
    const auto [low, high] =
        std::minmax(frequencies.front().frequencyRatio, frequencies.back().frequencyRatio);
    const double margin = high > low ? 0.0 : 0.05;
    const double amplitudeInSi = amplitudeUnit(range.place, bar);
    const Unit unit = unitFor(top * amplitudeInSi, amplitudeUnitName(range.place));
    print(script, "{}{}", hertzAxis(high - low + 2.0 * margin, bar),
          linkedAxis("y", top, amplitudeInSi * unit.factor, unit.name));
    print(script,
          "set border lw 0.8 front\nset tics out scale 0.6\nset xrange [{}:{}]\n"
          "set yrange [0:{}]\nset xlabel 'frequency of the excitation  ω/ω_1'\n"
          "set ylabel 'amplitude of the {}'\n"
          "set title \"motions with at most one contact in {},  ζ = {:.4g},  N = {}\"\n"
          "set key outside bottom center horizontal Left reverse samplen 1.6 width 1\n"
          "plot {}$edges using 1:2 with lines lw 2 lc '{}' title 'without contact meets the wall', "
          "$edges using 1:3 with lines lw 2 dt (6,3) lc '{}' title 'with contact, the least', "
          "{} with lines lw 1 dt (2,3) lc '{}' title 'amplitude of the response'{}\n",
          low - margin, high + margin, top,
          range.place == Excited::tip ? (range.stops.right != 0 ? "force  [EA g/L]" : "force  [EA]")
          : range.stops.right != 0    ? "base  [g]"
                                      : "base  [L]",
          range.cycles > 1 ? fmt::format("{} cycles", range.cycles) : "a cycle",
          range.damping.ratio, range.cells, plots, palette::ink, palette::contact, range.amplitude,
          palette::ink,
          hasPairs ? fmt::format(", $pairs using 1:2 with points pt 13 ps 0.4 lc '{}' title "
                                 "'two contacts'",
                                 palette::strain)
                   : std::string());
    runGnuplot(fmt::to_string(script), format, 16.0, 11.0, path);
}

}  // namespace signorini
