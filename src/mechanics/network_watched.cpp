#include "network_watched.hpp"

#include <algorithm>
#include <cmath>

#include "channel_waves.hpp"
#include "infinity.hpp"
#include "statics.hpp"

namespace signorini {

std::int64_t WatchedNetwork::pieces() const
{
    return static_cast<std::int64_t>(simulation_.fronts() + simulation_.network().channels());
}

std::vector<Piece> WatchedNetwork::joined(const NetworkStart& state) const
{
    std::vector<Piece> all;
    for (const std::vector<Piece>& channel : piecesOf(simulation_.network(), state)) {
        all.insert(all.end(), channel.begin(), channel.end());
    }
    for (const NetworkBar& bar : simulation_.network().bars) {
        if (bar.drifts()) {
            all.push_back({1.0, state.displacements[bar.firstNode]});
        }
    }
    return all;
}

std::vector<Piece> WatchedNetwork::state() const
{
    return joined(simulation_.state());
}

std::vector<Piece> WatchedNetwork::rest() const
{
    const Network& network = simulation_.network();
    if (std::any_of(network.bars.begin(), network.bars.end(),
                    [](const NetworkBar& bar) { return bar.drifts(); })) {
        // Forces may move it for ever: what does not move at 0 is as good.
        return joined({std::vector<double>(network.waves(), 0.0),
                       std::vector<double>(network.nodes.size(), 0.0)});
    }
    return joined(startAtRest(network));
}

std::vector<Piece> WatchedNetwork::weights() const
{
    const Network& network = simulation_.network();
    std::vector<Piece> weights;
    for (std::size_t k = 0; k < network.channels(); ++k) {
        const auto delay = static_cast<double>(lengthOf(network, k));
        weights.push_back({delay, network.impedanceOf(k)});
    }
    for (const NetworkBar& bar : network.bars) {
        if (bar.drifts()) {
            weights.push_back({1.0, 1.0 / static_cast<double>(network.cells())});
        }
    }
    return weights;
}

double WatchedNetwork::clearance(double duration) const
{
    const Network& network = simulation_.network();
    NetworkSimulation next(network, simulation_.state(), drive_);
    next.advance(duration);
    double room = infinity;
    for (std::size_t j = 0; j < network.contacts.size(); ++j) {
        const double compliance = complianceOf(network, network.contacts[j]);
        room = std::min(room, next.nearest(j) / std::sqrt(2.0 * compliance));
    }
    return room;
}

}  // namespace signorini
