#include "harmonic_network_pattern.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "contact_spans.hpp"
#include "dense.hpp"
#include "harmonic_motion.hpp"
#include "harmonic_network_march.hpp"
#include "harmonic_network_walk.hpp"
#include "infinity.hpp"
#include "largest.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

constexpr int mostPatterns = 12;
constexpr int mostNewton = 25;
constexpr double longestMove = 0.1;                // steps, and rad
constexpr double noMove = 1e-13;                   // that changes nothing any more
constexpr double sameCut = 1e-12;                  // steps
constexpr double sameEvent = 1e-7;                 // steps
constexpr std::int64_t mostFadeSteps = 4'000'000;  // until waves of a lane come back

/// A time whole + the place of that number.
struct Cut {
    std::int64_t whole = 0;
    std::size_t place = 0;
};

struct CutContact {
    std::size_t contact;
    bool isPinned;
    Cut begin;
    Cut end;
};

class NetworkPattern {
public:
    NetworkPattern(const HarmonicNetwork& given, const NetworkHarmonicMotion& start)
        : given_(given), excitation_(given.amplitude * turned(-start.phase)), laws_(given.network)
    {
        places_.push_back(0.0);
        for (const NetworkHarmonicContact& one : start.contacts) {
            const Cut begin = contacts_.empty() ? Cut{} : ownCut(one.begin);
            contacts_.push_back({one.contact, one.isPinned, begin, {}});
        }
        const std::size_t begins = places_.size();
        for (std::size_t k = 0; k < contacts_.size(); ++k) {
            const double end = start.contacts[k].end;
            contacts_[k].end = contacts_[k].isPinned ? cutAtFront(end, begins) : ownCut(end);
            if (contacts_[k].begin.whole < 0) {
                contacts_[k].begin.whole += given_.steps;
                contacts_[k].end.whole += given_.steps;
            }
        }
        order_.resize(places_.size());
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        std::stable_sort(order_.begin() + 1, order_.end(),
                         [&](std::size_t x, std::size_t y) { return places_[x] < places_[y]; });
        rank_.resize(order_.size());
        for (std::size_t lane = 0; lane < order_.size(); ++lane) {
            rank_[order_[lane]] = lane;
        }
    }

    /// \return false: they fade too slowly.
    [[nodiscard]] bool setWaves()
    {
        for (std::size_t lane = 0; lane < order_.size(); ++lane) {
            std::vector<ContactSet> closed(static_cast<std::size_t>(given_.steps));
            for (std::int64_t m = 0; m < given_.steps; ++m) {
                closed[static_cast<std::size_t>(m)] = closedAt(lane, m);
            }
            auto waves = fixedWaves(closed);
            if (!waves) {
                return false;
            }
            waves_.push_back(std::move(*waves));
            follow(lane, closed);
        }
        return true;
    }

    /// One step of Newton. \return how far it went; infinite where it cannot.
    [[nodiscard]] double improve()
    {
        const auto size = static_cast<Eigen::Index>(places_.size());
        Eigen::VectorXd residual = Eigen::VectorXd::Zero(size);
        Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(size, size);
        Eigen::Index row = 0;
        for (std::size_t k = 0; k < contacts_.size(); ++k, ++row) {
            const Complex way = wayTo(k);
            residual[row] = gapOf(k) + (excitation_ * way).real();
            slope(row, 0) = (excitation_ * way).imag();
            for (std::size_t place = 1; place < places_.size(); ++place) {
                const std::size_t lane = rank_[place];
                slope(row, static_cast<Eigen::Index>(place)) =
                    (excitation_ * (ways_[lane - 1][k] - ways_[lane][k]) * at(places_[place]))
                        .real();
            }
        }
        for (std::size_t k = 0; k < contacts_.size(); ++k) {
            if (!contacts_[k].isPinned) {
                const std::size_t place = contacts_[k].end.place;
                const Complex push = excitation_ * pushes_[k] * at(places_[place]);
                residual[row] = push.real();
                slope(row, 0) = push.imag();
                slope(row, static_cast<Eigen::Index>(place)) = -given_.omega() * push.imag();
                ++row;
            }
        }
        Eigen::VectorXd move = SquareFactors(slope).solve(-residual);
        if (!move.allFinite()) {
            return infinity;
        }
        const double far = move.cwiseAbs().maxCoeff();
        move *= std::min(1.0, longestMove / std::max(far, noMove));
        excitation_ *= turned(-move[0]);
        for (std::size_t place = 1; place < places_.size(); ++place) {
            places_[place] += move[static_cast<Eigen::Index>(place)];
        }
        return far;
    }

    [[nodiscard]] bool isOrdered() const
    {
        for (std::size_t lane = 0; lane < order_.size(); ++lane) {
            if (!(to(lane) - from(lane) > -sameCut)) {
                return false;
            }
        }
        return true;
    }

