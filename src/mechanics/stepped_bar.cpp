#include "stepped_bar.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>

#include "echo.hpp"
#include "faults.hpp"
#include "network.hpp"
#include "signorini/motion.hpp"
#include "signorini/schedule.hpp"
#include "signorini/simulation.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

constexpr std::int64_t mostWeight = std::int64_t{1} << 50;

/// Over one denominator, if all numbers stay small.
std::optional<JointWeights> exactWeights(double left, double right, double dashpot)
{
    std::int64_t common = 1;
    for (const double value : {left, right, dashpot}) {
        if (!isSimple(value)) {
            return std::nullopt;
        }
        const std::int64_t denominator = exactly(value).denominator;
        const std::int64_t factor = denominator / std::gcd(common, denominator);
        if (factor > mostWeight / common) {
            return std::nullopt;
        }
        common *= factor;
    }
    if (!((left + right + dashpot) * static_cast<double>(common) <
          static_cast<double>(mostWeight))) {
        return std::nullopt;
    }
    const auto times = [common](double value) {
        const Fraction fraction = exactly(value);
        return fraction.numerator * (common / fraction.denominator);
    };
    return JointWeights{times(left), times(right), times(left) + times(right) + times(dashpot)};
}

/// Visits the segments of a state, relative to the first, with the first cell of each.
template <typename Visit>
void forEachSegment(const State& state, std::span<const Segment> segments, Visit visit)
{
    if (segments.empty()) {
        return;
    }
    const SteppedBar bar = steppedBar(segments);
    requireCells(state, bar.cells);
    Eigen::Index first = 0;
    for (const Segment& segment : bar.segments) {
        visit(first, segment);
        first += segment.cells;
    }
}

}  // namespace

JointWeights jointWeights(double left, double right, double dashpot)
{
    JointWeights weights;
    if (const auto exact = exactWeights(left, right, dashpot)) {
        weights = *exact;
    } else {
        const double unit = static_cast<double>(mostWeight) / (left + right + dashpot);
        const auto rounded = [unit](double value) { return std::llround(value * unit); };
        weights = {rounded(left), rounded(right),
                   rounded(left) + rounded(right) + rounded(dashpot)};
    }
    const std::int64_t common = std::gcd(std::gcd(weights.left, weights.right), weights.all);
    return {weights.left / common, weights.right / common, weights.all / common};
}

SteppedBar steppedBar(std::span<const Segment> segments)
{
    Faults faults;
    faults.requireWhole("number of segments", static_cast<std::int64_t>(segments.size()), maxCells);
    faults.throwIfAny();
    const std::string positive = fmt::format("{}..{} [-]", 1.0 / mostImpedance, mostImpedance);
    SteppedBar bar;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        Segment segment = segments[i];
        const std::string which = fmt::format(" of segment {}", i + 1);
        faults.requireWhole("cells" + which, segment.cells, maxCells);
        segment.impedance /= segments.front().impedance;
        segment.speed /= segments.front().speed;
        segment.dashpot /= segments.front().impedance;
        if (!isImpedance(segment.impedance)) {
            faults.add("impedance" + which, segments[i].impedance, positive + " times the first");
        }
        if (!isImpedance(segment.speed)) {
            faults.add("speed" + which, segments[i].speed, positive + " times the first");
        }
        const bool isLast = i + 1 == segments.size();
        if (!(segment.dashpot >= 0.0 && segment.dashpot <= (isLast ? 0.0 : mostImpedance))) {
            faults.add("dashpot" + which, segments[i].dashpot,
                       isLast ? "0: no joint follows" : fmt::format("0..{} [-]", mostImpedance));
        }
        faults.throwIfAny();
        bar.cells += segment.cells;
        faults.requireWhole("cells of all segments", bar.cells, maxCells);
        faults.throwIfAny();
        bar.segments.push_back(segment);
    }
    for (std::size_t i = 0; i + 1 < bar.segments.size(); ++i) {
        bar.joints.push_back(jointWeights(bar.segments[i].impedance, bar.segments[i + 1].impedance,
                                          bar.segments[i].dashpot));
    }
    return bar;
}

void requireCells(const SteppedBar& bar, std::int64_t cells)
{
    if (bar.cells != cells) {
        throwFault("cells of all segments", bar.cells, fmt::format("{}, N", cells));
    }
}

Bar firstMaterial(const Scene& scene)
{
    double length = 0.0;
    double cells = 0.0;
    for (const Segment& segment : scene.segments) {
        const auto count = static_cast<double>(segment.cells);
        length += count * segment.speed / scene.segments.front().speed;
        cells += count;
    }
    Bar bar = scene.bar;
    bar.length *= cells > 0.0 ? cells / length : 1.0;
    return bar;
}

Bar unitsOfBar(const Scene& scene)
{
    Bar bar = firstMaterial(scene);
    if (!haveOneSpeed(scene.segments)) {
        bar.young.reset();
    }
    return bar;
}

bool isUniform(std::span<const Segment> segments)
{
    return std::all_of(segments.begin(), segments.end(), [&](const Segment& segment) {
        return segment.impedance == segments.front().impedance &&
               segment.speed == segments.front().speed && segment.dashpot == 0.0;
    });
}

bool haveOneSpeed(std::span<const Segment> segments)
{
    return std::all_of(segments.begin(), segments.end(), [&](const Segment& segment) {
        return segment.speed == segments.front().speed;
    });
}

Eigen::VectorXd strain(const State& state, std::span<const Segment> segments)
{
    Eigen::VectorXd result = strain(state);
    forEachSegment(state, segments, [&result](Eigen::Index first, const Segment& segment) {
        result.segment(first, segment.cells) /= segment.speed;
    });
    return result;
}

double energyRatio(const State& state, std::span<const Segment> segments)
{
    if (segments.empty()) {
        return energyRatio(state);
    }
    double sum = 0.0;
    forEachSegment(state, segments, [&](Eigen::Index first, const Segment& segment) {
        sum += segment.impedance * (state.a.segment(first, segment.cells).squaredNorm() +
                                    state.b.segment(first, segment.cells).squaredNorm());
    });
    return 2.0 * sum / static_cast<double>(state.cells());
}

Waves wavesAtRest(std::span<const Segment> segments, const Stops& stops, double base)
{
    const SteppedBar bar = steppedBar(segments);
    const auto cells = static_cast<double>(bar.cells);
    double compliance = 0.0;  // of the bar, relative to that of one of the first material
    for (const Segment& segment : bar.segments) {
        compliance += static_cast<double>(segment.cells) / (segment.impedance * cells);
    }
    const double force = 0.0 - restingStrain(stops, base) / compliance;
    Waves waves{cells, {}, {}};
    for (std::size_t i = 0; i < bar.segments.size(); ++i) {
        const auto piece = [&](const Segment& segment, double sign) {
            return Piece{static_cast<double>(segment.cells),
                         sign * 0.5 * force / segment.impedance};
        };
        waves.a.push_back(piece(bar.segments[bar.segments.size() - 1 - i], 1.0));
        waves.b.push_back(piece(bar.segments[i], -1.0));
    }
    return waves;
}

}  // namespace signorini
