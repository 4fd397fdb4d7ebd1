#include "network_cells.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "largest.hpp"

namespace signorini {

void SlidingRange::add(double value)
{
    const auto enter = [&](Ends& ends, auto isBeaten) {
        auto& [entries, gone] = ends;
        while (entries.size() > gone && !isBeaten(value, entries.back().value)) {
            entries.pop_back();
        }
        entries.push_back({count_, value});
        gone += entries[gone].number + window_ <= count_ ? 1 : 0;
        if (2 * gone > entries.size()) {
            entries.erase(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(gone));
            gone = 0;
        }
    };
    enter(most_, std::less<>());
    enter(least_, std::greater<>());
    ++count_;
}

NetworkCells::NetworkCells(const Network& network, const NetworkClaim& claim, double tolerance)
    : network_(network),
      claim_(claim),
      tolerance_(tolerance),
      displacements_(claim.displacements),
      velocities_(network.nodes.size()),
      extremes_{std::vector<ContactExtremes>(network.contacts.size()), infinity, -infinity,
                claim.displacements}
{
    const auto* next = claim.waves.data();
    for (const CellRow& row : network.rows) {
        const auto cells = static_cast<std::size_t>(row.cells);
        Row made{{std::reverse_iterator(next + cells), std::reverse_iterator(next)},
                 {next + cells, next + 2 * cells},
                 SlidingRange(cells),
                 SlidingRange(cells),
                 (network.nodes[row.right].rest - network.nodes[row.left].rest) /
                     static_cast<double>(cells)};
        for (std::size_t k = 0; k < cells; ++k) {
            meet(made, row.speed, made.right[k], made.left[k], std::nullopt);
        }
        rows_.push_back(std::move(made));
        next += 2 * cells;
    }
    stubs_.assign(next, next + network.stubs.size());
    compareWith();
}

void NetworkCells::compareWith()
{
    size_ = claim_.wave > 0.0 ? claim_.wave : largestSizeOf(claim_.waves);
    double gap = 0.0;
    std::vector<double> impedances(network_.nodes.size(), 0.0);
    for (std::size_t k = 0; k < network_.channels(); ++k) {
        impedances[network_.nodeOf(k)] += network_.impedanceOf(k);
    }
    for (const NetworkContact& contact : network_.contacts) {
        gap = std::max(gap, std::abs(contact.gap));
        const std::size_t other = contact.node + (contact.kind == ContactKind::gap ? 1 : 0);
        forces_.push_back(2.0 * (size_ > 0.0 ? size_ : 1.0) *
                          std::max(impedances[contact.node], impedances[other]));
    }
    length_ = claim_.length > 0.0 ? claim_.length
                                  : std::max(gap, size_ * static_cast<double>(network_.cells()));
    length_ = length_ > 0.0 ? length_ : 1.0;
}

double NetworkCells::distance(std::size_t number) const
{
    const NetworkContact& contact = network_.contacts[number];
    const double here = displacements_[contact.node];
    if (contact.kind == ContactKind::gap) {
        return contact.gap - here + displacements_[contact.node + 1];
    }
    return contact.kind == ContactKind::stopRight ? contact.gap - here : contact.gap + here;
}

/// By how much a contact becomes nearer in the step.
double NetworkCells::approach(std::size_t number) const
{
    const NetworkContact& contact = network_.contacts[number];
    const double here = velocities_[contact.node];
    return contact.kind == ContactKind::gap         ? here - velocities_[contact.node + 1]
           : contact.kind == ContactKind::stopRight ? here
                                                    : -here;
}

/// Two waves that enter a row meet those of the other side that are in it, and those that arrive
/// just now at its ends: number a from the left and b from the right where weight stretches a cell
/// by gravity (b - a)/2 less than in the middle, and by half of gravity less or more on the way
/// through each other, of which one half is the row's at its ends.
void NetworkCells::meet(Row& row, double speed, double right, double left,
                        std::optional<std::pair<double, double>> arriving)
{
    const double gravity = network_.gravity;
    const double weight = 0.5 * gravity * static_cast<double>(row.met++);
    right -= weight;
    left -= weight;
    row.rights.add(right);
    row.lefts.add(left);
    const double half = 0.5 * std::abs(gravity);
    double least = std::min(row.lefts.least() - right, left - row.rights.most()) - half;
    double most = std::max(row.lefts.most() - right, left - row.rights.least()) + half;
    if (arriving) {
        const double older = 0.5 * gravity * static_cast<double>(row.right.size());
        const double atLeft = arriving->second + older - weight - right;
        const double atRight = left - (arriving->first + older - weight);
        least = std::min(
            {least, atLeft - std::max(0.5 * gravity, 0.0), atRight + std::min(0.5 * gravity, 0.0)});
        most = std::max(
            {most, atLeft - std::min(0.5 * gravity, 0.0), atRight + std::max(0.5 * gravity, 0.0)});
    }
    extremes_.leastStrain = std::min(extremes_.leastStrain, (row.rest + least) / speed);
    extremes_.mostStrain = std::max(extremes_.mostStrain, (row.rest + most) / speed);
}

void NetworkCells::look(std::size_t step)
{
    driven_ = claim_.forces.empty() ? 0.0 : claim_.forces[step];
    base_ = claim_.velocities.empty() ? 0.0 : claim_.velocities[step];
    pulls_.clear();
    for (const NetworkNode& node : network_.nodes) {
        pulls_.push_back({node.force + (node.isDriven ? driven_ : 0.0), node.dashpot});
    }
    const auto add = [this](std::size_t node, double impedance, double wave) {
        pulls_[node].force += 2.0 * impedance * wave;
        pulls_[node].impedance += impedance;
    };
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        const CellRow& row = network_.rows[k];
        add(row.right, row.impedance, rows_[k].right[rows_[k].head]);
        add(row.left, row.impedance, rows_[k].left[rows_[k].head]);
    }
    for (std::size_t k = 0; k < stubs_.size(); ++k) {
        add(network_.stubs[k].node, network_.stubs[k].impedance, stubs_[k]);
    }
}

