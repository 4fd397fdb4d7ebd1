#include "harmonic_network.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "channel_waves.hpp"
#include "faults.hpp"
#include "harmonic_motion.hpp"
#include "network_sweep.hpp"
#include "statics.hpp"

namespace signorini {

double SteadyHarmonic::largest() const
{
    return std::abs(steady) + lengthOf(swing);
}

double HarmonicNetwork::omega() const
{
    return 2.0 * std::numbers::pi * static_cast<double>(cycles) / static_cast<double>(steps);
}

std::complex<double> HarmonicNetwork::turn(std::int64_t m) const
{
    return turnOf((cycles % steps) * (m % steps), steps);
}

std::complex<double> HarmonicNetwork::weight(double from, double to) const
{
    return (turned(omega() * to) - turned(omega() * from)) / std::complex<double>(0.0, omega());
}

HarmonicNetwork::Drive HarmonicNetwork::drive(std::complex<double> excitation) const
{
    if (place == Excited::tip) {
        return {.force = excitation};
    }
    return {.base = std::complex<double>(0.0, omega()) * excitation};
}

double NetworkHarmonicMotion::contactTime() const
{
    double time = 0.0;
    for (const NetworkHarmonicContact& one : contacts) {
        time += one.end - one.begin;
    }
    return time;
}

void requireAsked(const HarmonicNetwork& given, std::int64_t mostSteps)
{
    Faults faults;
    faults.requireWhole("steps", given.steps, mostSteps);
    faults.requireWhole("cycles", given.cycles, std::max<std::int64_t>(1, given.steps / 2));
    faults.requirePositive("amplitude", given.amplitude, "-");
    requireExcitable(faults, given.network, given.place);
    faults.throwIfAny();
}

void StillNetwork::addShape(NetworkStart& moved) const
{
    const std::vector<double> stretched = stretchedWaves(network, displacements);
    std::size_t wave = 0;
    for (std::size_t channel = 0; channel < stretched.size(); ++channel) {
        for (std::int64_t k = 0; k < lengthOf(network, channel); ++k) {
            moved.waves[wave++] += stretched[channel];
        }
    }
    for (std::size_t node = 0; node < displacements.size(); ++node) {
        moved.displacements[node] += displacements[node];
    }
}

namespace {

/// Displaced by forces on nodes, and by a base that stands elsewhere.
StillNetwork displaced(const Network& network, const std::vector<double>& forces, double base)
{
    StillNetwork still{network, {}};
    Network shape = network;
    for (std::size_t bar = 0; bar < network.bars.size(); ++bar) {
        const NetworkBar& one = network.bars[bar];
        const auto first = forces.begin() + static_cast<std::ptrdiff_t>(one.firstNode);
        const auto last = forces.begin() + static_cast<std::ptrdiff_t>(one.lastNode) + 1;
        if (!one.drifts() && std::any_of(first, last, [](double force) { return force != 0.0; })) {
            addShapeUnder(shape, bar, forces, std::nullopt);
        }
    }
    for (std::size_t node = 0; node < network.nodes.size(); ++node) {
        still.displacements.push_back(network.nodes[node].isShaken
                                          ? base
                                          : shape.nodes[node].rest - network.nodes[node].rest);
    }
    constexpr double rounding = 1e-14;
    for (NetworkContact& contact : still.network.contacts) {
        const double opened =
            openingOf(contact, [&](std::size_t node) { return still.displacements[node]; });
        const double size = std::abs(contact.gap) + std::abs(opened);
        contact.gap += opened;
        contact.gap = std::abs(contact.gap) <= rounding * size ? 0.0 : contact.gap;
    }
    return still;
}

}  // namespace

StillNetwork underConstantForces(const Network& network)
{
    std::vector<double> forces;
    for (const NetworkNode& node : network.nodes) {
        forces.push_back(node.force);
    }
    StillNetwork still = displaced(network, forces, 0.0);
    for (NetworkNode& node : still.network.nodes) {
        node.force = network.bars[node.bar].drifts() ? node.force : 0.0;
    }
    return still;
}

StillNetwork underMovedBase(const Network& network, double base)
{
    std::vector<double> forces(network.nodes.size(), 0.0);
    for (const CellRow& row : network.rows) {
        const double force = base * row.impedance / static_cast<double>(row.cells);
        forces[row.right] += network.nodes[row.left].isShaken ? force : 0.0;
        forces[row.left] += network.nodes[row.right].isShaken ? force : 0.0;
    }
    return displaced(network, forces, base);
}

}  // namespace signorini
