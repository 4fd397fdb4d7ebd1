#include "harmonic_network_contact.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "faults.hpp"
#include "harmonic_network_walk.hpp"
#include "harmonic_release.hpp"
#include "statics.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;
using Vector = Eigen::VectorXcd;

constexpr double sameContact = 1e-7;  // motions nearer than this are one
constexpr double resonance = 1e-12;   // of a matrix that is nearly singular

/// A network with its contacts open, at one frequency.
class OpenNetwork {
public:
    explicit OpenNetwork(const HarmonicNetwork& given)
        : given_(given),
          network_(given.network),
          law_(network_, 0),
          scatter_(channels(), channels())
    {
        std::vector<double> arriving(network_.channels(), 0.0);
        std::vector<double> entering(network_.channels(), 0.0);
        for (Eigen::Index c = 0; c < channels(); ++c) {
            arriving[static_cast<std::size_t>(c)] = 1.0;
            law_.scatter(arriving, entering);
            scatter_.col(c) = Eigen::Map<const Eigen::VectorXd>(entering.data(), channels());
            arriving[static_cast<std::size_t>(c)] = 0.0;
        }
        for (std::size_t row = 0; row < network_.rows.size(); ++row) {
            delays_.insert(delays_.end(), 2, network_.rows[row].cells);
        }
        delays_.resize(network_.channels(), 1);
    }

    [[nodiscard]] Eigen::Index channels() const
    {
        return static_cast<Eigen::Index>(network_.channels());
    }

    /// What arrives, for what enters, with the factor e^{2 pi i k/n} of a step: (I - DS) w = D s.
    [[nodiscard]] Vector arriving(std::int64_t k, const Vector& entering) const
    {
        Vector delay(channels());
        for (Eigen::Index c = 0; c < channels(); ++c) {
            delay[c] = std::conj(power(k, delays_[static_cast<std::size_t>(c)]));
        }
        Eigen::MatrixXcd matrix = delay.asDiagonal() * scatter_.cast<Complex>();
        matrix = Eigen::MatrixXcd::Identity(channels(), channels()) - matrix;
        const Vector right = delay.asDiagonal() * entering;
        const Eigen::PartialPivLU<Eigen::MatrixXcd> parts(matrix);
        if (parts.rcond() > resonance) {
            return parts.solve(right);
        }
        // Waves without damping that nothing excites are left out.
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXcd> least(matrix);
        least.setThreshold(resonance);
        Vector waves = least.solve(right);
        if (!((matrix * waves - right).norm() <= harmonicTolerance * right.norm())) {
            throw std::invalid_argument("waves that nothing damps resonate at this period");
        }
        return waves;
    }

    /// e^{2 pi i k m/n}.
    [[nodiscard]] Complex power(std::int64_t k, std::int64_t m) const
    {
        const std::int64_t n = given_.steps;
        return turned(2.0 * std::numbers::pi * static_cast<double>((k % n) * (m % n) % n) /
                      static_cast<double>(n));
    }

    /// What a push of 1 at a contact sends into the channels.
    [[nodiscard]] Vector sentBy(std::size_t contact) const
    {
        Vector sent = Vector::Zero(channels());
        forEachNode(contact, [&](std::size_t node, double sign) {
            for (std::size_t c = 0; c < network_.channels(); ++c) {
                if (network_.nodeOf(c) == node) {
                    sent[static_cast<Eigen::Index>(network_.entered(c))] +=
                        network_.sign(c) * sign / impedance(node);
                }
            }
        });
        return sent;
    }

    /// What A = 1 sends.
    [[nodiscard]] Vector sentByDrive() const
    {
        const std::vector<Complex> still(network_.channels(), 0.0);
        std::vector<Complex> sent(network_.channels(), 0.0);
        NetworkLaw<Complex>(network_, 0).scatter(still, sent, force(), base());
        return Eigen::Map<const Vector>(sent.data(), channels());
    }

    /// The rate of a contact's distance, when this arrives, a push acts, and the drive.
    [[nodiscard]] Complex rate(std::size_t contact, const Vector& arriving, double push,
                               bool isDriven) const
    {
        Complex sum = 0.0;
        forEachNode(contact, [&](std::size_t node, double sign) {
            const LinearForm<double>& form = law_.velocity(node);
            for (const auto& term : form.terms) {
                sum += sign * term.coefficient * arriving[static_cast<Eigen::Index>(term.channel)];
            }
            sum += push / impedance(node);
            if (isDriven) {
                sum += sign * (form.perForce * force() + form.perBase * base());
            }
        });
        return sum;
    }