void NetworkCells::find(ContactSet closed)
{
    const std::size_t nodes = network_.nodes.size();
    isHeld_.assign(nodes, false);
    isJoined_.assign(nodes + 1, false);
    shaken_ = 0.0;
    for (std::size_t j = 0; j < network_.contacts.size(); ++j) {
        if (contains(closed, j)) {
            const NetworkContact& contact = network_.contacts[j];
            contact.kind == ContactKind::gap ? isJoined_[contact.node + 1] = true
                                             : isHeld_[contact.node] = true;
        }
    }
    for (std::size_t first = 0; first < nodes;) {
        Pull all{0.0, 0.0};
        bool stands = false;
        double given = 0.0;
        std::size_t last = first;
        do {
            all.force += pulls_[last].force;
            all.impedance += pulls_[last].impedance;
            stands = stands || isHeld_[last] || network_.nodes[last].isClamped;
            given += network_.nodes[last].isShaken ? base_ : 0.0;
            ++last;
        } while (isJoined_[last]);
        const double v = stands ? given : all.force / all.impedance;
        shaken_ += stands ? v * (all.impedance * v - all.force) : 0.0;
        std::fill(velocities_.begin() + static_cast<std::ptrdiff_t>(first),
                  velocities_.begin() + static_cast<std::ptrdiff_t>(last), v);
        first = last;
    }
}

/// Each node's balance f - Z v is what its contacts have to bear: from the left while nothing
/// holds, from the right beyond.
double NetworkCells::pushOf(ContactSet closed, std::size_t number) const
{
    const NetworkContact& contact = network_.contacts[number];
    if (contact.kind == ContactKind::gap) {
        const auto [isKnown, fromLeft] = borne(closed, contact.node, -1);
        return isKnown ? fromLeft : -borne(closed, contact.node + 1, 1).second;
    }
    double push = balance(contact.node);
    for (const int side : {-1, 1}) {
        if (const auto gap = closedGap(closed, contact.node, side)) {
            push += borne(closed, *gap, side).second;
        }
    }
    return contact.kind == ContactKind::stopRight ? push : -push;
}

