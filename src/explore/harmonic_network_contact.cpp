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

namespace signorini {

namespace {

using Complex = OpenNetwork::Complex;

constexpr double sameContact = 1e-7;  // motions nearer than this are one

struct StillCase {
    HarmonicNetwork given;
    std::vector<double> displaced;  ///< the nodes, by constant forces
};

/// Distances counted from the shape under constant forces. \throws std::invalid_argument.
StillCase stillOf(const HarmonicNetwork& given)
{
    requireAsked(given, maxHarmonicSteps);
    const auto& nodes = given.network.nodes;
    if (std::none_of(nodes.begin(), nodes.end(),
                     [](const NetworkNode& node) { return node.dashpot > 0.0; })) {
        throw std::invalid_argument("nothing is damped: there must be a dashpot");
    }
    if (!driftingBars(given.network).empty()) {
        throw std::invalid_argument(
            "a bar that nothing holds: its place does not follow from waves");
    }
    StillNetwork still = underConstantForces(given.network);
    HarmonicNetwork moved = given;
    moved.network = std::move(still.network);
    return {std::move(moved), std::move(still.displacements)};
}

/// Pushes of a number of steps of contact, for A = 1.
struct HeldSteps {
    std::vector<Complex> pushes;  ///< Q_i
    Complex displaced;  ///< sum of H Q, by which the distance at the start is larger, d/ds
    Complex next;       ///< the rate in the step after it

    [[nodiscard]] double largestPush() const
    {
        return largestOf(pushes, [](Complex push) { return lengthOf(push); });
    }
};

/// Every length of one contact of a network.
class NetworkContactSearch {
public:
    NetworkContactSearch(const HarmonicNetwork& given, const OpenNetwork& open, std::size_t contact,
                         std::vector<NetworkHarmonicMotion>& found)
        : given_(given),
          contact_(contact),
          found_(found),
          answers_(given, open, contact, Drive::exactly),
          drivenRate_(-answers_.period().contacts.front().driven)
    {
    }

    void run()
    {
        GrowingContact growing(answers_.period());
        HeldSteps before{{}, 0.0, drivenRate_};
        while (growing.contact() + 1 < given_.steps) {
            growing.grow();
            HeldSteps held = heldBy(growing);
            addSmooth(growing.contact() - 1, held, before);
            addPinned(growing.contact(), held);
            before = std::move(held);
        }
    }

private:
    static HeldSteps heldBy(const GrowingContact& growing)
    {
        const auto complex = [](Plane plane) { return Complex(plane.c, plane.s); };
        HeldSteps held{{}, complex(growing.opened()), -complex(growing.speed(growing.contact()))};
        for (std::int64_t i = 0; i < growing.contact(); ++i) {
            held.pushes.push_back(complex(growing.push(i)));
        }
        return held;
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
            (early.displaced - late.displaced) * integrate(), early.pushes.back(), place(),
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
        const double nearPush = harmonicTolerance * (held.largestPush() + lengthOf(drivenRate_));
        forEachPinnedRelease(gap, place(), [&](Complex unit) {
            if ((held.pushes.back() * given_.turn(1) * unit).real() >= -nearPush &&
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
        const double force = 2.0 * largestOf(given_.network.rows, &CellRow::impedance) *
                             largestOf(motion.late, [](Complex wave) { return lengthOf(wave); });
        if (motion.residual <= harmonicTolerance && motion.peakForce > harmonicTolerance * force) {
            found_.push_back(std::move(motion));
        }
    }

    /// Does none of these steps pull where it begins? Most candidates end here.
    [[nodiscard]] bool pushesAll(Complex unit, const HeldSteps& held) const
    {
        const double near = 1e-6 * (held.largestPush() + lengthOf(drivenRate_));
        return std::all_of(held.pushes.begin(), held.pushes.end(),
                           [&](Complex push) { return (push * unit).real() >= -near; });
    }

    /// All waves at t = 0.
    [[nodiscard]] std::vector<Complex> wavesOf(const std::vector<Complex>& pushes,
                                               Complex excitation) const
    {
        std::vector<Complex> waves = answers_.wavesOf(pushes);
        for (Complex& wave : waves) {
            wave *= excitation;
        }
        return waves;
    }

    const HarmonicNetwork& given_;
    std::size_t contact_;
    std::vector<NetworkHarmonicMotion>& found_;
    ContactAnswers answers_;
    Complex drivenRate_;  ///< Y
};

}  // namespace

std::vector<double> openDistances(const HarmonicNetwork& given)
{
    const HarmonicNetwork still = stillOf(given).given;
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
    const auto [still, displaced] = stillOf(given);
    const OpenNetwork open(still);
    std::vector<NetworkHarmonicMotion> found;
    for (std::size_t contact = 0; contact < still.network.contacts.size(); ++contact) {
        NetworkContactSearch(still, open, contact, found).run();
    }
    for (NetworkHarmonicMotion& motion : found) {
        measureStrains(still, displaced, motion);
        motion.growth = growthOf(still, motion);
    }
    std::sort(found.begin(), found.end(),
              [](const auto& x, const auto& y) { return x.impulse < y.impulse; });
    return found;
}

}  // namespace signorini
