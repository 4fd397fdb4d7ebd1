// Scenes: bars in a row with all that stands at them, followed event by event.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "network_field.hpp"
#include "scene_report.hpp"
#include "scene_simulation_answer.hpp"
#include "views.hpp"

namespace signorini::web {

namespace {

constexpr double mostEvents = 2e6;  // about a second of a page
constexpr std::int64_t mostRowPlaces = 150;
constexpr std::int64_t mostFrames = 1500;

/// What is asked: "words", "gravity" [m/s^2], "hands", and "amplitude" [N] or [m] with "frequency"
/// [omega_1], if something is to shake.
struct SceneCourse {
    Assembly assembly;
    Network network;
    NetworkStart start;
    answers::SceneDrive drive = {};
};

Assembly sceneOf(const Request& request)
{
    Assembly assembly{
        .parts = partsOf(request.word("words")),
        .gravity = request.has("gravity") ? request.number("gravity", -10.0, 10.0) : 0.0};
    validate(assembly);
    std::int64_t cells = 0;
    for (const AssemblyPart& part : assembly.parts) {
        cells += part.cells;
    }
    if (cells > mostCells) {
        throw std::invalid_argument(
            fmt::format("words: {} cells: allowed at most {} on this page", cells, mostCells));
    }
    return assembly;
}

/// Where a hand moves the places of a bar that something holds, as a share of its own way: from a
/// clamp on, up to its free end, or up to its middle between two; all of it on a spring.
double pulledShare(const Network& network, const NetworkBar& bar, double share)
{
    const bool left = network.nodes[bar.firstNode].isClamped;
    const bool right = network.nodes[bar.lastNode].isClamped;
    if (left && right) {
        return 1.0 - std::abs(2.0 * share - 1.0);
    }
    return left ? share : right ? 1.0 - share : 1.0;
}

/// Adds what the hands do, one number for each bar: those that drift have that speed [c g/L], the
/// others are pulled so far [g].
void addHands(SceneCourse& course, const std::vector<double>& hands)
{
    const Network& network = course.network;
    const double displacement = bar.gap / network.scales.displacement;
    const double speed = bar.gap * bar.waveSpeed / bar.length / network.scales.velocity();
    std::vector<double> u(network.nodes.size(), 0.0);
    for (std::size_t k = 0; k < network.bars.size(); ++k) {
        const NetworkBar& held = network.bars[k];
        const double hand = k < hands.size() ? hands[k] : 0.0;
        double cells = 0.0;
        for (const CellRow& row : network.rows) {
            cells += network.nodes[row.left].bar == k ? static_cast<double>(row.cells) : 0.0;
        }
        double passed = 0.0;
        const auto pulled = [&](double at) {
            return held.drifts() ? 0.0
                                 : hand * displacement * pulledShare(network, held, at / cells);
        };
        u[held.firstNode] = pulled(0.0);
        for (std::size_t r = 0; r < network.rows.size(); ++r) {
            const CellRow& row = network.rows[r];
            if (network.nodes[row.left].bar != k) {
                continue;
            }
            const auto size = static_cast<std::size_t>(row.cells);
            const std::size_t first = network.firstWave(r);
            for (std::size_t cell = 0; cell < size; ++cell, passed += 1.0) {
                const double stretched = pulled(passed + 1.0) - pulled(passed);
                const double half = held.drifts() ? 0.5 * hand * speed : 0.0;
                course.start.waves[first + cell] += half - 0.5 * stretched;
                course.start.waves[first + size + cell] += half + 0.5 * stretched;
            }
            u[row.right] = pulled(passed);
        }
    }
    for (std::size_t k = 0; k < network.stubs.size(); ++k) {
        const Stub& stub = network.stubs[k];
        const NetworkBar& of = network.bars[network.nodes[stub.node].bar];
        const double hand =
            network.nodes[stub.node].bar < hands.size() ? hands[network.nodes[stub.node].bar] : 0.0;
        course.start.waves[network.firstWave(network.rows.size()) + k] +=
            stub.kind == StubKind::spring ? -u[stub.node]
            : of.drifts()                 ? 0.5 * hand * speed
                                          : 0.0;
    }
    for (std::size_t node = 0; node < u.size(); ++node) {
        course.start.displacements[node] += u[node];
    }
}

void addDrive(SceneCourse& course, const Request& request)
{
    if (request.has("amplitude")) {
        const bool isForce = isExcitable(course.network, Excited::tip);
        course.drive = answers::drivenBy(
            course.network, {isForce ? Excited::tip : Excited::base, amplitudeOf(request),
                             request.number("frequency", 0.01, 100.0)});
    }
}

SceneCourse sceneCourseOf(const Request& request)
{
    SceneCourse course;
    course.assembly = sceneOf(request);
    course.network = networkOf(course.assembly);
    const auto& bars = course.network.bars;
    const bool drifts =
        std::any_of(bars.begin(), bars.end(), [](const NetworkBar& bar) { return bar.drifts(); });
    addDrive(course, request);
    // Bars that fly begin unstrained where they were put; else all is at rest under its weight.
    course.start = drifts ? startWithSpeeds(course.network, std::vector(bars.size(), 0.0))
                          : startAtRest(course.network, course.drive.moved.base);
    addHands(course, request.numbers("hands", -100.0, 100.0));
    return course;
}

/// Places at which displacements are drawn, and which of them a row has.
struct Places {
    explicit Places(const SceneCourse& course)
        : network(course.network),
          list(placesOfRows(network, mostRowPlaces)),
          x(positionsOf(network, list, course.assembly.length))
    {
        for (std::size_t k = 0; k < list.size(); ++k) {
            if (rows.size() == list[k].row) {
                rows.push_back({k, k});
            }
            rows.back()[1] = k + 1;
        }
    }

