#include "contact_spans.hpp"

#include <algorithm>

namespace signorini {

namespace {

double addDisplacement(std::span<double> derivatives, const Network& network, std::size_t node,
                       double factor)
{
    const DisplacementForm form = displacementOf(network, node);
    for (const auto& stretch : form.rows) {
        const auto cells = static_cast<std::size_t>(network.rows[stretch.row].cells);
        const std::size_t first = network.firstWave(stretch.row);
        for (std::size_t k = first; k < first + cells; ++k) {
            derivatives[k] -= stretch.sign * factor;
            derivatives[k + cells] += stretch.sign * factor;
        }
    }
    if (form.spring) {
        derivatives[network.firstWave(network.rows.size()) + *form.spring] -= factor;
    }
    return form.clamp && network.nodes[*form.clamp].isShaken ? factor : 0.0;
}

}  // namespace

StepDrive driveOf(const Excitation& excitation)
{
    StepDrive drive;
    for (std::int64_t m = 0; m < excitation.steps(); ++m) {
        drive.forces.push_back(excitation.force(m));
        drive.velocities.push_back(excitation.baseVelocity(m));
        drive.places.push_back(excitation.baseDisplacement(m) * excitation.stepsPerCrossing);
    }
    return drive;
}

std::vector<double> wavesOf(const Network& network, const State& state)
{
    std::vector<double> waves;
    waves.reserve(network.waves());
    const double* a = state.a.data();
    const double* b = state.b.data();
    for (const CellRow& row : network.rows) {
        waves.insert(waves.end(), a, a + row.cells);
        waves.insert(waves.end(), b, b + row.cells);
        a += row.cells;
        b += row.cells;
    }
    return waves;
}

State stateOf(const Network& network, std::span<const double> waves)
{
    State state{Eigen::VectorXd(network.cells()), Eigen::VectorXd(network.cells())};
    Eigen::Index first = 0;
    const double* next = waves.data();
    for (const CellRow& row : network.rows) {
        state.a.segment(first, row.cells) = Eigen::Map<const Eigen::VectorXd>(next, row.cells);
        next += row.cells;
        state.b.segment(first, row.cells) = Eigen::Map<const Eigen::VectorXd>(next, row.cells);
        next += row.cells;
        first += row.cells;
    }
    return state;
}

double addDistance(std::span<double> derivatives, const Network& network, std::size_t contact,
                   double factor)
{
    const NetworkContact& at = network.contacts[contact];
    double byBase = addDisplacement(derivatives, network, at.node,
                                    at.kind == ContactKind::stopLeft ? factor : -factor);
    if (at.kind == ContactKind::gap) {
        byBase += addDisplacement(derivatives, network, at.node + 1, factor);
    }
    return byBase;
}

Network withoutForces(Network network)
{
    for (NetworkNode& node : network.nodes) {
        node.force = 0.0;
    }
    return network;
}

std::vector<std::size_t> driftingBars(const Network& network)
{
    std::vector<std::size_t> bars;
    for (std::size_t bar = 0; bar < network.bars.size(); ++bar) {
        if (network.bars[bar].drifts()) {
            bars.push_back(bar);
        }
    }
    return bars;
}

std::vector<std::pair<std::size_t, int>> driftsOf(const Network& network, std::size_t contact)
{
    const std::vector<std::size_t> bars = driftingBars(network);
    std::vector<std::pair<std::size_t, int>> drifts;
    const auto add = [&](std::size_t node, int sign) {
        const auto found = std::find(bars.begin(), bars.end(), network.nodes[node].bar);
        if (found != bars.end()) {
            drifts.emplace_back(found - bars.begin(), sign);
        }
    };
    const NetworkContact& at = network.contacts[contact];
    add(at.node, at.kind == ContactKind::stopLeft ? 1 : -1);
    if (at.kind == ContactKind::gap) {
        add(at.node + 1, 1);
    }
    return drifts;
}

std::vector<std::vector<double>> tiesOf(const Network& network)
{
    std::vector<std::vector<double>> ties;
    for (std::size_t node = 0; node < network.nodes.size(); ++node) {
        if (network.nodes[node].isClamped && displacementOf(network, node).clamp != node) {
            ties.emplace_back(network.waves(), 0.0);
            addDisplacement(ties.back(), network, node, 1.0);
        }
    }
    for (std::size_t k = 0; k < network.stubs.size(); ++k) {
        const std::size_t node = network.stubs[k].node;
        if (network.stubs[k].kind == StubKind::spring &&
            displacementOf(network, node).spring != k) {
            ties.emplace_back(network.waves(), 0.0);
            addDisplacement(ties.back(), network, node, 1.0);
            ties.back()[network.firstWave(network.rows.size()) + k] += 1.0;
        }
    }
    return ties;
}

std::vector<double> impedancesOf(const Network& network)
{
    std::vector<double> impedances;
    impedances.reserve(network.waves());
    for (const CellRow& row : network.rows) {
        impedances.insert(impedances.end(), 2 * static_cast<std::size_t>(row.cells), row.impedance);
    }
    for (const Stub& stub : network.stubs) {
        impedances.push_back(stub.impedance);
    }
    return impedances;
}

}  // namespace signorini
