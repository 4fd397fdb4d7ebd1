#pragma once
/// \file
/// The components of the motions of one energy, of several phases, from the vertices of their set.

#include <cstddef>
#include <vector>

#include "section_numbers.hpp"
#include "signorini/lumped_set.hpp"

namespace signorini {

/// Vertices and energies of several phases carry the rounding of a few operations.
inline constexpr double vertexRounding = 1e-13;

/// The graph of the vertices with Q >= q. A vertex is one of the sums S, with each pressing sum in
/// one class of its type. Between vertices S, S' the classes stay; within a type of sum S_tau the
/// class may change where Q - S_tau^2/2 >= q, in any component of the S that has such a vertex or
/// one with S_tau = 0. Otherwise the type is locked there: its class names the component.
class VertexGraph {
public:
    /// `vertices`: all S that are vertices, the set being bounded and without boxes of several
    /// classes; `squares`: q. O(vertices^2).
    VertexGraph(const LumpedSet& set, std::vector<std::vector<double>> vertices, double squares);

    [[nodiscard]] const std::vector<std::vector<double>>& vertices() const { return vertices_; }
    [[nodiscard]] bool isAbove(std::size_t vertex) const;

    /// The first vertex S of the component of one that is above.
    [[nodiscard]] std::size_t groupOf(std::size_t vertex) const { return groups_[vertex]; }

    /// For each live type: is its class the same throughout a component of this group?
    [[nodiscard]] const std::vector<bool>& locks(std::size_t group) const { return locks_[group]; }

    /// Infinite if they are many.
    [[nodiscard]] double components() const;

private:
    [[nodiscard]] std::vector<bool> locksOf(std::size_t group, double level) const;

    std::vector<double> counts_;  ///< classes of each live type
    std::vector<std::vector<double>> vertices_;
    std::vector<std::size_t> groups_;
    std::vector<std::vector<bool>> locks_;
};

}  // namespace signorini