double NetworkCells::balance(std::size_t node) const
{
    return pulls_[node].force - pulls_[node].impedance * velocities_[node];
}

/// The neighbour beyond a closed gap on that side of a node.
std::optional<std::size_t> NetworkCells::closedGap(ContactSet closed, std::size_t node,
                                                   int side) const
{
    for (std::size_t j = 0; j < network_.contacts.size(); ++j) {
        const NetworkContact& contact = network_.contacts[j];
        if (contains(closed, j) && contact.kind == ContactKind::gap &&
            contact.node + (side < 0 ? 1 : 0) == node) {
            return side < 0 ? contact.node : contact.node + 1;
        }
    }
    return std::nullopt;
}

/// The sum of balances from a node on to that side, and whether no stop is among them.
std::pair<bool, double> NetworkCells::borne(ContactSet closed, std::size_t node, int side) const
{
    double sum = 0.0;
    for (std::optional<std::size_t> at = node; at; at = closedGap(closed, *at, side)) {
        if (network_.nodes[*at].isClamped || isHeld_[*at]) {
            return {false, sum};
        }
        sum += balance(*at);
    }
    return {true, sum};
}

ContactSet NetworkCells::decide()
{
    ContactSet closed = 0;
    for (std::size_t turns = 0; turns < 4 * network_.contacts.size() + 1; ++turns) {
        find(closed);
        std::optional<std::size_t> next;
        double most = 0.0;
        const auto prefer = [&](std::size_t contact, double by) {
            if (by > most) {
                next = contact;
                most = by;
            }
        };
        for (std::size_t j = 0; j < network_.contacts.size(); ++j) {
            if (contains(closed, j)) {
                prefer(j, -pushOf(closed, j) / forces_[j]);
            }
        }
        for (std::size_t j = 0; !next && j < network_.contacts.size(); ++j) {
            // Rounding may make the way exceed the distance of nodes that meet just now.
            const double left = distance(j);
            if (!contains(closed, j) && left <= tolerance_ * length_ &&
                approach(j) > std::max(left, 2.0 * left)) {
                prefer(j, approach(j));
            }
        }
        if (!next) {
            break;
        }
        closed ^= ContactSet{1} << *next;
    }
    return closed;
}

double NetworkCells::overlap(ContactSet closed) const
{
    double deepest = 0.0;
    for (std::size_t j = 0; j < network_.contacts.size(); ++j) {
        if (!contains(closed, j) && approach(j) > 0.0) {
            deepest = std::max(deepest, approach(j) - distance(j));
        }
    }
    return deepest;
}

ContactSet NetworkCells::take(ContactSet closed)
{
    ContactSet pressed = 0;
    for (std::size_t j = 0; j < network_.contacts.size(); ++j) {
        ContactExtremes& seen = extremes_.contacts[j];
        if (!contains(closed, j)) {
            if (approach(j) > 0.0 && distance(j) - approach(j) <= tolerance_ * length_) {
                seen.approach = std::max(seen.approach, approach(j));
            }
            continue;
        }
        const double push = pushOf(closed, j);
        pull_ = std::max(pull_, -push / forces_[j]);
        seen.impulse += push;
        if (push > tolerance_ * forces_[j]) {
            seen.peakForce = std::max(seen.peakForce, push);
            pressed |= ContactSet{1} << j;
            ++seen.pressed;
        }
    }
    work();
    send();
    for (std::size_t j = 0; j < network_.contacts.size(); ++j) {
        if (!contains(closed, j)) {
            penetration_ = std::max(penetration_, -distance(j) / length_);
        }
    }
    return pressed;
}

