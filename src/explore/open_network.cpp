#include "open_network.hpp"

#include "dense.hpp"
#include "harmonic_motion.hpp"
#include "statics.hpp"

namespace signorini {

namespace {

constexpr double resonance = 1e-12;  // of a matrix that is nearly singular

}  // namespace

OpenNetwork::OpenNetwork(const HarmonicNetwork& given)
    : given_(given), network_(given.network), law_(network_, 0)
{
    for (const CellRow& row : network_.rows) {
        delays_.insert(delays_.end(), 2, row.cells);
    }
    delays_.resize(network_.channels(), 1);
    std::vector<double> arriving(network_.channels(), 0.0);
    std::vector<double> entering(network_.channels(), 0.0);
    scatter_.resize(channels(), channels());
    for (Eigen::Index c = 0; c < channels(); ++c) {
        arriving[static_cast<std::size_t>(c)] = 1.0;
        law_.scatter(arriving, entering);
        scatter_.col(c) = Eigen::Map<const Eigen::VectorXd>(entering.data(), channels());
        arriving[static_cast<std::size_t>(c)] = 0.0;
    }
    for (std::int64_t m = 0; m < given.steps; ++m) {
        turns_.push_back(turnOf(m, given.steps));
    }
}

OpenNetwork::Vector OpenNetwork::sentBy(std::size_t contact) const
{
    Vector sent = Vector::Zero(channels());
    forEachSide(network_.contacts[contact], [&](std::size_t node, int sign) {
        for (std::size_t c = 0; c < network_.channels(); ++c) {
            if (network_.nodeOf(c) == node) {
                sent[static_cast<Eigen::Index>(network_.entered(c))] +=
                    network_.sign(c) * sign / impedance(node);
            }
        }
    });
    return sent;
}

OpenNetwork::Vector OpenNetwork::sentByDrive() const
{
    const std::vector<Complex> still(network_.channels(), 0.0);
    std::vector<Complex> sent(network_.channels(), 0.0);
    NetworkLaw<Complex>(network_, 0).scatter(still, sent, force(), base());
    return Eigen::Map<const Vector>(sent.data(), channels());
}

OpenNetwork::Vector OpenNetwork::arriving(std::int64_t k, const Vector& sent,
                                          Undamped undamped) const
{
    Vector delay(channels());
    for (Eigen::Index c = 0; c < channels(); ++c) {
        delay[c] = std::conj(power(k, delays_[static_cast<std::size_t>(c)]));
    }
    Eigen::MatrixXcd matrix = delay.asDiagonal() * scatter_.cast<Complex>();
    matrix = Eigen::MatrixXcd::Identity(channels(), channels()) - matrix;
    const Vector right = delay.asDiagonal() * sent;
    // Real and imaginary parts: that has the same waves, also those of least norm.
    Eigen::MatrixXd both(2 * channels(), 2 * channels());
    both << matrix.real(), -matrix.imag(), matrix.imag(), matrix.real();
    Eigen::VectorXd sides(2 * channels());
    sides << right.real(), right.imag();
    const auto wavesOf = [this](const Eigen::VectorXd& parts) {
        Vector waves(channels());
        waves.real() = parts.head(channels());
        waves.imag() = parts.tail(channels());
        return waves;
    };
    const SquareFactors factors(both);
    if (factors.rcond() > resonance) {
        return wavesOf(factors.solve(sides));
    }
    if (undamped == Undamped::refused) {
        throw Resonance("nothing damps some waves of this period");
    }
    Vector waves = wavesOf(LeastSquares(both, resonance).solve(sides));
    if (!((matrix * waves - right).norm() <= harmonicTolerance * right.norm())) {
        throw Resonance("waves that nothing damps resonate at this period");
    }
    return waves;
}

std::vector<double> OpenNetwork::shapeUnder(const std::vector<double>& forces) const
{
    Network shape = network_;
    for (NetworkNode& node : shape.nodes) {
        node.rest = 0.0;
    }
    for (std::size_t bar = 0; bar < shape.bars.size(); ++bar) {
        const NetworkBar& one = shape.bars[bar];
        addShapeUnder(shape, bar, forces,
                      one.drifts() ? std::optional(one.firstNode) : std::nullopt);
    }
    std::vector<double> displacements;
    displacements.reserve(shape.nodes.size());
    for (const NetworkNode& node : shape.nodes) {
        displacements.push_back(node.rest);
    }
    return displacements;
}

double OpenNetwork::dashpotsOf(std::size_t bar) const
{
    double sum = 0.0;
    for (const NetworkNode& node : network_.nodes) {
        sum += node.bar == bar ? node.dashpot : 0.0;
    }
    return sum;
}

std::vector<double> OpenNetwork::speedsUnderPush(std::size_t contact) const
{
    std::vector<double> speeds(network_.bars.size(), 0.0);
    forEachSide(network_.contacts[contact], [&](std::size_t node, int sign) {
        const std::size_t bar = network_.nodes[node].bar;
        const double dashpots = dashpotsOf(bar);
        if (network_.bars[bar].drifts() && dashpots > 0.0) {
            speeds[bar] = sign / dashpots;
        }
    });
    return speeds;
}

double OpenNetwork::driftRate(std::size_t contact) const
{
    double sum = 0.0;
    forEachSide(network_.contacts[contact], [&](std::size_t node, int) {
        const std::size_t bar = network_.nodes[node].bar;
        const double dashpots = dashpotsOf(bar);
        if (network_.bars[bar].drifts()) {
            sum += dashpots > 0.0 ? 1.0 / dashpots : 1.0;
        }
    });
    return sum;
}

std::vector<double> OpenNetwork::shapeUnderPush(std::size_t contact) const
{
    const std::vector<double> speeds = speedsUnderPush(contact);
    std::vector<double> forces;
    forces.reserve(network_.nodes.size());
    for (const NetworkNode& node : network_.nodes) {
        forces.push_back(-node.dashpot * speeds[node.bar]);
    }
    forEachSide(network_.contacts[contact],
                [&](std::size_t node, int sign) { forces[node] += sign; });
    return shapeUnder(forces);
}

std::vector<double> OpenNetwork::evenWaves(std::span<const double> displacements,
                                           std::span<const double> speeds) const
{
    std::vector<double> waves = stretchedWaves(network_, displacements);
    for (std::size_t channel = 0; channel < waves.size(); ++channel) {
        waves[channel] += 0.5 * speeds[network_.nodes[network_.nodeOf(channel)].bar];
    }
    return waves;
}

OpenNetwork::Vector OpenNetwork::arrivingStill(std::size_t contact) const
{
    const std::vector<double> waves = evenWaves(shapeUnderPush(contact), speedsUnderPush(contact));
    return Eigen::Map<const Eigen::VectorXd>(waves.data(), channels()).cast<Complex>();
}

double OpenNetwork::compliance(std::size_t contact, std::size_t pushing) const
{
    const std::vector<double> shape = shapeUnderPush(pushing);
    return openingOf(network_.contacts[contact], [&](std::size_t node) { return shape[node]; });
}

OpenNetwork::Complex OpenNetwork::rate(std::size_t contact, const Vector& arriving) const
{
    return openingOf(network_.contacts[contact], [&](std::size_t node) {
        Complex sum = 0.0;
        for (const auto& term : law_.velocity(node).terms) {
            sum += term.coefficient * arriving[static_cast<Eigen::Index>(term.channel)];
        }
        return sum;
    });
}

OpenNetwork::Complex OpenNetwork::rateByPush(std::size_t contact, const Vector& arriving,
                                             std::size_t pushing) const
{
    Complex sum = rate(contact, arriving);
    forEachSide(network_.contacts[contact], [&](std::size_t node, int sign) {
        forEachSide(network_.contacts[pushing], [&](std::size_t pushed, int way) {
            sum += node == pushed ? sign * way / impedance(node) : 0.0;
        });
    });
    return sum;
}

OpenNetwork::Complex OpenNetwork::rateByDrive(std::size_t contact, const Vector& arriving) const
{
    return rate(contact, arriving) + openingOf(network_.contacts[contact], [&](std::size_t node) {
               const LinearForm<double>& form = law_.velocity(node);
               return form.perForce * force() + form.perBase * base();
           });
}

/// Sum of Z_k + D.
double OpenNetwork::impedance(std::size_t node) const
{
    double sum = network_.nodes[node].dashpot;
    for (std::size_t c = 0; c < network_.channels(); ++c) {
        sum += network_.nodeOf(c) == node ? network_.impedanceOf(c) : 0.0;
    }
    return sum;
}

}  // namespace signorini
