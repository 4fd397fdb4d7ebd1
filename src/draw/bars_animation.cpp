// Moving pictures of several bars over a period.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axes.hpp"
#include "bars_motion.hpp"
#include "scene_figures.hpp"

namespace signorini {

namespace {

using namespace plot;

constexpr double smallestGapShown = 0.06;  ///< [of all bars], the smallest gap in the picture

/// Bars end to end; displacements and gaps are magnified by one factor, so that what touches in the
/// picture touches.
class BarsFrames {
public:
    BarsFrames(const Assembly& assembly, const Network& network, const ShownPeriod& motion,
               std::int64_t most)
        : network_(network),
          places_(sampledPlaces(network)),
          samples_(samplesOf(assembly, network, motion, most)),
          length_(assembly.length),
          metre_(axisUnit(1.0, assembly.length, "m"))
    {
        double smallest = infinity;
        for (const NetworkContact& contact : network.contacts) {
            const double gap = std::abs(contact.gap) * network.scales.displacement;
            smallest = gap > 0.0 ? std::min(smallest, gap) : smallest;
        }
        for (std::size_t m = 0; m < samples_.instants(); ++m) {
            for (std::size_t i = 0; i < samples_.nodes(); ++i) {
                reach_ = std::max(reach_, std::abs(samples_.displacement(i, m)));
                strain_ = std::max(strain_, std::abs(samples_.strain(i, m)));
            }
        }
        // Not so much that a bar is turned inside out.
        magnified_ = smallestGapShown * length_ / (std::isfinite(smallest) ? smallest : reach_);
        magnified_ = std::min(magnified_, 0.5 / std::max(strain_, 1e-300));
        placeBars();
        place_ = axisUnit(1.0, reach_, "m");
    }

    [[nodiscard]] std::vector<FigureData> all() const
    {
        std::vector<FigureData> frames;
        for (std::size_t m = 0; m + 1 < std::max<std::size_t>(samples_.instants(), 2); ++m) {
            frames.push_back(frameAt(m));
        }
        return frames;
    }

private:
    /// By how much each bar stands to the right of where it is end to end [m].
    void placeBars()
    {
        double moved = 0.0;
        for (const NetworkBar& bar : network_.bars) {
            moved_.push_back(moved);
            for (const NetworkContact& contact : network_.contacts) {
                if (contact.kind == ContactKind::gap && contact.node == bar.lastNode) {
                    moved += magnified_ * contact.gap * network_.scales.displacement;
                }
            }
        }
    }

    [[nodiscard]] double placeAt(std::size_t i, std::size_t m) const
    {
        const std::size_t bar = network_.nodes[network_.rows[places_[i].row].left].bar;
        return (samples_.x(i) + moved_[bar] + magnified_ * samples_.displacement(i, m)) *
               metre_.factor;
    }

    /// Cells and stops as boxes.
    void addBars(Panel& panel, std::size_t m) const
    {
        Series cells{.kind = Kind::boxes};
        for (std::size_t i = 1; i < places_.size(); ++i) {
            if (places_[i].row == places_[i - 1].row) {
                const double half =
                    0.5 * std::clamp(network_.rows[places_[i].row].impedance, 0.3, 1.6);
                cells.add(placeAt(i - 1, m), -half, placeAt(i, m), half);
                cells.z.push_back(samples_.strain(i, m));
            }
        }
        panel.add(std::move(cells));
        const std::vector<double> nodes = placesOf(network_, length_);
        const double thick = 0.015 * length_ * metre_.factor;
        for (std::size_t k = 0; k < network_.nodes.size(); ++k) {
            const NetworkNode& node = network_.nodes[k];
            if (node.isClamped) {
                const double at = (nodes[k] + moved_[node.bar]) * metre_.factor;
                const bool isLeft = k == network_.bars[node.bar].firstNode;
                panel.add(
                    box(Role::ink, isLeft ? at - thick : at, -0.9, isLeft ? at : at + thick, 0.9));
            }
        }
        for (const NetworkContact& contact : network_.contacts) {
            if (contact.kind == ContactKind::gap) {
                continue;
            }
            const double side = contact.kind == ContactKind::stopRight ? 1.0 : -1.0;
            const double gap = contact.gap * network_.scales.displacement;
            const double at = (nodes[contact.node] + moved_[network_.nodes[contact.node].bar] +
                               side * magnified_ * gap) *
                              metre_.factor;
            const double wide = side * thick;
            panel.add(box(Role::faint, std::min(at, at + wide), 0.0, std::max(at, at + wide), 1.0));
        }
    }

    [[nodiscard]] FigureData frameAt(std::size_t m) const
    {
        const double room = 0.02 * length_;
        Axis along{
            .label = labelled("along the bars", metre_),
            .low = -(room + magnified_ * reach_) * metre_.factor,
            .high = (length_ + moved_.back() + room + 1.2 * magnified_ * reach_) * metre_.factor};
        Panel bars{.name = "bar", .place = {0.13, 0.97, 0.62, 0.9}, .hasGrid = false};
        bars.x = bare(along);
        bars.y = {.low = -1.0, .high = 1.0, .ticks = {{-2.0, ""}}};
        bars.map = ColourMap::diverging;
        const double size = std::max(strain_, 1e-300);
        bars.colour = {.low = -size, .high = size};
        addBars(bars, m);
        Panel displaced{.name = "displacement", .place = {0.13, 0.97, 0.11, 0.56}, .x = along};
        displaced.y = axisIn(place_, "u", -1.1 * reach_, 1.1 * reach_);
        Series u = plot::line(Role::ink, 2.0);
        for (std::size_t i = 0; i < places_.size(); ++i) {
            if (i > 0 && places_[i].row != places_[i - 1].row) {
                u.breakOff();
            }
            const std::size_t bar = network_.nodes[network_.rows[places_[i].row].left].bar;
            u.add((samples_.x(i) + moved_[bar]) * metre_.factor,
                  samples_.displacement(i, m) * place_.factor);
        }
        displaced.add(std::move(u));
        const Unit second = axisUnit(1.0, samples_.time(samples_.instants() - 1), "s");
        FigureData frame{.width = 20.0, .height = 13.0};
        frame.title = fmt::format(
            "t = {:.4g} {}  of  {:.4g} {}", samples_.time(m) * second.factor, second.name,
            samples_.time(samples_.instants() - 1) * second.factor, second.name);
        frame.panels = {std::move(bars), std::move(displaced)};
        return frame;
    }

    const Network& network_;
    std::vector<NetworkPlace> places_;
    MotionSamples samples_;
    double length_;
    Unit metre_;
    Unit place_;
    double magnified_ = 1.0;
    double reach_ = 0.0;   ///< [m], largest |u|
    double strain_ = 0.0;  ///< largest
    std::vector<double> moved_;
};

}  // namespace

std::vector<FigureData> barsFrames(const Assembly& assembly, const Network& network,
                                   const ShownPeriod& motion, std::size_t most)
{
    return BarsFrames(assembly, network, motion, static_cast<std::int64_t>(most) + 1).all();
}

}  // namespace signorini