/// What forces, shaken clamps and dashpots do in the step.
void NetworkCells::work()
{
    double done = shaken_;
    for (std::size_t node = 0; node < velocities_.size(); ++node) {
        const NetworkNode& here = network_.nodes[node];
        const double v = velocities_[node];
        done += (here.force + (here.isDriven ? driven_ : 0.0)) * v;
        spent_ += here.dashpot * v * v;
    }
    gained_ += done;
    exchanged_ += std::abs(done);
}

double NetworkCells::unbalanced() const
{
    double held = 0.0;
    for (const CellRow& row : network_.rows) {
        held += row.impedance * static_cast<double>(row.cells) * size_ * size_;
    }
    const double most = std::max({exchanged_, spent_, held});
    return most > 0.0 ? std::abs(gained_ - spent_) / most : 0.0;
}

void NetworkCells::send()
{
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        Row& row = rows_[k];
        const CellRow& cells = network_.rows[k];
        const std::pair arriving(row.right[row.head], row.left[row.head]);
        const double right = velocities_[cells.left] - arriving.second;
        const double left = velocities_[cells.right] - arriving.first;
        row.right[row.head] = right;
        row.left[row.head] = left;
        row.head = row.head + 1 == row.right.size() ? 0 : row.head + 1;
        meet(row, cells.speed, right, left, arriving);
    }
    for (std::size_t k = 0; k < stubs_.size(); ++k) {
        const double leaving = velocities_[network_.stubs[k].node] - stubs_[k];
        stubs_[k] = network_.stubs[k].kind == StubKind::spring ? -leaving : leaving;
    }
    for (std::size_t node = 0; node < velocities_.size(); ++node) {
        displacements_[node] += velocities_[node];
        extremes_.leastDisplacements[node] =
            std::min(extremes_.leastDisplacements[node], displacements_[node]);
    }
}

double NetworkCells::change(double enough) const
{
    const double unit = size_ > 0.0 ? size_ : 1.0;
    double most = 0.0;
    const auto see = [&most](double now, double before) {
        most = std::max(most, std::abs(now - before));
    };
    const auto* next = claim_.waves.data();
    for (const Row& row : rows_) {
        const std::size_t cells = row.right.size();
        std::size_t at = row.head;
        for (std::size_t k = 0; k < cells && most <= enough * unit; ++k) {
            see(row.right[at], next[cells - 1 - k]);
            see(row.left[at], next[cells + k]);
            at = at + 1 == cells ? 0 : at + 1;
        }
        next += 2 * cells;
    }
    for (const double wave : stubs_) {
        see(wave, *next++);
    }
    return most / unit;
}

double NetworkCells::moved() const
{
    double most = 0.0;
    for (std::size_t node = 0; node < displacements_.size(); ++node) {
        if (network_.bars[network_.nodes[node].bar].drifts()) {  // else they follow from the waves
            most = std::max(most, std::abs(displacements_[node] - claim_.displacements[node]));
        }
    }
    return most / length_;
}

double NetworkCells::untied() const
{
    double most = 0.0;
    const auto see = [&most](double difference) { most = std::max(most, std::abs(difference)); };
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        double stretched = 0.0;
        for (std::size_t cell = 0; cell < rows_[k].left.size(); ++cell) {
            stretched += rows_[k].left[cell] - rows_[k].right[cell];
        }
        const CellRow& row = network_.rows[k];
        see(displacements_[row.right] - displacements_[row.left] - stretched);
    }
    for (std::size_t k = 0; k < stubs_.size(); ++k) {
        if (network_.stubs[k].kind == StubKind::spring) {
            see(displacements_[network_.stubs[k].node] + stubs_[k]);
        }
    }
    for (std::size_t node = 0; node < displacements_.size(); ++node) {
        if (network_.nodes[node].isClamped && !network_.nodes[node].isShaken) {
            see(displacements_[node]);
        }
    }
    return most / length_;
}

}  // namespace signorini
