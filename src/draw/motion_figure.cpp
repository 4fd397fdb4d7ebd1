#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "axes.hpp"
#include "bar_check.hpp"
#include "faults.hpp"
#include "field.hpp"
#include "scene_figures.hpp"
#include "signorini/figures.hpp"
#include "signorini/motion.hpp"
#include "stepped_bar.hpp"
#include "text.hpp"

namespace signorini {

namespace {

using namespace plot;

constexpr std::int64_t maxTipInstants = 4001;
constexpr std::int64_t maxNodes = 301;
constexpr std::int64_t maxInstants = 701;

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

/// The panels, which share their axes of x and t.
class MotionPanels {
public:
    explicit MotionPanels(const Subject& subject)
        : subject_(subject),
          drawing_(finelyDrawn(subject)),
          motion_(drawing_.motion),
          scale_(scales(subject.scene.bar)),
          cells_(static_cast<double>(motion_.cells())),
          wall_(subject.scene.bar.gap / scale_.displacement)
    {
        if (subject.scene.secondStop) {
            second_ = -*subject.scene.secondStop / scale_.displacement;
        }
        double reach = 0.0;
        for (std::int64_t m = 0; m <= motion_.steps(); ++m) {
            const double tip = motion_.displacement(motion_.cells(), m);
            lowest_ = std::min(lowest_, tip);
            reach = std::max(reach, std::abs(tip));
        }
        metre_ = axisUnit(subject.scene.bar.length, 1.0, "m");
        time_ = axisUnit(scale_.time, end(), "s");
        place_ = axisUnit(scale_.displacement, reach, "m");
    }

    [[nodiscard]] FigureData figure() const
    {
        FigureData figure{.width = 18.0, .height = 16.0};
        figure.title = describe(subject_.schedule);
        figure.panels = {
            words(),
            profile("strain", 0.80, "s(x, 0)", scale_.strain, "", Role::strain, &Motion::strain),
            profile("velocity", 0.635, "v(x, 0)", scale_.velocity, "m/s", Role::velocity,
                    &Motion::velocity),
            field(),
            tip(),
            force()};
        return figure;
    }

private:
    [[nodiscard]] double end() const { return static_cast<double>(motion_.steps()) / cells_; }
    [[nodiscard]] double at(std::int64_t step) const
    {
        return static_cast<double>(step) / cells_ * time_.factor;
    }

    /// Who moves, and the legend, where the panels leave room.
    [[nodiscard]] Panel words() const
    {
        const Bar& bar = subject_.scene.bar;
        std::vector<std::string> lines = subject_.facts;
        lines.push_back(fmt::format("L = {},  c = {}", withUnit(bar.length, "m"),
                                    withUnit(bar.waveSpeed, "m/s")));
        lines.push_back(fmt::format(
            "EA = {},  g = {}{}", withUnit(bar.axialStiffness, "N"), withUnit(bar.gap, "m"),
            subject_.scene.secondStop ? ",  h = " + withUnit(*subject_.scene.secondStop, "m")
                                      : ""));
        if (period(drawing_.schedule) < period(subject_.schedule)) {
            lines.push_back(
                fmt::format("drawn without repetitions: {:.6g} L/c", period(drawing_.schedule)));
        }
        Panel panel{.name = "words", .place = {0.56, 0.98, 0.64, 0.94}, .isFramed = false};
        panel.x = {.low = 0.0, .high = 1.0};
        panel.y = {.low = 0.0, .high = 1.0};
        panel.legend = Legend::bottomLeft;
        Series said = notes();
        for (std::size_t k = 0; k < lines.size(); ++k) {
            said.add(0.02, 0.95 - 0.12 * static_cast<double>(k), lines[k]);
        }
        panel.explain({}, "path of the tip");
        panel.explain(line(Role::contact, 5.0),
                      second_ ? "contact: a stop presses" : "contact: the wall presses");
        panel.add(std::move(said));
        return panel;
    }

    [[nodiscard]] Axis position() const
    {
        return {.label = labelled("position  x", metre_), .low = 0.0, .high = metre_.factor};
    }

