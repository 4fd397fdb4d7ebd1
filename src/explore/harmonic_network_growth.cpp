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

constexpr int watchedPeriods = 401;   // in which waves between fronts fade
constexpr double sameInstant = 1e-9;  // steps
constexpr double noFront = 1e-9;      // of what all fronts at a release change
constexpr std::size_t isOpen = ~std::size_t{0};

/// Waves that last so short, and how far they have moved the first nodes of bars that drift.
struct Front {
    NetworkWaves<double> waves;
    std::vector<double> drifts;
};

/// What a front meets in a step.
struct Passing {
    ContactSet closed = 0;
    ContactSet beginning = 0;     ///< just then
    std::size_t ending = isOpen;  ///< the contact of the motion that a front ends just then
};

/// The waves of a lane at one time.
struct Moment {
    NetworkWaves<SteadyHarmonic> waves;
    Complex turn;  ///< e^{i omega s}
    SteadyHarmonic force;
    SteadyHarmonic base;
    ContactSet closed = 0;  ///< in this step of the lane
};

class NetworkFronts {
public:
    NetworkFronts(const HarmonicNetwork& given, const NetworkHarmonicMotion& motion)
        : given_(given),
          motion_(motion),
          contacts_(motion.contacts),
          unforced_(withoutForces(given.network)),
          bars_(driftingBars(given.network)),
          laws_(unforced_),
          forced_(given.network)
    {
        NetworkLaws<SteadyHarmonic> driven(given.network);
        for (const NetworkHarmonicContact& one : contacts_) {
            std::vector<Passing>& met = met_.emplace_back();
            met.reserve(static_cast<std::size_t>(given.steps));
            for (std::int64_t i = 0; i < given.steps; ++i) {
                met.push_back(passingAt(one.begin + static_cast<double>(i)));
            }
            starts_.push_back(frontOf(one, met.front(), driven));
            pushes_.push_back(one.isPinned ? pushesAt(one, driven) : std::pair(1.0, -1.0));
            units_.push_back(distanceBy(starts_.back(), one));
        }
    }

    /// Do events that are simultaneous know nothing of each other?
    [[nodiscard]] bool areApart() const { return areApart_; }

    [[nodiscard]] OrderedGrowth growth(const FrontOrders& orders)
    {
        const std::size_t count = contacts_.size();
        Course course{orders, starts_, std::vector(count, false), std::vector(count, false),
                      std::vector<std::vector<double>>(count * count)};
        for (std::int64_t travel = 0;; ++travel) {
            for (std::size_t j = 0; j < count && travel > 0; ++j) {
                if (!course.hasFaded[j]) {
                    pass(j, met_[j][static_cast<std::size_t>(travel % given_.steps)], course);
                }
            }
            enter(travel, course);
            if (travel % given_.steps != 0) {
                continue;
            }
            for (std::size_t j = 0; j < count; ++j) {
                course.hasFaded[j] = sizeOf(course.fronts[j]) <= faded * sizeOf(starts_[j]);
            }
            if (std::find(course.hasFaded.begin(), course.hasFaded.end(), false) ==
                course.hasFaded.end()) {
                const std::vector<double> weights = weightsOf(course);
                return {growthOfLate(weights, weights.size() / (count * count), count),
                        course.isMet};
            }
            if (travel >= static_cast<std::int64_t>(mostTerms) * given_.steps) {
                return {std::nullopt};
            }
        }
    }

    /// Of waves that meet no event.
    [[nodiscard]] double fading()
    {
        double most = 0.0;
        for (const HarmonicLane& lane : motion_.lanes) {
            most = std::max(most, fadingOf(lane));
        }
        return most;
    }

private:
    /// Fronts of all beginnings, so many steps later.
    struct Course {
        FrontOrders orders;
        std::vector<Front> fronts;
        std::vector<bool> hasFaded;
        std::vector<bool> isPinned;  ///< has the newest front that ends this contact come?
        /// What front j makes of the distance of contact k in each period, at k count + j.
        std::vector<std::vector<double>> seen;
        bool isMet = false;  ///< has a front come just as a contact begins?
    };

    static double sizeOf(const Front& front) { return largestSizeOf(front.waves.waves()); }

    [[nodiscard]] static bool isSame(double time, double other, double period)
    {
        return std::abs(std::remainder(time - other, period)) < sameInstant;
    }

