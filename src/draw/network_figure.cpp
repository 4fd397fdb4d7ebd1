#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "axes.hpp"
#include "network_simulation.hpp"
#include "scene_figures.hpp"

namespace signorini {

namespace {

using namespace plot;

constexpr std::size_t mostPanels = 6;
constexpr std::size_t mostPoints = 4000;
constexpr double shownCrossings = 24.0;  ///< of all cells

/// What is drawn of a simulation, in SI and units of engineers.
class ContactPanels {
public:
    /// Over its last `shown` h.
    ContactPanels(const NetworkSimulation& simulation, double shown)
        : simulation_(simulation),
          network_(simulation.network()),
          end_(simulation.time()),
          begin_(std::max(0.0, end_ - shown)),
          second_(axisUnit(network_.scales.time, end_, "s")),
          metre_(axisUnit(network_.scales.displacement, extent(), "m"))
    {
    }

    FigureData figure()
    {
        const std::size_t panels = std::min(network_.contacts.size(), mostPanels);
        FigureData figure{.height = 2.2 + 4.2 * static_cast<double>(panels)};
        const double room = 1.0 / figure.height;  // a centimetre
        for (std::size_t j = 0; j < panels; ++j) {
            const double top = 1.0 - room * (1.4 + 4.2 * static_cast<double>(j));
            Panel& panel = figure.add({.name = fmt::format("contact {}", j + 1),
                                       .place = {0.13, 0.96, top - 3.6 * room, top}});
            panel.x = axisIn(second_, "time", begin_, end_);
            if (j + 1 < panels) {
                panel.x.label.clear();
                panel.x.hasNumbers = false;
            }
            fill(panel, j);
            panel.y =
                axisAround(panel.series, fmt::format("u at contact {}  [{}]", j + 1, metre_.name));
        }
        if (panels > 0) {
            figure.panels.front().legend = Legend::above;
        }
        return figure;
    }

private:
    /// Of all that is drawn.
    [[nodiscard]] double extent() const
    {
        double most = 0.0;
        for (const auto& path : simulation_.paths()) {
            for (const NodePoint& point : path) {
                most = std::max(most, std::abs(point.displacement));
            }
        }
        for (const NetworkContact& contact : network_.contacts) {
            most = std::max(most, std::abs(contact.gap));
        }
        return most;
    }

    [[nodiscard]] Series pathOf(std::size_t node, double offset, Role role, std::string words) const
    {
        const std::vector<NodePoint>& path = simulation_.paths()[node];
        const auto first =
            std::lower_bound(path.begin(), path.end(), begin_,
                             [](const NodePoint& point, double time) { return point.time < time; });
        const auto count = static_cast<std::size_t>(path.end() - first);
        Series line = plot::line(role, 1.2).named(std::move(words));
        for (std::size_t k = 0; k < count; k += 1 + count / mostPoints) {
            const NodePoint& point = first[static_cast<std::ptrdiff_t>(k)];
            line.add(point.time * second_.factor, (point.displacement + offset) * metre_.factor);
        }
        line.add(end_ * second_.factor, (simulation_.displacement(node) + offset) * metre_.factor);
        return line;
    }

    /// From start to end, where the face is just then.
    [[nodiscard]] Series pressesOf(std::size_t contact) const
    {
        Series presses = plot::line(Role::contact, 4.0).named("in contact");
        std::size_t events = 0;
        for (const NetworkContactEvent& event : simulation_.contacts()) {
            if (event.contact != contact || event.end < begin_ || ++events > mostPoints) {
                continue;
            }
            for (const NodePoint& point : simulation_.paths()[network_.contacts[contact].node]) {
                if (point.time >= event.start && point.time <= event.end) {
                    presses.add(point.time * second_.factor, point.displacement * metre_.factor);
                }
            }
            presses.breakOff();
        }
        return presses;
    }

