#include "network_walk.hpp"

#include <algorithm>
#include <cmath>

#include "faults.hpp"
#include "infinity.hpp"

namespace signorini {

namespace {

void validate(const Network& network, const NetworkClaim& claim)
{
    validate(network);
    Faults faults;
    std::int64_t steps = 0;
    for (const ContactSteps& part : claim.schedule) {
        faults.requireWhole("steps", part.steps, std::int64_t{1} << 40);
        faults.throwIfAny();
        (void)clustersOf(network, part.closed);
        if (network.contacts.size() < maxContacts && part.closed >> network.contacts.size() != 0) {
            faults.add("closed contacts", part.closed,
                       fmt::format("sets of contacts 1..{}", network.contacts.size()));
        }
        steps += part.steps;
    }
    if (claim.schedule.empty()) {
        faults.add("schedule", 0, "at least one set of contacts and its steps");
    }
    if (claim.waves.size() != network.waves()) {
        faults.add("waves", claim.waves.size(), fmt::format("{}", network.waves()));
    }
    if (claim.displacements.size() != network.nodes.size()) {
        faults.add("displacements", claim.displacements.size(),
                   fmt::format("{}", network.nodes.size()));
    }
    for (const auto* values : {&claim.forces, &claim.velocities}) {
        if (!values->empty() && static_cast<std::int64_t>(values->size()) != steps) {
            faults.add("steps of the excitation", values->size(), fmt::format("{}", steps));
        }
    }
    faults.throwIfAny();
}

/// Cells, stubs and nodes on their way.
class Walk {
public:
    Walk(const Network& network, const NetworkClaim& claim)
        : network_(network), claim_(claim), displacements_(claim.displacements)
    {
        const auto* next = claim.waves.data();
        for (const CellRow& row : network.rows) {
            const auto cells = static_cast<std::size_t>(row.cells);
            Row made;
            made.right.assign(std::reverse_iterator(next + cells), std::reverse_iterator(next));
            made.left.assign(next + cells, next + 2 * cells);
            rows_.push_back(std::move(made));
            next += 2 * cells;
        }
        stubs_.assign(next, next + network.stubs.size());
        residuals_.impulses.assign(network.contacts.size(), 0.0);
        residuals_.peakForces.assign(network.contacts.size(), 0.0);
        for (const double wave : claim.waves) {
            size_ = std::max(size_, std::abs(wave));
        }
        double impedance = 0.0;
        for (std::size_t k = 0; k < network.channels(); ++k) {
            impedance = std::max(impedance, network.impedanceOf(k));
        }
        for (const NetworkContact& contact : network.contacts) {
            length_ = std::max(length_, std::abs(contact.gap));
        }
        length_ = std::max(length_, size_ * static_cast<double>(network.cells()));
        length_ = length_ > 0.0 ? length_ : 1.0;
        force_ = size_ > 0.0 ? size_ * impedance : 1.0;
    }

    NetworkResiduals run()
    {
        checkTie();
        std::size_t step = 0;
        ContactSet before = claim_.schedule.back().closed;
        for (const ContactSteps& part : claim_.schedule) {
            for (std::size_t j = 0; j < network_.contacts.size(); ++j) {
                const bool starts = contains(part.closed, j) && !contains(before, j);
                if (starts) {
                    residuals_.gap = std::max(residuals_.gap, std::abs(distance(j)) / length_);
                }
            }
            before = part.closed;
            for (std::int64_t k = 0; k < part.steps; ++k, ++step) {
                take(part.closed, claim_.forces.empty() ? 0.0 : claim_.forces[step],
                     claim_.velocities.empty() ? 0.0 : claim_.velocities[step]);
            }
        }
        compareWithStart();
        return residuals_;
    }

private:
    /// Two rings; what arrives next is at the head of both.
    struct Row {
        std::vector<double> right;
        std::vector<double> left;
        std::size_t head = 0;
    };
    /// 2 sum Z w + f and sum Z + D of a node.
    struct Pull {
        double force;
        double impedance;
    };