    /// With waves where it is ordered.
    [[nodiscard]] NetworkHarmonicMotion motion() const
    {
        NetworkHarmonicMotion motion;
        motion.phase = -angleOf(excitation_);
        for (const CutContact& one : contacts_) {
            motion.contacts.push_back({.contact = one.contact,
                                       .begin = timeOf(one.begin),
                                       .end = timeOf(one.end),
                                       .isPinned = one.isPinned});
        }
        for (std::size_t lane = 0; lane < order_.size(); ++lane) {
            if (to(lane) - from(lane) > sameCut || order_.size() == 1) {
                std::vector<SteadyHarmonic> waves;
                waves.reserve(waves_[lane].size());
                for (const Complex wave : waves_[lane]) {
                    waves.emplace_back(0.0, excitation_ * wave);
                }
                const double begin = motion.lanes.empty() ? 0.0 : motion.lanes.back().to;
                motion.lanes.push_back({begin, to(lane), std::move(waves)});
            }
        }
        motion.lanes.back().to = 1.0;
        return motion;
    }

private:
    [[nodiscard]] Cut ownCut(double time)
    {
        const double whole = std::floor(time);
        places_.push_back(time - whole);
        return {static_cast<std::int64_t>(whole), places_.size() - 1};
    }

    /// The front is that of the beginning whose place is nearest.
    [[nodiscard]] Cut cutAtFront(double time, std::size_t begins) const
    {
        std::size_t nearest = 0;
        const auto apart = [&](std::size_t place) {
            return std::abs(std::remainder(time - places_[place], 1.0));
        };
        for (std::size_t place = 1; place < begins; ++place) {
            nearest = apart(place) < apart(nearest) ? place : nearest;
        }
        return {std::llround(time - places_[nearest]), nearest};
    }

    [[nodiscard]] double timeOf(const Cut& cut) const
    {
        return static_cast<double>(cut.whole) + places_[cut.place];
    }
    [[nodiscard]] double from(std::size_t lane) const { return places_[order_[lane]]; }
    [[nodiscard]] double to(std::size_t lane) const
    {
        return lane + 1 == order_.size() ? 1.0 : from(lane + 1);
    }
    [[nodiscard]] Complex at(double s) const { return turned(given_.omega() * s); }

    /// The first step of this lane that comes after a time.
    [[nodiscard]] std::int64_t stepAfter(const Cut& cut, std::size_t lane) const
    {
        return cut.whole + (rank_[cut.place] > lane ? 1 : 0);
    }

    [[nodiscard]] ContactSet closedAt(std::size_t lane, std::int64_t m) const
    {
        ContactSet closed = 0;
        for (const CutContact& one : contacts_) {
            for (const std::int64_t step : {m, m + given_.steps}) {
                if (stepAfter(one.begin, lane) <= step && step < stepAfter(one.end, lane)) {
                    closed |= ContactSet{1} << one.contact;
                }
            }
        }
        return closed;
    }

    /// Waves for A = 1 that come back.
    [[nodiscard]] std::optional<std::vector<Complex>> fixedWaves(
        const std::vector<ContactSet>& closed)
    {
        constexpr double noChange = 1e-15;
        std::vector<Complex> now(given_.network.waves());
        double least = infinity;  // change so far
        int stale = 0;
        for (std::int64_t done = 0; done < mostFadeSteps; done += given_.steps) {
            NetworkWaves<Complex> waves(given_.network, now);
            for (std::int64_t m = 0; m < given_.steps; ++m) {
                const auto [force, base] = given_.drive(given_.turn(m));
                waves.step(laws_.of(closed[static_cast<std::size_t>(m)]), force, base);
            }
            std::vector<Complex> next = waves.waves();
            double change = 0.0;
            double size = 0.0;
            for (std::size_t i = 0; i < next.size(); ++i) {
                change = std::max(change, lengthOf(next[i] - now[i]));
                size = std::max(size, lengthOf(next[i]));
            }
            now = std::move(next);
            stale = change < least ? 0 : stale + 1;
            least = std::min(least, change);
            constexpr int mostStale = 20;
            if (change <= noChange * size || (stale > mostStale && change <= 1e-12 * size)) {
                return now;
            }
        }
        return std::nullopt;
    }

