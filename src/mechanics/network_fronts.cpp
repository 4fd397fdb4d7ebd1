// The fronts under way in a network: how they are kept, and which of them are one.

#include <cmath>

#include "network_simulation.hpp"

namespace signorini {

void NetworkSimulation::Channel::push(const Front& front)
{
    if (count == ring.size()) {
        std::vector<Front> wider(2 * ring.size());
        for (std::size_t k = 0; k < count; ++k) {
            wider[k] = at(k);
        }
        ring = std::move(wider);
        head = 0;
    }
    ++count;
    at(count - 1) = front;
}

void NetworkSimulation::Channel::pop()
{
    now = at(0).value;
    head = (head + 1) & (ring.size() - 1);
    --count;
}

/// A front that leaves right behind another one, as fronts do that should have met and were rounded
/// apart, becomes one with it, where what came between them carries as much as before: else short
/// pieces would make more of them at every node, for ever.
/// \return whether it did
bool NetworkSimulation::joins(Channel& channel, const Front& next)
{
    Front& last = channel.at(channel.count - 1);
    const double begin = channel.count > 1 ? channel.at(channel.count - 2).value : channel.now;
    const double apart = next.time - last.time;
    const double whole = next.value - begin;
    const double part = next.value - last.value;
    // The instant of one front that carries as much: between the two, or not far from them.
    const double moved = part * apart / whole;
    const double earliest = channel.count > 1 ? channel.at(channel.count - 2).time : now_;
    if (std::abs(part) <= 4.0 * std::abs(whole) && last.time + moved > earliest) {
        last = {last.time + moved, next.value};
    } else if (channel.count > 1) {
        // Hardly a front is left: what was between goes to the piece before.
        channel.at(channel.count - 2).value +=
            (last.value - begin) * apart / (next.time - earliest);
        last = next;
    } else if (apart <= same_) {
        last = next;
        channel.count -= whole == 0.0 ? 1 : 0;
    } else {
        return false;
    }
    merged_ += std::abs(part) * std::abs(apart);
    return true;
}

void NetworkSimulation::send(std::size_t number, double value)
{
    Channel& channel = channels_[number];
    const Front next{now_ + channel.delay, value};
    if (value != channel.last() &&
        !(channel.count > 0 && next.time - channel.at(channel.count - 1).time <= together_ &&
          joins(channel, next))) {
        if (channel.count >= 2) {
            Front& before = channel.at(channel.count - 2);
            const Front& last = channel.at(channel.count - 1);
            const double jump = std::abs(last.value - before.value);
            if (jump <= options_.mergeBelow) {
                const double duration = next.time - last.time;
                const double earlier = last.time - before.time;
                before.value =
                    (before.value * earlier + last.value * duration) / (earlier + duration);
                merged_ += jump * duration;
                --channel.count;
            }
        }
        channel.push(next);
    }
    due_[number] = channel.due();
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
        for (std::size_t k = 0; k < channel.count; ++k) {
            channel.at(k).time -= shift;
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
