#include "two_panels.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "axes.hpp"

namespace signorini {

namespace {

using namespace plot;

void measure(Upwards& of, const Series& series)
{
    for (const std::vector<double>* values : {&series.y, &series.y2}) {
        for (const double value : *values) {  // a NaN changes nothing
            of.largest = std::max(of.largest, value);
        }
    }
}

/// From SI to a unit for the size.
void scale(Panel& panel, const Upwards& of)
{
    const double high = of.largest > 0.0 ? of.room * of.largest : of.scale;
    const Unit unit = unitFor(high, of.base);
    panel.y = axisIn({of.scale * unit.factor, unit.name}, of.words, 0.0, high / of.scale, of.other);
    for (Series& series : panel.series) {
        for (std::vector<double>* values : {&series.y, &series.y2}) {
            for (double& value : *values) {
                value *= unit.factor;
            }
        }
    }
}

}  // namespace

void SeriesPair::add(double x, double upper, double lower)
{
    above.add(x, upper);
    below.add(x, lower);
}

void SeriesPair::breakOff()
{
    above.breakOff();
    below.breakOff();
}

void TwoPanels::add(SeriesPair pair, const std::string& words, bool isMeasure)
{
    if (isMeasure) {
        measure(above, pair.above);
        measure(below, pair.below);
    }
    const bool isBelow = lower.legend == Legend::below;
    Series& said = isBelow ? pair.below : pair.above;
    const bool isAlone = said.x.empty() && !(isBelow ? pair.above : pair.below).x.empty();
    if (!words.empty() && isAlone) {
        (isBelow ? lower : upper).explain(said, words);
    }
    pair.above.legend.clear();
    pair.below.legend.clear();
    said.legend = words;
    upper.add(std::move(pair.above));
    lower.add(std::move(pair.below));
}

FigureData TwoPanels::figure(std::string title, const Axis& x) &&
{
    scale(upper, above);
    scale(lower, below);
    upper.x = bare(x);
    lower.x = x;
    lower.x.other.reset();
    FigureData figure{.title = std::move(title)};
    figure.panels = {std::move(upper), std::move(lower)};
    return figure;
}

}  // namespace signorini
