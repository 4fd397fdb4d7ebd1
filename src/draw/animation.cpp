// Moving pictures of a motion over time and of a continuum over lambda.

#include <fmt/format.h>

#include <algorithm>

#include "axes.hpp"
#include "mapped.hpp"
#include "signorini/figures.hpp"
#include "signorini/motion.hpp"

namespace signorini {

namespace {

using namespace plot;

constexpr std::size_t maxFrames = 121;
constexpr std::size_t nodesShown = 301;
constexpr std::int64_t instantsShown = 701;
constexpr double gapShown = 0.1;  ///< [L], the gap in the picture of the bar

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
    [[nodiscard]] Axis axis(const Unit& unit, const std::string& words) const
    {
        const double margin = 0.08 * std::max(high - low, 1e-300);
        return axisIn(unit, words, low - margin, high + margin);
    }
};

/// Two fields that share an axis, in the scales of the bar; the legend stands above them.
Panel fieldsPanel(const Range& fields, const Bar& bar, Axis position)
{
    Panel panel{.name = "fields", .place = {0.13, 0.97, 0.11, 0.34}, .x = std::move(position)};
    panel.y = fields.axis({1.0, ""}, "");
    panel.y.label = bar.gap == 0.0  ? "s,  v/c"
                    : bar.gap > 0.0 ? "s L/g,  v L/(c g)"
                                    : "s L/|g|,  v L/(c |g|)";
    panel.legend = Legend::above;
    return panel;
}

void addFields(Panel& panel, Series strain, Series velocity)
{
    strain.role = Role::strain;
    strain.width = 4.0;
    strain.legend = "strain";
    velocity.role = Role::velocity;
    velocity.width = 2.0;
    velocity.legend = "velocity";
    panel.add(std::move(strain));
    panel.add(std::move(velocity));
}

/// Where a stop is.
Series stopLine(const Axis& along, double place)
{
    return across(*along.low, *along.high, place, 1.0, Dash::dashed);
}

/// u(L) at the stops, in the scales of the bar.
std::vector<double> stopsIn(const Scene& scene)
{
    const double unit = scales(scene.bar).displacement;
    std::vector<double> places{scene.bar.gap / unit};
    if (scene.secondStop) {
        places.push_back(-*scene.secondStop / unit);
    }
    return places;
}

class MotionFrames {
public:
    MotionFrames(const MotionSamples& samples, std::size_t most)
        : samples_(samples),
          scale_(scales(samples.bar())),
          nodes_(chosen(samples.nodes(), nodesShown)),
          instants_(chosen(samples.instants(), most + 1)),
          stops_(stopsIn(samples.scene()))
    {
        for (const double stop : stops_) {
            tip_.see(stop);
        }
        for (const std::size_t m : instants_) {
            for (const std::size_t i : nodes_) {
                strain_.see(samples.strain(i, m) / scale_.strain);
                fields_.see(samples.velocity(i, m) / scale_.velocity);
                tip_.see(samples.displacement(i, m) / scale_.displacement);
            }
        }
        fields_.see(strain_.low);
        fields_.see(strain_.high);
        metre_ = axisUnit(samples.bar().length, 1.0, "m");
        place_ = axisUnit(scale_.displacement, tip_.largest(), "m");
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
    [[nodiscard]] FigureData frameAt(std::size_t instant) const
    {
        Axis position{.label = labelled("position  x", metre_),
                      .low = -0.02 * metre_.factor,
                      .high = 1.25 * metre_.factor};
        Panel fields = fieldsPanel(fields_, samples_.bar(), position);
        position = bare(position);
        Panel bar{
            .name = "bar", .place = {0.13, 0.97, 0.76, 0.92}, .x = position, .hasGrid = false};
        bar.y = {.low = -1.0, .high = 1.0, .ticks = {{-2.0, ""}}};
        bar.map = ColourMap::diverging;
        const double size = std::max(strain_.largest(), 1e-300);
        bar.colour = {.low = -size, .high = size};
        Panel middle{.name = "displacement", .place = {0.13, 0.97, 0.46, 0.71}, .x = position};
        middle.y = tip_.axis(place_, "u");
        Series cells{.kind = Kind::boxes};
        Series u = plot::line(Role::ink, 2.0);
        Series strain;
        Series velocity;
        double left = 0.0;  // end of the cell before, magnified
        double from = 0.0;
        for (const std::size_t i : nodes_) {
            const double x = samples_.x(i) * metre_.factor / samples_.bar().length;
            const double moved = samples_.displacement(i, instant) / scale_.displacement;
            const double s = samples_.strain(i, instant) / scale_.strain;
            const double right = x + gapShown * moved * metre_.factor;
            cells.add(left, -0.5, right, 0.5);
            cells.z.push_back(s);
            u.add(x, moved * place_.factor);
            strain.addStep(from, x, s);
            velocity.addStep(from, x, samples_.velocity(i, instant) / scale_.velocity);
            left = right;
            from = x;
        }
        bar.add(std::move(cells));
        const double wall = metre_.factor * (1.0 + gapShown * stops_.front());
        Series walls = box(Role::faint, wall, -1.0, *position.high, 1.0);
        walls.add(*position.low, -1.0, 0.0, 1.0);
        bar.add(std::move(walls));
        for (const double stop : stops_) {
            middle.add(stopLine(position, stop * place_.factor));
        }
        middle.add(std::move(u));
        addFields(fields, std::move(strain), std::move(velocity));
        const Unit second = axisUnit(1.0, samples_.time(samples_.instants() - 1), "s");
        FigureData frame{.width = 20.0, .height = 16.0};
        frame.title = fmt::format(
            "t = {:.4g} {}  of  {:.4g} {}", samples_.time(instant) * second.factor, second.name,
            samples_.time(samples_.instants() - 1) * second.factor, second.name);
        frame.panels = {std::move(bar), std::move(middle), std::move(fields)};
        return frame;
    }

    const MotionSamples& samples_;
    Scales scale_;
    std::vector<std::size_t> nodes_;
    std::vector<std::size_t> instants_;
    std::vector<double> stops_;
    Range strain_;
    Range fields_;
    Range tip_;
    Unit metre_;
    Unit place_;
};

/// Force and tip over a period, strain and velocity at t = 0, one frame for each member.
class CurveFrames {
public:
    explicit CurveFrames(const Continuum& curve)
        : curve_(curve),
          scale_(scales(curve.scene.bar)),
          members_(chosen(curve.points.size(), maxFrames)),
          stops_(stopsIn(curve.scene))
    {
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
        Panel fields = fieldsPanel(fields_, bar, axisIn(along, "position  x, at t = 0,", 0.0, 1.0));
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
        Series strain;
        Series velocity;
        for (std::int64_t i = 1; i <= motion.cells(); ++i) {
            const double from = static_cast<double>(i - 1) / cells * along.factor;
            const double to = static_cast<double>(i) / cells * along.factor;
            strain.addStep(from, to, motion.strain(i, 0));
            velocity.addStep(from, to, motion.velocity(i, 0));
        }
        upper.add(std::move(force));
        for (const double stop : stops_) {
            middle.add(stopLine(middle.x, stop * metre.factor));
        }
        middle.add(std::move(tip));
        addFields(fields, std::move(strain), std::move(velocity));
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
    return MotionFrames(samples, most).all();
}

std::vector<FigureData> continuumFrames(const Continuum& curve)
{
    if (curve.points.empty()) {
        throw std::invalid_argument("animation: the curve holds no motion to draw");
    }
    return CurveFrames(curve).all();
}

}  // namespace signorini
