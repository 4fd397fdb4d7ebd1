#pragma once
/// \file
/// A network that does not move: rows of n cells are springs of stiffness Z/n, spring stubs of
/// stiffness 2 Z (network.hpp, units).

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "network.hpp"

namespace signorini {

/// What a uniform acceleration pulls each node with; a row hands half of its weight to each end.
[[nodiscard]] std::vector<double> weightsOf(const Network& network, double gravity);

/// Of the whole bar.
[[nodiscard]] double weightOf(const Network& network, std::size_t bar,
                              std::span<const double> weights);

/// Adds the static displacement of a bar under forces on its nodes to their `rest`. `support`: a
/// node that is held, too; needed where the bar drifts. O(nodes).
void addShapeUnder(Network& network, std::size_t bar, std::span<const double> forces,
                   std::optional<std::size_t> support);

/// By how much a force of 1 at a contact opens it, all contacts being open; infinite where a bar
/// drifts. O(nodes).
[[nodiscard]] double complianceOf(const Network& network, const NetworkContact& contact);

/// The waves of a network at rest whose nodes are displaced, one for each channel: rows and springs
/// are stretched evenly.
[[nodiscard]] std::vector<double> stretchedWaves(const Network& network,
                                                 std::span<const double> displacements);

/// The waves of a network at rest under its constant forces: contacts push or are open. A bar that
/// drifts and that nothing presses stays at displacement 0.
struct Rest {
    std::vector<double> waves;          ///< in the order of Network::waves
    std::vector<double> displacements;  ///< of the nodes
    ContactSet closed = 0;              ///< contacts that push
};

/// \throws std::invalid_argument if forces move a bar for ever, or there are more than
/// `mostRestContacts` contacts. O(2^contacts nodes^3).
[[nodiscard]] Rest restOf(const Network& network);

/// Constant forces on the bars that drift (contact_spans.hpp), and what rounding is compared with.
struct DriftForces {
    std::vector<double> ofBars;
    double size = 0.0;  ///< sum of |those of nodes|
};
[[nodiscard]] DriftForces driftForces(const Network& network);

/// Can bars that nothing holds go one way for ever, with the constant forces on them, and no
/// contact closes? Then no pushes balance these forces; else some do, and the network can be at
/// rest. O(bars^2 contacts).
[[nodiscard]] bool driftsAway(const Network& network);

inline constexpr std::size_t mostRestContacts = 12;

}  // namespace signorini
