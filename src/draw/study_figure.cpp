#include "scene_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "axes.hpp"
#include "largest.hpp"

namespace signorini {

namespace {

using namespace plot;
using answers::StudyPoint;

/// The values of one number, ascending, each once, and how they read.
class StudyAxis {
public:
    StudyAxis(const std::vector<StudyPoint>& points, double StudyPoint::*number)
    {
        std::set<double> values;
        for (const StudyPoint& point : points) {
            values.insert(point.*number);
        }
        values_.assign(values.begin(), values.end());
    }

    [[nodiscard]] std::size_t size() const { return values_.size(); }
    [[nodiscard]] double operator[](std::size_t k) const { return values_[k]; }
    [[nodiscard]] std::size_t indexOf(double value) const
    {
        return static_cast<std::size_t>(std::lower_bound(values_.begin(), values_.end(), value) -
                                        values_.begin());
    }
    /// The axis: values at 0, 1, 2, ..., ticks every so many that they fit.
    [[nodiscard]] plot::Axis axis(const std::string& words, const Unit& unit) const
    {
        constexpr std::size_t most = 12;
        const std::size_t stride = 1 + (values_.size() - 1) / most;
        plot::Axis axis{.label = labelled(words, unit),
                        .low = -0.5,
                        .high = static_cast<double>(values_.size()) - 0.5};
        for (std::size_t k = 0; k < values_.size(); k += stride) {
            axis.ticks.push_back(
                {static_cast<double>(k), fmt::format("{:.4g}", values_[k] * unit.factor)});
        }
        return axis;
    }
    [[nodiscard]] double largest() const
    {
        return std::max(std::abs(values_.front()), std::abs(values_.back()));
    }

private:
    std::vector<double> values_;
};

/// The fields of one damping ratio, and in them their words.
void addFields(Panel& panel, const std::vector<StudyPoint>& points, double damping,
               const StudyAxis& gaps, const StudyAxis& amplitudes, const Unit& impulse,
               double largest)
{
    constexpr std::size_t roomForText = 16;
    constexpr std::size_t roomForBoth = 8;
    constexpr double isDark = 0.6;
    Series boxes{.kind = Kind::boxes};
    Series onDark{.kind = Kind::words, .role = Role::paper, .align = Align::centre};
    Series onLight{.kind = Kind::words, .align = Align::centre};
    for (const StudyPoint& point : points) {
        if (point.damping != damping) {
            continue;
        }
        const auto x = static_cast<double>(amplitudes.indexOf(point.amplitude));
        const auto y = static_cast<double>(gaps.indexOf(point.gap));
        boxes.add(x - 0.48, y - 0.48, x + 0.48, y + 0.48);
        boxes.z.push_back(point.impulse * impulse.factor);
        Series& words = point.impulse < isDark * largest ? onDark : onLight;
        const bool hasBoth = point.impulse != 0.0 && amplitudes.size() <= roomForBoth;
        if (amplitudes.size() <= roomForText) {
            words.add(
                x, hasBoth ? y + 0.15 : y,
                point.impulse == 0.0 ? "–" : fmt::format("{:.3g}", point.impulse * impulse.factor));
        }
        if (hasBoth) {
            words.add(x, y - 0.15, fmt::format("{:.4g} Hz", point.frequency));
        }
    }
    panel.series = {std::move(boxes), std::move(onDark), std::move(onLight)};
}

}  // namespace

FigureData studyFigure(const answers::StudyAnswer& answer)
{
    if (answer.points.empty()) {
        throw std::invalid_argument("figure: the study holds no sweep to draw");
    }
    const StudyAxis gaps(answer.points, &StudyPoint::gap);
    const StudyAxis dampings(answer.points, &StudyPoint::damping);
    const StudyAxis amplitudes(answer.points, &StudyPoint::amplitude);
    const double largest = largestOf(answer.points, &StudyPoint::impulse);
    const Unit impulse = unitFor(largest, "N s");
    const Unit gap = unitFor(gaps.largest(), "m");
    const Unit amplitude =
        unitFor(amplitudes.largest(), amplitudeUnitName(answer.place, answer.derivative));
    const char* words =
        answer.place == Excited::tip ? "amplitude of the force" : "amplitude of the base";
    const double height = std::clamp(1.5 * static_cast<double>(gaps.size()), 4.0, 12.0) + 3.0;
    const auto panels = static_cast<double>(dampings.size());
    FigureData figure{
        .width = std::clamp(2.6 * static_cast<double>(amplitudes.size()), 7.0, 18.0) + 5.0,
        .height = height * panels};
    for (std::size_t k = 0; k < dampings.size(); ++k) {
        const double top = figure.height - static_cast<double>(k) * height;
        const Place place{0.14, 0.72, (top - height + 1.6) / figure.height,
                          (top - 1.0) / figure.height};
        Panel& panel = figure.add({.name = fmt::format("damping {:.4g}", dampings[k]),
                                   .place = place,
                                   .x = amplitudes.axis(words, amplitude),
                                   .y = gaps.axis("gap", gap),
                                   .title = fmt::format("ζ = {:.4g}", dampings[k])});
        panel.hasGrid = false;
        panel.colour = {.label = labelled("worst impulse per period", impulse),
                        .low = 0.0,
                        .high = largest > 0.0 ? largest * impulse.factor : 1.0};
        panel.colourBar = Place{0.75, 0.78, place.bottom, place.top};
        addFields(panel, answer.points, dampings[k], gaps, amplitudes, impulse, largest);
    }
    return figure;
}

}  // namespace signorini
