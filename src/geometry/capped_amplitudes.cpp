#include "capped_amplitudes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "infinity.hpp"

namespace signorini {

namespace {

constexpr double sameWithin = 1e-12;  // of the cap, the sum or a bound
constexpr double mostStates = 1e7;    // of a walk

std::optional<std::vector<double>> onSimplex(const AmplitudeSet& set, double cap)
{
    std::vector<double> z(static_cast<std::size_t>(set.count), 0.0);
    double left = set.sum;
    for (double& value : z) {
        value = std::min(left, cap);
        left -= value;
    }
    if (left > sameWithin * set.sum) {
        return std::nullopt;
    }
    return z;
}

/// A walk of d steps from 0 to S between two bounds, no step longer than the cap.
class CappedWalk {
public:
    CappedWalk(const AmplitudeSet& box, double cap)
        : count_(static_cast<std::size_t>(box.count)), cap_(cap), sum_(box.sum)
    {
        near_ = sameWithin * std::max({std::abs(box.lower), std::abs(box.upper), std::abs(sum_)});
        for (const double anchor : {0.0, sum_, box.lower, box.upper}) {
            const double below = cap < infinity ? std::ceil((box.lower - anchor) / cap) : 0.0;
            const double above = cap < infinity ? std::floor((box.upper - anchor) / cap) : 0.0;
            if (!((above - below) * static_cast<double>(box.count) <= mostStates)) {
                places_.clear();
                return;
            }
            places_.push_back(anchor);
            for (double k = below; k <= above; ++k) {
                places_.push_back(k == 0.0 ? anchor : anchor + k * cap);
            }
        }
        std::sort(places_.begin(), places_.end());
        places_.erase(std::unique(places_.begin(), places_.end(),
                                  [this](double x, double y) { return y - x <= near_; }),
                      places_.end());
    }

    [[nodiscard]] std::optional<std::vector<double>> run()
    {
        if (places_.empty()) {
            return std::nullopt;
        }
        std::vector<double> best(places_.size(), -1.0);
        best[placeOf(0.0)] = 0.0;
        from_.assign(count_ * places_.size(), 0);
        for (std::size_t step = 0; step < count_; ++step) {
            best = stepped(best, step);
        }
        std::size_t at = placeOf(sum_);
        if (best[at] < 0.0) {
            return std::nullopt;
        }
        std::vector<double> z(count_);
        for (std::size_t step = count_; step-- > 0;) {
            const std::size_t before = from_[step * places_.size() + at];
            z[step] = places_[at] - places_[before];
            at = before;
        }
        return z;
    }

private:
    [[nodiscard]] std::size_t placeOf(double x) const
    {
        const auto found = std::lower_bound(places_.begin(), places_.end(), x - near_);
        return static_cast<std::size_t>(found - places_.begin());
    }

    /// What can be reached with one step more, and the most squares on the way.
    [[nodiscard]] std::vector<double> stepped(const std::vector<double>& best, std::size_t step)
    {
        std::vector<double> next(places_.size(), -1.0);
        std::size_t low = 0;
        for (std::size_t to = 0; to < places_.size(); ++to) {
            while (places_[to] - places_[low] > cap_ + near_) {
                ++low;
            }
            for (std::size_t k = low;
                 k < places_.size() && places_[k] - places_[to] <= cap_ + near_; ++k) {
                const double way = places_[to] - places_[k];
                if (best[k] >= 0.0 && best[k] + way * way > next[to]) {
                    next[to] = best[k] + way * way;
                    from_[step * places_.size() + to] = static_cast<std::uint32_t>(k);
                }
            }
        }
        return next;
    }

    std::size_t count_;
    double cap_;
    double sum_;
    double near_ = 0.0;
    std::vector<double> places_;       ///< ascending
    std::vector<std::uint32_t> from_;  ///< of each step, by the place it leads to
};

}  // namespace

std::optional<std::vector<double>> mostAmplitudesBelow(const AmplitudeSet& set, double cap)
{
    switch (set.kind) {
        case SetKind::simplex:
            return onSimplex(set, cap);
        case SetKind::box:
            return CappedWalk(set, cap).run();
        case SetKind::point:
            if (std::abs(set.sum) <= cap * (1.0 + sameWithin)) {
                return std::vector<double>(static_cast<std::size_t>(set.count), set.sum);
            }
            return std::nullopt;
        default:
            return std::nullopt;
    }
}

}  // namespace signorini
