#include "harmonic_network_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "contact_answers.hpp"
#include "contact_spans.hpp"
#include "harmonic_network_growth.hpp"
#include "harmonic_network_walk.hpp"
#include "harmonic_release.hpp"
#include "largest.hpp"
#include "statics.hpp"

namespace signorini {

namespace {

using Complex = OpenNetwork::Complex;

constexpr double sameContact = 1e-7;  // motions nearer than this are one

}  // namespace

StillCase stillOf(const HarmonicNetwork& given)
{
    requireAsked(given, maxHarmonicSteps);
    const auto& nodes = given.network.nodes;
    if (std::none_of(nodes.begin(), nodes.end(),
                     [](const NetworkNode& node) { return node.dashpot > 0.0; })) {
        throw std::invalid_argument("nothing is damped: there must be a dashpot");
    }
    StillNetwork still = underConstantForces(given.network);
    HarmonicNetwork moved = given;
    moved.network = std::move(still.network);
    HarmonicNetwork unforced = given;
    unforced.network = withoutForces(moved.network);
    return {std::move(moved), std::move(unforced), std::move(still.displacements)};
}

namespace {

/// Constant forces on bars that drift, by node.
std::vector<double> forcesOf(const Network& network)
{
    std::vector<double> forces;
    forces.reserve(network.nodes.size());
    for (const NetworkNode& node : network.nodes) {
        forces.push_back(network.bars[node.bar].drifts() ? node.force : 0.0);
    }
    return forces;
}

/// Pushes of a number of steps of contact, for |A| = 1; swings are for A = 1.
struct HeldSteps {
    std::vector<SteadyHarmonic> pushes;  ///< P_i and Q_i
    /// The distance at the start without the drive, the swing negative and d/ds: gap and sum of H
    /// Q. Where a bar drifts the mean rate of the distance: V.
    SteadyHarmonic left;
    SteadyHarmonic next;  ///< the rate in the step after it

    [[nodiscard]] double largestPush() const { return largestOf(pushes, &SteadyHarmonic::largest); }
};

/// Every length of one contact of a network.
class NetworkContactSearch {
public:
    /// \pre a mean push that momentum allows [Z_1 delta/h].
    NetworkContactSearch(const StillCase& still, const OpenNetwork& open, std::size_t contact,
                         double meanPush, std::vector<NetworkHarmonicMotion>& found)
        : given_(still.given),
          contact_(contact),
          found_(found),
          answers_(still.unforced, open, contact, Drive::exactly),
          drivenRate_(-answers_.period().contacts.front().driven),
          meanPush_(meanPush / given_.amplitude),
          driftRate_(open.driftRate(contact)),
          undamped_(given_.network.bars.size(), 0.0)
    {
        std::vector<double> forces = forcesOf(given_.network);
        for (double& force : forces) {
            force /= given_.amplitude;
        }
        double count = 0.0;
        forEachSide(given_.network.contacts[contact], [&](std::size_t node, int sign) {
            forces[node] += sign * meanPush_;
            const std::size_t bar = given_.network.nodes[node].bar;
            if (given_.network.bars[bar].drifts() && open.dashpotsOf(bar) == 0.0) {
                undamped_[bar] = sign;
                count += 1.0;
            }
        });
        isUndamped_ = count > 0.0;
        for (double& way : undamped_) {
            way /= std::max(count, 1.0);
        }
        const std::vector<double> none(given_.network.nodes.size(), 0.0);
        even_ = open.evenWaves(open.shapeUnder(forces), none);
        const OpenNetwork::Vector pushed = open.arrivingStill(contact);
        for (std::size_t channel = 0; channel < even_.size(); ++channel) {
            even_[channel] -= meanPush_ * pushed[static_cast<Eigen::Index>(channel)].real();
        }
        undampedWaves_ = open.evenWaves(none, undamped_);
    }

    void run()
    {
        GrowingContact growing(answers_.period());
        ContactPeriod period = answers_.period();
        period.cycles = 0;
        period.contacts.front().driven = 1.0;
        period.usual = 1.0;
        GrowingContact resting(period);
        std::optional<HeldSteps> before = heldBy(growing, resting);
        while (growing.contact() + 1 < given_.steps) {
            growing.grow();
            if (isDrifting()) {
                resting.grow();
            }
            std::optional<HeldSteps> held = heldBy(growing, resting);
            if (held && before) {
                addSmooth(growing.contact() - 1, *held, *before);
            }
            if (held) {
                addPinned(growing.contact(), *held);
            }
            before = std::move(held);
        }
    }

private:
    [[nodiscard]] bool isDrifting() const { return driftRate_ > 0.0; }

