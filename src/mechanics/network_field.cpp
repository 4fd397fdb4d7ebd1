#include "network_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace signorini {

namespace {

double lengthOfRows(const Network& network)
{
    double cells = 0.0;
    for (const CellRow& row : network.rows) {
        cells += static_cast<double>(row.cells) * row.speed;
    }
    return cells;
}

}  // namespace

std::vector<double> placesOf(const Network& network, double length)
{
    const double cells = lengthOfRows(network);
    std::vector<double> places(network.nodes.size(), 0.0);
    std::size_t row = 0;
    for (std::size_t node = 0; node < places.size(); ++node) {
        if (row < network.rows.size() && network.rows[row].right == node) {
            const CellRow& here = network.rows[row++];
            places[node] =
                places[node - 1] + length * static_cast<double>(here.cells) * here.speed / cells;
        } else if (node > 0) {
            places[node] = places[node - 1];
        }
    }
    return places;
}

std::vector<NetworkPlace> placesOfRows(const Network& network, std::int64_t parts)
{
    std::vector<NetworkPlace> places;
    for (std::size_t r = 0; r < network.rows.size(); ++r) {
        const std::int64_t cells = network.rows[r].cells;
        const std::int64_t count = std::min(cells, parts);
        for (std::int64_t k = 0; k <= count; ++k) {
            const std::int64_t whole = cells * k / count;
            places.push_back({r, static_cast<double>(whole)});
        }
    }
    return places;
}

std::vector<NetworkPlace> placesAlong(const Network& network, std::size_t parts)
{
    std::vector<NetworkPlace> places;
    const double all = lengthOfRows(network);
    std::size_t r = 0;
    double passed = 0.0;
    const auto lengthOf = [&network](std::size_t row) {
        return static_cast<double>(network.rows[row].cells) * network.rows[row].speed;
    };
    for (std::size_t k = 0; k < parts; ++k) {
        const double at = all * (static_cast<double>(k) + 0.5) / static_cast<double>(parts);
        while (r + 1 < network.rows.size() && at > passed + lengthOf(r)) {
            passed += lengthOf(r++);
        }
        const auto cells = static_cast<double>(network.rows[r].cells);
        places.push_back({r, std::clamp((at - passed) / network.rows[r].speed, 0.0, cells)});
    }
    return places;
}

std::vector<double> positionsOf(const Network& network, std::span<const NetworkPlace> places,
                                double length)
{
    const std::vector<double> nodes = placesOf(network, length);
    std::vector<double> x;
    x.reserve(places.size());
    for (const NetworkPlace& place : places) {
        const CellRow& row = network.rows[place.row];
        x.push_back(std::lerp(nodes[row.left], nodes[row.right],
                              place.cells / static_cast<double>(row.cells)));
    }
    return x;
}

void look(NetworkLook& seen, const Network& network, const NetworkStart& now,
          std::span<const NetworkPlace> places)
{
    std::size_t r = network.rows.size();
    std::vector<double> at;
    for (const NetworkPlace& place : places) {
        const CellRow& row = network.rows[place.row];
        const auto size = static_cast<std::size_t>(row.cells);
        const double* right = now.waves.data() + network.firstWave(place.row);
        const double* left = right + size;
        const auto bent = [&](std::size_t k) {
            return network.stretchAtRest(row, static_cast<std::int64_t>(k));
        };
        if (r != place.row) {
            r = place.row;
            at.assign(1, now.displacements[row.left] + network.nodes[row.left].rest);
            for (std::size_t k = 0; k < size; ++k) {
                at.push_back(at.back() + left[k] - right[k] + bent(k));
            }
        }
        const auto cell = std::min(static_cast<std::size_t>(place.cells), size - 1);
        seen.displacements.push_back(
            std::lerp(at[cell], at[cell + 1], place.cells - static_cast<double>(cell)));
        const auto of = static_cast<std::size_t>(std::max(0.0, std::ceil(place.cells) - 1.0));
        seen.velocities.push_back(left[of] + right[of]);
        seen.strains.push_back((left[of] - right[of] + bent(of)) / row.speed);
    }
}

NetworkSimulation throughPeriod(const Network& network, const NetworkStart& start,
                                const NetworkDrive& drive, double period, std::int64_t instants,
                                const std::function<void(const NetworkSimulation&)>& see)
{
    NetworkSimulation simulation(network, start, drive, {.recordsPaths = true});
    see(simulation);
    for (std::int64_t k = 1; k <= instants; ++k) {
        const double until = period * static_cast<double>(k) / static_cast<double>(instants);
        simulation.advance(until - simulation.time());
        see(simulation);
    }
    const std::vector<double> waves = simulation.state().waves;
    double largest = 0.0;
    double change = 0.0;
    for (std::size_t k = 0; k < waves.size(); ++k) {
        largest = std::max(largest, std::abs(start.waves[k]));
        change = std::max(change, std::abs(waves[k] - start.waves[k]));
    }
    if (change > 1e-6 * largest) {
        throw std::runtime_error(fmt::format(
            "simulated for its period the motion comes back to within {:.2g} of its largest wave "
            "only, so it is neither drawn nor written",
            change / largest));
    }
    return simulation;
}

}  // namespace signorini
