// Moving pictures of a motion over time and of a continuum over lambda.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axes.hpp"
#include "bars_motion.hpp"
#include "infinity.hpp"
#include "mapped.hpp"
#include "scene_figures.hpp"
#include "signorini/motion.hpp"

namespace signorini {

namespace {

using namespace plot;

constexpr std::size_t maxFrames = 121;
constexpr std::size_t nodesShown = 301;
constexpr std::int64_t instantsShown = 701;
constexpr double gapShown = 0.1;  ///< [of all bars], the smallest gap in the picture of them
constexpr double tiny = 1e-300;

/// 0 ... last, at most so many, both ends among them.
std::vector<std::size_t> chosen(std::size_t count, std::size_t most)
{
    std::vector<std::size_t> result;
    const std::size_t gaps = std::min(count, most) - 1;
    for (std::size_t k = 0; k <= gaps; ++k) {
        result.push_back(gaps == 0 ? 0 : k * (count - 1) / gaps);
    }
    return result;
}

/// The largest and least of what frames show, so that all have the same axes.
struct Range {
    double low = 0.0;
    double high = 0.0;

    void see(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    [[nodiscard]] double largest() const { return std::max(high, -low); }
    [[nodiscard]] Axis axis(const Unit& unit, const std::string& words, double room = 0.08) const
    {
        const double margin = room * std::max(high - low, tiny);
        return axisIn(unit, words, low - margin, high + margin);
    }
};

/// Strain and velocity share an axis; the legend stands above it.
Panel fieldsPanel(const Range& fields, const Unit& unit, Axis position)
{
    return {.name = "fields",
            .place = {0.13, 0.97, 0.11, 0.34},
            .x = std::move(position),
            .y = fields.axis(unit, "s,  v/c"),
            .legend = Legend::above};
}

Series strainLine()
{
    return line(Role::strain, 4.0).named("strain");
}

Series velocityLine()
{
    return line(Role::velocity, 2.0).named("velocity");
}

/// Where a stop is.
Series stopLine(const Axis& along, double place)
{
    return across(*along.low, *along.high, place, 1.0, Dash::dashed);
}

/// Bars at their stops, and u, s, v along them. Displacements and gaps are magnified by one factor,
/// so that what touches in the picture touches.
class MotionFrames {
public:
    MotionFrames(const MotionSamples& samples, const Network& network, double waveSpeed,
                 std::size_t most)
        : samples_(samples),
          network_(network),
          waveSpeed_(waveSpeed),
          length_(samples.x(samples.nodes() - 1)),
          instants_(chosen(samples.instants(), most + 1)),
          metre_(axisUnit(1.0, length_, "m"))
    {
        chooseNodes();
        for (const NetworkContact& contact : network.contacts) {
            if (network.bars.size() == 1) {
                levels_.push_back(placeOf(contact));
                u_.see(levels_.back());
            }
        }
        for (const std::size_t m : instants_) {
            for (const std::vector<std::size_t>& row : rows_) {
                for (const std::size_t i : row) {
                    u_.see(samples.displacement(i, m));
                    strain_.see(samples.strain(i, m));
                    fields_.see(samples.velocity(i, m) / waveSpeed);
                }
            }
        }
        fields_.see(strain_.low);
        fields_.see(strain_.high);
        place_ = axisUnit(1.0, u_.largest(), "m");
        pure_ = axisUnit(1.0, fields_.largest(), "");
        placeBars();
        placeWalls();
    }

    [[nodiscard]] std::vector<FigureData> all() const
    {
        std::vector<FigureData> frames;
        // The last instant is the first one again.
        for (std::size_t k = 0; k + 1 < std::max<std::size_t>(instants_.size(), 2); ++k) {
            frames.push_back(frameAt(instants_[k]));
        }
        return frames;
    }

private:
    /// Row by row: where one ends and the next begins, two nodes have one place.
    void chooseNodes()
    {
        for (std::size_t from = 0, to = 1; from < samples_.nodes(); from = to++) {
            while (to < samples_.nodes() && samples_.x(to) != samples_.x(to - 1)) {
                ++to;
            }
            rows_.push_back(chosen(to - from, 1 + nodesShown / network_.rows.size()));
            for (std::size_t& node : rows_.back()) {
                node += from;
            }
        }
    }

