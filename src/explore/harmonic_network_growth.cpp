#include "harmonic_network_growth.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "harmonic_motion.hpp"
#include "largest.hpp"
#include "late_contacts.hpp"
#include "portable.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

constexpr int watchedPeriods = 401;  // in which waves between fronts fade

class NetworkFronts {
public:
    NetworkFronts(const HarmonicNetwork& given, const NetworkHarmonicMotion& motion)
        : given_(given),
          motion_(motion),
          contact_(given.network.contacts[motion.contact]),
          open_(given.network, 0),
          closed_(given.network, ContactSet{1} << motion.contact),
          held_(static_cast<std::int64_t>(std::floor(motion.release)))
    {
        const Complex drive = given.amplitude * turned(-motion.phase);
        startFront(drive);
        if (motion.isPinned) {
            findPushes(drive);
        }
    }

    [[nodiscard]] OrderedGrowth growth(const FrontOrders& orders) const
    {
        bool isMet = false;
        std::vector<double> weights{1.0};
        std::vector<double> front = front_;
        bool isNewest = motion_.isPinned;
        const double whole = sizeOf(front);
        const double unit = distanceBy(front);
        while (sizeOf(front) > faded * whole) {
            if (weights.size() == mostTerms) {
                return {std::nullopt};
            }
            front = aPeriodLater(std::move(front), orders, isNewest, isMet);
            weights.push_back(distanceBy(front) / unit);
        }
        return {growthOfLate(weights, weights.size(), 1), isMet};
    }

    /// Of waves that meet no event.
    [[nodiscard]] double fading() const
    {
        double most = fadingOf(held_);
        if (!motion_.isPinned) {
            most = std::max(most, fadingOf(held_ + 1));
        }
        return most;
    }

private:
    static double sizeOf(const std::vector<double>& waves) { return largestSizeOf(waves); }

    /// The distance of the contact with waves that nothing else moves.
    [[nodiscard]] double distanceBy(const std::vector<double>& waves) const
    {
        const std::vector<double> places = displacementsOf(given_.network, waves, {});
        return openingOf(contact_, [&](std::size_t node) { return places[node]; });
    }

    /// What an open network sends beyond what a closed one does as contact begins.
    void startFront(Complex drive)
    {
        std::vector<double> waves(motion_.early.size());
        std::transform(motion_.early.begin(), motion_.early.end(), waves.begin(),
                       [](Complex wave) { return wave.real(); });
        const HarmonicNetwork::Drive now = given_.drive(drive);
        const auto sent = [&](const NetworkLaw<double>& law) {
            NetworkWaves<double> moving(given_.network, waves);
            moving.step(law, now.force.real(), now.base.real());
            return moving.waves();
        };
        front_ = sent(open_);
        const std::vector<double> closed = sent(closed_);
        for (std::size_t i = 0; i < front_.size(); ++i) {
            front_[i] -= closed[i];
        }
    }

    /// The pushes before and after the front that ends the contact.
    void findPushes(Complex drive)
    {
        const NetworkLaw<Complex> closed(given_.network, ContactSet{1} << motion_.contact);
        NetworkWaves<Complex> waves(given_.network, motion_.late);
        for (std::int64_t m = 0;; ++m) {
            const auto [force, base] = given_.drive(drive * given_.turn(m));
            const Complex push = closed.push(motion_.contact).at(waves.arriving(), force, base);
            if (m == held_) {
                pushAfter_ = push.real();
                return;
            }
            pushBefore_ = (push * given_.turn(1)).real();
            waves.step(closed, force, base);
        }
    }

    /// One step in which a part meets the closed network.
    void stepBoth(NetworkWaves<double>& waves, double closedPart) const
    {
        NetworkWaves<double> other = waves;
        waves.step(closed_, 0.0, 0.0);
        other.step(open_, 0.0, 0.0);
        std::vector<double> both = waves.waves();
        const std::vector<double> open = other.waves();
        for (std::size_t i = 0; i < both.size(); ++i) {
            both[i] = closedPart * both[i] + (1.0 - closedPart) * open[i];
        }
        waves = NetworkWaves<double>(given_.network, std::move(both));
    }

