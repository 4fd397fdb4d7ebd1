#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "axes.hpp"
#include "excited_amplitude.hpp"
#include "infinity.hpp"
#include "scene_figures.hpp"
#include "signorini/figures.hpp"

namespace signorini {

namespace {

using namespace plot;

constexpr std::size_t mostTold = 4;  // motions at a place that are told apart
constexpr std::array countWords{"none (white)", "one", "two", "three", "more"};
constexpr std::array countShades{Role::paper, Role::shade6, Role::shade4, Role::shade3,
                                 Role::shade2};

constexpr std::size_t mapColumns = 400;  ///< what print shows
constexpr std::size_t mapRows = 240;

/// What there is at one frequency, in amplitudes of the axis.
struct Column {
    double frequency;
    double meets = 0.0;  ///< where the motion without contact does; 0: at once, or not known
    std::vector<std::array<double, 2>> motions = {};  ///< from, to, with one contact
    std::vector<double> pairs = {};                   ///< with two contacts
    double permanentUpTo = 0.0;                       ///< where contact that never opens would

    [[nodiscard]] double least() const
    {
        double least = infinity;
        for (const auto& [from, to] : motions) {
            least = std::min(least, from);
        }
        return least;
    }
    [[nodiscard]] std::size_t count(double amplitude) const
    {
        const auto holds = [amplitude](const std::array<double, 2>& one) {
            return one[0] <= amplitude && amplitude <= one[1];
        };
        const auto count = std::count_if(motions.begin(), motions.end(), holds) +
                           (amplitude < meets ? 1 : 0) + (amplitude <= permanentUpTo ? 1 : 0);
        return std::min(static_cast<std::size_t>(count), mostTold);
    }
};

/// From one end of an axis to the other.
using Reach = std::array<double, 2>;

/// How many motions, on an even grid: of columns finer than print none beats with its dots.
Series countsOf(const std::vector<Column>& columns, const Reach& x, const Reach& y)
{
    Series counts{.kind = Kind::image};
    const auto middle = [](std::size_t k, std::size_t count, const Reach& reach) {
        return reach[0] +
               (reach[1] - reach[0]) * (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    };
    std::vector<const Column*> nearest;
    for (std::size_t i = 0; i < mapColumns; ++i) {
        const double place = middle(i, mapColumns, x);
        counts.x.push_back(place);
        nearest.push_back(&*std::min_element(
            columns.begin(), columns.end(), [place](const Column& one, const Column& other) {
                return std::abs(one.frequency - place) < std::abs(other.frequency - place);
            }));
    }
    for (std::size_t j = 0; j < mapRows; ++j) {
        counts.y.push_back(middle(j, mapRows, y));
        for (const Column* column : nearest) {
            counts.z.push_back(static_cast<double>(column->count(counts.y.back())));
        }
    }
    return counts;
}

/// The frequencies of columns, a single one in the middle.
Reach reachOf(const std::vector<Column>& columns, double margin)
{
    if (columns.empty()) {
        return {1.0 - margin, 1.0 + margin};
    }
    margin = columns.size() > 1 ? 0.0 : margin;
    return {columns.front().frequency - margin, columns.back().frequency + margin};
}

/// \param columns by ascending frequency, in numbers of the axes. \param amplitude of the
/// response, a third of the largest that is shown
FigureData mapOf(const std::vector<Column>& columns, const Reach& reach, const Axis& x,
                 const Axis& y, double amplitude)
{
    const Reach amplitudes{0.0, 3.0 * amplitude};
    FigureData figure{.width = 16.0, .height = 12.0};
    Panel& panel = figure.add({.name = "map", .place = {0.12, 0.88, 0.30, 0.83}});
    panel.legend = Legend::below;
    panel.map = ColourMap::counts;
    panel.colour = {.low = 0.0, .high = static_cast<double>(mostTold)};
    panel.x = x;
    panel.y = y;
    Series meets = plot::line(Role::ink, 2.5).named("without contact meets a stop");
    Series least = plot::line(Role::contact, 2.5, Dash::dashed).named("with contact, the least");
    Series pairs = plot::dots(Role::strain, 0.5, Marker::diamond).named("two contacts");
    for (const Column& column : columns) {
        const auto add = [&column](Series& series, double edge) {
            std::isfinite(edge) ? series.add(column.frequency, edge) : series.breakOff();
        };
        column.meets > 0.0 ? add(meets, column.meets) : meets.breakOff();
        add(least, column.least());
        for (const double pair : column.pairs) {
            if (pair <= amplitudes[1]) {
                pairs.add(column.frequency, pair);
            }
        }
    }
    if (!columns.empty()) {
        panel.add(countsOf(columns, reach, amplitudes));
    }
    for (std::size_t count = 0; count < countWords.size(); ++count) {
        panel.explain({.kind = Kind::boxes, .role = countShades.at(count)}, countWords.at(count));
    }
    panel.add(std::move(meets));
    panel.add(std::move(least));
    panel.add(across(reach[0], reach[1], amplitude, 1.0, Dash::dotted)
                  .named("amplitude of the response"));
    panel.legendRows = 4;
    if (!pairs.x.empty()) {  // a ninth entry, and a row for it
        panel.legendRows = 5;
        figure.height = 13.0;
        panel.place = {0.12, 0.88, 0.33, 0.84};
    }
    panel.add(std::move(pairs));
    return figure;
}

Column columnOf(const FrequencyResponse& response, double factor)
{
    Column column{response.frequencyRatio, response.openUpTo * factor};
    for (const AmplitudeBranch& branch : response.branches) {
        column.motions.push_back({branch.least * factor, branch.most * factor});
    }
    column.permanentUpTo = response.permanentUpTo * factor;
    for (const TwoContactBranch& branch : response.twoContacts) {
        column.pairs.push_back(branch.least * factor);
    }
    return column;
}

std::string contactsIn(std::int64_t cycles, std::int64_t contacts)
{
    return fmt::format("motions with at most {} in {}",
                       contacts > 1 ? "two contacts" : "one contact",
                       cycles > 1 ? fmt::format("{} cycles", cycles) : "a cycle");
}

}  // namespace

FigureData responseMapFigure(std::span<const FrequencyResponse> frequencies,
                             const ResponseRange& range, const Bar& bar)
{
    if (frequencies.empty()) {
        throw std::invalid_argument("figure: the response holds no frequency to draw");
    }
    const double top = 3.0 * range.amplitude;
    const bool isForce = range.place == Excited::tip;
    const Unit unit = axisUnit(amplitudeUnit(range.place, bar), top, isForce ? "N" : "m");
    // Between two stops that are alike a motion that touches both is symmetric and has an even
    // number of steps; an odd one has only others.
    std::vector<Column> columns;
    for (const FrequencyResponse& response : frequencies) {
        if (!range.stops.left || response.steps % 2 == 0) {
            columns.push_back(columnOf(response, unit.factor));
        }
    }
    std::sort(columns.begin(), columns.end(), [](const Column& one, const Column& other) {
        return one.frequency < other.frequency;
    });
    const Reach reach = reachOf(columns, 0.05);
    const Axis y =
        axisIn(unit, isForce ? "amplitude of the force" : "amplitude of the base", 0.0, top,
               std::string(isForce ? "EA" : "") + (range.stops.right == 0 ? (isForce ? "" : "L")
                                                   : isForce              ? " g/L"
                                                                          : "g"));
    FigureData figure =
        mapOf(columns, reach, frequencyAxis("frequency of the excitation", reach[0], reach[1], bar),
              y, range.amplitude * unit.factor);
    figure.title = fmt::format("{},  ζ = {:.4g},  N = {}", contactsIn(range.cycles, range.contacts),
                               range.damping.ratio, range.cells);
    return figure;
}

FigureData sceneMapFigure(const answers::SceneResponse& response)
{
    if (response.frequencies.empty()) {
        throw std::invalid_argument("figure: the response holds no frequency to draw");
    }
    const bool isForce = response.range.place == Excited::tip;
    const double top = 3.0 * response.range.amplitude;
    const Unit unit = unitFor(top, isForce ? "N" : "m");
    std::vector<Column> columns;
    std::int64_t undecided = 0;
    for (const answers::SceneFrequency& at : response.frequencies) {
        undecided += at.undecided;
        const answers::SceneAmplitudes& amplitudes = at.amplitudes.value();
        Column& column =
            columns.emplace_back(Column{at.hertz, amplitudes.open.value_or(0.0) * unit.factor});
        for (const auto& [contact, branch] : amplitudes.closed) {
            if (branch.contact == at.steps) {
                column.permanentUpTo = branch.most * unit.factor;
            } else {
                column.motions.push_back({branch.least * unit.factor, branch.most * unit.factor});
            }
        }
        for (const TwoContactBranch& branch : amplitudes.pairs) {
            column.pairs.push_back(branch.least * unit.factor);
        }
    }
    std::reverse(columns.begin(), columns.end());
    const Reach reach = reachOf(columns, 0.02 * columns.front().frequency);
    const Axis y{
        .label = labelled(isForce ? "amplitude of the force" : "amplitude of the base", unit),
        .low = 0.0,
        .high = top * unit.factor};
    FigureData figure = mapOf(
        columns, reach, hertzAxis(reach[0], reach[1], answers::firstHertz(response.bars.reference)),
        y, response.range.amplitude * unit.factor);
    figure.title = fmt::format(
        "{},  {} cells{}", contactsIn(response.range.cycles, response.range.contacts),
        networkOf(response.bars.assembly).cells(),
        undecided > 0 ? fmt::format(",  {} schedules undecided", undecided) : std::string());
    return figure;
}

}  // namespace signorini
