#pragma once
/// \file
/// Networks drawn at random: bars of rows, with all that may stand at their nodes.

#include <cstdint>
#include <random>
#include <vector>

#include "network.hpp"

namespace signorini::test {

struct NetworkDraw {
    std::int64_t mostCells = 4;  ///< of a row
    int mostBars = 4;
    bool hasDashpots = false;
    bool hasForces = false;
};

class NetworkGenerator {
public:
    explicit NetworkGenerator(std::uint32_t seed) : generator_(seed) {}

    [[nodiscard]] std::int64_t whole(std::int64_t least, std::int64_t most)
    {
        return std::uniform_int_distribution<std::int64_t>(least, most)(generator_);
    }
    /// A simple fraction.
    [[nodiscard]] double fraction()
    {
        return static_cast<double>(whole(1, 12)) / static_cast<double>(whole(1, 12));
    }
    [[nodiscard]] bool isOneOf(int many) { return whole(1, many) == 1; }

    [[nodiscard]] Network network(const NetworkDraw& draw)
    {
        Network drawn;
        const auto bars = whole(1, draw.mostBars);
        for (std::int64_t bar = 0; bar < bars; ++bar) {
            addBar(drawn, draw, bar == 0, bar + 1 == bars);
        }
        for (std::size_t bar = 0; bar + 1 < drawn.bars.size(); ++bar) {
            drawn.contacts.push_back({ContactKind::gap, drawn.bars[bar].lastNode, fraction()});
        }
        for (std::size_t node = 0; node < drawn.nodes.size(); ++node) {
            addStops(drawn, node);
        }
        if (drawn.contacts.empty()) {
            for (std::size_t node = 0; node < drawn.nodes.size(); ++node) {
                if (!drawn.nodes[node].isClamped) {
                    drawn.contacts.push_back({ContactKind::stopRight, node, 1.0});
                    break;
                }
            }
        }
        return drawn;
    }

    /// A set of closed contacts that has a law.
    [[nodiscard]] ContactSet closedSet(const Network& network)
    {
        while (true) {
            const auto most = (std::int64_t{1} << network.contacts.size()) - 1;
            const auto set = static_cast<ContactSet>(whole(0, most));
            try {
                (void)clustersOf(network, set);
                return set;
            } catch (const std::invalid_argument&) {
                continue;
            }
        }
    }

private:
    void addBar(Network& drawn, const NetworkDraw& draw, bool isFirst, bool isLast)
    {
        NetworkBar bar{.firstNode = drawn.nodes.size()};
        const auto rows = whole(1, 3);
        for (std::int64_t k = 0; k <= rows; ++k) {
            const std::size_t node = drawn.nodes.size();
            NetworkNode made{.bar = drawn.bars.size()};
            const bool isOuter = (k == 0 && isFirst) || (k == rows && isLast);
            made.isClamped = isOuter && isOneOf(2);
            made.isShaken = made.isClamped && isOneOf(2);
            bar.clamps += made.isClamped ? 1 : 0;
            if (!made.isClamped) {
                addStubs(drawn, bar, node);
                made.dashpot = draw.hasDashpots && isOneOf(3) ? fraction() : 0.0;
                made.force = draw.hasForces && isOneOf(3) ? fraction() : 0.0;
                made.isDriven = draw.hasForces && isOneOf(3);
            }
            if (k > 0) {
                drawn.rows.push_back(
                    {whole(1, draw.mostCells), fraction(), fraction(), node - 1, node});
            }
            drawn.nodes.push_back(made);
        }
        bar.lastNode = drawn.nodes.size() - 1;
        drawn.bars.push_back(bar);
    }

    void addStubs(Network& drawn, NetworkBar& bar, std::size_t node)
    {
        if (isOneOf(5)) {
            drawn.stubs.push_back({StubKind::spring, fraction(), node});
            ++bar.springs;
        }
        if (isOneOf(5)) {
            drawn.stubs.push_back({StubKind::mass, fraction(), node});
            ++bar.masses;
        }
    }

    void addStops(Network& drawn, std::size_t node)
    {
        if (!drawn.nodes[node].isClamped && isOneOf(3)) {
            drawn.contacts.push_back({ContactKind::stopRight, node, fraction()});
        }
        if (!drawn.nodes[node].isClamped && isOneOf(4)) {
            drawn.contacts.push_back({ContactKind::stopLeft, node, fraction()});
        }
    }

    std::mt19937_64 generator_;
};

}  // namespace signorini::test