    /// What arrives while a push of 1 holds the network still: of a bar that is held twice waves of
    /// frequency 0 do not tell how far it is stretched.
    [[nodiscard]] Vector arrivingStill(std::size_t contact) const
    {
        Network shape = network_;
        std::vector<double> forces(shape.nodes.size(), 0.0);
        for (NetworkNode& node : shape.nodes) {
            node.rest = 0.0;
        }
        forEachNode(contact, [&](std::size_t node, double sign) { forces[node] = sign; });
        for (std::size_t bar = 0; bar < shape.bars.size(); ++bar) {
            addShapeUnder(shape, bar, forces, std::nullopt);
        }
        Vector arriving = Vector::Zero(channels());
        Eigen::Index next = 0;
        for (const CellRow& row : shape.rows) {
            const double stretch = (shape.nodes[row.right].rest - shape.nodes[row.left].rest) /
                                   static_cast<double>(row.cells);
            arriving[next++] = -0.5 * stretch;
            arriving[next++] = 0.5 * stretch;
        }
        for (const Stub& stub : shape.stubs) {
            arriving[next++] = stub.kind == StubKind::spring ? -shape.nodes[stub.node].rest : 0.0;
        }
        return arriving;
    }

    /// Distance by a constant push.
    [[nodiscard]] double compliance(std::size_t contact) const
    {
        double sum = 0.0;
        forEachNode(contact,
                    [&](std::size_t node, double) { sum += complianceAt(network_, node); });
        return sum;
    }

    /// Steps until a wave arrives, by channel.
    [[nodiscard]] const std::vector<std::int64_t>& delays() const { return delays_; }

private:
    [[nodiscard]] Complex force() const { return given_.place == Excited::tip ? 1.0 : 0.0; }
    [[nodiscard]] Complex base() const
    {
        return given_.place == Excited::tip ? 0.0 : Complex(0.0, given_.omega());
    }

    /// Nodes that a push acts on, and by how much their way is that of the distance.
    template <typename Visit>
    void forEachNode(std::size_t contact, const Visit& visit) const
    {
        const NetworkContact& one = network_.contacts[contact];
        visit(one.node, one.kind == ContactKind::stopLeft ? 1.0 : -1.0);
        if (one.kind == ContactKind::gap) {
            visit(one.node + 1, 1.0);
        }
    }

    /// Sum of Z_k + D.
    [[nodiscard]] double impedance(std::size_t node) const
    {
        double sum = network_.nodes[node].dashpot;
        for (std::size_t c = 0; c < network_.channels(); ++c) {
            sum += network_.nodeOf(c) == node ? network_.impedanceOf(c) : 0.0;
        }
        return sum;
    }

    const HarmonicNetwork& given_;
    const Network& network_;
    NetworkLaw<double> law_;
    Eigen::MatrixXd scatter_;
    std::vector<std::int64_t> delays_;
};

/// Pushes of a number of steps of contact, for A = 1.
struct HeldSteps {
    Vector pushes;      ///< Q_i
    Complex displaced;  ///< sum of H Q, by which the distance at the start is larger, d/ds
    Complex next;       ///< the rate in the step after it
};

/// Every length of one contact of a network.
class NetworkContactSearch {
public:
    NetworkContactSearch(const HarmonicNetwork& given, const OpenNetwork& open, std::size_t contact,
                         std::vector<NetworkHarmonicMotion>& found)
        : given_(given), open_(open), contact_(contact), found_(found)
    {
        const std::int64_t n = given.steps;
        const Vector sent = open.sentBy(contact);
        Vector rates(n);
        answers_.resize(open.channels(), n);
        answers_.col(0) = open.arrivingStill(contact);
        rates[0] = 0.0;
        for (std::int64_t k = 1; 2 * k <= n; ++k) {
            answers_.col(k) = open.arriving(k, sent);
            rates[k] = open.rate(contact, answers_.col(k), 1.0, false);
            answers_.col(n - k) = answers_.col(k).conjugate();
            rates[n - k] = std::conj(rates[k]);
        }
        driven_ = open.arriving(given.cycles, open.sentByDrive());
        drivenRate_ = open.rate(contact, driven_, 0.0, true);
        for (std::int64_t m = 0; m < n; ++m) {
            double sum = 0.0;
            for (std::int64_t k = 0; k < n; ++k) {
                sum += (rates[k] * open.power(k, m)).real();
            }
            rates_.push_back(sum / static_cast<double>(n));
        }
        double mean = 0.0;
        for (const double rate : rates_) {
            ways_.push_back(rate + (ways_.empty() ? 0.0 : ways_.back()));
            mean += ways_.back() / static_cast<double>(n);
        }
        for (double& way : ways_) {
            way += open.compliance(contact) / static_cast<double>(n) - mean;
        }
    }