    [[nodiscard]] double distance(std::size_t number) const
    {
        const NetworkContact& contact = network_.contacts[number];
        const double here = displacements_[contact.node];
        if (contact.kind == ContactKind::gap) {
            return contact.gap - here + displacements_[contact.node + 1];
        }
        return contact.kind == ContactKind::stopRight ? contact.gap - here : contact.gap + here;
    }

    /// Displacements against elongations and springs.
    void checkTie()
    {
        const auto see = [this](double difference) {
            residuals_.tie = std::max(residuals_.tie, std::abs(difference) / length_);
        };
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
    }

    void take(ContactSet closed, double driven, double base)
    {
        std::vector<Pull> pulls;
        for (const NetworkNode& node : network_.nodes) {
            pulls.push_back({node.force + (node.isDriven ? driven : 0.0), node.dashpot});
        }
        const auto add = [&pulls](std::size_t node, double impedance, double wave) {
            pulls[node].force += 2.0 * impedance * wave;
            pulls[node].impedance += impedance;
        };
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            const CellRow& row = network_.rows[k];
            add(row.right, row.impedance, rows_[k].right[rows_[k].head]);
            add(row.left, row.impedance, rows_[k].left[rows_[k].head]);
        }
        for (std::size_t k = 0; k < stubs_.size(); ++k) {
            add(network_.stubs[k].node, network_.stubs[k].impedance, stubs_[k]);
        }
        const std::vector<double> velocities = velocitiesOf(closed, pulls, base);
        press(closed, pulls, velocities);
        send(velocities);
        for (std::size_t j = 0; j < network_.contacts.size(); ++j) {
            if (!contains(closed, j)) {
                residuals_.penetration = std::max(residuals_.penetration, -distance(j) / length_);
            }
        }
    }

    /// Of all nodes: runs that closed gaps join have one.
    [[nodiscard]] std::vector<double> velocitiesOf(ContactSet closed,
                                                   const std::vector<Pull>& pulls,
                                                   double base) const
    {
        const std::size_t nodes = network_.nodes.size();
        std::vector<bool> isHeld(nodes, false);
        std::vector<bool> isJoined(nodes + 1, false);  // to the node before
        for (std::size_t j = 0; j < network_.contacts.size(); ++j) {
            if (contains(closed, j)) {
                const NetworkContact& contact = network_.contacts[j];
                contact.kind == ContactKind::gap ? isJoined[contact.node + 1] = true
                                                 : isHeld[contact.node] = true;
            }
        }
        std::vector<double> velocities(nodes, 0.0);
        for (std::size_t first = 0; first < nodes;) {
            Pull all{0.0, 0.0};
            bool stands = false;
            double given = 0.0;
            std::size_t last = first;
            do {
                all.force += pulls[last].force;
                all.impedance += pulls[last].impedance;
                stands = stands || isHeld[last] || network_.nodes[last].isClamped;
                given += network_.nodes[last].isShaken ? base : 0.0;
                ++last;
            } while (isJoined[last]);
            const double v = stands ? given : all.force / all.impedance;
            std::fill(velocities.begin() + static_cast<std::ptrdiff_t>(first),
                      velocities.begin() + static_cast<std::ptrdiff_t>(last), v);
            first = last;
        }
        return velocities;
    }

    /// Each node's balance f - Z v is what its contacts have to bear: from the left while nothing
    /// holds, from the right beyond.
    void press(ContactSet closed, const std::vector<Pull>& pulls,
               const std::vector<double>& velocities)
    {
        for (std::size_t j = 0; j < network_.contacts.size(); ++j) {
            if (!contains(closed, j)) {
                continue;
            }
            const NetworkContact& contact = network_.contacts[j];
            double push = 0.0;
            if (contact.kind == ContactKind::gap) {
                const auto [isKnown, fromLeft] = borne(closed, contact.node, -1, pulls, velocities);
                push = isKnown ? fromLeft
                               : -borne(closed, contact.node + 1, 1, pulls, velocities).second;
            } else {
                push = balance(contact.node, pulls, velocities);
                if (const auto gap = closedGap(closed, contact.node, -1)) {
                    push += borne(closed, *gap, -1, pulls, velocities).second;
                }
                if (const auto gap = closedGap(closed, contact.node, 1)) {
                    push += borne(closed, *gap, 1, pulls, velocities).second;
                }
                push = contact.kind == ContactKind::stopRight ? push : -push;
            }
            residuals_.pressure = std::max(residuals_.pressure, -push / force_);
            residuals_.impulses[j] += push;
            residuals_.peakForces[j] = std::max(residuals_.peakForces[j], push);
        }
    }