    /// A field at t = 0, constant on each cell.
    Panel profile(const char* name, double bottom, const char* words, double scale,
                  const char* base, Role role,
                  double (Motion::*value)(std::int64_t, std::int64_t) const) const
    {
        double low = 0.0;
        double high = 0.0;
        for (std::int64_t i = 1; i <= motion_.cells(); ++i) {
            low = std::min(low, (motion_.*value)(i, 0));
            high = std::max(high, (motion_.*value)(i, 0));
        }
        const Unit unit = axisUnit(scale, std::max(high, -low), base);
        const double span = std::max(high - low, 1e-9 / unit.factor);
        Panel panel{.name = name, .place = {0.11, 0.51, bottom, bottom + 0.14}};
        panel.x = bare(position());
        panel.y = axisIn(unit, words, low - 0.14 * span, high + 0.14 * span);
        panel.y.step = niceStep(span * unit.factor / 3.5);
        Series line = plot::line(role, 2.0);
        line.dash = role == Role::velocity ? Dash::dashed : Dash::solid;
        for (std::int64_t i = 1; i <= motion_.cells(); ++i) {
            const double left = static_cast<double>(i - 1) / cells_ * metre_.factor;
            line.addStep(left, static_cast<double>(i) / cells_ * metre_.factor,
                         (motion_.*value)(i, 0) * unit.factor);
        }
        panel.add(std::move(line));
        markJoints(panel);
        return panel;
    }

    /// Lines where segments meet.
    void markJoints(Panel& panel) const
    {
        const std::vector<Segment>& segments = subject_.scene.segments;
        std::int64_t cells = 0;
        for (std::size_t k = 0; !isUniform(segments) && k + 1 < segments.size(); ++k) {
            cells += segments[k].cells;
            const double place = static_cast<double>(cells) /
                                 static_cast<double>(subject_.schedule.cells) * metre_.factor;
            panel.add({.dash = Dash::dashed,
                       .x = {place, place},
                       .y = {panel.y.low.value_or(0.0), panel.y.high.value_or(1.0)}});
        }
    }

    [[nodiscard]] Panel field() const
    {
        Panel panel{.name = "displacement", .place = {0.11, 0.51, 0.10, 0.61}, .hasGrid = false};
        panel.x = position();
        panel.y = axisIn(time_, "time  t", 0.0, end());
        panel.colour.label = labelled("displacement  u", place_);
        panel.colourBar = Place{0.895, 0.913, 0.10, 0.61};
        panel.add(
            fieldOf(motion_, metre_.factor, time_.factor, place_.factor, maxNodes, maxInstants));
        markJoints(panel);
        return panel;
    }

    /// Beside the field, with its axis of time: the tip between its stops.
    [[nodiscard]] Panel tip() const
    {
        const double lowest = std::min(lowest_, second_.value_or(lowest_));
        const double reach = std::max(wall_ - lowest, 1e-3);
        Panel panel{.name = "tip", .place = {0.55, 0.715, 0.10, 0.61}};
        panel.x = axisIn(place_, "tip  u(L, t)", wall_ - (second_ ? 1.12 : 1.05) * reach,
                         wall_ + 0.12 * reach);
        panel.x.step = niceStep(reach * place_.factor / 3.0);
        panel.y = beside();
        const auto stop = [&](double from, double to, const char* name, Align align) {
            Series place = box(Role::faint, from, 0.0, to, *panel.y.high);
            place.opacity = 0.5;
            panel.add(std::move(place));
            Series word = notes(align);
            word.add(align == Align::left ? 0.0 : 1.0, 1.03, name);
            panel.add(std::move(word));
        };
        stop(wall_ * place_.factor, *panel.x.high, "wall", Align::right);
        if (second_) {
            stop(*panel.x.low, *second_ * place_.factor, "stop", Align::left);
        }
        Series path;
        for (const std::int64_t m : thinned(motion_.steps(), maxTipInstants)) {
            path.add(motion_.displacement(motion_.cells(), m) * place_.factor, at(m));
        }
        panel.add(std::move(path));
        Series presses = plot::strokes(Role::contact, 5.0);
        for (const Pressed& one : pressed(drawing_.force)) {
            const bool isWall = drawing_.force[static_cast<std::size_t>(one.from)] > 0.0;
            const double place = (isWall ? wall_ : second_.value()) * place_.factor;
            presses.add(place, at(one.from), place, at(one.to));
        }
        panel.add(std::move(presses));
        return panel;
    }

    [[nodiscard]] Axis beside() const
    {
        return {.low = 0.0, .high = end() * time_.factor, .hasNumbers = false};
    }