    void run()
    {
        levinson();
        for (std::int64_t j = 1; j < given_.steps; ++j) {
            const auto i = static_cast<std::size_t>(j);
            addSmooth(j - 1, held_[i], held_[i - 1]);
            addPinned(j, held_[i]);
        }
    }

private:
    [[nodiscard]] double rateAfter(std::int64_t steps) const
    {
        const std::int64_t n = given_.steps;
        return rates_[static_cast<std::size_t>((steps % n + n) % n)];
    }

    /// held_[j], j = 0 ... n - 1.
    void levinson()
    {
        Vector pushes(0);
        Eigen::VectorXd first(0);  // pushes with rate 1 in the first step, 0 in the others
        Eigen::VectorXd last(0);
        for (std::int64_t j = 0;; ++j) {
            Complex next = drivenRate_ * given_.turn(j);
            Complex displaced = 0.0;
            for (std::int64_t i = 0; i < j; ++i) {
                next += rateAfter(j - i) * pushes[i];
                displaced += ways_[static_cast<std::size_t>(given_.steps - 1 - i)] * pushes[i];
            }
            held_.push_back({pushes, displaced, next});
            if (j + 1 == given_.steps) {
                return;
            }
            double below = 0.0;
            double above = 0.0;
            for (std::int64_t i = 0; i < j; ++i) {
                below += rateAfter(j - i) * first[i];
                above += rateAfter(-(i + 1)) * last[i];
            }
            const Eigen::VectorXd longer = appended(first);
            const Eigen::VectorXd later = prepended(last);
            if (j == 0) {
                first = last = Eigen::VectorXd::Constant(1, 1.0 / rates_[0]);
            } else {
                const double size = 1.0 - below * above;
                first = (longer - below * later) / size;
                last = (later - above * longer) / size;
            }
            Vector more = Vector::Zero(j + 1);
            more.head(j) = pushes;
            pushes = more - next * last.cast<Complex>();
        }
    }

    static Eigen::VectorXd appended(const Eigen::VectorXd& values)
    {
        Eigen::VectorXd longer = Eigen::VectorXd::Zero(values.size() + 1);
        longer.head(values.size()) = values;
        return longer;
    }
    static Eigen::VectorXd prepended(const Eigen::VectorXd& values)
    {
        Eigen::VectorXd longer = Eigen::VectorXd::Zero(values.size() + 1);
        longer.tail(values.size()) = values;
        return longer;
    }

    /// 1/(i omega).
    [[nodiscard]] Complex integrate() const { return Complex(0.0, -1.0) / given_.omega(); }
    /// The gap for |A| = 1: what is left of it is to be 0 at the start.
    [[nodiscard]] double place() const
    {
        return -given_.network.contacts[contact_].gap / given_.amplitude;
    }

    /// R(tau) = 0 in step j.
    void addSmooth(std::int64_t j, const HeldSteps& early, const HeldSteps& late)
    {
        const ReleaseCell cell{
            (drivenRate_ + given_.turn(1) * late.displaced - early.displaced) * integrate(),
            (early.displaced - late.displaced) * integrate(), early.pushes[j], place(),
            given_.omega()};
        forEachSmoothRelease(cell, [&](double part, Complex unit) {
            if (part > 0.0 && part < 1.0) {
                add(static_cast<double>(j) + part, unit, early, late, false);
            }
        });
    }

    /// tau = j, where a front ends the contact.
    void addPinned(std::int64_t j, const HeldSteps& held)
    {
        const Complex gap = (drivenRate_ + (given_.turn(1) - 1.0) * held.displaced) * integrate();
        const double near = harmonicTolerance * (lengthOf(held.next) + lengthOf(drivenRate_));
        const double nearPush =
            harmonicTolerance * (held.pushes.cwiseAbs().maxCoeff() + lengthOf(drivenRate_));
        forEachPinnedRelease(gap, place(), [&](Complex unit) {
            if ((held.pushes[j - 1] * given_.turn(1) * unit).real() >= -nearPush &&
                (held.next * unit).real() >= -near) {
                add(static_cast<double>(j), unit, held, held, true);
            }
        });
    }

    /// A contact of so many steps and the excitation |A| unit, if they are a motion.
    void add(double release, Complex unit, const HeldSteps& early, const HeldSteps& late,
             bool isPinned)
    {
        NetworkHarmonicMotion motion;
        motion.contact = contact_;
        motion.phase = -angleOf(unit);
        motion.release = release;
        motion.isPinned = isPinned;
        const bool isKnown = std::any_of(found_.begin(), found_.end(), [&](const auto& other) {
            return other.contact == contact_ && std::abs(other.release - release) <= sameContact &&
                   std::abs(std::remainder(other.phase - motion.phase, 2.0 * std::numbers::pi)) <=
                       sameContact;
        });
        if (isKnown || !pushesAll(unit, early)) {
            return;
        }
        motion.late = wavesOf(late.pushes, given_.amplitude * unit);
        motion.early = isPinned ? motion.late : wavesOf(early.pushes, given_.amplitude * unit);
        measure(given_, motion);
        if (motion.residual <= harmonicTolerance) {
            found_.push_back(std::move(motion));
        }
    }

