#include "signorini/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "axes.hpp"
#include "gnuplot.hpp"
#include "palette.hpp"
#include "signorini/motion.hpp"
#include "text.hpp"
#include "wall_force.hpp"

namespace signorini {

namespace {

constexpr std::size_t maxMembers = 16;
constexpr std::int64_t nodesOfMember = 201;
constexpr std::int64_t instantsOfMember = 401;

/// The dashes of the first, the middle and the last member, in every panel.
constexpr std::array dashes{"dt solid", "dt (6,3)", "dt (2,2)"};
constexpr std::array dashNames{"solid", "dashed", "dotted"};

/// Points to stack, evenly, and the places among them of those drawn in full.
struct ShownMembers {
    std::vector<std::size_t> members;
    std::vector<std::size_t> full;
};

ShownMembers choose(const Continuum& curve)
{
    const std::size_t last = curve.points.size() - 1;
    const std::size_t gaps = std::min(last, maxMembers - 1);
    ShownMembers choice;
    for (std::size_t k = 0; k <= gaps; ++k) {
        choice.members.push_back(gaps == 0 ? 0 : k * last / gaps);
    }
    for (const std::size_t k : {std::size_t{0}, gaps / 2, gaps}) {
        if (choice.full.empty() || choice.full.back() != k) {
            choice.full.push_back(k);
        }
    }
    return choice;
}

/// What is stacked in one panel: a profile of each member, constant on pieces of equal width.
struct Stack {
    const char* table;
    std::string title;
    std::string axis;
    const char* colour;
    double width;  ///< [unit of the axis], of a piece
    double scale;  ///< [SI], of 1
    const char* base;
    std::vector<std::vector<double>> profiles;