    [[nodiscard]] static double balance(std::size_t node, const std::vector<Pull>& pulls,
                                        const std::vector<double>& velocities)
    {
        return pulls[node].force - pulls[node].impedance * velocities[node];
    }

    /// The neighbour beyond a closed gap on that side of a node.
    [[nodiscard]] std::optional<std::size_t> closedGap(ContactSet closed, std::size_t node,
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
    [[nodiscard]] std::pair<bool, double> borne(ContactSet closed, std::size_t node, int side,
                                                const std::vector<Pull>& pulls,
                                                const std::vector<double>& velocities) const
    {
        double sum = 0.0;
        for (std::optional<std::size_t> at = node; at; at = closedGap(closed, *at, side)) {
            const bool isHeld =
                network_.nodes[*at].isClamped ||
                std::any_of(network_.contacts.begin(), network_.contacts.end(),
                            [&, j = std::size_t{0}](const NetworkContact& contact) mutable {
                                return contains(closed, j++) && contact.node == *at &&
                                       contact.kind != ContactKind::gap;
                            });
            if (isHeld) {
                return {false, sum};
            }
            sum += balance(*at, pulls, velocities);
        }
        return {true, sum};
    }

    void send(const std::vector<double>& velocities)
    {
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            Row& row = rows_[k];
            const double right = row.right[row.head];
            const double left = row.left[row.head];
            row.right[row.head] = velocities[network_.rows[k].left] - left;
            row.left[row.head] = velocities[network_.rows[k].right] - right;
            row.head = row.head + 1 == row.right.size() ? 0 : row.head + 1;
        }
        for (std::size_t k = 0; k < stubs_.size(); ++k) {
            const double leaving = velocities[network_.stubs[k].node] - stubs_[k];
            stubs_[k] = network_.stubs[k].kind == StubKind::spring ? -leaving : leaving;
        }
        for (std::size_t node = 0; node < velocities.size(); ++node) {
            displacements_[node] += velocities[node];
        }
    }

    void compareWithStart()
    {
        const double size = size_ > 0.0 ? size_ : 1.0;
        const auto see = [&](double now, double before, double unit) {
            residuals_.periodicity =
                std::max(residuals_.periodicity, std::abs(now - before) / unit);
        };
        const auto* next = claim_.waves.data();
        for (const Row& row : rows_) {
            const std::size_t cells = row.right.size();
            for (std::size_t k = 0; k < cells; ++k) {
                const std::size_t at = (row.head + k) % cells;
                see(row.right[at], next[cells - 1 - k], size);
                see(row.left[at], next[cells + k], size);
            }
            next += 2 * cells;
        }
        for (const double wave : stubs_) {
            see(wave, *next++, size);
        }
        for (std::size_t node = 0; node < displacements_.size(); ++node) {
            see(displacements_[node], claim_.displacements[node], length_);
        }
    }

    const Network& network_;
    const NetworkClaim& claim_;
    std::vector<Row> rows_;
    std::vector<double> stubs_;
    std::vector<double> displacements_;
    NetworkResiduals residuals_;
    double size_ = 0.0;    ///< largest wave
    double length_ = 0.0;  ///< what lengths are compared with
    double force_ = 1.0;   ///< what forces are compared with
};

}  // namespace

double NetworkResiduals::worst() const
{
    return std::max({periodicity, tie, gap, pressure, penetration});
}

NetworkResiduals walk(const Network& network, const NetworkClaim& claim)
{
    validate(network, claim);
    const auto areFinite = [](const std::vector<double>& values) {
        return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
    };
    if (!areFinite(claim.waves) || !areFinite(claim.displacements) || !areFinite(claim.forces) ||
        !areFinite(claim.velocities)) {
        return {infinity, infinity, infinity, infinity, infinity, {}, {}};
    }
    return Walk(network, claim).run();
}

}  // namespace signorini