    /// What this lane makes of distances where contacts begin, and of pushes where they fade.
    void follow(std::size_t lane, const std::vector<ContactSet>& closed)
    {
        const Network& network = given_.network;
        pushes_.resize(contacts_.size());
        std::vector<Complex> sums(network.contacts.size());
        for (std::size_t j = 0; j < sums.size(); ++j) {
            std::vector<double> by(network.waves(), 0.0);
            addDistance(by, network, j, 1.0);
            for (std::size_t i = 0; i < by.size(); ++i) {
                sums[j] += by[i] * waves_[lane][i];
            }
        }
        std::vector<Complex> ways(contacts_.size());
        NetworkWaves<Complex> waves(network, waves_[lane]);
        for (std::int64_t m = 0; m <= given_.steps; ++m) {
            const auto [force, base] = given_.drive(given_.turn(m));
            const ContactSet held = closed[static_cast<std::size_t>(m % given_.steps)];
            const NetworkLaw<Complex>& law = laws_.of(held);
            for (std::size_t k = 0; k < contacts_.size(); ++k) {
                const CutContact& one = contacts_[k];
                if (stepAfter(one.begin, lane) == m) {
                    ways[k] = sums[one.contact];
                }
                if (!one.isPinned && rank_[one.end.place] == lane + 1 &&
                    one.end.whole % given_.steps == m) {
                    pushes_[k] = law.push(one.contact).at(waves.arriving(), force, base);
                }
            }
            for (std::size_t j = 0; j < sums.size(); ++j) {
                if (!contains(held, j)) {
                    sums[j] +=
                        openingOf(network.contacts[j], [&, f = force, b = base](std::size_t node) {
                            return law.velocity(node).at(waves.arriving(), f, b);
                        });
                }
            }
            waves.step(law, force, base);
        }
        ways_.push_back(std::move(ways));
    }

    /// The distance at a beginning is the gap and A times this.
    [[nodiscard]] Complex wayTo(std::size_t k) const
    {
        Complex way = 0.0;
        for (std::size_t lane = 0; lane < order_.size(); ++lane) {
            way += ways_[lane][k] * given_.weight(from(lane), to(lane));
        }
        if (given_.place != Excited::tip) {
            std::vector<double> by(given_.network.waves(), 0.0);
            way += addDistance(by, given_.network, contacts_[k].contact, 1.0);
        }
        return way;
    }
    [[nodiscard]] double gapOf(std::size_t k) const
    {
        return given_.network.contacts[contacts_[k].contact].gap;
    }

    const HarmonicNetwork& given_;
    Complex excitation_;          ///< A
    std::vector<double> places_;  ///< in a step; the first is 0
    std::vector<CutContact> contacts_;
    std::vector<std::size_t> order_;  ///< lanes begin at these places
    std::vector<std::size_t> rank_;   ///< the lane that begins at a place
    NetworkLaws<Complex> laws_;
    std::vector<std::vector<Complex>> waves_;  ///< by lane, for A = 1
    std::vector<std::vector<Complex>> ways_;   ///< G, by lane and contact
    std::vector<Complex> pushes_;              ///< P
};

/// What a motion that is not one does in a period: its contacts as they should be.
[[nodiscard]] std::vector<NetworkHarmonicContact> contactsAfter(const HarmonicNetwork& given,
                                                                const NetworkHarmonicMotion& motion)
{
    const auto period = static_cast<double>(given.steps);
    ContactSet closed = 0;
    for (const NetworkHarmonicContact& one : motion.contacts) {
        closed |= one.end > period + sameEvent ? ContactSet{1} << one.contact : 0;
    }
    std::vector<double> distances = startDistances(given, motion);
    distances[motion.first().contact] = 0.0;
    HarmonicNetworkMarch march(given, motion.phase, motion.lanes, std::move(distances), closed,
                               0.0);
    if (!march.advance(given.steps)) {
        return {};
    }
    std::vector<NetworkHarmonicContact> found;
    for (const NetworkHarmonicContact& one : march.contacts()) {
        if (one.begin >= 0.0 && one.begin < period - sameEvent) {
            found.push_back(one);
        }
    }
    for (NetworkHarmonicContact& one : found) {
        if (one.end == 0.0) {  // it lasts into the next period
            const auto& all = march.contacts();
            const auto rest = std::find_if(all.begin(), all.end(), [&](const auto& other) {
                return other.contact == one.contact && other.begin < 0.0;
            });
            one.end = period + (rest == all.end() ? 0.0 : rest->end);
            one.isPinned = rest == all.end() || rest->isPinned;
        }
    }
    return found;
}

}  // namespace

std::optional<NetworkHarmonicMotion> harmonicNear(const HarmonicNetwork& given,
                                                  NetworkHarmonicMotion start)
{
    for (int tried = 0; tried < mostPatterns && !start.contacts.empty(); ++tried) {
        NetworkPattern pattern(given, start);
        if (!pattern.setWaves()) {
            return std::nullopt;
        }
        double far = infinity;
        for (int k = 0; k < mostNewton && far > noMove && pattern.isOrdered(); ++k) {
            far = pattern.improve();
            if (far == infinity) {
                return std::nullopt;
            }
        }
        NetworkHarmonicMotion motion = pattern.motion();
        if (!pattern.isOrdered()) {
            start.phase = motion.phase;
            start.contacts = std::move(motion.contacts);
            continue;
        }
        measure(given, motion);
        if (motion.residual <= harmonicTolerance) {
            return motion;
        }
        start = motion;
        start.contacts = contactsAfter(given, motion);
    }
    return std::nullopt;
}

}  // namespace signorini
