
#include "network.hpp"
#include "stepped_bar.hpp"

namespace signorini {

Network networkOf(const Scene& scene, std::int64_t cells, const Damping& damping)
{
    validate(scene);
    validate(damping);
    std::vector<Segment> segments{{.cells = cells}};
    if (!scene.segments.empty()) {
        const SteppedBar bar = steppedBar(scene.segments);
        requireCells(bar, cells);
        segments = bar.segments;
    }
    Network network;
    network.nodes.push_back({.isClamped = true, .isShaken = true});
    for (const Segment& segment : segments) {
        const std::size_t node = network.nodes.size();
        network.rows.push_back({segment.cells, segment.impedance, segment.speed, node - 1, node});
        network.nodes.push_back({.dashpot = segment.dashpot});
    }
    const std::size_t tip = network.nodes.size() - 1;
    network.nodes[tip].isDriven = true;
    network.nodes[tip].dashpot = damping.eta();
    network.bars.push_back({.firstNode = 0, .lastNode = tip, .clamps = 1});

    const Stops stops = stopsOf(scene);
    const auto steps = static_cast<double>(cells);  // delta = |g|/N
    network.contacts.push_back({ContactKind::stopRight, tip, steps * stops.right});
    if (stops.left) {
        const double way = steps * static_cast<double>(stops.left->numerator) /
                           static_cast<double>(stops.left->denominator);
        network.contacts.push_back({ContactKind::stopLeft, tip, way});
    }
    const Bar first = firstMaterial(scene);
    network.scales = {.time = first.length / first.waveSpeed / steps,
                      .displacement = scales(scene.bar).displacement / steps,
                      .impedance = first.axialStiffness / first.waveSpeed};
    validate(network);
    return network;
}

Network networkOf(const Stops& stops, const std::vector<Segment>& segments, std::int64_t cells,
                  const Damping& damping)
{
    Scene scene;
    scene.bar.gap = stops.right;
    if (stops.left) {
        scene.secondStop = stops.left->value();
    }
    scene.segments = segments;
    return networkOf(scene, cells, damping);
}

}  // namespace signorini
