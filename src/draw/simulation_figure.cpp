#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "axes.hpp"
#include "gnuplot.hpp"
#include "palette.hpp"
#include "signorini/figures.hpp"
#include "stops.hpp"
#include "text.hpp"

namespace signorini {

namespace {

constexpr double shownPeriods = 4.0;
constexpr double shownTime = 16.0;  // [L/c], of a bar that nothing excites
constexpr std::size_t maxPoints = 4000;
constexpr std::size_t maxContacts = 20'000;

/// What numbers of the simulation are multiplied with for the axes, and the names of their units.
struct SimulationAxes {
    Unit time;
    Unit place;
    Unit impulse;

    SimulationAxes(const BarSimulation& simulation, const Bar& bar, double farthest)
    {
        const Scales si = scales(bar);
        double largest = 0.0;
        for (const ContactEvent& contact : simulation.contacts()) {
            largest = std::max(largest, contact.impulse);
        }
        const double impulseUnit = bar.axialStiffness * si.strain * si.time;
        time = scaled(simulation.time(), si.time, "s");
        place = scaled(farthest, si.displacement, "m");
        impulse = scaled(largest, impulseUnit, "N s");
    }

private:
    static Unit scaled(double largest, double unit, const char* base)
    {
        Unit made = unitFor(largest * unit, base);
        made.factor *= unit;
        return made;
    }
};

/// A stretch of time [L/c].
struct Window {
    double begin;
    double end;
};

/// The path of the tip in a window, thinned to what print can show.
void printTip(Text& script, const char* block, const std::vector<TipPoint>& path, Window window,
              const SimulationAxes& axes)
{
    const auto isBefore = [](const TipPoint& point, double time) { return point.time < time; };
    auto first = std::lower_bound(path.begin(), path.end(), window.begin, isBefore);
    const auto last = std::lower_bound(first, path.end(), window.end, isBefore);
    first -= first == path.begin() ? 0 : 1;
    const auto count = static_cast<std::size_t>(last - first);
    const std::size_t stride = 1 + count / maxPoints;
    print(script, "${} << EOD\n", block);
    for (std::size_t k = 0; k <= count; k += stride) {
        const auto at = first + static_cast<std::ptrdiff_t>(k);
        if (at != path.end()) {
            print(script, "{:.9g} {:.7g}\n", axes.time.factor * at->time,
                  axes.place.factor * at->displacement);
        }
    }
    print(script, "EOD\n");
}

/// The contacts of a window as strokes at the stop that is touched.
void printStrokes(Text& script, const char* block, const BarSimulation& simulation, Window window,
                  const SimulationAxes& axes)
{
    print(script, "${} << EOD\nNaN NaN NaN\n", block);
    for (const ContactEvent& contact : simulation.contacts()) {
        if (contact.end > window.begin && contact.start < window.end) {
            const double start = std::max(contact.start, window.begin);
            print(script, "{:.9g} {:.6g} {:.6g}\n", axes.time.factor * start,
                  axes.time.factor * (std::min(contact.end, window.end) - start),
                  axes.place.factor * placeOf(simulation.stops(), contact.stop).value());
        }
    }
    print(script, "EOD\n");
}

void printImpulses(Text& script, const std::vector<ContactEvent>& contacts,
                   const SimulationAxes& axes)
{
    const std::size_t stride = 1 + contacts.size() / maxContacts;
    print(script, "$impulses << EOD\nNaN NaN\n");
    for (std::size_t k = 0; k < contacts.size(); k += stride) {
        print(script, "{:.9g} {:.7g}\n", axes.time.factor * contacts[k].start,
              axes.impulse.factor * contacts[k].impulse);
    }
    print(script, "EOD\n");
}

void plotTip(Text& script, const char* name, Window window, const Stops& stops,
             const SimulationAxes& axes, bool isNamed)
{
    window = {axes.time.factor * window.begin, axes.time.factor * window.end};
    if (stops.left) {
        print(script,
              "set object 2 rectangle from graph 0,graph 0 to graph 1,first {:.9g} fillcolor '{}' "
              "fillstyle solid noborder behind\n",
              axes.place.factor * placeOf(stops, Stop::left).value(), palette::faint);
    }
    print(script,
          "set xrange [{1:.9g}:{2:.9g}]\nset xtics {3:.9g}\nset object 1 rectangle from graph "
          "0,first {7} to graph "
          "1,graph 1 fillcolor '{4}' fillstyle solid noborder behind\n"
          "plot $tip{0} using 1:2 with lines lw 1.2 lc '{5}' {8}, "
          "$contact{0} using 1:3:2:(0) with vectors nohead lw 5 lc '{6}' {9}\n",
          name, window.begin, window.end, niceStep((window.end - window.begin) / 5.0),
          palette::faint, palette::ink, palette::contact, axes.place.factor * stops.right,
          isNamed ? "title 'tip'" : "notitle", isNamed ? "title 'contact'" : "notitle");
}

}  // namespace

void drawSimulation(const BarSimulation& simulation, const Excitation& excitation, const Bar& bar,
                    FigureFormat format, const std::string& path)
{
    const std::vector<TipPoint>& tip = simulation.tipPath();
    if (tip.size() < 2) {
        throw std::invalid_argument("figure: the simulation holds no path of the tip to draw");
    }
    const double end = simulation.time();
    const double period = excitation.steps() > 0 ? static_cast<double>(excitation.steps()) /
                                                       excitation.stepsPerCrossing
                                                 : shownTime / shownPeriods;
    const double shown = std::min(end, shownPeriods * period);
    const std::array<Window, 2> windows{{{0.0, shown}, {end - shown, end}}};
    const std::array names{"first", "last"};
    Text script;
    const Stops& stops = simulation.stops();
    const double wall = stops.right;
    double lowest = std::min(0.0, stops.left ? placeOf(stops, Stop::left).value() : wall - 0.1);
    for (const TipPoint& point : tip) {
        lowest = std::min(lowest, point.displacement);
    }
    const SimulationAxes axes(simulation, bar, std::max(std::abs(lowest), std::abs(wall)));
    for (std::size_t k = 0; k < 2; ++k) {
        printTip(script, fmt::format("tip{}", names[k]).c_str(), tip, windows[k], axes);
        printStrokes(script, fmt::format("contact{}", names[k]).c_str(), simulation, windows[k],
                     axes);
    }
    printImpulses(script, simulation.contacts(), axes);
    print(script,
          "set multiplot\nset border lw 0.8\nset tics out nomirror scale 0.6\n"
          "set grid lw 0.4 lc '{}'\nset tmargin at screen 0.90\nset bmargin at screen 0.58\n"
          "set yrange [{:.5g}:{:.5g}]\nset xlabel 'time  [{}]' offset 0,0.4\n"
          "set lmargin at screen 0.12\nset rmargin at screen 0.53\n"
          "set key horizontal at screen 0.97,0.985 right top samplen 1.6\n"
          "set ylabel 'tip  u(L,t)  [{}]'\nset label 1 'the beginning' at graph 0.5,1.06 center\n",
          palette::grid, axes.place.factor * (wall - 1.08 * (wall - lowest)),
          axes.place.factor * (wall + 0.08 * (wall - lowest)), axes.time.name, axes.place.name);
    plotTip(script, "first", windows[0], stops, axes, true);
    print(script,
          "set lmargin at screen 0.57\nset rmargin at screen 0.97\nset ylabel ''\n"
          "set format y ''\nset label 1 'the end' at graph 0.5,1.06 center\n");
    plotTip(script, "last", windows[1], stops, axes, false);
    print(script,
          "unset label 1\nunset object 1\nunset object 2\nset format y '%g'\nset lmargin at screen "
          "0.12\n"
          "set tmargin at screen 0.44\nset bmargin at screen 0.12\nset xtics auto\nset xrange "
          "[0:{:.9g}]\n"
          "set yrange [0:*]\nset offsets 0,0,graph 0.06,0\nset xlabel 'time  [{}]' offset 0,0\n"
          "set ylabel 'impulse of a contact  [{}]'\n",
          axes.time.factor * end, axes.time.name, axes.impulse.name);
    if (simulation.contacts().empty()) {
        print(script, "set yrange [0:1]\nset label 2 'no contact' at graph 0.5,0.5 center\n");
    }
    print(script,
          "plot $impulses using 1:2 with points pt 7 ps 0.4 lc '{}' notitle\n"
          "unset multiplot\n",
          palette::contact);
    runGnuplot(fmt::to_string(script), format, 16.0, 12.0, path);
}

}  // namespace signorini
