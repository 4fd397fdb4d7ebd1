#include "signorini/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "axes.hpp"
#include "faults.hpp"
#include "gnuplot.hpp"
#include "palette.hpp"
#include "signorini/motion.hpp"
#include "stepped_bar.hpp"
#include "text.hpp"
#include "wall_force.hpp"

namespace signorini {

namespace {

constexpr std::int64_t maxTipInstants = 4001;

/// From dimensionless numbers to those on an axis.
struct Axis {
    double factor;     ///< [unit] of 1
    std::string unit;  ///< as gnuplot writes it

    /// `scale` is 1 in SI, `largest` what the axis must reach, dimensionless.
    Axis(double scale, double largest, const std::string& base)
    {
        const Unit chosen = unitFor(scale * largest, base);
        factor = scale * chosen.factor;
        unit = chosen.name;
    }
};

/// Lowest and highest of some numbers, 0 among them.
struct Span {
    double low = 0.0;
    double high = 0.0;

    void take(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    /// About three steps of an axis.
    [[nodiscard]] double step(double factor) const
    {
        return niceStep(std::max((high - low) * factor, 1e-9) / 3.5);
    }
    [[nodiscard]] double largest() const { return std::max(high, -low); }
};

/// What a picture is of.
struct Subject {
    const State& state;
    const Schedule& schedule;
    const Scene& scene;
    std::vector<std::string> facts = {};  ///< lines beside the initial state
    Damping damping = {};
    Excitation excitation = {};
};

/// The motion on a grid fine enough to look like the continuous field it is.
struct Drawing {
    Schedule schedule;
    Motion motion;
    std::vector<double> force;  ///< [EA g/L], of each step
};

Drawing finelyDrawn(const Subject& subject)
{
    Schedule schedule = subject.schedule;
    std::vector<Segment> segments = subject.scene.segments;
    const bool isPaper = isUniform(segments) && subject.excitation.values.empty();
    if (isPaper) {
        fold(schedule);  // other bars do not repeat themselves in contact or flight
    } else if (segments.empty()) {
        segments.push_back({.cells = schedule.cells});
    }
    const std::int64_t longest = std::max(schedule.cells, steps(schedule) / 4);
    const std::int64_t factor = std::max<std::int64_t>(1, (maxNodes - 1) / longest);
    schedule.cells *= factor;
    for (Phase& phase : schedule.phases) {
        phase.contact *= factor;
        phase.free *= factor;
    }
    const State state = refined(subject.state, factor);
    for (Segment& segment : segments) {
        segment.cells *= factor;
    }
    Motion motion = isPaper ? Motion(state, schedule)
                            : Motion(state, schedule, segments, subject.damping,
                                     refined(subject.excitation, factor));
    std::vector<double> force = wallForces(motion);
    return {schedule, std::move(motion), std::move(force)};
}

/// The axes of the figure.
struct Axes {
    Axis x;
    Axis t;
    Axis u;
    Axis s;
    Axis v;
    Axis force;
    Span tip;                      ///< [g]
    Span strain;                   ///< [g/L], at t = 0
    Span velocity;                 ///< [c g/L], at t = 0
    double cells;                  ///< N: steps and cells are 1/N
    double wall;                   ///< [g], where the tip meets it
    std::optional<double> second;  ///< [g], the second stop

