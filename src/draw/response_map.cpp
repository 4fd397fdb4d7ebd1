#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "axes.hpp"
#include "excited_amplitude.hpp"
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

/// The amplitude from which the motion without contact meets the wall.
double edgeOfContact(const FrequencyResponse& response, const ResponseRange& range)
{
    const auto& [right, left] = range.stops;
    const double nearest = left ? std::min<double>(right, left->value()) : right;
    return std::max(nearest, 0.0) * range.amplitude / response.linearPeak;
}

/// The least one of a motion with contact; infinite if there is none.
double edgeOfMotions(const FrequencyResponse& response)
{
    double least = std::numeric_limits<double>::infinity();
    for (const AmplitudeBranch& branch : response.branches) {
        least = std::min(least, branch.least);
    }
    return least;
}

std::size_t motionsAt(const FrequencyResponse& response, double edge, double amplitude)
{
    std::size_t count = amplitude < edge ? 1 : 0;
    for (const AmplitudeBranch& branch : response.branches) {
        count += branch.least <= amplitude && amplitude <= branch.most ? 1U : 0U;
    }
    return std::min(count, mostTold);
}

/// Those to be shown, by ascending frequency: between two stops that are alike a motion that
/// touches both is symmetric and has an even number of steps; an odd one has only others.
std::vector<const FrequencyResponse*> shown(std::span<const FrequencyResponse> frequencies,
                                            const ResponseRange& range)
{
    std::vector<const FrequencyResponse*> all;
    for (const FrequencyResponse& response : frequencies) {
        if (!range.stops.left || response.steps % 2 == 0) {
            all.push_back(&response);
        }
    }
    std::sort(all.begin(), all.end(),
              [](const auto* x, const auto* y) { return x->frequencyRatio < y->frequencyRatio; });
    return all;
}

/// How many motions, on an even grid: of columns finer than print none beats with its dots.
Series countsOf(const std::vector<const FrequencyResponse*>& frequencies,
                const ResponseRange& range, double low, double high, double top, double factor)
{
    Series counts{.kind = Kind::image};
    const auto middle = [](std::size_t k, std::size_t count, double from, double to) {
        return from + (to - from) * (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    };
    std::vector<const FrequencyResponse*> nearest;
    for (std::size_t i = 0; i < mapColumns; ++i) {
        counts.x.push_back(middle(i, mapColumns, low, high));
        nearest.push_back(*std::min_element(
            frequencies.begin(), frequencies.end(), [&counts](const auto* one, const auto* other) {
                return std::abs(one->frequencyRatio - counts.x.back()) <
                       std::abs(other->frequencyRatio - counts.x.back());
            }));
    }
    for (std::size_t j = 0; j < mapRows; ++j) {
        const double amplitude = middle(j, mapRows, 0.0, top);
        counts.y.push_back(amplitude * factor);
        for (const FrequencyResponse* response : nearest) {
            counts.z.push_back(static_cast<double>(
                motionsAt(*response, edgeOfContact(*response, range), amplitude)));
        }
    }
    return counts;
}

}  // namespace

FigureData responseMapFigure(std::span<const FrequencyResponse> frequencies,
                             const ResponseRange& range, const Bar& bar)
{
    if (frequencies.empty()) {
        throw std::invalid_argument("figure: the response holds no frequency to draw");
    }
    const double top = 3.0 * range.amplitude;
    const std::vector<const FrequencyResponse*> all = shown(frequencies, range);
    const double margin = all.size() > 1 ? 0.0 : 0.05;
    const double low = (all.empty() ? 1.0 : all.front()->frequencyRatio) - margin;
    const double high = (all.empty() ? 1.0 : all.back()->frequencyRatio) + margin;
    const bool isForce = range.place == Excited::tip;
    const Unit unit = axisUnit(amplitudeUnit(range.place, bar), top, isForce ? "N" : "m");
    FigureData figure{.width = 16.0, .height = 12.0};
    figure.title =
        fmt::format("motions with at most one contact in {},  ζ = {:.4g},  N = {}",
                    range.cycles > 1 ? fmt::format("{} cycles", range.cycles) : "a cycle",
                    range.damping.ratio, range.cells);
    Panel& panel = figure.add({.name = "map", .place = {0.12, 0.88, 0.30, 0.83}});
    panel.legend = Legend::below;
    panel.legendRows = 4;
    panel.map = ColourMap::counts;
    panel.colour = {.low = 0.0, .high = static_cast<double>(mostTold)};
    panel.x = frequencyAxis("frequency of the excitation", low, high, bar);
    panel.y =
        axisIn(unit, isForce ? "amplitude of the force" : "amplitude of the base", 0.0, top,
               std::string(isForce ? "EA" : "") + (range.stops.right == 0 ? (isForce ? "" : "L")
                                                   : isForce              ? " g/L"
                                                                          : "g"));
    Series meets = plot::line(Role::ink, 2.5).named("without contact meets a stop");
    Series least = plot::line(Role::contact, 2.5, Dash::dashed).named("with contact, the least");
    Series pairs = plot::dots(Role::strain, 0.5, Marker::diamond).named("two contacts");
    for (const FrequencyResponse* response : all) {
        const double x = response->frequencyRatio;
        const double edge = edgeOfMotions(*response);
        meets.add(x, edgeOfContact(*response, range) * unit.factor);
        std::isfinite(edge) ? least.add(x, edge * unit.factor) : least.breakOff();
        for (const TwoContactBranch& branch : response->twoContacts) {
            if (branch.least <= top) {
                pairs.add(x, branch.least * unit.factor);
            }
        }
    }
    if (!all.empty()) {
        panel.add(countsOf(all, range, low, high, top, unit.factor));
    }
    for (std::size_t count = 0; count < countWords.size(); ++count) {
        panel.explain({.kind = Kind::boxes, .role = countShades.at(count)}, countWords.at(count));
    }
    panel.add(std::move(meets));
    panel.add(std::move(least));
    panel.add(across(low, high, range.amplitude * unit.factor, 1.0, Dash::dotted)
                  .named("amplitude of the response"));
    panel.add(std::move(pairs));
    return figure;
}

}  // namespace signorini
