#include "network_blocks.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace signorini {

NetworkBlocks::NetworkBlocks(Network network, std::vector<ContactSpan> schedule, bool lumps)
    : network_(std::move(network)),
      schedule_(std::move(schedule)),
      clocks_(network_.nodes.size(), 0)
{
    for (const ContactSpan& span : schedule_) {
        steps_ += span.steps;
        ends_.push_back(steps_);
    }
    unit_ = network_.stubs.empty() ? steps_ : 1;
    for (const CellRow& row : network_.rows) {
        unit_ = std::gcd(unit_, 2 * row.cells);
    }
    std::vector<std::int64_t> crossing(network_.nodes.size(), 0);  // to the next node
    for (const CellRow& row : network_.rows) {
        crossing[row.left] = row.cells;
    }
    for (std::size_t node = clocks_.size() - 1; node-- > 0;) {
        clocks_[node] = clocks_[node + 1] + crossing[node];
    }
    const bool areAlike = network_.strainLimit == infinity && withoutForces(network_) == network_;
    findTypes(lumps && areAlike);
}

/// Cut where a contact switches.
void NetworkBlocks::findTypes(bool lumps)
{
    std::set<std::int64_t> cuts{0};
    for (std::int64_t residue = 0; residue < unit_ && !lumps; ++residue) {
        cuts.insert(cuts.end(), residue);
    }
    ContactSet before = schedule_.back().closed;
    for (std::size_t k = 0; k < schedule_.size(); ++k) {
        const ContactSet switched = before ^ schedule_[k].closed;
        before = schedule_[k].closed;
        for (std::size_t j = 0; j < network_.contacts.size(); ++j) {
            if (contains(switched, j)) {
                const std::int64_t step =
                    (k > 0 ? ends_[k - 1] : 0) - clocks_[network_.contacts[j].node];
                cuts.insert((step % unit_ + unit_) % unit_);
            }
        }
    }
    for (auto cut = cuts.begin(); cut != cuts.end(); ++cut) {
        const auto next = std::next(cut);
        types_.push_back({*cut, (next == cuts.end() ? unit_ : *next) - *cut});
    }
}

std::int64_t NetworkBlocks::delay(std::size_t channel) const
{
    if (channel >= 2 * network_.rows.size()) {
        return 1;
    }
    return channel % 2 == 0 ? 2 * network_.rows[channel / 2].cells / unit_ : 0;
}

std::int64_t NetworkBlocks::stateSize() const
{
    std::int64_t size = 0;
    for (std::size_t channel = 0; channel < network_.channels(); ++channel) {
        size += delay(channel);
    }
    return size;
}

std::int64_t NetworkBlocks::stepOf(std::size_t node, std::size_t type, std::int64_t turn) const
{
    return (turn * unit_ + types_[type].first + clocks_[node]) % steps_;
}

std::int64_t NetworkBlocks::periodOf(std::size_t node, std::size_t type, std::int64_t turn) const
{
    return (turn * unit_ + types_[type].first + clocks_[node]) / steps_;
}

NetworkBlocks::Place NetworkBlocks::placeOf(std::size_t node, std::int64_t step) const
{
    const std::int64_t own = ((step - clocks_[node]) % steps_ + steps_) % steps_;
    const auto after = std::upper_bound(
        types_.begin(), types_.end(), own % unit_,
        [](std::int64_t residue, const ResidueType& type) { return residue < type.first; });
    return {static_cast<std::size_t>(after - types_.begin()) - 1, own / unit_};
}

ContactSet NetworkBlocks::closed(std::size_t type, std::int64_t turn) const
{
    ContactSet set = 0;
    for (std::size_t j = 0; j < network_.contacts.size(); ++j) {
        const std::int64_t step = stepOf(network_.contacts[j].node, type, turn);
        const auto span = std::upper_bound(ends_.begin(), ends_.end(), step) - ends_.begin();
        if (contains(schedule_[static_cast<std::size_t>(span)].closed, j)) {
            set |= ContactSet{1} << j;
        }
    }
    return set;
}

}  // namespace signorini