    void fill(Panel& panel, std::size_t j) const
    {
        const NetworkContact& contact = network_.contacts[j];
        const bool isGap = contact.kind == ContactKind::gap;
        if (isGap) {
            panel.add(pathOf(contact.node + 1, contact.gap, Role::strain, "right face"));
        } else {
            const double stop =
                metre_.factor *
                (contact.kind == ContactKind::stopRight ? contact.gap : -contact.gap);
            panel.add({.role = Role::faint,
                       .width = 3.0,
                       .legend = "stop",
                       .x = {*panel.x.low, *panel.x.high},
                       .y = {stop, stop}});
        }
        panel.add(pathOf(contact.node, 0.0, Role::ink, isGap ? "left face" : "face"));
        panel.add(pressesOf(j));
    }

    const NetworkSimulation& simulation_;
    const Network& network_;
    double end_;
    double begin_;
    Unit second_;
    Unit metre_;
};

}  // namespace

FigureData simulationFigure(const NetworkSimulation& simulation)
{
    const auto& paths = simulation.paths();
    if (std::all_of(paths.begin(), paths.end(), [](const auto& one) { return one.empty(); })) {
        throw std::invalid_argument("figure: the simulation holds no paths to draw");
    }
    const auto cells = static_cast<double>(simulation.network().cells());
    return ContactPanels(simulation, shownCrossings * cells).figure();
}

FigureData periodFigure(const Network& network, const NetworkClaim& motion)
{
    const auto period = static_cast<double>(motion.steps());
    NetworkSimulation simulation(network, {motion.waves, motion.displacements},
                                 {.forces = motion.forces, .velocities = motion.velocities},
                                 {.recordsPaths = true});
    simulation.advance(period);
    const std::vector<double> waves = simulation.state().waves;
    double largest = 0.0;
    double change = 0.0;
    for (std::size_t k = 0; k < waves.size(); ++k) {
        largest = std::max(largest, std::abs(motion.waves[k]));
        change = std::max(change, std::abs(waves[k] - motion.waves[k]));
    }
    if (change > 1e-6 * largest) {
        throw std::runtime_error(fmt::format(
            "figure: simulated for its period the motion comes back to within {:.2g} of its "
            "largest wave only, so it is not drawn",
            change / largest));
    }
    FigureData figure = ContactPanels(simulation, period).figure();
    figure.title = "one period of the motion";
    return figure;
}

FigureData contactFigure(const std::vector<ContactInstant>& path, const NetworkScales& scales)
{
    double wide = 0.0;
    double pressed = 0.0;
    for (const ContactInstant& one : path) {
        wide = std::max(wide, one.distance);
        pressed = std::max(pressed, one.push);
    }
    const Unit second = axisUnit(scales.time, path.back().time, "s");
    const Unit metre = axisUnit(scales.displacement, wide, "m");
    const Unit newton = axisUnit(scales.force(), pressed, "N");
    Series gap{.width = 1.8};
    Series force{.role = Role::contact, .width = 1.8};
    for (const ContactInstant& one : path) {
        gap.add(one.time * second.factor, one.distance * metre.factor);
        force.add(one.time * second.factor, one.push * newton.factor);
    }
    FigureData figure{.title = "the contact over a period, under an exact harmonic"};
    Panel above{.name = "gap", .place = {0.13, 0.96, 0.54, 0.9}};
    above.x = {.low = 0.0, .high = gap.x.back(), .hasNumbers = false};
    above.series.push_back(std::move(gap));
    above.y = axisAround(above.series, labelled("open by", metre));
    Panel below{.name = "force", .place = {0.13, 0.96, 0.12, 0.48}};
    below.x = {.label = labelled("time  t", second), .low = 0.0, .high = force.x.back()};
    below.series.push_back(std::move(force));
    below.y = axisAround(below.series, labelled("force", newton));
    figure.panels = {std::move(above), std::move(below)};
    return figure;
}

}  // namespace signorini