    /// u of a node that touches its stop [m].
    [[nodiscard]] double placeOf(const NetworkContact& contact) const
    {
        return (contact.kind == ContactKind::stopLeft ? -1.0 : 1.0) * contact.gap *
               network_.scales.displacement;
    }

    void placeBars()
    {
        double smallest = infinity;
        for (const NetworkContact& contact : network_.contacts) {
            const double gap = std::abs(placeOf(contact));
            smallest = gap > 0.0 ? std::min(smallest, gap) : smallest;
        }
        smallest = std::isfinite(smallest) ? smallest : std::max(u_.largest(), tiny);
        // Not so much that a bar is turned inside out.
        magnified_ =
            std::min(gapShown * length_ / smallest, 0.5 / std::max(strain_.largest(), tiny));
        double moved = 0.0;
        for (const NetworkBar& bar : network_.bars) {
            moved_.push_back(moved);
            for (const NetworkContact& contact : network_.contacts) {
                if (contact.kind == ContactKind::gap && contact.node == bar.lastNode) {
                    moved += magnified_ * placeOf(contact);
                }
            }
        }
        for (const std::size_t m : instants_) {
            for (std::size_t r = 0; r < rows_.size(); ++r) {
                along_.see(placeAt(r, rows_[r].front(), m));
                along_.see(placeAt(r, rows_[r].back(), m));
                along_.see(restAt(r, rows_[r].back()));
            }
        }
    }

    /// Clamps and stops; what a collar meets, above the bar alone.
    void placeWalls()
    {
        const std::vector<double> nodes = placesOf(network_, length_);
        const auto put = [&](std::size_t node, double beyond, bool isRight, Role role) {
            const NetworkBar& bar = network_.bars[network_.nodes[node].bar];
            const double face = nodes[node] + moved_[network_.nodes[node].bar] + beyond;
            const double back = face + (isRight ? 0.015 : -0.015) * length_;
            const bool isOuter = node == (isRight ? bar.lastNode : bar.firstNode);
            walls_.push_back(box(role, std::min(face, back) * metre_.factor, isOuter ? -1.0 : 0.0,
                                 std::max(face, back) * metre_.factor, 1.0));
            along_.see(back);
        };
        for (std::size_t k = 0; k < network_.nodes.size(); ++k) {
            if (network_.nodes[k].isClamped) {
                put(k, 0.0, k != network_.bars[network_.nodes[k].bar].firstNode, Role::ink);
            }
        }
        for (const NetworkContact& contact : network_.contacts) {
            if (contact.kind != ContactKind::gap) {
                put(contact.node, magnified_ * placeOf(contact),
                    contact.kind == ContactKind::stopRight, Role::faint);
            }
        }
    }

    /// Of a node of a row, by how much its bar stands to the right of where it is end to end [m].
    [[nodiscard]] double restAt(std::size_t row, std::size_t node) const
    {
        return samples_.x(node) + moved_[network_.nodes[network_.rows[row].left].bar];
    }
    [[nodiscard]] double placeAt(std::size_t row, std::size_t node, std::size_t instant) const
    {
        return restAt(row, node) + magnified_ * samples_.displacement(node, instant);
    }

    [[nodiscard]] FigureData frameAt(std::size_t instant) const
    {
        const Axis along =
            along_.axis(metre_, network_.bars.size() == 1 ? "position  x" : "along the bars", 0.02);
        Panel bars{.name = "bar", .place = {0.13, 0.97, 0.76, 0.92}, .hasGrid = false};
        bars.x = bare(along);
        bars.y = {.low = -1.0, .high = 1.0, .ticks = {{-2.0, ""}}};
        bars.map = ColourMap::diverging;
        const double size = std::max(strain_.largest(), tiny);
        bars.colour = {.low = -size, .high = size};
        Panel middle{.name = "displacement", .place = {0.13, 0.97, 0.46, 0.71}, .x = bars.x};
        middle.y = u_.axis(place_, "u");
        Panel fields = fieldsPanel(fields_, pure_, along);
        for (const double level : levels_) {
            middle.add(stopLine(along, level * place_.factor));
        }
        addRows(bars, middle, fields, instant);
        for (const Series& one : walls_) {
            bars.add(one);
        }
        const Unit second = axisUnit(1.0, samples_.time(samples_.instants() - 1), "s");
        FigureData frame{.width = 20.0, .height = 16.0};
        frame.title = fmt::format(
            "t = {:.4g} {}  of  {:.4g} {}", samples_.time(instant) * second.factor, second.name,
            samples_.time(samples_.instants() - 1) * second.factor, second.name);
        frame.panels = {std::move(bars), std::move(middle), std::move(fields)};
        return frame;
    }

