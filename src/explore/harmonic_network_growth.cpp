#include "harmonic_network_growth.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "contact_spans.hpp"
#include "harmonic_motion.hpp"
#include "largest.hpp"
#include "late_contacts.hpp"
#include "portable.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

constexpr int watchedPeriods = 401;  // in which waves between fronts fade

/// Waves that last so short, and how far they have moved the first nodes of bars that drift.
struct Front {
    NetworkWaves<double> waves;
    std::vector<double> drifts;
};

class NetworkFronts {
public:
    NetworkFronts(const HarmonicNetwork& given, const NetworkHarmonicMotion& motion)
        : given_(given),
          motion_(motion),
          unforced_(withoutForces(given.network)),
          contact_(given.network.contacts[motion.first().contact]),
          bars_(driftingBars(given.network)),
          open_(unforced_, 0),
          closed_(unforced_, ContactSet{1} << motion.first().contact),
          held_(static_cast<std::int64_t>(std::floor(motion.first().end)))
    {
        const Complex drive = given.amplitude * turned(-motion.phase);
        startFront(drive);
        if (motion.first().isPinned) {
            findPushes(drive);
        }
    }

    [[nodiscard]] OrderedGrowth growth(const FrontOrders& orders) const
    {
        bool isMet = false;
        std::vector<double> weights{1.0};
        Front front{{unforced_, front_}, drifts_};
        bool isNewest = motion_.first().isPinned;
        const double whole = sizeOf(front_);
        const double unit = distanceBy(front);
        double last = 1.0;
        while (sizeOf(front.waves.waves()) > faded * whole) {
            if (weights.size() == mostTerms) {
                return {std::nullopt};
            }
            aPeriodLater(front, orders, isNewest, isMet);
            const double weight = distanceBy(front) / unit;
            // What stays of a bar's place does so in all later periods: their differences count.
            weights.push_back(bars_.empty() ? weight : weight - last);
            last = weight;
        }
        return {growthOfLate(weights, weights.size(), 1), isMet};
    }

    /// Of waves that meet no event.
    [[nodiscard]] double fading() const
    {
        double most = fadingOf(held_);
        if (!motion_.first().isPinned) {
            most = std::max(most, fadingOf(held_ + 1));
        }
        return most;
    }

private:
    static double sizeOf(const std::vector<double>& waves) { return largestSizeOf(waves); }

    /// The distance of the contact with waves that nothing else moves.
    [[nodiscard]] double distanceBy(const Front& front) const
    {
        const std::vector<double> places =
            displacementsOf(unforced_, front.waves.waves(), front.drifts);
        return openingOf(contact_, [&](std::size_t node) { return places[node]; });
    }

    /// What an open network sends beyond what a closed one does as contact begins.
    void startFront(Complex drive)
    {
        const std::vector<SteadyHarmonic>& early = motion_.lanes.front().waves;
        std::vector<double> waves(early.size());
        std::transform(early.begin(), early.end(), waves.begin(),
                       [](const SteadyHarmonic& wave) { return wave.steady + wave.swing.real(); });
        const HarmonicNetwork::Drive now = given_.drive(drive);
        const auto sent = [&](ContactSet closed) {
            const NetworkLaw<double> law(given_.network, closed);
            Front front{{given_.network, waves}, std::vector<double>(bars_.size(), 0.0)};
            step(front, law, now.force.real(), now.base.real());
            return front;
        };
        const Front open = sent(0);
        const Front closed = sent(ContactSet{1} << motion_.first().contact);
        const auto without = [](std::vector<double> all, const std::vector<double>& part) {
            std::transform(all.begin(), all.end(), part.begin(), all.begin(), std::minus<>());
            return all;
        };
        front_ = without(open.waves.waves(), closed.waves.waves());
        drifts_ = without(open.drifts, closed.drifts);
    }

