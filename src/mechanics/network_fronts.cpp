// The fronts under way in a network: how they are kept, and which of them are one.

#include <cmath>

#include "network_simulation.hpp"

namespace signorini {

void NetworkSimulation::Channel::widen()
{
    std::vector<Front> wider(2 * ring.size());
    for (std::size_t k = 0; k < ring.size(); ++k) {
        wider[k] = ring[(begin + k) & mask];
    }
    end -= begin;
    begin = 0;
    ring = std::move(wider);
    mask = ring.size() - 1;
}

/// A front that leaves right behind another one, as fronts do that should have met and were rounded
/// apart, becomes one with it, where what came between them carries as much as before: else short
/// pieces would make more of them at every node, for ever.
/// \return whether it did
bool NetworkSimulation::joins(Channel& channel, const Front& next)
{
    const bool isOnly = channel.count() == 1;
    Front& last = channel.last(1);
    const double begin = isOnly ? channel.now : channel.last(2).value;
    const double apart = next.time - last.time;
    const double whole = next.value - begin;
    const double part = next.value - last.value;
    // The instant of one front that carries as much: between the two, or not far from them.
    const double moved = part * apart / whole;
    const double earliest = isOnly ? now_ : channel.last(2).time;
    if (std::abs(part) <= 4.0 * std::abs(whole) && last.time + moved > earliest) {
        last = {last.time + moved, next.value};
    } else if (!isOnly) {
        // Hardly a front is left: what was between goes to the piece before.
        channel.last(2).value += (last.value - begin) * apart / (next.time - earliest);
        last = next;
    } else if (apart <= same_) {
        last = next;
        channel.end -= whole == 0.0 ? 1 : 0;
    } else {
        return false;
    }
    merged_ += std::abs(part) * std::abs(apart);
    return true;
}

/// Times are counted from a later instant, by whole steps, so that they keep their digits: what
/// they are rounded by stays far below `same_`, so that fronts that meet do so for ever.
void NetworkSimulation::rebase()
{
    if (now_ < longestBase * static_cast<double>(network_.cells())) {
        return;
    }
    const double shift = std::floor(now_);
    base_ += shift;
    now_ -= shift;
    for (Channel& channel : channels_) {
        for (Front& front : channel.ring) {
            front.time -= shift;
        }
    }
    for (Node& node : nodes_) {
        node.since -= shift;
    }
    for (Touch& touch : touches_) {
        touch.since -= shift;
    }
    for (double& due : due_) {
        due -= shift;
    }
}

}  // namespace signorini
