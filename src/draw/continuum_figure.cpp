#include "signorini/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gnuplot.hpp"
#include "palette.hpp"
#include "signorini/motion.hpp"
#include "text.hpp"

namespace signorini {

namespace {

constexpr std::size_t maxMembers = 31;
constexpr std::int64_t maxNodes = 301;
constexpr std::int64_t maxInstants = 401;

/// Points to stack, evenly, and the places among them of the two members drawn in full.
struct Choice {
    std::vector<std::size_t> members;
    std::array<std::size_t, 2> black;
};

Choice choose(const Continuum& curve)
{
    const std::size_t last = curve.points.size() - 1;
    const std::size_t gaps = std::min(last, maxMembers - 1);
    Choice choice{{}, {0, 0}};
    for (std::size_t k = 0; k <= gaps; ++k) {
        choice.members.push_back(gaps == 0 ? 0 : k * last / gaps);
    }
    // The first is drawn left, the second right: a little inside, as in the paper.
    choice.black = {gaps / 10, gaps - gaps / 10};
    return choice;
}

/// Strain and velocity of one member, raised to its lambda: the height of the steps is chosen so
/// that the largest spans about a sixth of the panel.
void printMember(Text& script, const ContinuumPoint& point, double base, double raise,
                 const char* name, std::size_t number)
{
    const Eigen::VectorXd s = strain(point.state);
    const Eigen::VectorXd v = velocity(point.state);
    const auto cells = static_cast<double>(point.state.cells());
    print(script, "${}{} << EOD\n", name, number);
    print(script, "0 {} {} {}\n", base + raise * s[0], base + raise * v[0], base);
    // Only where a value changes, and both sides of the change: steps stay upright.
    for (Eigen::Index i = 1; i < s.size(); ++i) {
        if (s[i] != s[i - 1] || v[i] != v[i - 1]) {
            const double x = static_cast<double>(i) / cells;
            print(script, "{} {} {} {}\n", x, base + raise * s[i - 1], base + raise * v[i - 1],
                  base);
            print(script, "{} {} {} {}\n", x, base + raise * s[i], base + raise * v[i], base);
        }
    }
    const Eigen::Index end = s.size() - 1;
    print(script, "1 {} {} {}\nEOD\n", base + raise * s[end], base + raise * v[end], base);
}

/// Largest |s| and |v| of the stacked members.
double largest(const Continuum& curve, const Choice& choice)
{
    double size = 0.0;
    for (const std::size_t k : choice.members) {
        const State& state = curve.points[k].state;
        size = std::max(
            {size, strain(state).cwiseAbs().maxCoeff(), velocity(state).cwiseAbs().maxCoeff()});
    }
    return size;
}

/// u(x, t) on an even grid, and its lowest value.
double printField(Text& script, const Motion& motion, std::size_t number)
{
    const auto cells = static_cast<double>(motion.cells());
    double lowest = 0.0;
    print(script, "$field{} << EOD\n", number);
    for (const std::int64_t m : evenly(motion.steps(), maxInstants)) {
        for (const std::int64_t i : evenly(motion.cells(), maxNodes)) {
            const double u = motion.displacement(i, m);
            lowest = std::min(lowest, u);
            print(script, "{} {} {:.5g}\n", static_cast<double>(i) / cells,
                  static_cast<double>(m) / cells, u);
        }
    }
    print(script, "EOD\n$tip{} << EOD\n", number);
    for (const std::int64_t m : thinned(motion.steps(), 4001)) {
        print(script, "{} {}\n", motion.displacement(motion.cells(), m),
              static_cast<double>(m) / cells);
    }
    print(script, "EOD\n");
    return lowest;
}

const char* unitOf(Parameter parameter)
{
    switch (parameter) {
        case Parameter::arcLength:
            return "arc length λ [√E_1]";
        case Parameter::pause:
            return "pause λ between the pulses [L/c]";
        case Parameter::number:
            return "number λ of the motion";
    }
    return "λ";
}

/// One waterfall: column 2 (strain) or 3 (velocity) of every member.
void plotWaterfall(Text& script, const Choice& choice, int column, const char* colour)
{
    const std::size_t count = choice.members.size();
    print(script, "plot ");
    for (std::size_t k = count; k-- > 0;) {
        // From the top down: each member covers what stands behind it.
        print(script,
              "$member{0} using 1:{1}:4 with filledcurves fillcolor '{2}' fillstyle transparent "
              "solid 0.18 noborder notitle, $member{0} using 1:{1} with lines lw 0.8 lc '{2}' "
              "notitle, ",
              k, column, colour);
    }
    print(script,
          "$member{} using 1:{} with lines lw 2 lc 'black' notitle, "
          "$member{} using 1:{} with lines lw 2 lc 'black' dt (6,2) notitle\n",
          choice.black[0], column, choice.black[1], column);
}

void printWaterfalls(Text& script, const Continuum& curve, const Choice& choice)
{
    const double low = curve.points.front().lambda;
    const double high = curve.points.back().lambda;
    const double range = high > low ? high - low : 1.0;
    const double size = largest(curve, choice);
    const double raise = range / (6.0 * std::max(size, 1e-300));
    for (std::size_t k = 0; k < choice.members.size(); ++k) {
        const ContinuumPoint& point = curve.points[choice.members[k]];
        printMember(script, point, point.lambda, raise, "member", k);
    }
    print(script,
          "set border lw 0.8\nset tics out nomirror scale 0.6\nset xrange [0:1]\n"
          "set yrange [{}:{}]\nset tmargin at screen 0.90\nset bmargin at screen 0.55\n"
          "set xlabel 'position  x/L' offset 0,0.4\n",
          low - 0.2 * range, high + 0.2 * range);
    print(script,
          "set lmargin at screen 0.11\nset rmargin at screen 0.49\nset ylabel '{}'\n"
          "set label 3 'strain  s L/g at t = 0' at graph 0.5,1.05 center\n"
          "set arrow 1 from graph 1.03,first {} to graph 1.03,first {} heads size graph 0.01,90 "
          "lw 1.2\nset label 4 '{:.3g}' at graph 1.045,first {} left\n",
          unitOf(curve.parameter), low, low + raise * size, size, low + 0.5 * raise * size);
    plotWaterfall(script, choice, 2, "#0072b2");
    print(script, "unset label 1\n");
    print(script,
          "set lmargin at screen 0.56\nset rmargin at screen 0.96\nset ylabel ''\n"
          "set format y ''\nunset arrow 1\nunset label 4\n"
          "set label 3 'velocity  v L/(c g) at t = 0, same scale'\n");
    plotWaterfall(script, choice, 3, "#d55e00");
    print(script, "set format y '%g'\nunset label 3\n");
}

void printMotions(Text& script, const Continuum& curve, const Choice& choice)
{
    double lowest = 0.0;
    double time = 0.0;
    for (std::size_t k = 0; k < 2; ++k) {
        const ContinuumPoint& point = curve.points[choice.members[choice.black[k]]];
        const Motion motion(point.state, curve.schedule);
        lowest = std::min(lowest, printField(script, motion, k));
        time = static_cast<double>(motion.steps()) / static_cast<double>(motion.cells());
    }
    print(script,
          "{}set cbrange [{}:1]\nset cblabel 'displacement  u/g'\nset yrange [0:{}]\n"
          "set tmargin at screen 0.41\nset bmargin at screen 0.08\n",
          palette::sequential(), lowest, time);
    for (std::size_t k = 0; k < 2; ++k) {
        const ContinuumPoint& point = curve.points[choice.members[choice.black[k]]];
        const double left = k == 0 ? 0.11 : 0.51;
        print(script,
              "set lmargin at screen {}\nset rmargin at screen {}\nset ylabel '{}'\n"
              "set format y '{}'\n{}\n"
              "set label 3 'u(x, t) at λ = {:.4g}  ({})' at graph 0.5,1.05 center\n"
              "plot $field{} using 1:2:3 with image notitle\n",
              left, left + 0.355, k == 0 ? "time  t c/L" : "", k == 0 ? "%g" : "",
              k == 0 ? "unset colorbox"
                     : "set colorbox user origin screen 0.88,0.08 size screen 0.018,0.33",
              point.lambda, k == 0 ? "solid above" : "dashed above", k);
    }
}

}  // namespace

void drawContinuum(const Continuum& curve, FigureFormat format, const std::string& path)
{
    if (curve.points.empty()) {
        throw std::invalid_argument("figure: the curve holds no motion to draw");
    }
    const Choice choice = choose(curve);
    Text script;
    print(script,
          "set multiplot\nset label 1 \"{}   ω/ω_1 = {:.5g}   E/E_1 = {:.5g}   {}, {} motions\" at "
          "screen 0.5,0.97 center\n",
          describe(curve.schedule), frequencyRatio(curve.schedule), curve.energyRatio, curve.family,
          curve.points.size());
    printWaterfalls(script, curve, choice);
    printMotions(script, curve, choice);
    print(script, "unset multiplot\n");
    runGnuplot(fmt::to_string(script), format, 18.0, 19.0, path);
}

}  // namespace signorini
