#include "statics.hpp"

#include <algorithm>
#include <cmath>

#include "channel_waves.hpp"
#include "contact_spans.hpp"
#include "dense.hpp"
#include "faults.hpp"
#include "infinity.hpp"
#include "network_simulation.hpp"

namespace signorini {

namespace {

double stiffnessOf(const CellRow& row)
{
    return row.impedance / static_cast<double>(row.cells);
}

/// Of the springs at each node; infinite at clamps.
std::vector<double> groundOf(const Network& network)
{
    std::vector<double> ground(network.nodes.size(), 0.0);
    for (const Stub& stub : network.stubs) {
        ground[stub.node] += stub.kind == StubKind::spring ? 2.0 * stub.impedance : 0.0;
    }
    for (std::size_t node = 0; node < ground.size(); ++node) {
        if (network.nodes[node].isClamped) {
            ground[node] = infinity;
        }
    }
    return ground;
}

double inSeries(double one, double other)
{
    return one == 0.0 || other == 0.0 ? 0.0 : 1.0 / (1.0 / one + 1.0 / other);
}

}  // namespace

std::vector<double> weightsOf(const Network& network, double gravity)
{
    std::vector<double> weights(network.nodes.size(), 0.0);
    for (const CellRow& row : network.rows) {
        const double half = 0.5 * row.impedance * static_cast<double>(row.cells) * gravity;
        weights[row.left] += half;
        weights[row.right] += half;
    }
    for (const Stub& stub : network.stubs) {
        weights[stub.node] += stub.kind == StubKind::mass ? 0.5 * stub.impedance * gravity : 0.0;
    }
    return weights;
}

double weightOf(const Network& network, std::size_t bar, std::span<const double> weights)
{
    double sum = 0.0;
    for (std::size_t node = network.bars[bar].firstNode; node <= network.bars[bar].lastNode;
         ++node) {
        sum += weights[node];
    }
    return sum;
}

void addShapeUnder(Network& network, std::size_t bar, std::span<const double> forces,
                   std::optional<std::size_t> support)
{
    const std::size_t first = network.bars[bar].firstNode;
    const std::size_t last = network.bars[bar].lastNode;
    std::vector<double> ground = groundOf(network);
    if (support) {
        ground[*support] = infinity;
    }
    // Elimination from the left: k u_i = f + (what is to the right of it).
    std::vector<double> stiffness(last - first + 1, 0.0);  // of all to the left, at the node
    std::vector<double> force(last - first + 1, 0.0);      // by all to the left, at the node
    std::vector<double> rows(last - first + 1, 0.0);       // to the left of the node
    for (const CellRow& row : network.rows) {
        if (row.left >= first && row.right <= last) {
            rows[row.right - first] = stiffnessOf(row);
        }
    }
    for (std::size_t k = 0; k < stiffness.size(); ++k) {
        stiffness[k] = ground[first + k];
        force[k] = forces[first + k];
        if (k > 0 && std::isinf(stiffness[k - 1])) {
            stiffness[k] += rows[k];
        } else if (k > 0) {
            stiffness[k] += inSeries(rows[k], stiffness[k - 1]);
            force[k] += force[k - 1] * rows[k] / (rows[k] + stiffness[k - 1]);
        }
    }
    double next = 0.0;
    for (std::size_t k = stiffness.size(); k-- > 0;) {
        const double row = k + 1 < stiffness.size() ? rows[k + 1] : 0.0;
        next = std::isinf(stiffness[k]) ? 0.0 : (force[k] + row * next) / (stiffness[k] + row);
        network.nodes[first + k].rest += next;
    }
}

namespace {

/// The displacement of a node under a force of 1.
double complianceAt(const Network& network, std::size_t node)
{
    const std::size_t bar = network.nodes[node].bar;
    if (network.bars[bar].drifts()) {
        return infinity;
    }
    std::vector<double> forces(network.nodes.size(), 0.0);
    forces[node] = 1.0;
    Network shape = network;
    shape.nodes[node].rest = 0.0;
    addShapeUnder(shape, bar, forces, std::nullopt);
    return shape.nodes[node].rest;
}

}  // namespace

double complianceOf(const Network& network, const NetworkContact& contact)
{
    double sum = 0.0;
    forEachSide(contact, [&](std::size_t node, int) { sum += complianceAt(network, node); });
    return sum;
}

namespace {

/// Displacements and pushes where certain contacts are closed; empty if they do not follow.
struct Balance {
    Eigen::VectorXd displacements;
    Eigen::VectorXd pushes;  ///< by contact, 0 where open
};

/// Contact j pushes node i with -directions(i) times its push.
Eigen::VectorXd directionOf(const Network& network, const NetworkContact& contact)
{
    Eigen::VectorXd direction =
        Eigen::VectorXd::Zero(static_cast<Eigen::Index>(network.nodes.size()));
    forEachSide(contact, [&direction](std::size_t node, int sign) {
        direction[static_cast<Eigen::Index>(node)] = -sign;
    });
    return direction;
}

std::optional<Balance> balanceOf(const Network& network, ContactSet closed)
{
    const auto nodes = static_cast<Eigen::Index>(network.nodes.size());
    const auto contacts = static_cast<Eigen::Index>(network.contacts.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(nodes + contacts, nodes + contacts);
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(nodes + contacts);
    for (const CellRow& row : network.rows) {
        const auto left = static_cast<Eigen::Index>(row.left);
        const double stiffness = stiffnessOf(row);
        matrix(left, left) += stiffness;
        matrix(left + 1, left + 1) += stiffness;
        matrix(left, left + 1) -= stiffness;
        matrix(left + 1, left) -= stiffness;
    }
    const std::vector<double> ground = groundOf(network);
    for (Eigen::Index node = 0; node < nodes; ++node) {
        rhs[node] = network.nodes[static_cast<std::size_t>(node)].force;
        const double held = ground[static_cast<std::size_t>(node)];
        if (std::isinf(held)) {
            matrix.row(node).setZero();
            matrix(node, node) = 1.0;
            rhs[node] = 0.0;
        } else {
            matrix(node, node) += held;
        }
    }
    for (Eigen::Index j = 0; j < contacts; ++j) {
        const NetworkContact& contact = network.contacts[static_cast<std::size_t>(j)];
        if ((closed >> static_cast<unsigned>(j) & 1U) == 0) {
            matrix(nodes + j, nodes + j) = 1.0;
            continue;
        }
        const Eigen::VectorXd direction = directionOf(network, contact);
        matrix.col(nodes + j).head(nodes) = direction;
        matrix.row(nodes + j).head(nodes) = direction.transpose();
        rhs[nodes + j] = contact.gap;
    }
    // A bar that nothing holds stays where it is, if nothing pushes it.
    for (const NetworkBar& bar : network.bars) {
        if (!bar.drifts()) {
            continue;
        }
        const auto first = static_cast<Eigen::Index>(bar.firstNode);
        const bool isTouched =
            matrix
                .block(first, nodes, static_cast<Eigen::Index>(bar.lastNode) - first + 1, contacts)
                .cwiseAbs()
                .sum() > 0.0;
        if (!isTouched) {
            matrix(first, first) += 1.0;
        }
    }
    const Eigen::VectorXd x = FullFactors(matrix).solve(rhs);
    if (!x.allFinite() || (matrix * x - rhs).norm() > 1e-9 * (1.0 + rhs.norm() + x.norm())) {
        return std::nullopt;
    }
    return Balance{x.head(nodes), x.tail(contacts)};
}

/// Nothing pulls, nothing overlaps, and what is not held is not pushed.
bool isAtRest(const Network& network, ContactSet closed, const Balance& balance)
{
    const double size = 1e-9 * (1.0 + balance.displacements.cwiseAbs().maxCoeff());
    for (std::size_t j = 0; j < network.contacts.size(); ++j) {
        const NetworkContact& contact = network.contacts[j];
        const double distance =
            contact.gap - directionOf(network, contact).dot(balance.displacements);
        const bool isClosed = contains(closed, j);
        if (distance < -size ||
            (isClosed && balance.pushes[static_cast<Eigen::Index>(j)] < -size)) {
            return false;
        }
    }
    for (const NetworkBar& bar : network.bars) {
        double force = 0.0;
        for (std::size_t node = bar.firstNode; node <= bar.lastNode; ++node) {
            force += network.nodes[node].force;
        }
        double push = 0.0;
        for (std::size_t j = 0; j < network.contacts.size(); ++j) {
            const Eigen::VectorXd direction = directionOf(network, network.contacts[j]);
            for (std::size_t node = bar.firstNode; node <= bar.lastNode; ++node) {
                push += direction[static_cast<Eigen::Index>(node)] *
                        balance.pushes[static_cast<Eigen::Index>(j)];
            }
        }
        if (bar.drifts() && std::abs(force - push) > size * (1.0 + std::abs(force))) {
            return false;
        }
    }
    return true;
}

/// Adds the bars that contacts close on where these go that way. \return can they go for ever?
bool takeAlong(const Network& network, int way, std::vector<bool>& goes)
{
    for (bool isDone = false; !isDone;) {
        isDone = true;
        for (std::size_t contact = 0; contact < network.contacts.size(); ++contact) {
            int opens = 0;
            std::optional<std::size_t> other;
            for (const auto& [bar, sign] : driftsOf(network, contact)) {
                opens += goes[bar] ? way * sign : 0;
                other = goes[bar] ? other : bar;
            }
            if (opens < 0 && !other) {
                return false;
            }
            if (opens < 0) {
                goes[*other] = true;
                isDone = false;
            }
        }
    }
    return true;
}

}  // namespace

std::vector<double> stretchedWaves(const Network& network, std::span<const double> displacements)
{
    std::vector<double> waves;
    for (const CellRow& row : network.rows) {
        const double stretch =
            (displacements[row.right] - displacements[row.left]) / static_cast<double>(row.cells);
        waves.insert(waves.end(), {-0.5 * stretch, 0.5 * stretch});
    }
    for (const Stub& stub : network.stubs) {
        waves.push_back(stub.kind == StubKind::spring ? -displacements[stub.node] : 0.0);
    }
    return waves;
}

DriftForces driftForces(const Network& network)
{
    const std::vector<std::size_t> bars = driftingBars(network);
    DriftForces forces{std::vector<double>(bars.size(), 0.0)};
    for (const NetworkNode& node : network.nodes) {
        const auto bar = std::find(bars.begin(), bars.end(), node.bar);
        if (bar != bars.end()) {
            forces.ofBars[static_cast<std::size_t>(bar - bars.begin())] += node.force;
            forces.size += std::abs(node.force);
        }
    }
    return forces;
}

bool driftsAway(const Network& network)
{
    constexpr double rounding = 1e-12;
    const auto [forces, size] = driftForces(network);
    // Of bars in a row those that one takes along are all to one side of it.
    for (std::size_t first = 0; first < forces.size(); ++first) {
        for (const int way : {1, -1}) {
            std::vector<bool> goes(forces.size(), false);
            goes[first] = true;
            if (!takeAlong(network, way, goes)) {
                continue;
            }
            double along = 0.0;
            for (std::size_t bar = 0; bar < forces.size(); ++bar) {
                along += goes[bar] ? way * forces[bar] : 0.0;
            }
            if (along > rounding * size) {
                return true;
            }
        }
    }
    return false;
}

Rest restOf(const Network& network)
{
    if (network.contacts.size() > mostRestContacts) {
        throwFault("contacts of a scene at rest", network.contacts.size(),
                   fmt::format("at most {}", mostRestContacts), "start it with --velocity");
    }
    for (ContactSet closed = 0; closed < ContactSet{1} << network.contacts.size(); ++closed) {
        const auto balance = balanceOf(network, closed);
        if (!balance || !isAtRest(network, closed, *balance)) {
            continue;
        }
        Rest rest{.waves = {},
                  .displacements = {balance->displacements.begin(), balance->displacements.end()},
                  .closed = closed};
        const std::vector<double> stretched = stretchedWaves(network, rest.displacements);
        for (std::size_t channel = 0; channel < stretched.size(); ++channel) {
            rest.waves.insert(rest.waves.end(),
                              static_cast<std::size_t>(lengthOf(network, channel)),
                              stretched[channel]);
        }
        return rest;
    }
    throwFault("constant forces", "those of the scene", "what contacts can hold at rest",
               "start it with --velocity");
}

}  // namespace signorini