    [[nodiscard]] bool isClosed(const NetworkHarmonicContact& one, double time) const
    {
        const auto period = static_cast<double>(given_.steps);
        const double since = time - one.begin;
        return since - period * std::floor(since / period) < one.end - one.begin;
    }

    /// What is closed, begins and is ended by a front.
    [[nodiscard]] Passing passingAt(double time)
    {
        const auto period = static_cast<double>(given_.steps);
        Passing passing;
        for (std::size_t k = 0; k < contacts_.size(); ++k) {
            const NetworkHarmonicContact& one = contacts_[k];
            const ContactSet bit = ContactSet{1} << one.contact;
            if (isSame(time, one.begin, period)) {
                passing.beginning |= bit;
            } else if (one.isPinned && isSame(time, one.end, period)) {
                areApart_ = areApart_ && passing.ending == isOpen;
                passing.ending = k;
            } else if (isClosed(one, time)) {
                passing.closed |= bit;
            }
        }
        return passing;
    }

    [[nodiscard]] ContactSet closedIn(const HarmonicLane& lane, std::int64_t step) const
    {
        const double time = static_cast<double>(step) + 0.5 * (lane.from + lane.to);
        ContactSet closed = 0;
        for (const NetworkHarmonicContact& one : contacts_) {
            closed |= isClosed(one, time) ? ContactSet{1} << one.contact : 0;
        }
        return closed;
    }

    [[nodiscard]] Moment momentOf(std::size_t lane, std::int64_t step, double place,
                                  NetworkLaws<SteadyHarmonic>& laws) const
    {
        const HarmonicLane& one = motion_.lanes[lane];
        Moment now{{given_.network, one.waves}, turned(given_.omega() * place), {}, {}};
        for (std::int64_t m = 0;; ++m) {
            const HarmonicNetwork::Drive drive =
                given_.drive(given_.amplitude * turned(-motion_.phase) * given_.turn(m));
            now.force.swing = drive.force;
            now.base.swing = drive.base;
            now.closed = closedIn(one, m);
            if (m == step) {
                return now;
            }
            now.waves.step(laws.of(now.closed), now.force, now.base);
        }
    }

    /// Before and after a time at which lanes meet.
    [[nodiscard]] std::pair<Moment, Moment> momentsAt(double time,
                                                      NetworkLaws<SteadyHarmonic>& laws) const
    {
        const double whole = std::floor(time + sameInstant);
        const double place = std::max(0.0, time - whole);
        const auto& lanes = motion_.lanes;
        const auto nearest =
            std::min_element(lanes.begin(), lanes.end(), [&](const auto& x, const auto& y) {
                return std::abs(x.from - place) < std::abs(y.from - place);
            });
        const auto lane = static_cast<std::size_t>(nearest - lanes.begin());
        const std::int64_t step = static_cast<std::int64_t>(whole) + given_.steps;
        return {lane == 0 ? momentOf(lanes.size() - 1, step - 1, 1.0, laws)
                          : momentOf(lane - 1, step, place, laws),
                momentOf(lane, step, place, laws)};
    }

    /// What is sent while a contact lacks beyond what is sent once it has begun.
    [[nodiscard]] Front frontOf(const NetworkHarmonicContact& one, const Passing& met,
                                NetworkLaws<SteadyHarmonic>& laws)
    {
        const Moment now = momentsAt(one.begin, laws).first;
        std::vector<double> waves;
        waves.reserve(given_.network.waves());
        for (const SteadyHarmonic& wave : now.waves.waves()) {
            waves.push_back(wave.at(now.turn));
        }
        const ContactSet own = ContactSet{1} << one.contact;
        const ContactSet others = met.closed | (met.beginning & ~own);
        const auto sent = [&](ContactSet closed) {
            Front front{{given_.network, waves}, std::vector<double>(bars_.size(), 0.0)};
            move(front, forced_.of(closed), now.force.at(now.turn), now.base.at(now.turn));
            return front;
        };
        requireApart(one.contact, met.beginning & ~own, others | own);
        return mixed(sent(others), 1.0, sent(others | own), -1.0);
    }