    /// None if a bar without dashpots would lose momentum.
    [[nodiscard]] std::optional<HeldSteps> heldBy(const GrowingContact& growing,
                                                  const GrowingContact& resting) const
    {
        const auto complex = [](Plane plane) { return Complex(plane.c, plane.s); };
        HeldSteps held{{},
                       SteadyHarmonic(-place(), complex(growing.opened())),
                       SteadyHarmonic(0.0, -complex(growing.speed(growing.contact())))};
        Complex sum = 0.0;
        for (std::int64_t i = 0; i < growing.contact(); ++i) {
            held.pushes.emplace_back(0.0, complex(growing.push(i)));
            sum += complex(growing.push(i));
        }
        return isDrifting() ? drifting(std::move(held), sum, resting) : std::optional(held);
    }

    /// With pushes beside that open the contact at a steady rate -V: `resting` has those for 1.
    [[nodiscard]] std::optional<HeldSteps> drifting(HeldSteps held, Complex sum,
                                                    const GrowingContact& resting) const
    {
        const auto steps = static_cast<double>(given_.steps);
        double resisted = 0.0;
        for (std::int64_t i = 0; i < resting.contact(); ++i) {
            resisted += resting.push(i).c;
        }
        if (isUndamped_ && resisted == 0.0) {
            return std::nullopt;
        }
        const SteadyHarmonic speed =
            isUndamped_ ? SteadyHarmonic(-steps * meanPush_ / resisted, sum / resisted)
                        : SteadyHarmonic(-driftRate_ * meanPush_);
        for (std::size_t i = 0; i < held.pushes.size(); ++i) {
            const double push = resting.push(static_cast<std::int64_t>(i)).c;
            held.pushes[i] = held.pushes[i] - push * speed;
        }
        held.left = speed + (driftRate_ / steps) * (SteadyHarmonic(0.0, sum) - resisted * speed);
        held.next = held.next + resting.speed(resting.contact()).c * speed;
        return held;
    }

    /// What the drive makes of the distance, or of its mean rate.
    [[nodiscard]] Complex startRate() const { return isDrifting() ? 0.0 : drivenRate_; }
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
            (startRate() + given_.turn(1) * late.left.swing - early.left.swing) * integrate(),
            (early.left.swing - late.left.swing) * integrate(),
            early.pushes.back().swing,
            -late.left.steady,
            given_.omega(),
            late.left.steady - early.left.steady,
            early.pushes.back().steady};
        const auto visit = [&](double part, Complex unit) {
            if (part > 0.0 && part < 1.0) {
                add(static_cast<double>(j) + part, unit, early, late, false);
            }
        };
        if (isDrifting()) {
            forEachLoadedRelease(cell, visit);
        } else {
            forEachSmoothRelease(cell, visit);
        }
    }

    /// tau = j, where a front ends the contact.
    void addPinned(std::int64_t j, const HeldSteps& held)
    {
        const Complex gap = (startRate() + (given_.turn(1) - 1.0) * held.left.swing) * integrate();
        const double near = harmonicTolerance * (std::abs(held.next.steady) +
                                                 lengthOf(held.next.swing) + lengthOf(drivenRate_));
        const double nearPush = harmonicTolerance * (held.largestPush() + lengthOf(drivenRate_));
        forEachPinnedRelease(gap, -held.left.steady, [&](Complex unit) {
            if (held.pushes.back().at(given_.turn(1) * unit) >= -nearPush &&
                held.next.at(unit) >= -near) {
                add(static_cast<double>(j), unit, held, held, true);
            }
        });
    }

    /// A contact of so many steps and the excitation |A| unit, if they are a motion.
    void add(double release, Complex unit, const HeldSteps& early, const HeldSteps& late,
             bool isPinned)
    {
        NetworkHarmonicMotion motion;
        motion.phase = -angleOf(unit);
        motion.contacts = {{.contact = contact_, .end = release, .isPinned = isPinned}};
        const bool isKnown = std::any_of(found_.begin(), found_.end(), [&](const auto& other) {
            return other.first().contact == contact_ &&
                   std::abs(other.first().end - release) <= sameContact &&
                   std::abs(std::remainder(other.phase - motion.phase, 2.0 * std::numbers::pi)) <=
                       sameContact;
        });
        if (isKnown || !pushesAll(unit, early)) {
            return;
        }
        const double part = release - std::floor(release);
        if (part > 0.0) {
            motion.lanes.push_back({0.0, part, wavesOf(early, unit)});
        }
        motion.lanes.push_back({part, 1.0, wavesOf(late, unit)});
        measure(given_, motion);
        const double force = 2.0 * largestOf(given_.network.rows, &CellRow::impedance) *
                             largestOf(motion.lanes.back().waves, [](const SteadyHarmonic& wave) {
                                 return lengthOf(wave.swing);
                             });
        if (motion.residual <= harmonicTolerance && motion.peakForce > harmonicTolerance * force) {
            found_.push_back(std::move(motion));
        }
    }