    void addRows(Panel& bars, Panel& middle, Panel& fields, std::size_t instant) const
    {
        Series cells{.kind = Kind::boxes};
        Series u = plot::line(Role::ink, 2.0);
        Series strain = strainLine();
        Series velocity = velocityLine();
        for (std::size_t r = 0; r < rows_.size(); ++r) {
            const double half = 0.5 * std::clamp(network_.rows[r].impedance, 0.3, 1.6);
            std::size_t last = rows_[r].front();
            for (const std::size_t i : rows_[r]) {
                const double from = restAt(r, last) * metre_.factor;
                const double to = restAt(r, i) * metre_.factor;
                u.add(to, samples_.displacement(i, instant) * place_.factor);
                if (i != last) {
                    cells.add(placeAt(r, last, instant) * metre_.factor, -half,
                              placeAt(r, i, instant) * metre_.factor, half);
                    cells.z.push_back(samples_.strain(i, instant));
                    strain.addStep(from, to, samples_.strain(i, instant) * pure_.factor);
                    velocity.addStep(from, to,
                                     samples_.velocity(i, instant) / waveSpeed_ * pure_.factor);
                }
                last = i;
            }
            for (Series* line : {&u, &strain, &velocity}) {
                line->breakOff();
            }
        }
        bars.add(std::move(cells));
        middle.add(std::move(u));
        fields.add(std::move(strain));
        fields.add(std::move(velocity));
    }

    const MotionSamples& samples_;
    const Network& network_;
    double waveSpeed_;  ///< [m/s]
    double length_;     ///< [m], of all bars
    std::vector<std::size_t> instants_;
    std::vector<std::vector<std::size_t>> rows_;  ///< nodes
    std::vector<double> levels_;                  ///< of u, where a single bar stops [m]
    Range u_;                                     ///< [m]
    Range strain_;
    Range fields_;  ///< s and v/c
    Range along_;   ///< [m]
    double magnified_ = 1.0;
    std::vector<double> moved_;  ///< each bar, for the gaps before it [m]
    std::vector<Series> walls_;
    Unit metre_;
    Unit place_;
    Unit pure_;
};

/// Force and tip over a period, strain and velocity at t = 0, one frame for each member.
class CurveFrames {
public:
    explicit CurveFrames(const Continuum& curve)
        : curve_(curve),
          scale_(scales(curve.scene.bar)),
          members_(chosen(curve.points.size(), maxFrames)),
          stops_{curve.scene.bar.gap / scale_.displacement}
    {
        if (curve.scene.secondStop) {
            stops_.push_back(-*curve.scene.secondStop / scale_.displacement);
        }
        for (const double stop : stops_) {
            tip_.see(stop);
        }
        for (const std::size_t k : members_) {
            const State& state = curve.points[k].state;
            const Motion motion(state, curve.schedule);
            period_ = static_cast<double>(motion.steps()) / static_cast<double>(motion.cells());
            for (std::int64_t m = 0; m < motion.steps(); ++m) {
                force_.see(motion.wallForce(m));
                tip_.see(motion.displacement(motion.cells(), m));
            }
            for (const double value : strain(state)) {
                fields_.see(value);
            }
            for (const double value : velocity(state)) {
                fields_.see(value);
            }
        }
    }