    [[nodiscard]] Panel force() const
    {
        const auto [least, most] =
            std::minmax_element(drawing_.force.begin(), drawing_.force.end());
        const bool isPressed = *most > 0.0 || *least < 0.0;
        const Unit unit = axisUnit(subject_.scene.bar.axialStiffness * scale_.strain,
                                   isPressed ? std::max(*most, -*least) : 1.0, "N");
        Panel panel{.name = "force", .place = {0.74, 0.86, 0.10, 0.61}};
        panel.x = axisIn(unit, second_ ? "force" : "wall force", 1.15 * *least,
                         isPressed ? 1.15 * *most : 1.0);
        const double span = *panel.x.high - *panel.x.low;
        panel.x.step = niceStep(span / (second_ ? 4.2 : 2.5));
        if (second_ && span / panel.x.step < 2.5) {  // 0 is one tick, there are to be others
            panel.x.step /= 2.0;
        }
        panel.y = beside();
        Series line = plot::line(Role::contact, 1.5);
        line.add(0.0, 0.0);
        for (std::size_t m = 0; m < drawing_.force.size(); ++m) {
            const double value = drawing_.force[m] * unit.factor;
            if (line.x.back() != value) {
                line.add(line.x.back(), at(static_cast<std::int64_t>(m)));
                line.add(value, at(static_cast<std::int64_t>(m)));
            }
        }
        line.add(line.x.back(), end() * time_.factor);
        line.add(0.0, end() * time_.factor);
        Series area = line;
        area.kind = Kind::band;
        area.opacity = 0.35;
        panel.add(std::move(area));
        panel.add(std::move(line));
        if (!isPressed) {
            Series word = notes(Align::centre);
            word.turn = 90.0;
            word.add(0.5, 0.5, "none: contact without force");
            panel.add(std::move(word));
        }
        return panel;
    }

    const Subject& subject_;
    Drawing drawing_;
    const Motion& motion_;
    Scales scale_;
    double cells_;                  ///< N: steps and cells are 1/N
    double wall_;                   ///< [g], where the tip meets it
    std::optional<double> second_;  ///< [g], the second stop
    double lowest_ = 0.0;           ///< [g], of the tip
    Unit metre_;
    Unit time_;
    Unit place_;
};

/// "T = 8 L/c = 8 s" and the frequency.
std::vector<std::string> timesOf(const Schedule& schedule, const Bar& bar)
{
    const double time = period(schedule) * scales(bar).time;
    return {fmt::format("T = {:.6g} L/c = {}", period(schedule), withUnit(time, "s")),
            fmt::format("f = {},  ω/ω_1 = {:.5g}", withUnit(1.0 / time, "Hz"),
                        frequencyRatio(schedule))};
}

FigureData figureOf(const Subject& subject)
{
    if (!haveOneSpeed(subject.scene.segments)) {  // its nodes are on no even grid
        const Network network = networkOf(subject.scene, subject.schedule.cells, subject.damping);
        return periodFigure(network,
                            claimOf(network, subject.state, subject.schedule, subject.excitation),
                            subject.scene.bar.length);
    }
    return MotionPanels(subject).figure();
}

FigureData freeFigure(const State& state, const Schedule& schedule, const Scene& scene,
                      double joule, double ratio)
{
    std::vector<std::string> facts = timesOf(schedule, scene.bar);
    facts.push_back(
        fmt::format("E = {}", withUnit(joule, "J")) +
        (scene.bar.gap == 0.0 ? std::string() : fmt::format(",  E/E_1 = {:.5g}", ratio)));
    return figureOf({state, schedule, scene, std::move(facts)});
}

}  // namespace

FigureData motionFigure(const PeriodicResult& result)
{
    if (!result.motion) {
        throw std::invalid_argument("figure: the result holds no motion to draw");
    }
    return freeFigure(result.motion->state, result.schedule, result.scene, result.motion->energy,
                      result.motion->energyRatio);
}

FigureData motionFigure(const State& state, const Schedule& schedule, const Scene& scene)
{
    const double ratio = energyRatio(state, scene.segments);
    return freeFigure(state, schedule, scene, ratio * scales(scene.bar).energy, ratio);
}

FigureData motionFigure(const ForcedMotion& motion, const Scene& scene)
{
    const Scales unit = scales(scene.bar);
    const bool isTip = motion.excitation.place == Excited::tip;
    std::vector<std::string> facts = timesOf(motion.schedule, scene.bar);
    facts.push_back(
        fmt::format("{} {},  ζ = {:.4g}", isTip ? "force on the tip" : "base moved by",
                    isTip ? withUnit(motion.amplitude * scene.bar.axialStiffness * unit.strain, "N")
                          : withUnit(motion.amplitude * unit.displacement, "m"),
                    motion.damping.ratio));
    return figureOf({motion.state, motion.schedule, scene, std::move(facts), motion.damping,
                     motion.excitation});
}

}  // namespace signorini
