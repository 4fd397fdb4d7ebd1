#pragma once
/// \file
/// A schedule of a network, in blocks of steps that may be taken for one.
///
/// Nodes stand in a row. Let the clock of each run ahead of the last one's by the travel time
/// between them. Then what a node sends to the left arrives in the same step, and what it sends to
/// the right through row i arrives 2 N_i steps later: steps m and m' have to do with each other
/// only if they differ by a multiple of G = gcd(2 N_1, 2 N_2, ..., n) (1 where stubs are). The
/// residues mod G obey equations of their own, those between two switches of the schedule the same
/// ones. Their mean obeys them, too; its distances run straight between those at the ends of a
/// block, its energy is no larger. So a block of d residues is as good as one of them taken d
/// times: what exists, and what has the least energy, is decided on n/G steps for each block.
/// docs/theory.md, section 20.
///
/// With r the waves that arrive at the right end of row i, of M_i = 2 N_i/G of them in blocks, u
/// falls along the row by sum r, and its energy is Z sum r^2.

#include <vector>

#include "contact_spans.hpp"
#include "network.hpp"

namespace signorini {

/// Residues with the same switches.
struct ResidueType {
    std::int64_t first = 0;  ///< residue
    std::int64_t width = 1;  ///< d
};

class NetworkBlocks {
public:
    /// `lumps`: whether blocks of several residues are made, where these are alike: not under a
    /// limit on strain, which waves of different residues share, nor under constant forces, which
    /// work on waves on their way from node to node. Else each residue is a block. O(blocks
    /// contacts). \pre a valid network, steps > 0.
    NetworkBlocks(Network network, std::vector<ContactSpan> schedule, bool lumps = true);

    [[nodiscard]] const Network& network() const { return network_; }
    [[nodiscard]] const std::vector<ContactSpan>& schedule() const { return schedule_; }
    [[nodiscard]] std::int64_t unit() const { return unit_; }            ///< G
    [[nodiscard]] std::int64_t turns() const { return steps_ / unit_; }  ///< n/G
    [[nodiscard]] const std::vector<ResidueType>& types() const { return types_; }
    /// Blocks after which what enters a channel arrives: M, 0 to the left, 1 in a stub.
    [[nodiscard]] std::int64_t delay(std::size_t channel) const;
    /// Waves under way in a block.
    [[nodiscard]] std::int64_t stateSize() const;
    /// Contacts that are closed in a block, each by the clock of its node.
    [[nodiscard]] ContactSet closed(std::size_t type, std::int64_t turn) const;
    /// The step of the schedule in which a block begins at a node.
    [[nodiscard]] std::int64_t stepOf(std::size_t node, std::size_t type, std::int64_t turn) const;
    /// Periods from the start of the schedule to that step as the clock counts it.
    [[nodiscard]] std::int64_t periodOf(std::size_t node, std::size_t type,
                                        std::int64_t turn) const;
    /// The block of a step of the schedule at a node.
    struct Place {
        std::size_t type;
        std::int64_t turn;
    };
    [[nodiscard]] Place placeOf(std::size_t node, std::int64_t step) const;

private:
    void findTypes(bool lumps);

    Network network_;
    std::vector<ContactSpan> schedule_;
    std::int64_t steps_ = 0;
    std::int64_t unit_ = 1;
    std::vector<std::int64_t> clocks_;  ///< by node: how far ahead
    std::vector<std::int64_t> ends_;    ///< of the spans
    std::vector<ResidueType> types_;
};

}  // namespace signorini
