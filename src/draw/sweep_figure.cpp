#include <fmt/format.h>

#include "axes.hpp"
#include "excited_amplitude.hpp"
#include "largest.hpp"
#include "signorini/figures.hpp"

namespace signorini {

namespace {

using namespace plot;

/// The axis of what is varied: what 1 in the range is there, and its words.
Unit unitOfSwept(const SweepRange& range, const Bar& bar)
{
    const Scales unit = scales(bar);
    switch (range.over) {
        case Swept::frequency:
            return {0.25 / unit.time, "Hz"};
        case Swept::amplitude:
            return axisUnit(
                range.place == Excited::tip ? bar.axialStiffness * unit.strain : unit.displacement,
                range.most, range.place == Excited::tip ? "N" : "m");
        case Swept::gap:
            return axisUnit(unit.displacement, range.most, "m");
        case Swept::damping:
            return {1.0, "–"};
    }
    return {1.0, "–"};
}

Axis axisOfSwept(const SweepRange& range, const Bar& bar)
{
    const double margin = range.most > range.least ? 0.01 * (range.most - range.least) : 0.05;
    const char* words = "damping ratio ζ";
    switch (range.over) {
        case Swept::frequency:
            words = "frequency of the excitation";
            break;
        case Swept::amplitude:
            words =
                range.place == Excited::tip ? "amplitude of the force" : "amplitude of the base";
            break;
        case Swept::gap:
            words = "gap";
            break;
        case Swept::damping:
            break;
    }
    return axisIn(unitOfSwept(range, bar), words, range.least - margin, range.most + margin,
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

Unit impulseUnitOf(std::span<const SweepPoint> points, const Bar& bar)
{
    const double pushed =
        largestOf(points, [](const SweepPoint& point) { return point.impulse[1]; });
    const Scales unit = scales(bar);
    return axisUnit(bar.axialStiffness * unit.strain * unit.time, pushed, "N s");
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

/// One quantity of a point: its mean, and from where to where it goes.
using Seen = std::array<double, 3> (*)(const SweepPoint& point);

/// A line with dots for the mean, strokes where the bar does not repeat itself.
void addSeen(Panel& panel, std::span<const SweepPoint> points, SweepDirection direction,
             double place, double factor, Seen seen)
{
    Series line = styleOf(direction);
    Series dots = line;
    dots.kind = Kind::dots;
    line.legend.clear();
    Series strokes = line;
    strokes.kind = Kind::strokes;
    for (const SweepPoint& point : points) {
        if (point.direction == direction) {
            const auto [mean, least, most] = seen(point);
            const double x = point.value * place;
            line.add(x, mean * factor);
            dots.add(x, mean * factor);
            if (!point.settling.settled) {
                strokes.add(x, least * factor, x, most * factor);
            }
        }
    }
    panel.add(std::move(strokes));
    panel.add(std::move(line));
    panel.add(std::move(dots));
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
    const Unit impulse = impulseUnitOf(points, bar);
    const double reach =
        largestSizeOf(points, [](const SweepPoint& point) { return point.tip[0]; });
    const Unit swing = axisUnit(scales(bar).displacement, reach, "m");
    const double place = unitOfSwept(range, bar).factor;
    FigureData figure{.title = titleOf(range, bar)};
    Panel upper{
        .name = "impulse", .place = {0.12, 0.97, 0.52, 0.83}, .x = bare(axisOfSwept(range, bar))};
    upper.legend = Legend::topLeft;
    Panel lower{.name = "tip", .place = {0.12, 0.97, 0.12, 0.47}, .x = axisOfSwept(range, bar)};
    lower.x.other.reset();
    Series under = plot::dots(Role::faint, 0.5).named("exact motions with one contact");
    Series underSwing = under;
    underSwing.legend.clear();
    for (const FrequencyResponse& response : exact) {
        for (const ForcedMotion& motion : response.motions) {
            const double x = response.frequencyRatio * place;
            under.add(x, motion.extremes.impulse * impulse.factor);
            underSwing.add(x, -motion.extremes.lowestTip * swing.factor);
        }
    }
    upper.add(std::move(under));
    lower.add(std::move(underSwing));
    for (const SweepDirection direction : {SweepDirection::up, SweepDirection::down}) {
        addSeen(upper, points, direction, place, impulse.factor, [](const SweepPoint& point) {
            return std::array{point.meanImpulse, point.impulse[0], point.impulse[1]};
        });
        addSeen(lower, points, direction, place, swing.factor, [](const SweepPoint& point) {
            return std::array{-point.tip[0], -point.tip[0], -point.tip[0]};
        });
    }
    upper.y = axisAround(upper.series, labelled("impulse per period", impulse), true);
    lower.y = axisAround(lower.series, labelled("swing  −min u(L)", swing), true);
    figure.panels = {std::move(upper), std::move(lower)};
    return figure;
}

FigureData bifurcationFigure(std::span<const SweepPoint> points, const SweepRange& range,
                             const Bar& bar)
{
    requirePoints(points);
    constexpr std::size_t most = 400;  // dots at one value
    const Unit impulse = impulseUnitOf(points, bar);
    const double place = unitOfSwept(range, bar).factor;
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