    /// Where a node is among them.
    [[nodiscard]] std::size_t of(std::size_t node) const
    {
        for (std::size_t r = 0; r < rows.size(); ++r) {
            const CellRow& row = network.rows[r];
            if (row.left == node || row.right == node) {
                return row.right == node ? rows[r][1] - 1 : rows[r][0];
            }
        }
        return 0;
    }

    const Network& network;
    std::vector<NetworkPlace> list;
    std::vector<double> x;                         ///< [L]
    std::vector<std::array<std::size_t, 2>> rows;  ///< of x, from and to
};

/// Clamps, springs, masses, dashpots, what is driven, and the contacts with their distance [g]
/// while nothing is displaced.
void addStanding(Reply& reply, const Network& network, const Places& places)
{
    Json stands = Json::array();
    const auto add = [&](const char* kind, std::size_t node) {
        stands.push_back({{"kind", kind}, {"at", places.of(node)}});
    };
    for (std::size_t k = 0; k < network.nodes.size(); ++k) {
        const NetworkNode& node = network.nodes[k];
        if (node.isClamped) {
            const bool isRight = k == network.bars[node.bar].lastNode;
            add(isRight ? "clamp right" : "clamp left", k);
        }
        if (node.isDriven) {
            add("driven", k);
        }
        if (node.dashpot > 0.0) {
            add("dash", k);
        }
    }
    for (const Stub& stub : network.stubs) {
        add(stub.kind == StubKind::spring ? "spring" : "mass", stub.node);
    }
    reply.json["stands"] = std::move(stands);
    reply.json["drifts"] = Json::array();
    for (const NetworkBar& one : network.bars) {
        reply.json["drifts"].push_back(one.drifts());
    }
    reply.json["contacts"] = Json::array();
    for (const NetworkContact& contact : network.contacts) {
        const double rest = network.nodes[contact.node].rest;
        const bool isGap = contact.kind == ContactKind::gap;
        const double opening = contact.kind == ContactKind::stopLeft ? contact.gap - rest
                               : isGap ? contact.gap + rest - network.nodes[contact.node + 1].rest
                                       : contact.gap + rest;
        reply.json["contacts"].push_back(
            {{"kind", name(contact.kind)},
             {"at", places.of(contact.node)},
             {"next", isGap ? Json(places.of(contact.node + 1)) : Json()},
             {"gap", opening * network.scales.displacement / bar.gap}});
    }
}

}  // namespace

Reply showScene(const Request& request)
{
    Reply reply;
    const SceneCourse course = sceneCourseOf(request);
    const NetworkScales& scales = course.network.scales;
    const double crossing = bar.length / bar.waveSpeed / scales.time;
    const double begin = request.number("from", 0.0, 1e4) * crossing;
    const double span = request.number("span", 0.1, 200.0) * crossing;
    NetworkSimulation simulation(course.network, course.start,
                                 driveFrom(course.network, course.start, course.drive.moved),
                                 {.mergeBelow = 1e-9});
    // In parts, for what takes too long is to be refused.
    const auto goOn = [&](double duration) {
        for (double left = duration; left > 0.0; left -= crossing) {
            simulation.advance(std::min(left, crossing));
            if (static_cast<double>(simulation.events()) > mostEvents) {
                throw std::invalid_argument(
                    "too much happens in that time for a page: fewer parts or less time; the "
                    "command line has no such limit");
            }
        }
    };
    goOn(begin);
    const Places places(course);
    const std::size_t contacts = course.network.contacts.size();
    const double unit = scales.force() * bar.length / (bar.axialStiffness * bar.gap);
    std::vector<double> times;
    NetworkLook seen;
    std::vector<double> forces;
    const auto frames =
        std::clamp(static_cast<std::int64_t>(span / crossing * 60.0), std::int64_t{60}, mostFrames);
    for (std::int64_t k = 0; k <= frames; ++k) {
        times.push_back(simulation.time() / crossing);
        look(seen, course.network, simulation.state(), places.list);
        for (std::size_t j = 0; j < contacts; ++j) {
            forces.push_back(unit * simulation.push(j));
        }
        goOn(k < frames ? span / static_cast<double>(frames) : 0.0);
    }
    answers::SceneSimulationAnswer answer{
        .bars = answers::severalOf(course.assembly, course.network), .drive = course.drive.told};
    answer.see(simulation);
    reply.json["answer"] = cli::wholeJsonOf(answer);
    reply.json["words"] = textOf(course.assembly.parts);
    addStanding(reply, course.network, places);
    reply.json["rows"] = Json::array();
    for (std::size_t r = 0; r < places.rows.size(); ++r) {
        const CellRow& row = course.network.rows[r];
        reply.json["rows"].push_back({{"from", places.rows[r][0]},
                                      {"to", places.rows[r][1]},
                                      {"bar", course.network.nodes[row.left].bar},
                                      {"impedance", row.impedance}});
    }
    reply.json["nodes"] = places.x.size();
    reply.add("x", places.x);
    reply.add("times", times);
    for (double& u : seen.displacements) {
        u *= scales.displacement / bar.gap;
    }
    reply.add("u", seen.displacements);
    reply.add("forces", forces);
    return reply;
}

}  // namespace signorini::web
