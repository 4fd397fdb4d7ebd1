#pragma once
/// \file
/// The law (N) for any kind of number; included by network.hpp.

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "network.hpp"

namespace signorini {

template <typename Number>
NetworkLaw<Number>::NetworkLaw(const Network& network, ContactSet closed)
    : closed_(closed), clusterOf_(network.nodes.size()), pushes_(network.contacts.size())
{
    for (const Cluster& cluster : clustersOf(network, closed)) {
        for (std::size_t node = cluster.firstNode; node <= cluster.lastNode; ++node) {
            clusterOf_[node] = clusters_.size();
        }
        clusters_.push_back(scattererFor(network, cluster));
        findPushes(network, cluster);
    }
}

template <typename Number>
auto NetworkLaw<Number>::scattererFor(const Network& network, const Cluster& cluster) const
    -> Scatterer
{
    Scatterer made{.nodes = cluster, .branches = {}, .velocity = {}};
    const auto isOfCluster = [&](std::size_t channel) {
        const std::size_t node = network.nodeOf(channel);
        return node >= cluster.firstNode && node <= cluster.lastNode;
    };
    Number all(0);  // sum of Z_k + D
    for (std::size_t channel = 0; channel < network.channels(); ++channel) {
        if (isOfCluster(channel)) {
            all = all + asNumber<Number>(network.impedanceOf(channel));
        }
    }
    for (std::size_t node = cluster.firstNode; node <= cluster.lastNode; ++node) {
        all = all + asNumber<Number>(network.nodes[node].dashpot);
    }
    for (std::size_t channel = 0; channel < network.channels(); ++channel) {
        if (!isOfCluster(channel)) {
            continue;
        }
        const Number twice = Number(2) * asNumber<Number>(network.impedanceOf(channel));
        const Number weight = cluster.held ? Number(0) : twice / all;
        made.branches.push_back({channel, network.entered(channel), Number(network.sign(channel)),
                                 weight, cluster.held ? Number(-1) : (twice - all) / all});
        if (!cluster.held) {
            made.velocity.terms.push_back({channel, weight});
        }
    }
    if (cluster.held) {
        made.velocity.perBase = Number(network.nodes[*cluster.held].isShaken ? 1 : 0);
        return made;
    }
    for (std::size_t node = cluster.firstNode; node <= cluster.lastNode; ++node) {
        made.velocity.constant =
            made.velocity.constant + asNumber<Number>(network.nodes[node].force) / all;
        if (network.nodes[node].isDriven) {
            made.velocity.perForce = made.velocity.perForce + Number(1) / all;
        }
    }
    return made;
}

/// f - (sum of Z + D) v, what neighbours have to balance: 2 sum Z w + f, if nothing moves.
template <typename Number>
LinearForm<Number> NetworkLaw<Number>::forceOn(const Network& network, std::size_t node) const
{
    LinearForm<Number> form;
    auto all = asNumber<Number>(network.nodes[node].dashpot);
    for (std::size_t channel = 0; channel < network.channels(); ++channel) {
        if (network.nodeOf(channel) == node) {
            const auto impedance = asNumber<Number>(network.impedanceOf(channel));
            all = all + impedance;
            form.terms.push_back({channel, Number(2) * impedance});
        }
    }
    form.constant = asNumber<Number>(network.nodes[node].force);
    form.perForce = Number(network.nodes[node].isDriven ? 1 : 0);
    form.add(velocity(node), Number(0) - all);
    return form;
}

/// The push at a gap is what the nodes to its left, up to one that is held, pass on to the right,
/// or, beyond that one, what those to its right do not balance. A stop takes what is left.
template <typename Number>
void NetworkLaw<Number>::findPushes(const Network& network, const Cluster& cluster)
{
    const auto contactAt = [&](std::size_t node, bool isGap) {
        for (std::size_t j = 0; j < network.contacts.size(); ++j) {
            const NetworkContact& contact = network.contacts[j];
            if (contains(closed_, j) && contact.node == node &&
                (contact.kind == ContactKind::gap) == isGap) {
                return std::optional<std::size_t>(j);
            }
        }
        return std::optional<std::size_t>();
    };
    const std::size_t turn = cluster.held.value_or(cluster.lastNode);
    LinearForm<Number> fromLeft;
    for (std::size_t node = cluster.firstNode; node < turn; ++node) {
        fromLeft.add(forceOn(network, node), Number(1));
        pushes_[*contactAt(node, true)] = fromLeft;
    }
    LinearForm<Number> fromRight;  // to the left
    for (std::size_t node = cluster.lastNode; node > turn; --node) {
        fromRight.add(forceOn(network, node), Number(-1));
        pushes_[*contactAt(node - 1, true)] = fromRight;
    }
    if (const auto stop = contactAt(turn, false)) {
        LinearForm<Number> rest = forceOn(network, turn);
        rest.add(fromLeft, Number(1));
        rest.add(fromRight, Number(-1));
        const bool pushesLeft = network.contacts[*stop].kind == ContactKind::stopRight;
        pushes_[*stop].add(rest, Number(pushesLeft ? 1 : -1));
    }
}

template <typename Number>
void NetworkLaw<Number>::scatter(std::span<const Number> arriving, std::span<Number> entering,
                                 const Number& force, const Number& base) const
{
    for (const Scatterer& cluster : clusters_) {
        const std::vector<Branch>& branches = cluster.branches;
        const LinearForm<Number>& velocity = cluster.velocity;
        const Number pulled =
            velocity.constant + velocity.perForce * force + velocity.perBase * base;
        if (branches.size() == 1) {
            const Branch& only = branches.front();
            entering[only.entered] = only.sign * (only.own * arriving[only.channel] + pulled);
        } else if (branches.size() == 2) {  // nothing is rounded where a wave only passes through
            const Branch& one = branches.front();
            const Branch& other = branches.back();
            const Number& left = arriving[one.channel];
            const Number& right = arriving[other.channel];
            entering[one.entered] = one.sign * (one.own * left + other.weight * right + pulled);
            entering[other.entered] = other.sign * (one.weight * left + other.own * right + pulled);
        } else {
            Number v = pulled;
            for (const Branch& branch : branches) {
                v = v + branch.weight * arriving[branch.channel];
            }
            for (const Branch& branch : branches) {
                entering[branch.entered] = branch.sign * (v - arriving[branch.channel]);
            }
        }
    }
}

template <typename Number>
DrivenDerivatives<Number> NetworkLaw<Number>::scatterBack(std::span<const Number> byEntering,
                                                          std::span<Number> byArriving) const
{
    DrivenDerivatives<Number> driven;
    for (const Scatterer& cluster : clusters_) {
        Number sum(0);
        for (const Branch& branch : cluster.branches) {
            sum = sum + branch.sign * byEntering[branch.entered];
        }
        for (const Branch& branch : cluster.branches) {
            byArriving[branch.channel] =
                branch.weight * sum - branch.sign * byEntering[branch.entered];
        }
        driven.force = driven.force + cluster.velocity.perForce * sum;
        driven.base = driven.base + cluster.velocity.perBase * sum;
        driven.constant = driven.constant + cluster.velocity.constant * sum;
    }
    return driven;
}

template <typename Number>
NetworkWaves<Number>::NetworkWaves(const Network& network, std::vector<Number> waves)
    : values_(std::move(waves)),
      now_(network.channels(), Number(0)),
      scratch_(network.channels(), Number(0))
{
    if (values_.size() != network.waves()) {
        throw std::invalid_argument("a state has as many waves as its network");
    }
    std::size_t next = 0;
    for (const CellRow& row : network.rows) {
        const auto size = static_cast<std::size_t>(row.cells);
        rings_.push_back({next, size, 0});
        // Place k is that of the k-th to arrive.
        const auto first = values_.begin() + static_cast<std::ptrdiff_t>(next);
        std::reverse(first, first + static_cast<std::ptrdiff_t>(size));
        const std::size_t channel = 2 * (rings_.size() - 1);
        now_[channel] = values_[next];
        now_[channel + 1] = values_[next + size];
        next += 2 * size;
    }
    for (std::size_t channel = 2 * rings_.size(); channel < now_.size(); ++channel) {
        now_[channel] = values_[next + channel - 2 * rings_.size()];
    }
    values_.resize(next);
}

template <typename Number>
void NetworkWaves<Number>::step(const NetworkLaw<Number>& law, const Number& force,
                                const Number& base)
{
    law.scatter(now_, scratch_, force, base);
    std::swap(now_, scratch_);
    for (std::size_t row = 0; row < rings_.size(); ++row) {
        Ring& ring = rings_[row];
        Number* const right = &values_[ring.first];
        Number* const left = right + ring.size;
        right[ring.head] = now_[2 * row];
        left[ring.head] = now_[2 * row + 1];
        ring.head = ring.head + 1 == ring.size ? 0 : ring.head + 1;
        now_[2 * row] = right[ring.head];
        now_[2 * row + 1] = left[ring.head];
    }
}

template <typename Number>
DrivenDerivatives<Number> NetworkWaves<Number>::stepBack(const NetworkLaw<Number>& law)
{
    for (std::size_t row = 0; row < rings_.size(); ++row) {
        Ring& ring = rings_[row];
        Number* const right = &values_[ring.first];
        Number* const left = right + ring.size;
        ring.head = (ring.head == 0 ? ring.size : ring.head) - 1;
        now_[2 * row] = right[ring.head];
        now_[2 * row + 1] = left[ring.head];
    }
    const DrivenDerivatives<Number> driven = law.scatterBack(now_, scratch_);
    std::swap(now_, scratch_);
    for (std::size_t row = 0; row < rings_.size(); ++row) {
        const Ring& ring = rings_[row];
        values_[ring.first + ring.head] = now_[2 * row];
        values_[ring.first + ring.size + ring.head] = now_[2 * row + 1];
    }
    return driven;
}

template <typename Number>
void NetworkWaves<Number>::add(std::size_t channel, const Number& value)
{
    now_[channel] = now_[channel] + value;
    if (channel < 2 * rings_.size()) {
        const Ring& ring = rings_[channel / 2];
        values_[ring.first + (channel % 2) * ring.size + ring.head] = now_[channel];
    }
}

template <typename Number>
std::vector<Number> NetworkWaves<Number>::waves() const
{
    std::vector<Number> all;
    all.reserve(values_.size() + now_.size() - 2 * rings_.size());
    for (const Ring& ring : rings_) {
        const auto place = [&ring](std::size_t k) { return (ring.head + k) % ring.size; };
        for (std::size_t k = ring.size; k-- > 0;) {
            all.push_back(values_[ring.first + place(k)]);
        }
        for (std::size_t k = 0; k < ring.size; ++k) {
            all.push_back(values_[ring.first + ring.size + place(k)]);
        }
    }
    all.insert(all.end(), now_.begin() + static_cast<std::ptrdiff_t>(2 * rings_.size()),
               now_.end());
    return all;
}

}  // namespace signorini