    void step(Front& front, const NetworkLaw<double>& law, double force = 0.0,
              double base = 0.0) const
    {
        for (std::size_t k = 0; k < bars_.size(); ++k) {
            const std::size_t node = given_.network.bars[bars_[k]].firstNode;
            front.drifts[k] += law.velocity(node).at(front.waves.arriving(), force, base);
        }
        front.waves.step(law, force, base);
    }

    /// The pushes before and after the front that ends the contact.
    void findPushes(Complex drive)
    {
        const NetworkLaw<SteadyHarmonic> closed(given_.network,
                                                ContactSet{1} << motion_.first().contact);
        NetworkWaves<SteadyHarmonic> waves(given_.network, motion_.lanes.back().waves);
        for (std::int64_t m = 0;; ++m) {
            const HarmonicNetwork::Drive now = given_.drive(drive * given_.turn(m));
            const SteadyHarmonic force(0.0, now.force);
            const SteadyHarmonic base(0.0, now.base);
            const SteadyHarmonic push =
                closed.push(motion_.first().contact).at(waves.arriving(), force, base);
            if (m == held_) {
                pushAfter_ = push.steady + push.swing.real();
                return;
            }
            pushBefore_ = push.steady + (push.swing * given_.turn(1)).real();
            waves.step(closed, force, base);
        }
    }

    /// One step in which a part meets the closed network.
    void stepBoth(Front& front, double closedPart) const
    {
        Front open = front;
        step(front, closed_);
        step(open, open_);
        const auto mixed = [closedPart](std::vector<double> both,
                                        const std::vector<double>& other) {
            for (std::size_t i = 0; i < both.size(); ++i) {
                both[i] = closedPart * both[i] + (1.0 - closedPart) * other[i];
            }
            return both;
        };
        front = {{unforced_, mixed(front.waves.waves(), open.waves.waves())},
                 mixed(front.drifts, open.drifts)};
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
    void aPeriodLater(Front& front, const FrontOrders& orders, bool& isNewest, bool& isMet) const
    {
        for (std::int64_t m = 1; m < given_.steps; ++m) {
            if (m != held_ || !motion_.first().isPinned) {
                step(front, m <= held_ ? closed_ : open_);
                continue;
            }
            const double push =
                closed_.push(motion_.first().contact).at(front.waves.arriving(), 0.0, 0.0);
            const double near = 1e-9 * std::abs(pushBefore_ - pushAfter_);
            if (isNewest && std::abs(push) > near) {
                stepBoth(front, closedPart(push, orders.isLateAtRelease));
                isNewest = false;
            } else {
                step(front, orders.isLateAtRelease ? open_ : closed_);
            }
        }
        const double push =
            closed_.push(motion_.first().contact).at(front.waves.arriving(), 0.0, 0.0);
        isMet = isMet || push != 0.0;
        step(front, orders.isLateAtContact ? closed_ : open_);
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
            NetworkWaves<double> waves(unforced_, std::move(start));
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
    Network unforced_;
    const NetworkContact& contact_;
    std::vector<std::size_t> bars_;  ///< that drift
    NetworkLaw<double> open_;
    NetworkLaw<double> closed_;
    std::int64_t held_;          ///< j
    std::vector<double> front_;  ///< after the step in which contact begins
    std::vector<double> drifts_;
    double pushBefore_ = 0.0;
    double pushAfter_ = 0.0;
};

}  // namespace

std::optional<double> growthOf(const HarmonicNetwork& given, const NetworkHarmonicMotion& motion)
{
    const std::size_t drifting = driftingBars(given.network).size();
    if (drifting > 0 && (drifting > 1 || driftsOf(given.network, motion.first().contact).empty())) {
        return std::nullopt;  // a bar without contact never comes back to its place
    }
    const NetworkFronts fronts(given, motion);
    const std::optional<double> growth = growthOfOrders(
        motion.first().isPinned, [&](const FrontOrders& orders) { return fronts.growth(orders); });
    if (!growth || *growth >= 1.0) {
        return growth;
    }
    // Waves that nothing sends never grow.
    return std::max(*growth, fronts.fading());
}

}  // namespace signorini