    /// q_-/(q_- + |q_+|) where the newest front arrives, which has this push for each unit of time.
    [[nodiscard]] double closedPart(double push, bool isLateAtRelease) const
    {
        const double before = isLateAtRelease ? pushBefore_ : pushAfter_ + push;
        const double after = std::abs(isLateAtRelease ? pushBefore_ - push : pushAfter_);
        return before / (before + after);
    }

    /// From just after the beginning of contact to the next. `isNewest` until this front, the
    /// newest of all, has been at the end of a contact. `isMet` once it comes just as contact
    /// begins.
    [[nodiscard]] std::vector<double> aPeriodLater(std::vector<double> front,
                                                   const FrontOrders& orders, bool& isNewest,
                                                   bool& isMet) const
    {
        NetworkWaves<double> waves(given_.network, std::move(front));
        for (std::int64_t m = 1; m < given_.steps; ++m) {
            if (m != held_ || !motion_.isPinned) {
                waves.step(m <= held_ ? closed_ : open_, 0.0, 0.0);
                continue;
            }
            const double push = closed_.push(motion_.contact).at(waves.arriving(), 0.0, 0.0);
            const double near = 1e-9 * std::abs(pushBefore_ - pushAfter_);
            if (isNewest && std::abs(push) > near) {
                stepBoth(waves, closedPart(push, orders.isLateAtRelease));
                isNewest = false;
            } else {
                waves.step(orders.isLateAtRelease ? open_ : closed_, 0.0, 0.0);
            }
        }
        isMet = isMet || closed_.push(motion_.contact).at(waves.arriving(), 0.0, 0.0) != 0.0;
        waves.step(orders.isLateAtContact ? closed_ : open_, 0.0, 0.0);
        return waves.waves();
    }

    /// Growth in the second half of many periods of so many steps of contact.
    [[nodiscard]] double fadingOf(std::int64_t held) const
    {
        std::mt19937_64 generator(1);
        std::uniform_real_distribution<double> any(-1.0, 1.0);
        std::vector<double> start(given_.network.waves());
        std::generate(start.begin(), start.end(), [&] { return any(generator); });
        double grown = 0.0;  // log
        double slope = 0.0;  // of it, by least squares over the second half
        double spread = 0.0;
        for (int k = 0; k < watchedPeriods; ++k) {
            NetworkWaves<double> waves(given_.network, std::move(start));
            for (std::int64_t m = 0; m < given_.steps; ++m) {
                waves.step(m < held ? closed_ : open_, 0.0, 0.0);
            }
            start = waves.waves();
            const double size = sizeOf(start);
            if (!(size > 0.0)) {
                return 0.0;
            }
            grown += portable::log(size);
            const double late = static_cast<double>(k) - 0.75 * (watchedPeriods - 1);
            if (2 * k >= watchedPeriods - 1) {
                slope += late * grown;
                spread += late * late;
            }
            for (double& wave : start) {
                wave /= size;
            }
        }
        return portable::exp(slope / spread);
    }

    const HarmonicNetwork& given_;
    const NetworkHarmonicMotion& motion_;
    const NetworkContact& contact_;
    NetworkLaw<double> open_;
    NetworkLaw<double> closed_;
    std::int64_t held_;          ///< j
    std::vector<double> front_;  ///< after the step in which contact begins
    double pushBefore_ = 0.0;
    double pushAfter_ = 0.0;
};

}  // namespace

std::optional<double> growthOf(const HarmonicNetwork& given, const NetworkHarmonicMotion& motion)
{
    const NetworkFronts fronts(given, motion);
    const std::optional<double> growth = growthOfOrders(
        motion.isPinned, [&](const FrontOrders& orders) { return fronts.growth(orders); });
    if (!growth || *growth >= 1.0) {
        return growth;
    }
    // Waves that nothing sends never grow.
    return std::max(*growth, fronts.fading());
}

}  // namespace signorini
