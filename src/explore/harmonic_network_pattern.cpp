#include "harmonic_network_pattern.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact_spans.hpp"
#include "dense.hpp"
#include "harmonic_motion.hpp"
#include "harmonic_network_march.hpp"
#include "harmonic_network_walk.hpp"
#include "infinity.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

constexpr int mostPatterns = 12;
constexpr int mostNewton = 25;
constexpr double longestMove = 0.1;                // steps, and rad
constexpr double noMove = 1e-13;                   // that changes nothing any more
constexpr double sameCut = 1e-12;                  // steps
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
        : given_(given),
          bars_(driftingBars(given.network)),
          drifts_(bars_.size(), 0.0),
          isTouched_(bars_.size(), false),
          excitation_(turned(-start.phase)),
          laws_(given.network)
    {
        places_.push_back(0.0);
        for (const NetworkHarmonicContact& one : start.contacts) {
            const Cut begin = contacts_.empty() ? Cut{} : ownCut(one.begin);
            contacts_.push_back({one.contact, one.isPinned, begin, {}});
            for (const auto& [bar, sign] : driftsOf(given.network, one.contact)) {
                isTouched_[bar] = true;
            }
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
        Equations equations(static_cast<Eigen::Index>(places_.size() + bars_.size()));
        enterDistances(equations);
        enterPushes(equations);
        enterDrifts(equations);
        const Eigen::VectorXd move = SquareFactors(equations.slope).solve(-equations.residual);
        if (!move.allFinite()) {
            return infinity;
        }
        const double far =
            move.head(static_cast<Eigen::Index>(places_.size())).cwiseAbs().maxCoeff();
        const double part = std::min(1.0, longestMove / std::max(far, noMove));
        excitation_ *= turned(-part * move[0]);
        for (std::size_t place = 1; place < places_.size(); ++place) {
            places_[place] += part * move[static_cast<Eigen::Index>(place)];
        }
        for (std::size_t bar = 0; bar < bars_.size(); ++bar) {  // all rows are linear in these
            drifts_[bar] += move[columnOf(bar)];
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
                for (const SteadyHarmonic& wave : waves_[lane]) {
                    waves.emplace_back(wave.steady, excitation_ * wave.swing);
                }
                const double begin = motion.lanes.empty() ? 0.0 : motion.lanes.back().to;
                motion.lanes.push_back({begin, to(lane), std::move(waves)});
            }
        }
        motion.lanes.back().to = 1.0;
        motion.drifts = drifts_;
        return motion;
    }

