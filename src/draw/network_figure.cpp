#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "axes.hpp"
#include "largest.hpp"
#include "network_field.hpp"
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

    /// Above them a field of all bars, if one is given.
    FigureData figure(std::optional<Panel> field = {})
    {
        constexpr double fieldHeight = 6.5;  // [cm]
        const std::size_t panels = std::min(network_.contacts.size(), mostPanels);
        const double above = 1.4 + (field ? fieldHeight : 0.0);
        FigureData figure{.height = above + 0.8 + 4.2 * static_cast<double>(panels)};
        const double room = 1.0 / figure.height;  // a centimetre
        if (field) {
            const double top = 1.0 - 1.2 * room;
            field->place = {0.13, 0.86, top - (fieldHeight - 1.0) * room, top};
            field->colourBar = Place{0.88, 0.9, field->place.bottom, field->place.top};
            figure.panels.push_back(std::move(*field));
        }
        const double right = figure.panels.empty() ? 0.96 : 0.86;
        for (std::size_t j = 0; j < panels; ++j) {
            const double top = 1.0 - room * (above + 4.2 * static_cast<double>(j));
            Panel& panel = figure.add({.name = fmt::format("contact {}", j + 1),
                                       .place = {0.13, right, top - 3.6 * room, top}});
            panel.x = j + 1 < panels ? bare(time()) : time();
            fill(panel, j);
            panel.y =
                axisAround(panel.series, fmt::format("u at contact {}  [{}]", j + 1, metre_.name));
        }
        for (Panel& panel : figure.panels) {
            if (panel.name == "contact 1") {
                panel.legend = Legend::above;
            }
        }
        return figure;
    }

    /// u of all bars over time: instants by places, in units of the network, at positions [m].
    [[nodiscard]] Panel field(const std::vector<double>& instants, std::vector<double> positions,
                              const std::vector<double>& displacements, double length) const
    {
        Panel panel{.name = "displacement", .hasGrid = false};
        const Unit along = axisUnit(1.0, length, "m");
        panel.x = bare(time());
        panel.y = axisIn(along, "along the bars", 0.0, length);
        panel.colour.label = labelled("displacement  u", metre_);
        Series image{.kind = Kind::image};
        for (const double instant : instants) {
            image.x.push_back(instant * second_.factor);
        }
        for (std::size_t i = 0; i < positions.size(); ++i) {
            image.y.push_back(positions[i] * along.factor);
            for (std::size_t m = 0; m < instants.size(); ++m) {
                image.z.push_back(displacements[m * positions.size() + i] * metre_.factor);
            }
        }
        panel.add(std::move(image));
        const std::vector<double> nodes = placesOf(network_, length);
        Series presses = plot::strokes(Role::contact, 4.0);
        for (const NetworkContactEvent& event : simulation_.contacts()) {
            const double y = nodes[network_.contacts[event.contact].node] * along.factor;
            presses.add(event.start * second_.factor, y, event.end * second_.factor, y);
        }
        for (const NetworkContact& contact : network_.contacts) {
            panel.add(across(*panel.x.low, *panel.x.high, nodes[contact.node] * along.factor, 1.0,
                             Dash::dashed));
        }
        panel.add(std::move(presses));
        return panel;
    }

private:
    [[nodiscard]] Axis time() const { return axisIn(second_, "time", begin_, end_); }

    /// Of all that is drawn.
    [[nodiscard]] double extent() const
    {
        const double moved = largestOf(simulation_.paths(), [](const auto& path) {
            return largestSizeOf(path, &NodePoint::displacement);
        });
        return std::max(moved, largestSizeOf(network_.contacts, &NetworkContact::gap));
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

FigureData periodFigure(const Network& network, const NetworkClaim& motion, double length)
{
    constexpr std::int64_t mostInstants = 400;
    constexpr std::size_t parts = 240;
    const auto period = static_cast<double>(motion.steps());
    const std::vector<NetworkPlace> places = placesAlong(network, parts);
    NetworkLook seen;
    std::vector<double> instants;
    const NetworkSimulation simulation =
        throughPeriod(network, {motion.waves, motion.displacements},
                      {.forces = motion.forces, .velocities = motion.velocities}, period,
                      mostInstants, [&](const NetworkSimulation& now) {
                          instants.push_back(now.time());
                          look(seen, network, now.state(), places);
                      });
    ContactPanels panels(simulation, period);
    FigureData figure = panels.figure(
        panels.field(instants, positionsOf(network, places, length), seen.displacements, length));
    figure.title = "one period of the motion";
    return figure;
}

FigureData contactFigure(const std::vector<ContactInstant>& path, const NetworkScales& scales)
{
    const Unit second = axisUnit(scales.time, path.back().time, "s");
    const Unit metre =
        axisUnit(scales.displacement, largestOf(path, &ContactInstant::distance), "m");
    const Unit newton = axisUnit(scales.force(), largestOf(path, &ContactInstant::push), "N");
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