    [[nodiscard]] std::vector<FigureData> all() const
    {
        return mapped(members_, [this](std::size_t k) { return frameOf(curve_.points[k]); });
    }

private:
    [[nodiscard]] FigureData frameOf(const ContinuumPoint& point) const
    {
        const Bar& bar = curve_.scene.bar;
        const Unit newton = axisUnit(bar.axialStiffness * scale_.strain, force_.largest(), "N");
        const Unit metre = axisUnit(scale_.displacement, tip_.largest(), "m");
        const Unit second = axisUnit(scale_.time, period_, "s");
        const Unit along = axisUnit(bar.length, 1.0, "m");
        Panel upper{.name = "force", .place = {0.13, 0.97, 0.72, 0.92}};
        upper.x = bare(axisIn(second, "", 0.0, period_));
        upper.y = force_.axis(newton, curve_.scene.secondStop ? "forces" : "wall force");
        Panel middle{.name = "tip", .place = {0.13, 0.97, 0.5, 0.69}};
        middle.x = axisIn(second, "time  t", 0.0, period_);
        middle.y = tip_.axis(metre, "u(L,t)");
        const Unit pure = axisUnit(scale_.strain, fields_.largest(), "");
        Panel fields =
            fieldsPanel(fields_, pure, axisIn(along, "position  x, at t = 0,", 0.0, 1.0));
        const Motion motion(point.state, curve_.schedule);
        const auto cells = static_cast<double>(motion.cells());
        Series force = plot::line(Role::contact, 2.0);
        for (std::int64_t m = 0; m < motion.steps(); ++m) {
            force.addStep(static_cast<double>(m) / cells * second.factor,
                          static_cast<double>(m + 1) / cells * second.factor,
                          motion.wallForce(m) * newton.factor);
        }
        Series tip = plot::line(Role::ink, 2.0);
        for (const std::int64_t m : thinned(motion.steps(), instantsShown)) {
            tip.add(static_cast<double>(m) / cells * second.factor,
                    motion.displacement(motion.cells(), m) * metre.factor);
        }
        Series strain = strainLine();
        Series velocity = velocityLine();
        for (std::int64_t i = 1; i <= motion.cells(); ++i) {
            const double from = static_cast<double>(i - 1) / cells * along.factor;
            const double to = static_cast<double>(i) / cells * along.factor;
            strain.addStep(from, to, motion.strain(i, 0) * pure.factor);
            velocity.addStep(from, to, motion.velocity(i, 0) * pure.factor);
        }
        upper.add(std::move(force));
        for (const double stop : stops_) {
            middle.add(stopLine(middle.x, stop * metre.factor));
        }
        middle.add(std::move(tip));
        fields.add(std::move(strain));
        fields.add(std::move(velocity));
        FigureData frame{.width = 20.0, .height = 16.0};
        frame.title =
            fmt::format("{}, {}:   λ = {:.4g} ({})", curve_.family,
                        energyLabel(bar, curve_.energyRatio), point.lambda, name(curve_.parameter));
        frame.panels = {std::move(upper), std::move(middle), std::move(fields)};
        return frame;
    }

    const Continuum& curve_;
    Scales scale_;
    std::vector<std::size_t> members_;
    std::vector<double> stops_;
    double period_ = 0.0;  ///< [L/c], of the folded schedule
    Range force_;
    Range tip_;
    Range fields_;
};

}  // namespace

std::vector<FigureData> motionFrames(const MotionSamples& samples, std::size_t most)
{
    const std::vector<Segment>& segments = samples.scene().segments;
    std::int64_t cells = segments.empty() ? 1 : 0;
    for (const Segment& segment : segments) {
        cells += segment.cells;
    }
    return MotionFrames(samples, networkOf(samples.scene(), cells), samples.bar().waveSpeed, most)
        .all();
}

std::vector<FigureData> barsFrames(const Assembly& assembly, const Network& network,
                                   const ShownPeriod& motion, std::size_t most)
{
    const MotionSamples samples =
        samplesOf(assembly, network, motion, static_cast<std::int64_t>(most) + 1);
    return MotionFrames(samples, network, assembly.waveSpeed, most).all();
}

std::vector<FigureData> continuumFrames(const Continuum& curve)
{
    if (curve.points.empty()) {
        throw std::invalid_argument("animation: the curve holds no motion to draw");
    }
    return CurveFrames(curve).all();
}

}  // namespace signorini