    /// Contacts that begin together are not to be joined.
    void requireApart(std::size_t contact, ContactSet together, ContactSet closed)
    {
        const NetworkLaw<double>& law = laws_.of(closed);
        const auto& contacts = given_.network.contacts;
        for (std::size_t j = 0; j < contacts.size(); ++j) {
            areApart_ = areApart_ &&
                        !(contains(together, j) && law.scattererOf(contacts[j].node) ==
                                                       law.scattererOf(contacts[contact].node));
        }
    }

    /// The pushes before and after the front that ends a contact.
    [[nodiscard]] std::pair<double, double> pushesAt(const NetworkHarmonicContact& one,
                                                     NetworkLaws<SteadyHarmonic>& laws) const
    {
        const auto [before, after] = momentsAt(one.end, laws);
        const auto push = [&, closed = before.closed](const Moment& now) {
            return laws.of(closed)
                .push(one.contact)
                .at(now.waves.arriving(), now.force, now.base)
                .at(now.turn);
        };
        return {push(before), push(after)};
    }

    /// The distance of a contact with waves that nothing else moves.
    [[nodiscard]] double distanceBy(const Front& front, const NetworkHarmonicContact& one) const
    {
        const std::vector<double> places =
            displacementsOf(unforced_, front.waves.waves(), front.drifts);
        return openingOf(given_.network.contacts[one.contact],
                         [&](std::size_t node) { return places[node]; });
    }

    void move(Front& front, const NetworkLaw<double>& law, double force = 0.0,
              double base = 0.0) const
    {
        for (std::size_t k = 0; k < bars_.size(); ++k) {
            const std::size_t node = given_.network.bars[bars_[k]].firstNode;
            front.drifts[k] += law.velocity(node).at(front.waves.arriving(), force, base);
        }
        front.waves.step(law, force, base);
    }

    [[nodiscard]] Front mixed(const Front& x, double ofX, const Front& y, double ofY) const
    {
        const auto sum = [&](std::vector<double> one, const std::vector<double>& other) {
            std::transform(one.begin(), one.end(), other.begin(), one.begin(),
                           [&](double a, double b) { return ofX * a + ofY * b; });
            return one;
        };
        return {{unforced_, sum(x.waves.waves(), y.waves.waves())}, sum(x.drifts, y.drifts)};
    }

    /// q_-/(q_- + |q_+|) where the newest front arrives, which has this push for each unit of time.
    [[nodiscard]] double closedPart(std::size_t k, double push, bool isLateAtRelease) const
    {
        const auto [first, last] = pushes_[k];
        const double before = isLateAtRelease ? first : last + push;
        const double after = std::abs(isLateAtRelease ? first - push : last);
        return before / (before + after);
    }

    /// One step of the front of a beginning. Fronts come by ascending age, so the first one that
    /// presses where a contact is ended by one is the newest of all that do.
    void pass(std::size_t j, const Passing& met, Course& course)
    {
        Front& front = course.fronts[j];
        const auto push = [&](ContactSet closed, std::size_t contact) {
            return laws_.of(closed).push(contact).at(front.waves.arriving(), 0.0, 0.0);
        };
        for (std::size_t c = 0; c < given_.network.contacts.size() && !course.isMet; ++c) {
            course.isMet = contains(met.beginning, c) && push(met.closed | met.beginning, c) != 0.0;
        }
        const ContactSet closed =
            met.closed | (course.orders.isLateAtContact ? met.beginning : ContactSet{0});
        if (met.ending == isOpen) {
            move(front, laws_.of(closed));
            return;
        }
        const std::size_t ending = met.ending;
        const ContactSet held = closed | ContactSet{1} << contacts_[ending].contact;
        const double pushed = push(held, contacts_[ending].contact);
        const double near = noFront * std::abs(pushes_[ending].first - pushes_[ending].second);
        if (course.isPinned[ending] || std::abs(pushed) <= near) {
            move(front, laws_.of(course.orders.isLateAtRelease ? closed : held));
            return;
        }
        course.isPinned[ending] = true;
        const double part = closedPart(ending, pushed, course.orders.isLateAtRelease);
        Front open = front;
        move(front, laws_.of(held));
        move(open, laws_.of(closed));
        front = mixed(front, part, open, 1.0 - part);
    }

