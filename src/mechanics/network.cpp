#include "network.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "faults.hpp"
#include "stepped_bar.hpp"

namespace signorini {

std::int64_t Network::cells() const
{
    std::int64_t sum = 0;
    for (const CellRow& row : rows) {
        sum += row.cells;
    }
    return sum;
}

std::size_t Network::waves() const
{
    return firstWave(rows.size()) + stubs.size();
}

std::size_t Network::firstWave(std::size_t row) const
{
    std::size_t sum = 0;
    for (std::size_t k = 0; k < row; ++k) {
        sum += 2 * static_cast<std::size_t>(rows[k].cells);
    }
    return sum;
}

double Network::stretchAtRest(const CellRow& row, std::int64_t k) const
{
    const auto cells = static_cast<double>(row.cells);
    return (nodes[row.right].rest - nodes[row.left].rest) / cells -
           gravity * (static_cast<double>(k) - 0.5 * (cells - 1.0));
}

std::size_t Network::nodeOf(std::size_t channel) const
{
    if (channel >= 2 * rows.size()) {
        return stubs[channel - 2 * rows.size()].node;
    }
    const CellRow& row = rows[channel / 2];
    return channel % 2 == 0 ? row.right : row.left;
}

double Network::impedanceOf(std::size_t channel) const
{
    return channel < 2 * rows.size() ? rows[channel / 2].impedance
                                     : stubs[channel - 2 * rows.size()].impedance;
}

std::size_t Network::entered(std::size_t channel) const
{
    return channel < 2 * rows.size() ? channel ^ 1U : channel;
}

int Network::sign(std::size_t channel) const
{
    return channel >= 2 * rows.size() && stubs[channel - 2 * rows.size()].kind == StubKind::spring
               ? -1
               : 1;
}

namespace {

void checkNumbers(const Network& network, Faults& faults)
{
    if (!(network.strainLimit > 0.0)) {
        faults.add("strainLimit", network.strainLimit, "numbers > 0");
    }
    const std::string positive = fmt::format("{}..{} [-]", 1.0 / mostImpedance, mostImpedance);
    std::int64_t cells = 0;
    for (const CellRow& row : network.rows) {
        faults.requireWhole("cells", row.cells, maxCells);
        faults.throwIfAny();
        cells += row.cells;
        faults.requireWhole("cells of all rows", cells, maxCells);
        faults.throwIfAny();
        if (!isImpedance(row.impedance)) {
            faults.add("impedance", row.impedance, positive);
        }
        if (!isImpedance(row.speed)) {
            faults.add("speed", row.speed, positive);
        }
    }
    for (const Stub& stub : network.stubs) {
        if (!isImpedance(stub.impedance)) {
            faults.add(stub.kind == StubKind::spring ? "impedance K h/2 of a spring"
                                                     : "impedance 2 M/h of a mass",
                       stub.impedance, positive + ", relative to impedance 1");
        }
    }
    for (const NetworkNode& node : network.nodes) {
        if (!(node.dashpot >= 0.0 && node.dashpot <= mostImpedance)) {
            faults.add("dashpot", node.dashpot, fmt::format("0..{} [-]", mostImpedance));
        }
        if (!(std::abs(node.force) <= mostGap)) {
            faults.add("force", node.force, fmt::format("|force| <= {} Z_1 delta/h", mostGap));
        }
    }
    for (const NetworkContact& contact : network.contacts) {
        if (!(std::abs(contact.gap) <= mostGap)) {
            faults.add("gap", contact.gap, fmt::format("|gap| <= {} delta", mostGap));
        }
    }
}

/// Nodes, rows and bars stand in order, and every node has a branch.
bool isOrdered(const Network& network)
{
    const std::size_t nodes = network.nodes.size();
    std::vector<bool> hasBranch(nodes, false);
    std::vector<bool> isJoined(nodes, false);  // to the next one
    for (const CellRow& row : network.rows) {
        if (row.right != row.left + 1 || row.right >= nodes || isJoined[row.left]) {
            return false;
        }
        hasBranch[row.left] = hasBranch[row.right] = isJoined[row.left] = true;
    }
    for (const Stub& stub : network.stubs) {
        if (stub.node >= nodes) {
            return false;
        }
        hasBranch[stub.node] = true;
    }
    std::size_t next = 0;
    for (std::size_t bar = 0; bar < network.bars.size(); ++bar) {
        if (network.bars[bar].firstNode != next || network.bars[bar].lastNode < next ||
            network.bars[bar].lastNode >= nodes) {
            return false;
        }
        for (; next <= network.bars[bar].lastNode; ++next) {
            if (network.nodes[next].bar != bar || !hasBranch[next] ||
                isJoined[next] != (next < network.bars[bar].lastNode)) {
                return false;
            }
        }
    }
    return next == nodes && nodes > 0;
}

bool hasGoodContacts(const Network& network)
{
    for (const NetworkContact& contact : network.contacts) {
        if (contact.node >= network.nodes.size() || network.nodes[contact.node].isClamped) {
            return false;
        }
        const bool isGap = contact.kind == ContactKind::gap;
        const NetworkBar& bar = network.bars[network.nodes[contact.node].bar];
        if (isGap && (contact.node != bar.lastNode || contact.node + 1 >= network.nodes.size() ||
                      network.nodes[contact.node + 1].isClamped)) {
            return false;
        }
        const auto same =
            std::count_if(network.contacts.begin(), network.contacts.end(),
                          [&contact](const NetworkContact& other) {
                              return other.node == contact.node && other.kind == contact.kind;
                          });
        if (same != 1) {
            return false;
        }
    }
    return network.contacts.size() <= maxContacts;
}

}  // namespace

void validate(const Network& network)
{
    Faults faults;
    if (!isOrdered(network)) {
        faults.add("network", network.nodes.size(),
                   "nodes from left to right, each with a row or stub, in bars without holes");
        faults.throwIfAny();
    }
    if (!hasGoodContacts(network)) {
        faults.add(
            "contacts", network.contacts.size(),
            fmt::format("at most {}, one of a kind at a node that is no clamp", maxContacts));
    }
    checkNumbers(network, faults);
    faults.throwIfAny();
}

bool isSimple(double value)
{
    const double size = std::abs(value);
    constexpr double most = 4503599627370496.0;  // 2^52
    return size == 0.0 || (size >= 1.0 / most && size <= most);
}

Fraction exactly(double value)
{
    if (value == 0.0) {
        return {0, 1};
    }
    Fraction fraction = simplestFraction(std::abs(value));
    fraction.numerator = value < 0.0 ? -fraction.numerator : fraction.numerator;
    return fraction;
}

std::vector<Cluster> clustersOf(const Network& network, ContactSet closed)
{
    std::vector<Cluster> clusters;
    std::vector<bool> isJoined(network.nodes.size(), false);  // to the one before
    std::vector<int> holds(network.nodes.size(), 0);
    for (std::size_t j = 0; j < network.contacts.size(); ++j) {
        const NetworkContact& contact = network.contacts[j];
        if (!contains(closed, j)) {
            continue;
        }
        if (contact.kind == ContactKind::gap) {
            isJoined[contact.node + 1] = true;
        } else {
            ++holds[contact.node];
        }
    }
    for (std::size_t node = 0; node < network.nodes.size(); ++node) {
        if (!isJoined[node]) {
            clusters.push_back({node, node, {}});
        }
        Cluster& cluster = clusters.back();
        cluster.lastNode = node;
        const int here = holds[node] + (network.nodes[node].isClamped ? 1 : 0);
        if (here > 1 || (here == 1 && cluster.held)) {
            throwFault("closed contacts", fmt::format("{:#x}", closed),
                       "gaps that adjoin with one stop at most: how two share a push does not "
                       "follow from the waves");
        }
        if (here == 1) {
            cluster.held = node;
        }
    }
    return clusters;
}

DisplacementForm displacementOf(const Network& network, std::size_t node)
{
    const NetworkBar& bar = network.bars[network.nodes[node].bar];
    DisplacementForm form;
    std::size_t reference = bar.firstNode;
    if (bar.clamps > 0) {
        while (!network.nodes[reference].isClamped) {
            ++reference;
        }
        form.clamp = reference;
    } else if (bar.springs > 0) {
        std::size_t stub = 0;
        while (network.stubs[stub].kind != StubKind::spring ||
               network.nodes[network.stubs[stub].node].bar != network.nodes[node].bar) {
            ++stub;
        }
        form.spring = stub;
        reference = network.stubs[stub].node;
    } else {
        form.hasDrift = true;
    }
    for (std::size_t row = 0; row < network.rows.size(); ++row) {
        const CellRow& cells = network.rows[row];
        if (cells.left >= reference && cells.right <= node) {
            form.rows.push_back({row, 1});
        } else if (cells.left >= node && cells.right <= reference) {
            form.rows.push_back({row, -1});
        }
    }
    return form;
}

}  // namespace signorini