    [[nodiscard]] double position(std::int64_t node) const
    {
        return static_cast<double>(node) / cells * x.factor;
    }
    [[nodiscard]] double time(std::int64_t step) const
    {
        return static_cast<double>(step) / cells * t.factor;
    }
};

Axes axesOf(const Drawing& drawing, const Scene& scene)
{
    const Bar& bar = scene.bar;
    const Motion& motion = drawing.motion;
    Span tip;
    Span strain;
    Span velocity;
    for (std::int64_t m = 0; m <= motion.steps(); ++m) {
        tip.take(motion.displacement(motion.cells(), m));
    }
    for (std::int64_t i = 1; i <= motion.cells(); ++i) {
        strain.take(motion.strain(i, 0));
        velocity.take(motion.velocity(i, 0));
    }
    const Scales unit = scales(bar);
    const auto size = static_cast<double>(motion.cells());
    const auto [least, most] = std::minmax_element(drawing.force.begin(), drawing.force.end());
    return {.x = {bar.length, 1.0, "m"},
            .t = {unit.time, static_cast<double>(motion.steps()) / size, "s"},
            .u = {unit.displacement, tip.largest(), "m"},
            .s = {unit.strain, strain.largest(), ""},
            .v = {unit.velocity, velocity.largest(), "m/s"},
            .force = {bar.axialStiffness * unit.strain, std::max(*most, -*least), "N"},
            .tip = tip,
            .strain = strain,
            .velocity = velocity,
            .cells = size,
            .wall = bar.gap / unit.displacement,
            .second = scene.secondStop ? std::optional(-*scene.secondStop / unit.displacement)
                                       : std::nullopt};
}

/// Strain and velocity as steps: only where they change, and both sides of the change.
void printInitialState(Text& script, const Motion& motion, const Axes& axes)
{
    const auto row = [&](std::int64_t node, std::int64_t cell) {
        print(script, "{:.7g} {:.7g} {:.7g}\n", axes.position(node),
              motion.strain(cell, 0) * axes.s.factor, motion.velocity(cell, 0) * axes.v.factor);
    };
    print(script, "$initial << EOD\n");
    row(0, 1);
    std::int64_t last = 1;
    for (const std::int64_t cell : thinned(motion.cells(), maxTipInstants)) {
        if (cell > 0 && (motion.strain(cell, 0) != motion.strain(last, 0) ||
                         motion.velocity(cell, 0) != motion.velocity(last, 0))) {
            row(cell - 1, last);
            row(cell - 1, cell);
            last = cell;
        }
    }
    row(motion.cells(), last);
    print(script, "EOD\n");
}

void printField(Text& script, const Motion& motion, const Axes& axes)
{
    print(script, "$field << EOD\n");
    for (const std::int64_t m : evenly(motion.steps(), maxInstants)) {
        for (const std::int64_t i : evenly(motion.cells(), maxNodes)) {
            print(script, "{:.7g} {:.7g} {:.5g}\n", axes.position(i), axes.time(m),
                  motion.displacement(i, m) * axes.u.factor);
        }
    }
    print(script, "EOD\n$tip << EOD\n");
    for (const std::int64_t m : thinned(motion.steps(), maxTipInstants)) {
        print(script, "{:.7g} {:.7g}\n", motion.displacement(motion.cells(), m) * axes.u.factor,
              axes.time(m));
    }
    print(script, "EOD\n");
}

/// The force as steps, and when it acts.
void printForce(Text& script, const std::vector<double>& force, const Axes& axes)
{
    const auto at = [&](std::int64_t step) {
        return force[static_cast<std::size_t>(step)] * axes.force.factor;
    };
    const auto count = static_cast<std::int64_t>(force.size());
    print(script, "$force << EOD\n0 0\n");
    double last = 0.0;
    for (const std::int64_t m : thinned(count - 1, maxTipInstants)) {
        if (at(m) != last) {
            print(script, "{:.7g} {:.7g}\n{:.7g} {:.7g}\n", last, axes.time(m), at(m),
                  axes.time(m));
            last = at(m);
        }
    }
    print(script, "{:.7g} {:.7g}\n0 {:.7g}\nEOD\n$pressed << EOD\n", last, axes.time(count),
          axes.time(count));
    for (const Pressed& one : pressed(force)) {
        const bool isWall = force[static_cast<std::size_t>(one.from)] > 0.0;
        const double stop = (isWall ? axes.wall : axes.second.value()) * axes.u.factor;
        print(script, "{0:.7g} {1:.7g}\n{0:.7g} {2:.7g}\n\n", stop, axes.time(one.from),
              axes.time(one.to));
    }
    print(script, "{}EOD\n", offThePlot);
}

/// Who moves, and the key, where the panels leave room.
void printLegend(Text& script, const Subject& subject, double folded)
{
    const Bar& bar = subject.scene.bar;
    const std::optional<double> second = subject.scene.secondStop;
    std::vector<std::string> lines = subject.facts;
    lines.push_back(
        fmt::format("L = {},  c = {}", withUnit(bar.length, "m"), withUnit(bar.waveSpeed, "m/s")));
    lines.push_back(
        fmt::format("EA = {},  g = {}{}", withUnit(bar.axialStiffness, "N"), withUnit(bar.gap, "m"),
                    second ? fmt::format(",  h = {}", withUnit(*second, "m")) : std::string()));
    if (folded < period(subject.schedule)) {
        lines.push_back(fmt::format("drawn without repetitions: {:.6g} L/c", folded));
    }
    print(script, "set label 1 \"{}\" at screen 0.5,0.975 center\n", describe(subject.schedule));
    double height = 0.925;
    for (std::size_t k = 0; k < lines.size(); ++k, height -= 0.036) {
        print(script, "set label {} \"{}\" at screen 0.57,{} left\n", k + 2, lines[k], height);
    }
    print(script,
          "set key at screen 0.565,0.715 left top reverse Left samplen 2 spacing 1.2\n"
          "plot NaN with lines lw 1.5 lc '{}' title 'path of the tip', "
          "NaN with lines lw 5 lc '{}' title 'contact: {}'\nunset key\n",
          palette::ink, palette::contact, second ? "a stop presses" : "the wall presses");
    for (std::size_t k = 0; k <= lines.size(); ++k) {
        print(script, "unset label {}\n", k + 1);
    }
}

/// The initial state, one panel for each quantity, above the field.
void plotInitialState(Text& script, const Axes& axes)
{
    print(script,
          "set lmargin at screen 0.11\nset rmargin at screen 0.51\n"
          "set xrange [0:{}]\nset format x ''\nset xlabel ''\n"
          "set offsets 0,0,graph 0.12,graph 0.12\nset yrange [*<0:0<*]\n"
          "set tmargin at screen 0.94\nset bmargin at screen 0.80\n"
          "set ylabel 's(x, 0)  [{}]'\nset ytics {}\n"
          "plot $initial using 1:2 with lines lw 2 lc '{}'\n"
          "set tmargin at screen 0.775\nset bmargin at screen 0.635\n"
          "set ylabel 'v(x, 0)  [{}]'\nset ytics {}\n"
          "plot $initial using 1:3 with lines lw 2 dt (6,3) lc '{}'\n"
          "set offsets\nset format x '%g'\nset ytics autofreq\n",
          axes.x.factor, axes.s.unit, axes.strain.step(axes.s.factor), palette::strain, axes.v.unit,
          axes.velocity.step(axes.v.factor), palette::velocity);
}

void plotField(Text& script, const Axes& axes, double period)
{
    print(script,
          "{}set tmargin at screen 0.61\nset bmargin at screen 0.10\n"
          "set xlabel 'position  x  [{}]'\nset ylabel 'time  t  [{}]'\nset yrange [0:{}]\n"
          "set colorbox user origin screen 0.895,0.10 size screen 0.018,0.51\n"
          "set cblabel 'displacement  u  [{}]'\nunset grid\n"
          "plot $field using 1:2:3 with image\nunset colorbox\n",
          palette::sequential(), axes.x.unit, axes.t.unit, period, axes.u.unit);
}

/// Lines where segments meet.
void markJoints(Text& script, const Subject& subject, const Axes& axes)
{
    if (isUniform(subject.scene.segments)) {
        return;
    }
    std::int64_t cells = 0;
    const auto all = static_cast<double>(subject.schedule.cells);
    for (std::size_t k = 0; k + 1 < subject.scene.segments.size(); ++k) {
        cells += subject.scene.segments[k].cells;
        const double place = static_cast<double>(cells) / all * axes.x.factor;
        print(script,
              "set arrow {0} from {1},graph 0 to {1},graph 1 nohead front lw 1.5 dt 2 lc '{2}'\n",
              k + 1, place, palette::ink);
    }
}

/// Beside the field, with its axis of time: the tip and the wall, and the force between them.
void plotWall(Text& script, const Axes& axes, double leastForce, double mostForce)
{
    const double lowest = std::min(axes.tip.low, axes.second.value_or(axes.tip.low));
    const double reach = std::max(axes.wall - lowest, 1e-3) * axes.u.factor;
    const double wall = axes.wall * axes.u.factor;
    if (axes.second) {
        print(script,
              "set object 2 rectangle from graph 0,graph 0 to first {},graph 1 fillcolor '{}' "
              "fillstyle transparent solid 0.5 noborder behind\n"
              "set label 2 'stop' at graph 0,1.03 left\n",
              *axes.second * axes.u.factor, palette::faint);
    }
    print(script,
          "set lmargin at screen 0.55\nset rmargin at screen 0.715\nset ylabel ''\n"
          "set format y ''\nset xlabel 'tip  u(L, t)  [{}]'\nset xrange [{}:{}]\nset xtics {}\n"
          "set grid lw 0.6 lc '{}'\n"
          "set object 1 rectangle from {},graph 0 to graph 1,graph 1 fillcolor '{}' fillstyle "
          "transparent solid 0.5 noborder behind\n"
          "set label 1 'wall' at graph 1,1.03 right\n"
          "plot $tip using 1:2 with lines lw 1.5 lc '{}', "
          "$pressed using 1:2 with lines lw 5 lc '{}'\nunset object 1\nunset label 1\n"
          "unset object 2\nunset label 2\n",
          axes.u.unit, wall - (axes.second ? 1.12 : 1.05) * reach, wall + 0.12 * reach,
          niceStep(reach / 3.0), palette::grid, wall, palette::faint, palette::ink,
          palette::contact);
    const bool isPressed = mostForce > 0.0 || leastForce < 0.0;
    const double top = isPressed ? 1.15 * mostForce : 1.0;
    const double bottom = 1.15 * leastForce;
    print(script,
          "set lmargin at screen 0.74\nset rmargin at screen 0.86\n"
          "set xlabel '{}  [{}]'\nset xrange [{}:{}]\nset xtics {}\n{}"
          "plot $force using 1:2 with filledcurves closed fillcolor '{}' fillstyle solid 0.35 "
          "noborder, $force using 1:2 with lines lw 1.5 lc '{}'\n",
          axes.second ? "force" : "wall force", axes.force.unit, bottom, top,
          niceStep((top - bottom) / (axes.second ? 4.0 : 2.5)),
          isPressed ? ""
                    : "set label 1 'none: contact without force' at graph 0.5,0.5 center "
                      "rotate\n",
          palette::contact, palette::contact);
}

std::string scriptFor(const Subject& subject)
{
    const Drawing drawing = finelyDrawn(subject);
    const Axes axes = axesOf(drawing, subject.scene);
    const std::vector<double>& force = drawing.force;
    Text script;
    printInitialState(script, drawing.motion, axes);
    printField(script, drawing.motion, axes);
    printForce(script, force, axes);
    print(script, "set multiplot\nunset border\nunset tics\nset xrange [0:1]\nset yrange [0:1]\n");
    printLegend(script, subject, period(drawing.schedule));
    print(script,
          "set autoscale y\nset border 31 lw 0.8\nset tics out nomirror scale 0.6\n"
          "set grid lw 0.6 lc '{}'\n",
          palette::grid);
    markJoints(script, subject, axes);
    plotInitialState(script, axes);
    plotField(script, axes, axes.time(drawing.motion.steps()));
    print(script, "unset arrow\n");
    const auto [least, most] = std::minmax_element(force.begin(), force.end());
    plotWall(script, axes, *least * axes.force.factor, *most * axes.force.factor);
    print(script, "unset multiplot\n");
    return fmt::to_string(script);
}

/// "T = 8 L/c = 8 s" and the frequency.
std::vector<std::string> timesOf(const Schedule& schedule, const Bar& bar)
{
    const double time = period(schedule) * scales(bar).time;
    return {fmt::format("T = {:.6g} L/c = {}", period(schedule), withUnit(time, "s")),
            fmt::format("f = {},  ω/ω_1 = {:.5g}", withUnit(1.0 / time, "Hz"),
                        frequencyRatio(schedule))};
}

void draw(const Subject& subject, FigureFormat format, const std::string& path)
{
    if (!isUniform(subject.scene.segments) && !haveOneSpeed(subject.scene.segments)) {
        throw std::invalid_argument(
            "figure: allowed only for segments in which waves have one speed");
    }
    runGnuplot(scriptFor(subject), format, 18.0, 16.0, path);
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
    std::vector<std::string> facts = timesOf(result.schedule, result.scene.bar);
    facts.push_back(fmt::format("E = {}", withUnit(result.motion->energy, "J")) +
                    (result.scene.bar.gap == 0.0
                         ? std::string()
                         : fmt::format(",  E/E_1 = {:.5g}", result.motion->energyRatio)));
    draw({result.motion->state, result.schedule, result.scene, std::move(facts)}, format, path);
}

void drawMotion(const ForcedMotion& motion, const Scene& scene, FigureFormat format,
                const std::string& path)
{
    const Scales unit = scales(scene.bar);
    const bool isTip = motion.excitation.place == Excited::tip;
    std::vector<std::string> facts = timesOf(motion.schedule, scene.bar);
    facts.push_back(
        fmt::format("{} {},  ζ = {:.4g}", isTip ? "force on the tip" : "base moved by",
                    isTip ? withUnit(motion.amplitude * scene.bar.axialStiffness * unit.strain, "N")
                          : withUnit(motion.amplitude * unit.displacement, "m"),
                    motion.damping.ratio));
    draw(
        {motion.state, motion.schedule, scene, std::move(facts), motion.damping, motion.excitation},
        format, path);
}

}  // namespace signorini