    /// What the fronts say at the beginnings that come before their next step.
    void enter(std::int64_t travel, Course& course) const
    {
        const std::size_t count = contacts_.size();
        for (std::size_t j = 0; j < count; ++j) {
            for (std::size_t k = 0; k < count; ++k) {
                const double apart = contacts_[k].begin - contacts_[j].begin;
                const std::int64_t later =
                    travel - static_cast<std::int64_t>(std::floor(apart + sameInstant));
                if (course.hasFaded[j] || later < 0 || later % given_.steps != 0) {
                    continue;
                }
                std::vector<double>& seen = course.seen[k * count + j];
                seen.resize(static_cast<std::size_t>(later / given_.steps) + 1);
                seen.back() = j == k && travel == 0
                                  ? 1.0
                                  : distanceBy(course.fronts[j], contacts_[k]) / units_[k];
            }
        }
    }

    /// As growthOfLate takes them.
    [[nodiscard]] std::vector<double> weightsOf(const Course& course) const
    {
        const std::size_t count = contacts_.size();
        std::size_t terms = 0;
        for (const std::vector<double>& one : course.seen) {
            terms = std::max(terms, one.size());
        }
        std::vector<double> by;
        for (std::size_t k = 0; k < count; ++k) {
            const auto touched = driftsOf(given_.network, contacts_[k].contact);
            by.push_back(touched.empty() ? 0.0 : touched.front().second / units_[k]);
        }
        std::vector<double> weights(terms * count * count);
        for (std::size_t row = 0; row < count * count; ++row) {
            const Front& front = course.fronts[row % count];
            const double left = front.drifts.empty() ? 0.0 : by[row / count] * front.drifts.front();
            const std::vector<double>& seen = course.seen[row];
            for (std::size_t s = 0; s < terms; ++s) {
                weights[s * count * count + row] = s < seen.size() ? seen[s] : left;
            }
        }
        takeOffPlace(weights, by);
        return weights;
    }

    /// Growth in the second half of many periods of the steps of a lane.
    [[nodiscard]] double fadingOf(const HarmonicLane& lane)
    {
        std::vector<const NetworkLaw<double>*> steps;
        steps.reserve(static_cast<std::size_t>(given_.steps));
        for (std::int64_t m = 0; m < given_.steps; ++m) {
            steps.push_back(&laws_.of(closedIn(lane, m)));
        }
        std::mt19937_64 generator(1);
        std::uniform_real_distribution<double> any(-1.0, 1.0);
        std::vector<double> start(given_.network.waves());
        std::generate(start.begin(), start.end(), [&] { return any(generator); });
        double grown = 0.0;  // log
        double slope = 0.0;  // of it, by least squares over the second half
        double spread = 0.0;
        for (int k = 0; k < watchedPeriods; ++k) {
            NetworkWaves<double> waves(unforced_, std::move(start));
            for (const NetworkLaw<double>* law : steps) {
                waves.step(*law, 0.0, 0.0);
            }
            start = waves.waves();
            const double size = largestSizeOf(start);
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
    const std::vector<NetworkHarmonicContact>& contacts_;
    Network unforced_;
    std::vector<std::size_t> bars_;  ///< that drift
    NetworkLaws<double> laws_;
    NetworkLaws<double> forced_;
    bool areApart_ = true;
    std::vector<std::vector<Passing>> met_;  ///< by beginning and step after it
    std::vector<Front> starts_;              ///< after the step in which contact begins
    std::vector<std::pair<double, double>> pushes_;
    std::vector<double> units_;  ///< distances by starts_
};

}  // namespace

std::optional<double> growthOf(const HarmonicNetwork& given, const NetworkHarmonicMotion& motion)
{
    const std::size_t drifting = driftingBars(given.network).size();
    const bool isTouched =
        std::any_of(motion.contacts.begin(), motion.contacts.end(),
                    [&](const auto& one) { return !driftsOf(given.network, one.contact).empty(); });
    if (drifting > 1 || (drifting == 1 && !isTouched)) {
        return std::nullopt;  // a bar without contact never comes back to its place
    }
    NetworkFronts fronts(given, motion);
    if (!fronts.areApart()) {
        return std::nullopt;
    }
    const bool arePinned = std::any_of(motion.contacts.begin(), motion.contacts.end(),
                                       [](const auto& one) { return one.isPinned; });
    const std::optional<double> growth =
        growthOfOrders(arePinned, [&](const FrontOrders& orders) { return fronts.growth(orders); });
    if (!growth || *growth >= 1.0) {
        return growth;
    }
    // Waves that nothing sends never grow.
    return std::max(*growth, fronts.fading());
}

}  // namespace signorini
