#include <algorithm>
#include <cmath>

#include "faults.hpp"
#include "harmonic_network.hpp"
#include "network_simulation.hpp"
#include "statics.hpp"

namespace signorini {

NetworkStart startAtRest(const Network& network, double base)
{
    const StillNetwork still = underMovedBase(network, base);
    const Rest rest = restOf(still.network);
    NetworkStart start{rest.waves, rest.displacements};
    still.addShape(start);
    return start;
}

NetworkStart startWithSpeeds(const Network& network, std::span<const double> speeds)
{
    Faults faults;
    if (speeds.size() != network.bars.size()) {
        faults.add("velocity", speeds.size(),
                   fmt::format("{}, one for each bar", network.bars.size()));
    }
    for (const double speed : speeds) {
        if (!std::isfinite(speed)) {
            faults.add("velocity", speed, "finite");
        }
    }
    faults.throwIfAny();
    NetworkStart start;
    start.waves.reserve(network.waves());
    for (const CellRow& row : network.rows) {
        const double half = 0.5 * speeds[network.nodes[row.left].bar];
        // Displacements are counted from the shape at rest: it is taken away.
        const auto strain = [&](std::int64_t k) { return -0.5 * network.stretchAtRest(row, k); };
        for (std::int64_t k = 0; k < row.cells; ++k) {
            start.waves.push_back(half - strain(k));
        }
        for (std::int64_t k = 0; k < row.cells; ++k) {
            start.waves.push_back(half + strain(k));
        }
    }
    for (const Stub& stub : network.stubs) {
        start.waves.push_back(stub.kind == StubKind::mass
                                  ? 0.5 * speeds[network.nodes[stub.node].bar]
                                  : network.nodes[stub.node].rest);
    }
    for (const NetworkNode& node : network.nodes) {
        start.displacements.push_back(-node.rest);
    }
    return start;
}

std::vector<double> displacementsOf(const Network& network, std::span<const double> waves,
                                    std::span<const double> drifts)
{
    std::vector<double> stretched;  // l - r over each row
    for (std::size_t k = 0; k < network.rows.size(); ++k) {
        const auto size = static_cast<std::size_t>(network.rows[k].cells);
        const std::size_t first = network.firstWave(k);
        double sum = 0.0;
        for (std::size_t cell = 0; cell < size; ++cell) {
            sum += waves[first + size + cell] - waves[first + cell];
        }
        stretched.push_back(sum);
    }
    std::vector<double> displacements;
    std::size_t drift = 0;
    for (std::size_t node = 0; node < network.nodes.size(); ++node) {
        const NetworkBar& bar = network.bars[network.nodes[node].bar];
        const DisplacementForm form = displacementOf(network, node);
        double sum = 0.0;
        if (form.hasDrift) {
            sum = drift < drifts.size() ? drifts[drift] : 0.0;
            drift += node == bar.lastNode ? 1 : 0;
        } else if (form.spring) {
            sum = -waves[network.firstWave(network.rows.size()) + *form.spring];
        }
        for (const auto& [row, sign] : form.rows) {
            sum += sign * stretched[row];
        }
        displacements.push_back(sum);
    }
    return displacements;
}

double NetworkSimulation::energy() const
{
    CompensatedSum sum;
    for (const Channel& channel : channels_) {
        channel.forEachPiece(now_, [&](double duration, double value) {
            sum.add(channel.impedance * duration * value * value);
        });
    }
    return sum.value();
}

double NetworkSimulation::momentum() const
{
    CompensatedSum sum;
    for (const Channel& channel : channels_) {
        if (channel.sign > 0.0) {  // not of springs
            channel.forEachPiece(now_, [&](double duration, double value) {
                sum.add(channel.impedance * duration * value);
            });
        }
    }
    return sum.value();
}

std::size_t NetworkSimulation::fronts() const
{
    std::size_t sum = 0;
    for (const Channel& channel : channels_) {
        sum += channel.count();
    }
    return sum;
}

NetworkBalance NetworkSimulation::balance() const
{
    NetworkBalance balance;
    balance.work = work_.value();
    balance.dissipated = dissipated_.value();
    for (const Node& node : nodes_) {
        balance.work += node.power * (now_ - node.since);
        balance.dissipated += node.loss * (now_ - node.since);
    }
    const double energyNow = energy();
    balance.error = energyNow - startEnergy_ - balance.work + balance.dissipated;
    balance.size = std::max({energyNow, startEnergy_, std::abs(balance.work), balance.dissipated});
    return balance;
}

MomentumBalance NetworkSimulation::momentumBalance() const
{
    MomentumBalance balance;
    balance.given = given_.value();
    for (const Node& node : nodes_) {
        balance.given += node.external * (now_ - node.since);
    }
    for (std::size_t j = 0; j < touches_.size(); ++j) {
        const double impulse = touches_[j].push * (now_ - touches_[j].since);
        const ContactKind kind = network_.contacts[j].kind;
        balance.given += kind == ContactKind::stopRight  ? -impulse
                         : kind == ContactKind::stopLeft ? impulse
                                                         : 0.0;
    }
    const double momentumNow = momentum();
    balance.error = momentumNow - startMomentum_ - balance.given;
    double impulses = 0.0;
    for (const NetworkContactEvent& event : contacts()) {
        impulses += event.impulse;
    }
    balance.size = std::max(
        {std::abs(momentumNow), std::abs(startMomentum_), std::abs(balance.given), impulses});
    return balance;
}

std::vector<NetworkContactEvent> NetworkSimulation::contacts() const
{
    std::vector<NetworkContactEvent> all = done_;
    for (const Touch& touch : touches_) {
        if (!touch.lasts) {
            continue;
        }
        all.push_back(touch.event);
        if (const double lasted = now_ - touch.since; lasted > 0.0 && touch.push > 0.0) {
            all.back().impulse += touch.push * lasted;
            all.back().peakForce = std::max(all.back().peakForce, touch.push);
            all.back().end = time();
        }
    }
    return all;
}

}  // namespace signorini