    /// Does none of these steps pull where it begins? Most candidates end here.
    [[nodiscard]] bool pushesAll(Complex unit, const HeldSteps& held) const
    {
        const double near = 1e-6 * (held.largestPush() + lengthOf(drivenRate_));
        return std::all_of(held.pushes.begin(), held.pushes.end(),
                           [&](const SteadyHarmonic& push) { return push.at(unit) >= -near; });
    }

    /// All waves at t = 0.
    [[nodiscard]] std::vector<SteadyHarmonic> wavesOf(const HeldSteps& held, Complex unit) const
    {
        const auto excited = [&](const SteadyHarmonic& value) {
            return SteadyHarmonic(given_.amplitude * value.steady,
                                  given_.amplitude * unit * value.swing);
        };
        std::vector<SteadyHarmonic> even;
        even.reserve(even_.size());
        for (std::size_t channel = 0; channel < even_.size(); ++channel) {
            even.push_back(
                excited(SteadyHarmonic(even_[channel]) + undampedWaves_[channel] * held.left));
        }
        std::vector<SteadyHarmonic> pushes;
        pushes.reserve(held.pushes.size());
        for (const SteadyHarmonic& push : held.pushes) {
            pushes.push_back(excited(push));
        }
        return answers_.wavesOf(given_.amplitude * unit, pushes, even);
    }

    const HarmonicNetwork& given_;
    std::size_t contact_;
    std::vector<NetworkHarmonicMotion>& found_;
    ContactAnswers answers_;
    Complex drivenRate_;            ///< Y
    double meanPush_;               ///< p
    double driftRate_;              ///< sum of 1/D
    std::vector<double> undamped_;  ///< speeds of bars without dashpots as the distance grows by 1
    bool isUndamped_ = false;
    std::vector<double> even_;  ///< by channel: what pushes of p in all steps leave of forces
    std::vector<double> undampedWaves_;
};

}  // namespace

std::optional<double> meanPushOf(const Network& network, std::size_t contact)
{
    constexpr double rounding = 1e-12;
    auto [forces, size] = driftForces(network);
    std::optional<double> push;
    for (const auto& [bar, sign] : driftsOf(network, contact)) {
        const double needed = -sign * forces[static_cast<std::size_t>(bar)];
        if (!(needed > rounding * size) ||
            (push && !(std::abs(needed - *push) <= rounding * size))) {
            return std::nullopt;
        }
        push = needed;
        forces[static_cast<std::size_t>(bar)] = 0.0;
    }
    return largestSizeOf(forces) > rounding * size ? std::nullopt
                                                   : std::optional(push.value_or(0.0));
}

std::optional<std::vector<double>> openDistances(const HarmonicNetwork& given)
{
    const StillCase moved = stillOf(given);
    const std::vector<double> forces = forcesOf(moved.given.network);
    if (largestSizeOf(forces) > 0.0) {
        return std::nullopt;
    }
    const HarmonicNetwork& still = moved.given;
    const OpenNetwork open(still);
    const OpenNetwork::Vector driven = open.arriving(given.cycles, open.sentByDrive());
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
    const StillCase still = stillOf(given);
    const OpenNetwork open(still.unforced);
    std::vector<NetworkHarmonicMotion> found;
    for (std::size_t contact = 0; contact < given.network.contacts.size(); ++contact) {
        if (const auto push = meanPushOf(still.given.network, contact)) {
            NetworkContactSearch(still, open, contact, *push, found).run();
        }
    }
    for (NetworkHarmonicMotion& motion : found) {
        measureStrains(still.given, still.displaced, motion);
        motion.growth = growthOf(still.given, motion);
    }
    std::sort(found.begin(), found.end(),
              [](const auto& x, const auto& y) { return x.impulse < y.impulse; });
    return found;
}

}  // namespace signorini
