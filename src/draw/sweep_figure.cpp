#include <fmt/format.h>

#include "axes.hpp"
#include "excited_amplitude.hpp"
#include "largest.hpp"
#include "signorini/figures.hpp"
#include "two_panels.hpp"

namespace signorini {

namespace {

using namespace plot;

/// What is varied: its words, and what 1 in the range is on the axis.
struct Varied {
    const char* words;
    Unit unit;
};

Varied variedIn(const SweepRange& range, const Bar& bar)
{
    const Scales unit = scales(bar);
    const bool isForce = range.place == Excited::tip;
    switch (range.over) {
        case Swept::frequency:
            return {"frequency of the excitation", {0.25 / unit.time, "Hz"}};
        case Swept::amplitude:
            return {isForce ? "amplitude of the force" : "amplitude of the base",
                    axisUnit(isForce ? bar.axialStiffness * unit.strain : unit.displacement,
                             range.most, isForce ? "N" : "m")};
        case Swept::gap:
            return {"gap", axisUnit(unit.displacement, range.most, "m")};
        case Swept::damping:
            break;
    }
    return {"damping ratio ζ", {1.0, "–"}};
}

Axis axisOfSwept(const SweepRange& range, const Bar& bar)
{
    const double margin = range.most > range.least ? 0.01 * (range.most - range.least) : 0.05;
    const auto [words, unit] = variedIn(range, bar);
    return axisIn(unit, words, range.least - margin, range.most + margin,
                  range.over == Swept::frequency ? "ω/ω_1" : "");
}

std::string titleOf(const SweepRange& range, const Bar& bar)
{
    const Scales unit = scales(bar);
    std::string text = range.place == Excited::tip ? "force on the tip" : "base moving";
    if (range.over != Swept::amplitude) {
        text +=
            ",  " + withUnit(range.amplitude * amplitudeUnit(range.place, bar, range.derivative),
                             amplitudeUnitName(range.place, range.derivative));
    }
    text += range.over == Swept::frequency
                ? ""
                : fmt::format(",  {:.6g} Hz", range.frequencyRatio / 4.0 / unit.time);
    text += range.over == Swept::damping ? "" : fmt::format(",  ζ = {:.4g}", range.damping.ratio);
    return text + fmt::format(",  N = {}", range.cells);
}

Series styleOf(SweepDirection direction)
{
    const bool isUp = direction == SweepDirection::up;
    return {.role = isUp ? Role::contact : Role::ink,
            .width = 1.0,
            .marker = isUp ? Marker::disc : Marker::ring,
            .size = 0.9,
            .legend = isUp ? "upward" : "downward"};
}

/// A line with dots for the mean, strokes where the bar does not repeat itself; `x`: what 1 of the
/// range is there, in SI the units of impulse and swing.
void addSeen(TwoPanels& panels, std::span<const SweepPoint> points, SweepDirection direction,
             double x, double impulse, double displacement)
{
    SeriesPair lines(styleOf(direction));
    SeriesPair dots(styleOf(direction).as(Kind::dots));
    SeriesPair strokes(styleOf(direction).as(Kind::strokes));
    for (const SweepPoint& point : points) {
        if (point.direction == direction) {
            const double at = point.value * x;
            lines.add(at, point.meanImpulse * impulse, -point.tip[0] * displacement);
            dots.add(at, point.meanImpulse * impulse, -point.tip[0] * displacement);
            if (!point.settling.settled) {
                strokes.above.add(at, point.impulse[0] * impulse, at, point.impulse[1] * impulse);
            }
        }
    }
    panels.add(std::move(strokes));
    panels.add(std::move(lines));
    panels.add(std::move(dots), styleOf(direction).legend);
}

void requirePoints(std::span<const SweepPoint> points)
{
    if (points.empty()) {
        throw std::invalid_argument("figure: the sweep holds no value to draw");
    }
}

}  // namespace

FigureData sweepFigure(std::span<const SweepPoint> points, const SweepRange& range, const Bar& bar,
                       std::span<const FrequencyResponse> exact)
{
    requirePoints(points);
    const Scales unit = scales(bar);
    const double impulse = bar.axialStiffness * unit.strain * unit.time;
    const double x = variedIn(range, bar).unit.factor;
    TwoPanels panels{
        .upper = {.name = "impulse", .place = {0.12, 0.97, 0.52, 0.83}, .legend = Legend::topLeft},
        .lower = {.name = "tip", .place = {0.12, 0.97, 0.12, 0.47}},
        .above = {"impulse per period", "N s", impulse, "", 1.07},
        .below = {"swing  −min u(L)", "m", unit.displacement, "", 1.07}};
    SeriesPair under(plot::dots(Role::faint, 0.5));
    for (const FrequencyResponse& response : exact) {
        for (const ForcedMotion& motion : response.motions) {
            under.add(response.frequencyRatio * x, motion.extremes.impulse * impulse,
                      -motion.extremes.lowestTip * unit.displacement);
        }
    }
    panels.add(std::move(under), "exact motions with one contact");
    for (const SweepDirection direction : {SweepDirection::up, SweepDirection::down}) {
        addSeen(panels, points, direction, x, impulse, unit.displacement);
    }
    return std::move(panels).figure(titleOf(range, bar), axisOfSwept(range, bar));
}

FigureData bifurcationFigure(std::span<const SweepPoint> points, const SweepRange& range,
                             const Bar& bar)
{
    requirePoints(points);
    constexpr std::size_t most = 400;  // dots at one value
    const Scales unit = scales(bar);
    const double pushed =
        largestOf(points, [](const SweepPoint& point) { return point.impulse[1]; });
    const Unit impulse = axisUnit(bar.axialStiffness * unit.strain * unit.time, pushed, "N s");
    const double place = variedIn(range, bar).unit.factor;
    FigureData figure{.height = 9.0, .title = titleOf(range, bar)};
    Panel& panel = figure.add({.name = "impulse", .place = {0.12, 0.97, 0.15, 0.78}});
    panel.x = axisOfSwept(range, bar);
    panel.legend = Legend::topLeft;
    for (const SweepDirection direction : {SweepDirection::up, SweepDirection::down}) {
        Series dots = styleOf(direction);
        dots.kind = Kind::dots;
        dots.size = 0.7;
        for (const SweepPoint& point : points) {
            const std::size_t stride = 1 + point.impulses.size() / most;
            for (std::size_t k = 0; point.direction == direction && k < point.impulses.size();
                 k += stride) {
                dots.add(point.value * place, point.impulses[k] * impulse.factor);
            }
        }
        panel.add(std::move(dots));
    }
    panel.y = axisAround(panel.series, labelled("impulse of a contact", impulse), true);
    return figure;
}

}  // namespace signorini
