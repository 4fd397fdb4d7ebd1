#include "signorini/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "faults.hpp"
#include "gnuplot.hpp"
#include "signorini/motion.hpp"
#include "text.hpp"

namespace signorini {

namespace {

constexpr std::int64_t maxNodes = 301;
constexpr std::int64_t maxInstants = 701;
constexpr std::int64_t maxTipInstants = 4001;

/// Steps and cells as x/L and t c/L: both are 1/N.
double scaled(std::int64_t count, const Motion& motion)
{
    return static_cast<double>(count) / static_cast<double>(motion.cells());
}

void printInitialState(Text& script, const Motion& motion)
{
    print(script, "$initial << EOD\n");
    for (const std::int64_t i : thinned(motion.cells(), maxTipInstants)) {
        const std::int64_t cell = std::max<std::int64_t>(i, 1);
        print(script, "{} {} {}\n", scaled(i, motion), motion.strain(cell, 0),
              motion.velocity(cell, 0));
    }
    print(script, "EOD\n");
}

void printField(Text& script, const Motion& motion)
{
    print(script, "$field << EOD\n");
    for (const std::int64_t m : evenly(motion.steps(), maxInstants)) {
        for (const std::int64_t i : evenly(motion.cells(), maxNodes)) {
            print(script, "{} {} {:.5g}\n", scaled(i, motion), scaled(m, motion),
                  motion.displacement(i, m));
        }
    }
    print(script, "EOD\n");
}

void printTip(Text& script, const Motion& motion)
{
    print(script, "$tip << EOD\n");
    for (const std::int64_t m : thinned(motion.steps(), maxTipInstants)) {
        print(script, "{} {}\n", motion.displacement(motion.cells(), m), scaled(m, motion));
    }
    print(script, "EOD\n");
}

/// How far the tip moves away from the wall, in units of g.
double tipReach(const Motion& motion)
{
    double lowest = 1.0;
    for (std::int64_t m = 0; m <= motion.steps(); ++m) {
        lowest = std::min(lowest, motion.displacement(motion.cells(), m));
    }
    return std::max(1.0 - lowest, 1e-3);
}

/// The height of the panel of the initial state.
double initialSpan(const Motion& motion)
{
    double low = 0.0;
    double high = 0.0;
    for (std::int64_t i = 1; i <= motion.cells(); ++i) {
        low = std::min({low, motion.strain(i, 0), motion.velocity(i, 0)});
        high = std::max({high, motion.strain(i, 0), motion.velocity(i, 0)});
    }
    return high - low;
}

/// The least of 1, 2, 5 times a power of ten that is not below `least`.
double niceStep(double least)
{
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= least) {
            return factor * power;
        }
    }
    return 10.0 * power;
}

/// The stretches of time in which the schedule holds the tip at the wall.
void printContact(Text& script, const Schedule& schedule, const Motion& motion)
{
    print(script, "$contact << EOD\n");
    std::int64_t step = 0;
    for (const Phase& phase : schedule.phases) {
        print(script, "1 {}\n1 {}\n\n", scaled(step, motion), scaled(step + phase.contact, motion));
        step += phase.contact + phase.free;
    }
    print(script, "EOD\n");
}

/// 0.001 -> "1 mm": people read engineering units.
std::string withPrefix(double value, const char* unit)
{
    struct Prefix {
        double factor;
        const char* symbol;
    };
    for (const Prefix& p : {Prefix{1e3, "k"}, Prefix{1.0, ""}, Prefix{1e-3, "m"}, Prefix{1e-6, "µ"},
                            Prefix{1e-9, "n"}}) {
        if (value >= p.factor && value < 1e3 * p.factor) {
            return fmt::format("{:.4g} {}{}", value / p.factor, p.symbol, unit);
        }
    }
    return fmt::format("{:.4g} {}", value, unit);
}

/// The motion on a grid fine enough to look like the continuous field it is.
struct Drawing {
    Schedule schedule;
    Motion motion;
};

Drawing finelyDrawn(const PeriodicResult& result)
{
    Schedule schedule = result.schedule;
    fold(schedule);
    const std::int64_t longest = std::max(schedule.cells, steps(schedule) / 4);
    const std::int64_t factor = std::max<std::int64_t>(1, (maxNodes - 1) / longest);
    schedule.cells *= factor;
    for (Phase& phase : schedule.phases) {
        phase.contact *= factor;
        phase.free *= factor;
    }
    return {schedule, Motion(refined(result.motion->state, factor), schedule)};
}

