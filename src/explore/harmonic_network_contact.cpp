#include "harmonic_network_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "faults.hpp"
#include "harmonic_network_walk.hpp"
#include "harmonic_release.hpp"
#include "network_sweep.hpp"
#include "open_network.hpp"

namespace signorini {

namespace {

using Complex = OpenNetwork::Complex;
using Vector = OpenNetwork::Vector;
using Eigen::Index;

constexpr double sameContact = 1e-7;  // motions nearer than this are one

/// Distances counted from the shape under constant forces. \throws std::invalid_argument.
HarmonicNetwork stillOf(const HarmonicNetwork& given)
{
    requireAsked(given, maxHarmonicSteps);
    const auto& nodes = given.network.nodes;
    if (std::none_of(nodes.begin(), nodes.end(),
                     [](const NetworkNode& node) { return node.dashpot > 0.0; })) {
        throw std::invalid_argument("nothing is damped: there must be a dashpot");
    }
    if (drifts(given.network)) {
        throw std::invalid_argument(
            "a bar that nothing holds: its place does not follow from waves");
    }
    HarmonicNetwork still = given;
    still.network = underConstantForces(given.network).network;
    return still;
}

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
        const auto n = static_cast<Index>(given.steps);
        const Vector sent = open.sentBy(contact);
        Vector rates(n);
        answers_.resize(open.channels(), n);
        answers_.col(0) = open.arrivingStill(contact);
        rates[0] = 0.0;
        for (Index k = 1; 2 * k <= n; ++k) {
            answers_.col(k) = open.arriving(k, sent);
            rates[k] = open.rateByPush(contact, answers_.col(k), contact);
            answers_.col(n - k) = answers_.col(k).conjugate();
            rates[n - k] = std::conj(rates[k]);
        }
        driven_ = open.arriving(given.cycles, open.sentByDrive());
        drivenRate_ = open.rateByDrive(contact, driven_);
        for (Index m = 0; m < n; ++m) {
            double sum = 0.0;
            for (Index k = 0; k < n; ++k) {
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
            way += open.compliance(contact, contact) / static_cast<double>(n) - mean;
        }
    }

    void run()
    {
        levinson();
        for (Index j = 1; j < given_.steps; ++j) {
            const auto i = static_cast<std::size_t>(j);
            addSmooth(j - 1, held_[i], held_[i - 1]);
            addPinned(j, held_[i]);
        }
    }

private:
    [[nodiscard]] double rateAfter(Index steps) const
    {
        const auto n = static_cast<Index>(given_.steps);
        return rates_[static_cast<std::size_t>((steps % n + n) % n)];
    }

    /// held_[j], j = 0 ... n - 1.
    void levinson()
    {
        Vector pushes(0);
        Eigen::VectorXd first(0);  // pushes with rate 1 in the first step, 0 in the others
        Eigen::VectorXd last(0);
        for (Index j = 0;; ++j) {
            Complex next = drivenRate_ * given_.turn(j);
            Complex displaced = 0.0;
            for (Index i = 0; i < j; ++i) {
                next += rateAfter(j - i) * pushes[i];
                displaced += ways_[static_cast<std::size_t>(given_.steps - 1 - i)] * pushes[i];
            }
            held_.push_back({pushes, displaced, next});
            if (j + 1 == given_.steps) {
                return;
            }
            double below = 0.0;
            double above = 0.0;
            for (Index i = 0; i < j; ++i) {
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
    void addSmooth(Index j, const HeldSteps& early, const HeldSteps& late)
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
    void addPinned(Index j, const HeldSteps& held)
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
        const auto n = static_cast<Index>(given_.steps);
        Vector spectrum = Vector::Zero(n);
        for (Index k = 0; k < n; ++k) {
            for (Index i = 0; i < pushes.size(); ++i) {
                spectrum[k] += pushes[i] * std::conj(open_.power(k, i));
            }
        }
        const auto arriving = [&](Index channel, Index m) {
            Complex sum = 0.0;
            for (Index k = 0; k < n; ++k) {
                sum += answers_(channel, k) * spectrum[k] * open_.power(k, m);
            }
            return excitation * (sum / static_cast<double>(n) + driven_[channel] * given_.turn(m));
        };
        std::vector<Complex> waves;
        const auto rows = static_cast<Index>(given_.network.rows.size());
        for (Index row = 0; row < rows; ++row) {
            const auto cells =
                static_cast<Index>(open_.delays()[static_cast<std::size_t>(2 * row)]);
            for (Index cell = cells; cell-- > 0;) {
                waves.push_back(arriving(2 * row, cell));
            }
            for (Index cell = 0; cell < cells; ++cell) {
                waves.push_back(arriving(2 * row + 1, cell));
            }
        }
        for (Index channel = 2 * rows; channel < open_.channels(); ++channel) {
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

}  // namespace

void requireAsked(const HarmonicNetwork& given, std::int64_t mostSteps)
{
    Faults faults;
    faults.requireWhole("steps", given.steps, mostSteps);
    faults.requireWhole("cycles", given.cycles, std::max<std::int64_t>(1, given.steps / 2));
    faults.requirePositive("amplitude", given.amplitude, "-");
    requireExcitable(faults, given.network, given.place);
    faults.throwIfAny();
}

bool drifts(const Network& network)
{
    return std::any_of(network.bars.begin(), network.bars.end(),
                       [](const NetworkBar& bar) { return bar.drifts(); });
}

std::vector<double> openDistances(const HarmonicNetwork& given)
{
    const HarmonicNetwork still = stillOf(given);
    const OpenNetwork open(still);
    const Vector driven = open.arriving(given.cycles, open.sentByDrive());
    std::vector<double> distances;
    for (std::size_t contact = 0; contact < still.network.contacts.size(); ++contact) {
        const double swing =
            given.amplitude / given.omega() * lengthOf(open.rateByDrive(contact, driven));
        distances.push_back(still.network.contacts[contact].gap - swing);
    }
    return distances;
}

std::vector<NetworkHarmonicMotion> harmonicContacts(const HarmonicNetwork& given)
{
    const HarmonicNetwork still = stillOf(given);
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