private:
    /// Of arg A (negative), places, and displacements of bars that drift.
    struct Equations {
        Eigen::VectorXd residual;
        Eigen::MatrixXd slope;
        Eigen::Index row = 0;

        explicit Equations(Eigen::Index size)
            : residual(Eigen::VectorXd::Zero(size)), slope(Eigen::MatrixXd::Zero(size, size))
        {
        }
    };

    [[nodiscard]] Eigen::Index columnOf(std::size_t bar) const
    {
        return static_cast<Eigen::Index>(places_.size() + bar);
    }

    /// A row for what lanes add up to.
    void enter(Equations& to, const SteadyHarmonic& sum, const auto& ofLane) const
    {
        to.residual[to.row] = sum.at(excitation_);
        to.slope(to.row, 0) = (excitation_ * sum.swing).imag();
        for (std::size_t place = 1; place < places_.size(); ++place) {
            const std::size_t lane = rank_[place];
            to.slope(to.row, static_cast<Eigen::Index>(place)) =
                (ofLane(lane - 1) - ofLane(lane)).at(excitation_ * at(places_[place]));
        }
    }

    void enterDistances(Equations& to) const
    {
        for (std::size_t k = 0; k < contacts_.size(); ++k, ++to.row) {
            enter(to, wayTo(k), [&](std::size_t lane) { return follows_[lane].ways[k]; });
            to.residual[to.row] += given_.network.contacts[contacts_[k].contact].gap;
            for (const auto& [bar, sign] : driftsOf(given_.network, contacts_[k].contact)) {
                to.residual[to.row] += sign * drifts_[bar];
                to.slope(to.row, columnOf(bar)) = sign;
            }
        }
    }

    void enterPushes(Equations& to) const
    {
        for (std::size_t k = 0; k < contacts_.size(); ++k) {
            if (!contacts_[k].isPinned) {
                const std::size_t place = contacts_[k].end.place;
                const Complex turn = excitation_ * at(places_[place]);
                const double rate = (pushes_[k].swing * turn).imag();
                to.residual[to.row] = pushes_[k].at(turn);
                to.slope(to.row, 0) = rate;
                to.slope(to.row, static_cast<Eigen::Index>(place)) = -given_.omega() * rate;
                ++to.row;
            }
        }
    }

    /// Bars that contacts touch come back; others swing about their places in the scene.
    void enterDrifts(Equations& to) const
    {
        for (std::size_t bar = 0; bar < bars_.size(); ++bar, ++to.row) {
            const auto rateIn = [&](std::size_t lane) { return follows_[lane].rates[bar]; };
            if (isTouched_[bar]) {
                enter(to, sumOf(rateIn), rateIn);
            } else {
                const Complex swing = excitation_ * follows_.front().firstRates[bar].swing /
                                      Complex(0.0, given_.omega());
                to.residual[to.row] = drifts_[bar] - swing.real();
                to.slope(to.row, 0) = -swing.imag();
                to.slope(to.row, columnOf(bar)) = 1.0;
            }
        }
    }

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

    /// What drives a step where A is |A|.
    [[nodiscard]] std::pair<SteadyHarmonic, SteadyHarmonic> driveAt(std::int64_t m) const
    {
        const auto [force, base] = given_.drive(given_.amplitude * given_.turn(m));
        return {SteadyHarmonic(0.0, force), SteadyHarmonic(0.0, base)};
    }

    /// Waves for A = |A| that come back.
    [[nodiscard]] std::optional<std::vector<SteadyHarmonic>> fixedWaves(
        const std::vector<ContactSet>& closed)
    {
        constexpr double noChange = 1e-15;
        std::vector<SteadyHarmonic> now(given_.network.waves());
        double least = infinity;  // change so far
        int stale = 0;
        for (std::int64_t done = 0; done < mostFadeSteps; done += given_.steps) {
            NetworkWaves<SteadyHarmonic> waves(given_.network, now);
            for (std::int64_t m = 0; m < given_.steps; ++m) {
                const auto [force, base] = driveAt(m);
                waves.step(laws_.of(closed[static_cast<std::size_t>(m)]), force, base);
            }
            std::vector<SteadyHarmonic> next = waves.waves();
            double change = 0.0;
            double size = 0.0;
            for (std::size_t i = 0; i < next.size(); ++i) {
                change = std::max(change, (next[i] - now[i]).largest());
                size = std::max(size, next[i].largest());
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

    /// What this lane makes of distances where contacts begin, of pushes where they fade, and of
    /// bars that drift.
    void follow(std::size_t lane, const std::vector<ContactSet>& closed)
    {
        const Network& network = given_.network;
        pushes_.resize(contacts_.size());
        std::vector<SteadyHarmonic> sums(network.contacts.size());
        for (std::size_t j = 0; j < sums.size(); ++j) {
            std::vector<double> by(network.waves(), 0.0);
            addDistance(by, network, j, 1.0);
            for (std::size_t i = 0; i < by.size(); ++i) {
                sums[j] = sums[j] + by[i] * waves_[lane][i];
            }
        }
        Followed followed;
        followed.ways.resize(contacts_.size());
        followed.rates.resize(bars_.size());
        NetworkWaves<SteadyHarmonic> waves(network, waves_[lane]);
        for (std::int64_t m = 0; m <= given_.steps; ++m) {
            const auto [force, base] = driveAt(m);
            const ContactSet held = closed[static_cast<std::size_t>(m % given_.steps)];
            const NetworkLaw<SteadyHarmonic>& law = laws_.of(held);
            const auto velocity = [&, f = force, b = base](std::size_t node) {
                return law.velocity(node).at(waves.arriving(), f, b);
            };
            for (std::size_t k = 0; k < contacts_.size(); ++k) {
                const CutContact& one = contacts_[k];
                if (stepAfter(one.begin, lane) == m) {
                    followed.ways[k] = sums[one.contact];
                }
                if (!one.isPinned && rank_[one.end.place] == lane + 1 &&
                    one.end.whole % given_.steps == m) {
                    pushes_[k] = law.push(one.contact).at(waves.arriving(), force, base);
                }
            }
            for (std::size_t j = 0; j < sums.size(); ++j) {
                if (!contains(held, j)) {
                    sums[j] = sums[j] + openingOf(network.contacts[j], velocity);
                }
            }
            for (std::size_t bar = 0; bar < bars_.size() && m < given_.steps; ++bar) {
                const SteadyHarmonic rate = velocity(network.bars[bars_[bar]].firstNode);
                followed.rates[bar] = followed.rates[bar] + rate;
                if (m == 0) {
                    followed.firstRates.push_back(rate);
                }
            }
            waves.step(law, force, base);
        }
        follows_.push_back(std::move(followed));
    }

    /// What all lanes add up to, for A = |A|.
    [[nodiscard]] SteadyHarmonic sumOf(const auto& ofLane) const
    {
        SteadyHarmonic sum;
        for (std::size_t lane = 0; lane < order_.size(); ++lane) {
            const SteadyHarmonic rate = ofLane(lane);
            sum = sum + SteadyHarmonic(rate.steady * (to(lane) - from(lane)),
                                       rate.swing * given_.weight(from(lane), to(lane)));
        }
        return sum;
    }

    /// The distance at a beginning, without the gap and what bars have drifted.
    [[nodiscard]] SteadyHarmonic wayTo(std::size_t k) const
    {
        SteadyHarmonic way = sumOf([&](std::size_t lane) { return follows_[lane].ways[k]; });
        if (given_.place != Excited::tip) {
            std::vector<double> by(given_.network.waves(), 0.0);
            way.swing +=
                given_.amplitude * addDistance(by, given_.network, contacts_[k].contact, 1.0);
        }
        return way;
    }

    /// Of a lane, for A = |A|.
    struct Followed {
        std::vector<SteadyHarmonic> ways;        ///< G, by contact: of distances at beginnings
        std::vector<SteadyHarmonic> rates;       ///< by bar that drifts, in a period
        std::vector<SteadyHarmonic> firstRates;  ///< in its first step
    };

    const HarmonicNetwork& given_;
    std::vector<std::size_t> bars_;  ///< that drift
    std::vector<double> drifts_;     ///< displacements of their first nodes at t = 0
    std::vector<bool> isTouched_;    ///< by a contact, of these bars
    Complex excitation_;             ///< A/|A|
    std::vector<double> places_;     ///< in a step; the first is 0
    std::vector<CutContact> contacts_;
    std::vector<std::size_t> order_;  ///< lanes begin at these places
    std::vector<std::size_t> rank_;   ///< the lane that begins at a place
    NetworkLaws<SteadyHarmonic> laws_;
    std::vector<std::vector<SteadyHarmonic>> waves_;  ///< by lane, for A = |A|
    std::vector<Followed> follows_;                   ///< by lane
    std::vector<SteadyHarmonic> pushes_;              ///< P
};

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