std::string scriptFor(const PeriodicResult& result)
{
    const auto [schedule, motion] = finelyDrawn(result);
    Text script;
    printInitialState(script, motion);
    printField(script, motion);
    printTip(script, motion);
    printContact(script, schedule, motion);
    const double reach = tipReach(motion);
    const bool isFolded = period(schedule) < period(result.schedule);
    print(script,
          "set multiplot\n"
          "set label 1 \"{}   T = {:.6g} L/c   ω/ω_1 = {:.5g}   E/E_1 = {:.5g}\" at screen "
          "0.5,0.965 center\n"
          "set label 2 \"L = {},  c = {},  g = {}{}\" at screen 0.5,0.925 center "
          "textcolor '#444444'\n",
          describe(result.schedule), period(result.schedule), result.frequencyRatio,
          result.motion->energyRatio, withPrefix(result.bar.length, "m"),
          withPrefix(result.bar.waveSpeed, "m/s"), withPrefix(result.bar.gap, "m"),
          isFolded ? "   (free oscillations of 4 L/c that repeat are left out)" : "");
    print(script,
          "set border lw 0.8\nset tics out nomirror scale 0.6\nset grid lw 0.4 lc '#cccccc'\n"
          "set lmargin at screen 0.12\nset rmargin at screen 0.62\n"
          "set tmargin at screen 0.88\nset bmargin at screen 0.70\n"
          "set xrange [0:1]\nset format x ''\nset offsets 0,0,graph 0.1,graph 0.1\n"
          "set ylabel 'at t = 0'\nset ytics {}\n"
          "set key at screen 0.65,0.87 left top reverse Left samplen 1.5 spacing 1.25\n"
          "plot $initial using 1:2 with fsteps lw 2 lc '#0072b2' title 'strain  s L/g', "
          "$initial using 1:3 with fsteps lw 2 dt (8,4) lc '#d55e00' title 'velocity  v L/(c g)', "
          "NaN with lines lw 1.5 lc 'black' title 'path of the tip', "
          "NaN with lines lw 5 lc '#cc79a7' title 'contact phase'\n"
          "unset label 1\nunset label 2\nunset key\nset format x '%g'\nset offsets\n",
          niceStep(initialSpan(motion) / 4.0));
    print(script,
          "{}set tmargin at screen 0.64\nset bmargin at screen 0.12\n"
          "set xlabel 'position  x/L'\nset ylabel 'time  t c/L'\nset yrange [0:{}]\n"
          "set ytics auto\nset colorbox user origin screen 0.905,0.12 size screen 0.018,0.52\n"
          "set cblabel 'displacement  u/g'\nunset grid\n"
          "plot $field using 1:2:3 with image\n",
          viridis(), scaled(motion.steps(), motion));
    print(script,
          "set lmargin at screen 0.65\nset rmargin at screen 0.86\n"
          "set ylabel ''\nset format y ''\nset xlabel 'tip  u(L,t)/g'\n"
          "set xrange [{}:{}]\nset xtics {}\nset grid lw 0.4 lc '#cccccc'\n"
          "set object 1 rectangle from 1,graph 0 to graph 1,graph 1 fillcolor '#bbbbbb' "
          "fillstyle solid border lc '#555555' behind\n"
          "set label 3 'wall' at graph 0.99,graph 1.03 right\n"
          "plot $tip using 1:2 with lines lw 1.5 lc 'black', "
          "$contact using 1:2 with lines lw 5 lc '#cc79a7'\n"
          "unset multiplot\n",
          1.0 - 1.05 * reach, 1.0 + 0.12 * reach, niceStep(reach / 4.0));
    return fmt::to_string(script);
}

}  // namespace

FigureFormat figureFormat(const std::string& path)
{
    const auto endsWith = [&path](std::string_view ending) { return path.ends_with(ending); };
    if (endsWith(".svg")) {
        return FigureFormat::svg;
    }
    if (endsWith(".png")) {
        return FigureFormat::png;
    }
    if (endsWith(".pdf")) {
        return FigureFormat::pdf;
    }
    throw std::invalid_argument(
        fmt::format("figure = {} is out of range: allowed a name ending in .svg, .png or .pdf",
                    shortened(path)));
}

void drawMotion(const PeriodicResult& result, FigureFormat format, const std::string& path)
{
    if (!result.motion) {
        throw std::invalid_argument("figure: the result holds no motion to draw");
    }
    runGnuplot(scriptFor(result), format, 16.0, 13.0, path);
}

}  // namespace signorini