    [[nodiscard]] double largest() const
    {
        double size = 0.0;
        for (const std::vector<double>& profile : profiles) {
            for (const double value : profile) {
                size = std::max(size, std::abs(value));
            }
        }
        return size;
    }
    /// The longest profile, without the zeros at its end.
    [[nodiscard]] double length() const
    {
        std::size_t pieces = 0;
        for (const std::vector<double>& profile : profiles) {
            const auto last = std::find_if(profile.rbegin(), profile.rend(),
                                           [](double value) { return value != 0.0; });
            pieces = std::max(pieces, static_cast<std::size_t>(profile.rend() - last));
        }
        return width * static_cast<double>(pieces > 0 ? pieces : profiles.front().size());
    }
};

std::vector<double> values(const Eigen::VectorXd& vector)
{
    return {vector.begin(), vector.end()};
}

std::vector<Stack> stacksOf(const Continuum& curve, const ShownMembers& choice)
{
    const Scales unit = scales(curve.scene.bar);
    const auto cells = static_cast<double>(curve.schedule.cells);
    const Unit metre = unitFor(curve.scene.bar.length, "m");
    Schedule folded = curve.schedule;
    fold(folded);
    const Unit second = unitFor(period(folded) * unit.time, "s");
    const std::string position = fmt::format("position  x  [{}]", metre.name);
    const double dx = curve.scene.bar.length * metre.factor / cells;
    std::vector<Stack> stacks{
        {"force",
         curve.scene.secondStop ? "force of the stops" : "force of the wall",
         fmt::format("time  t  [{}]", second.name),
         palette::contact,
         unit.time * second.factor / cells,
         curve.scene.bar.axialStiffness * unit.strain,
         "N",
         {}},
        {"strain", "strain  s(x, 0)", position, palette::strain, dx, unit.strain, "", {}},
        {"velocity",
         "velocity  v(x, 0)",
         position,
         palette::velocity,
         dx,
         unit.velocity,
         "m/s",
         {}}};
    for (const std::size_t k : choice.members) {
        const State& state = curve.points[k].state;
        stacks[0].profiles.push_back(wallForces(Motion(state, curve.schedule)));
        stacks[1].profiles.push_back(values(strain(state)));
        stacks[2].profiles.push_back(values(velocity(state)));
    }
    return stacks;
}

/// One profile, raised to its lambda: only where it changes, and both sides of the change.
void printProfile(Text& script, const Stack& stack, std::size_t k, double base, double raise)
{
    const std::vector<double>& profile = stack.profiles[k];
    const auto row = [&](std::size_t place, double value) {
        print(script, "{:.7g} {:.7g} {}\n", static_cast<double>(place) * stack.width,
              base + raise * value, base);
    };
    print(script, "${}{} << EOD\n", stack.table, k);
    row(0, profile.front());
    for (std::size_t i = 1; i < profile.size(); ++i) {
        if (profile[i] != profile[i - 1]) {
            row(i, profile[i - 1]);
            row(i, profile[i]);
        }
    }
    row(profile.size(), profile.back());
    print(script, "EOD\n");
}

const char* unitOf(const Continuum& curve)
{
    switch (curve.parameter) {
        case Parameter::arcLength:
            return curve.scene.bar.gap != 0.0 ? "arc length λ [√E_1]" : "arc length λ [√(EA L/2)]";
        case Parameter::pause:
            return "pause λ between the pulses [L/c]";
        case Parameter::number:
            return "number λ of the motion";
    }
    return "λ";
}

/// The members stacked upwards by lambda, those drawn in full in black.
void plotStack(Text& script, const Stack& stack, const ShownMembers& choice)
{
    print(script, "plot ");
    for (std::size_t k = choice.members.size(); k-- > 0;) {
        // From the top down: each member covers what stands behind it.
        print(script,
              "${0}{1} using 1:2:3 with filledcurves fillcolor '{2}' fillstyle transparent solid "
              "0.25 noborder, ${0}{1} using 1:2 with lines lw 0.8 lc '{2}', ",
              stack.table, k, stack.colour);
    }
    for (std::size_t k = 0; k < choice.full.size(); ++k) {
        print(script, "{}${}{} using 1:2 with lines lw 1.8 lc '{}' {}", k == 0 ? "" : ", ",
              stack.table, choice.full[k], palette::ink, dashes.at(k));
    }
    print(script, "\n");
}

/// The paper's Fig. 2, and the force that tells orbits apart: it is the same at every start.
void printStacks(Text& script, const Continuum& curve, const ShownMembers& choice)
{
    const std::vector<Stack> stacks = stacksOf(curve, choice);
    const double low = curve.points.front().lambda;
    const double high = curve.points.back().lambda;
    const double range = high > low ? high - low : 1.0;
    const double step = range / static_cast<double>(choice.members.size());
    print(script,
          "set border lw 0.8\nset tics out nomirror scale 0.6\nunset key\n"
          "set yrange [{}:{}]\nset tmargin at screen 0.90\nset bmargin at screen 0.54\n"
          "set ylabel '{}'\n",
          low - 1.5 * step, high + 2.6 * step, unitOf(curve));
    double left = 0.105;
    for (const Stack& stack : stacks) {
        const double size = stack.largest();
        const double raise = size > 0.0 ? 2.2 * step / size : 0.0;
        for (std::size_t k = 0; k < choice.members.size(); ++k) {
            printProfile(script, stack, k, curve.points[choice.members[k]].lambda, raise);
        }
        print(script,
              "set lmargin at screen {}\nset rmargin at screen {}\nset xrange [0:{:.6g}]\n"
              "set xlabel '{}' offset 0,0.4\nset xtics {:.3g}\n"
              "set label 3 '{}' at graph 0.5,1.05 center\n"
              "set arrow 1 from graph 1.03,first {} to graph 1.03,first {} heads size graph "
              "0.01,90 lw 1.2\n"
              "set label 4 '{}' at graph 1.07,first {} left rotate\n",
              left, left + 0.235, stack.length(), stack.axis, niceStep(stack.length() / 3.0),
              stack.title, low, low + raise * size, withUnit(size * stack.scale, stack.base), low);
        plotStack(script, stack, choice);
        print(script,
              "unset label 1\nunset label 3\nunset label 4\nunset arrow 1\n"
              "set ylabel ''\nset format y ''\n");
        left += 0.3;
    }
}

/// u(x, t) on an even grid and the path of the tip; the lowest and highest u, in [g].
std::pair<double, double> printField(Text& script, const Motion& motion, std::size_t number,
                                     double length, double time, double gap)
{
    const auto cells = static_cast<double>(motion.cells());
    std::pair<double, double> range{0.0, 0.0};
    print(script, "$field{} << EOD\n", number);
    for (const std::int64_t m : evenly(motion.steps(), instantsOfMember)) {
        for (const std::int64_t i : evenly(motion.cells(), nodesOfMember)) {
            const double u = motion.displacement(i, m);
            range = {std::min(range.first, u), std::max(range.second, u)};
            print(script, "{:.7g} {:.7g} {:.5g}\n", static_cast<double>(i) / cells * length,
                  static_cast<double>(m) / cells * time, u * gap);
        }
    }
    print(script, "EOD\n");
    return range;
}

/// The paper's Fig. 3, for the members drawn in full above.
void printMotions(Text& script, const Continuum& curve, const ShownMembers& choice)
{
    const Scales scale = scales(curve.scene.bar);
    const Unit metre = unitFor(curve.scene.bar.length, "m");
    const ContinuumPoint& first = curve.points.front();
    const double reach =
        curve.scene.bar.gap != 0.0 ? 1.0 : -extremesOf(first.state, curve.schedule).lowestTip;
    const Unit deflection = unitFor(scale.displacement * reach, "m");
    const Unit second = unitFor(period(curve.schedule) * scale.time, "s");
    const double time = scale.time * second.factor;
    double lowest = 0.0;
    double highest = 0.0;
    double end = 0.0;
    for (std::size_t k = 0; k < choice.full.size(); ++k) {
        const ContinuumPoint& point = curve.points[choice.members[choice.full[k]]];
        const Motion motion(point.state, curve.schedule);
        const auto [low, high] =
            printField(script, motion, k, curve.scene.bar.length * metre.factor, time,
                       scale.displacement * deflection.factor);
        lowest = std::min(lowest, low);
        highest = std::max(highest, high);
        end = static_cast<double>(motion.steps()) / static_cast<double>(motion.cells()) * time;
    }
    print(
        script,
        "{}set cbrange [{:.5g}:{:.5g}]\nset xrange [0:{}]\nset yrange [0:{}]\n"
        "set tmargin at screen 0.42\nset bmargin at screen 0.08\n"
        "set xlabel 'position  x  [{}]'\nset xtics {}\nset cblabel 'displacement  u(x, t)  [{}]'\n"
        "set ylabel 'time  t  [{}]'\nset format y '%g'\nunset colorbox\n",
        palette::sequential(), lowest * scale.displacement * deflection.factor,
        highest * scale.displacement * deflection.factor, curve.scene.bar.length * metre.factor,
        end, metre.name, niceStep(curve.scene.bar.length * metre.factor / 3.0), deflection.name,
        second.name);
    double left = 0.105;
    for (std::size_t k = 0; k < choice.full.size(); ++k, left += 0.265) {
        const ContinuumPoint& point = curve.points[choice.members[choice.full[k]]];
        print(script,
              "set lmargin at screen {}\nset rmargin at screen {}\n{}"
              "set label 3 'λ = {:.4g}, {}' at graph 0.5,1.05 center\n"
              "plot $field{} using 1:2:3 with image\nset ylabel ''\nset format y ''\n",
              left, left + 0.24,
              k + 1 == choice.full.size()
                  ? fmt::format("set colorbox user origin screen {},0.08 size screen 0.015,0.34\n",
                                left + 0.26)
                  : std::string(),
              point.lambda, dashNames.at(k), k);
    }
}

}  // namespace

void drawContinuum(const Continuum& curve, FigureFormat format, const std::string& path)
{
    if (curve.points.empty()) {
        throw std::invalid_argument("figure: the curve holds no motion to draw");
    }
    const ShownMembers choice = choose(curve);
    Text script;
    print(script,
          "set multiplot\nset label 1 \"{}   ω/ω_1 = {:.5g}   {}   {}, {} motions\" at "
          "screen 0.5,0.97 center\n",
          describe(curve.schedule), frequencyRatio(curve.schedule),
          energyLabel(curve.scene.bar, curve.energyRatio), curve.family, curve.points.size());
    printStacks(script, curve, choice);
    printMotions(script, curve, choice);
    print(script, "unset multiplot\n");
    runGnuplot(fmt::to_string(script), format, 18.0, 19.0, path);
}

}  // namespace signorini