    /// Does none of these steps pull where it begins? Most candidates end here.
    [[nodiscard]] bool pushesAll(Complex unit, const HeldSteps& held) const
    {
        const double near = 1e-6 * (held.pushes.cwiseAbs().maxCoeff() + lengthOf(drivenRate_));
        return std::all_of(held.pushes.begin(), held.pushes.end(),
                           [&](Complex push) { return (push * unit).real() >= -near; });
    }

    /// All waves at t = 0, in the order of Network::waves: what arrives in the steps to come.
    [[nodiscard]] std::vector<Complex> wavesOf(const Vector& pushes, Complex excitation) const
    {
        const std::int64_t n = given_.steps;
        Vector spectrum = Vector::Zero(n);
        for (std::int64_t k = 0; k < n; ++k) {
            for (std::int64_t i = 0; i < pushes.size(); ++i) {
                spectrum[k] += pushes[i] * std::conj(open_.power(k, i));
            }
        }
        const auto arriving = [&](Eigen::Index channel, std::int64_t m) {
            Complex sum = 0.0;
            for (std::int64_t k = 0; k < n; ++k) {
                sum += answers_(channel, k) * spectrum[k] * open_.power(k, m);
            }
            return excitation * (sum / static_cast<double>(n) + driven_[channel] * given_.turn(m));
        };
        std::vector<Complex> waves;
        const auto rows = static_cast<Eigen::Index>(given_.network.rows.size());
        for (Eigen::Index row = 0; row < rows; ++row) {
            const std::int64_t cells = open_.delays()[static_cast<std::size_t>(2 * row)];
            for (std::int64_t cell = cells; cell-- > 0;) {
                waves.push_back(arriving(2 * row, cell));
            }
            for (std::int64_t cell = 0; cell < cells; ++cell) {
                waves.push_back(arriving(2 * row + 1, cell));
            }
        }
        for (Eigen::Index channel = 2 * rows; channel < open_.channels(); ++channel) {
            waves.push_back(arriving(channel, 0));
        }
        return waves;
    }

    const HarmonicNetwork& given_;
    const OpenNetwork& open_;
    std::size_t contact_;
    std::vector<NetworkHarmonicMotion>& found_;
    Eigen::MatrixXcd answers_;   ///< what arrives, by channel and frequency, for a push of 1
    Vector driven_;              ///< what arrives in step 0 for A = 1
    Complex drivenRate_;         ///< Y
    std::vector<double> rates_;  ///< g
    std::vector<double> ways_;   ///< H
    std::vector<HeldSteps> held_;
};

void requireDecidable(const HarmonicNetwork& given)
{
    Faults faults;
    faults.requireWhole("steps", given.steps, maxHarmonicSteps);
    faults.requireWhole("cycles", given.cycles, std::max<std::int64_t>(1, given.steps / 2));
    faults.requirePositive("amplitude", given.amplitude, "-");
    faults.throwIfAny();
    const auto& nodes = given.network.nodes;
    const bool isForce = given.place == Excited::tip;
    if (std::none_of(nodes.begin(), nodes.end(), [isForce](const NetworkNode& node) {
            return isForce ? node.isDriven : node.isShaken;
        })) {
        throw std::invalid_argument(isForce ? "no node is driven" : "no clamp is shaken");
    }
    if (std::none_of(nodes.begin(), nodes.end(),
                     [](const NetworkNode& node) { return node.dashpot > 0.0; })) {
        throw std::invalid_argument("nothing is damped: there must be a dashpot");
    }
    if (std::any_of(given.network.bars.begin(), given.network.bars.end(),
                    [](const NetworkBar& bar) { return bar.drifts(); })) {
        throw std::invalid_argument(
            "a bar that nothing holds: its place does not follow from waves");
    }
}

}  // namespace

std::vector<NetworkHarmonicMotion> harmonicContacts(const HarmonicNetwork& given)
{
    requireDecidable(given);
    HarmonicNetwork still = given;
    still.network = underConstantForces(given.network);
    const OpenNetwork open(still);
    std::vector<NetworkHarmonicMotion> found;
    for (std::size_t contact = 0; contact < still.network.contacts.size(); ++contact) {
        NetworkContactSearch(still, open, contact, found).run();
    }
    std::sort(found.begin(), found.end(),
              [](const auto& x, const auto& y) { return x.impulse < y.impulse; });
    return found;
}

}  // namespace signorini
