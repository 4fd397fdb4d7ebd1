#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
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

/// Axis and units of what is drawn over time.
struct OverTime {
    Axis axis;
    Unit second;  ///< [h]
    Unit metre;   ///< [delta]
};

constexpr std::size_t partsOfField = 240;  ///< places

/// u of all bars over time, seen at places along them, instant by instant [h]; what presses is
/// marked.
Panel fieldPanel(const Network& network, double length, const OverTime& units,
                 const std::vector<double>& instants, const NetworkLook& seen,
                 const std::vector<NetworkContactEvent>& events)
{
    Panel panel{.name = "displacement", .hasGrid = false};
    const Unit along = axisUnit(1.0, length, "m");
    panel.x = bare(units.axis);
    panel.y = axisIn(along, "along the bars", 0.0, length);
    panel.colour.label = labelled("displacement  u", units.metre);
    Series image{.kind = Kind::image};
    for (const double instant : instants) {
        image.x.push_back(instant * units.second.factor);
    }
    const std::vector<double> positions =
        positionsOf(network, placesAlong(network, partsOfField), length);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        image.y.push_back(positions[i] * along.factor);
        for (std::size_t m = 0; m < instants.size(); ++m) {
            image.z.push_back(seen.displacements[m * positions.size() + i] * units.metre.factor);
        }
    }
    panel.add(std::move(image));
    const std::vector<double> nodes = placesOf(network, length);
    Series presses = plot::strokes(Role::contact, 4.0);
    for (const NetworkContactEvent& event : events) {
        const double y = nodes[network.contacts[event.contact].node] * along.factor;
        presses.add(event.start * units.second.factor, y, event.end * units.second.factor, y);
    }
    for (const NetworkContact& contact : network.contacts) {
        panel.add(across(*panel.x.low, *panel.x.high, nodes[contact.node] * along.factor, 1.0,
                         Dash::dashed));
    }
    panel.add(std::move(presses));
    return panel;
}

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

    [[nodiscard]] Panel field(const std::vector<double>& instants, const NetworkLook& seen,
                              double length) const
    {
        return fieldPanel(network_, length, {time(), second_, metre_}, instants, seen,
                          simulation_.contacts());
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

/// By contact: how far it is open, and its force.
using ContactCurves = std::map<std::size_t, std::array<Series, 2>>;

ContactCurves curvesOf(const std::vector<ContactInstant>& path, double second, double metre,
                       double newton)
{
    constexpr std::array dashes{Dash::solid, Dash::dashed, Dash::dotted, Dash::longDashed};
    ContactCurves curves;
    for (const ContactInstant& at : path) {
        const auto [curve, isNew] = curves.try_emplace(at.contact);
        auto& [gap, force] = curve->second;
        if (isNew) {
            const Dash dash = dashes.at((curves.size() - 1) % dashes.size());
            gap = line(Role::ink, 1.8, dash);
            force = line(Role::contact, 1.8, dash);
        }
        gap.add(at.time * second, at.distance * metre);
        force.add(at.time * second, at.push * newton);
    }
    return curves;
}

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
    const auto period = static_cast<double>(motion.steps());
    const std::vector<NetworkPlace> places = placesAlong(network, partsOfField);
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
    FigureData figure = panels.figure(panels.field(instants, seen, length));
    figure.title = "one period of the motion";
    return figure;
}

ShownPeriod shownPeriod(const answers::SceneHarmonicAnswer& answer, std::size_t motion)
{
    return [&answer, motion](std::int64_t instants, const auto& see) {
        const std::int64_t count = std::min(instants, answer.steps);
        std::int64_t seen = 0;
        answer.watch(motion, {.state = [&](std::int64_t step, const NetworkStart& now) {
                         if (step == answer.steps * seen / count) {
                             see(static_cast<double>(step), now);
                             ++seen;
                         }
                     }});
    };
}

FigureData harmonicFigure(const answers::SceneHarmonicAnswer& answer, std::size_t motion)
{
    const Network network = networkOf(answer.bars.assembly);
    const NetworkHarmonicMotion& one = answer.motions.at(motion).value;
    const std::vector<NetworkPlace> places = placesAlong(network, partsOfField);
    std::vector<ContactInstant> path;
    NetworkLook seen;
    std::vector<double> instants;
    answer.watch(motion, {&path, [&](std::int64_t step, const NetworkStart& now) {
                              instants.push_back(static_cast<double>(step));
                              look(seen, network, now, places);
                          }});
    const NetworkScales& scales = answer.scales;
    const Unit second = axisUnit(scales.time, instants.back(), "s");
    const Unit metre =
        axisUnit(scales.displacement, largestOf(path, &ContactInstant::distance), "m");
    const Unit newton = axisUnit(scales.force(), largestOf(path, &ContactInstant::push), "N");
    ContactCurves curves = curvesOf(path, second.factor, metre.factor, newton.factor);
    const Axis time = axisIn(second, "time  t", 0.0, instants.back());
    std::vector<NetworkContactEvent> events;
    events.reserve(2 * one.contacts.size());
    for (const NetworkHarmonicContact& contact : one.contacts) {
        events.push_back({.contact = contact.contact, .start = contact.begin, .end = contact.end});
        if (const double over = contact.end - static_cast<double>(answer.steps); over > 0.0) {
            events.push_back({.contact = contact.contact, .start = 0.0, .end = over});
        }
    }
    const double swing = largestOf(seen.displacements, [](double u) { return std::abs(u); });
    Panel above = fieldPanel(network, answer.bars.assembly.length,
                             {time, second, axisUnit(scales.displacement, swing, "m")}, instants,
                             seen, events);
    above.place = {0.13, 0.86, 0.66, 0.92};
    above.colourBar = Place{0.88, 0.9, 0.66, 0.92};
    Panel middle{.name = "gap", .place = {0.13, 0.86, 0.38, 0.62}, .x = bare(time)};
    Panel below{.name = "force", .place = {0.13, 0.86, 0.1, 0.34}, .x = time};
    std::vector<std::string> names;
    for (auto& [contact, curve] : curves) {
        names.push_back(std::to_string(contact + 1));
        if (curves.size() > 1) {
            curve[0].legend = curve[1].legend = "contact " + names.back();
            middle.legend = below.legend = Legend::above;
        }
        middle.series.push_back(std::move(curve[0]));
        below.series.push_back(std::move(curve[1]));
    }
    middle.y = axisAround(middle.series, labelled("open by", metre));
    below.y = axisAround(below.series, labelled("force", newton));
    FigureData figure{.title =
                          fmt::format("contact{} {} over a period, under an exact harmonic",
                                      names.size() == 1 ? "" : "s", fmt::join(names, " and "))};
    figure.panels = {std::move(above), std::move(middle), std::move(below)};
    return figure;
}

}  // namespace signorini
