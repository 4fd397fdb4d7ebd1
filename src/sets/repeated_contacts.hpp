#pragma once
/// \file
/// Do contacts repeat? Of lists by ascending beginning.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace signorini {

/// Those that begin in [from, to[.
template <typename Contact>
[[nodiscard]] std::span<const Contact> begunIn(const std::vector<Contact>& all, double from,
                                               double to)
{
    const auto at = [&](double time) {
        return static_cast<std::size_t>(
            std::lower_bound(all.begin(), all.end(), time,
                             [](const Contact& one, double t) { return one.begin < t; }) -
            all.begin());
    };
    return std::span(all).subspan(at(from), at(to) - at(from));
}

/// How far the second are from the first, so much later, in time; infinite if they are others.
/// `place`: which contact or stop one is of.
template <typename Contact, typename Place>
[[nodiscard]] double apart(std::span<const Contact> first, std::span<const Contact> second,
                           double later, Place Contact::*place)
{
    double most = first.size() == second.size() ? 0.0 : std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < first.size() && std::isfinite(most); ++k) {
        const Contact& a = first[k];
        const Contact& b = second[k];
        most = a.*place == b.*place ? std::max({most, std::abs(b.begin - a.begin - later),
                                                std::abs(b.end - a.end - later)})
                                    : std::numeric_limits<double>::infinity();
    }
    return most;
}

/// The period, of m = 1, 2, ..., with which contacts settle that are looked at again and again.
/// What comes nearer to a shorter one from look to look repeats with a multiple of it earlier.
class SettlingPeriod {
public:
    SettlingPeriod(std::int64_t most, double sameTime)
        : sameTime_(sameTime),
          last_(static_cast<std::size_t>(most) + 1, std::numeric_limits<double>::infinity())
    {
    }

    void lookAgain() { isComing_ = false; }

    /// At each look by ascending m. `apart`: two such periods.
    [[nodiscard]] bool is(std::int64_t m, double apart)
    {
        if (apart <= sameTime_) {
            return !isComing_;
        }
        double& last = last_.at(static_cast<std::size_t>(m));
        isComing_ = isComing_ || apart < 0.9 * last;
        last = apart;
        return false;
    }

private:
    double sameTime_;
    std::vector<double> last_;
    bool isComing_ = false;  ///< nearer to a shorter period
};

}  // namespace signorini
