#include "bars_motion.hpp"

#include <algorithm>
#include <cmath>

namespace signorini {

std::vector<NetworkPlace> sampledPlaces(const Network& network)
{
    const auto rows = static_cast<std::int64_t>(network.rows.size());
    return placesOfRows(network, std::max<std::int64_t>(1, maxMotionNodes / rows - 1));
}

ShownPeriod shownPeriod(const Network& network, const NetworkClaim& motion)
{
    return [&](std::int64_t instants, const auto& see) {
        (void)throughPeriod(network, {motion.waves, motion.displacements},
                            {.forces = motion.forces, .velocities = motion.velocities},
                            static_cast<double>(motion.steps()), std::min(motion.steps(), instants),
                            [&](const NetworkSimulation& now) { see(now.time(), now.state()); });
    };
}

MotionSamples samplesOf(const Assembly& assembly, const Network& network, const ShownPeriod& motion,
                        std::int64_t mostInstants)
{
    const std::vector<NetworkPlace> places = sampledPlaces(network);
    std::vector<NetworkPlace> middles = places;
    for (NetworkPlace& place : middles) {
        place.cells = std::max(1.0, std::ceil(place.cells)) - 0.5;
    }
    BarsSampled sampled{.x = positionsOf(network, places, assembly.length),
                        .xCell = positionsOf(network, middles, assembly.length)};
    NetworkLook seen;
    const NetworkScales& scales = network.scales;
    motion(mostInstants - 1, [&](double time, const NetworkStart& now) {
        sampled.times.push_back(time * scales.time);
        look(seen, network, now, places);
    });
    const auto inUnit = [](std::vector<double> values, double unit) {
        for (double& value : values) {
            value *= unit;
        }
        return values;
    };
    sampled.displacements = inUnit(std::move(seen.displacements), scales.displacement);
    sampled.velocities = inUnit(std::move(seen.velocities), scales.velocity());
    sampled.strains = inUnit(std::move(seen.strains), scales.velocity() / assembly.waveSpeed);
    return MotionSamples(std::move(sampled));
}

}  // namespace signorini
