#include <algorithm>
#include <cmath>
#include <cstddef>

#include "signorini/simulation.hpp"

namespace signorini {

void SettlingWatch::see(const BarSimulation& simulation)
{
    const auto contacts = static_cast<std::int64_t>(simulation.contacts().size());
    periods_.push_back(
        {simulation.tip(), simulation.impulse() - impulseBefore_, contacts - contactsBefore_});
    impulseBefore_ = simulation.impulse();
    contactsBefore_ = contacts;
    constexpr std::size_t most = 4096;
    if (periods_.size() > most) {
        periods_.erase(periods_.begin(), periods_.begin() + most / 2);
    }
}

bool SettlingWatch::repeats(std::size_t length, double tolerance) const
{
    const std::size_t compared = length * static_cast<std::size_t>(repeats_);
    if (compared + length > periods_.size()) {
        return false;
    }
    const auto isAlike = [tolerance](const Period& one, const Period& other) {
        return std::abs(one.tip - other.tip) <= tolerance * std::max(1.0, std::abs(other.tip)) &&
               std::abs(one.impulse - other.impulse) <= tolerance * std::max(1.0, other.impulse);
    };
    const auto last = periods_.end() - static_cast<std::ptrdiff_t>(compared);
    return std::equal(last, periods_.end(), last - static_cast<std::ptrdiff_t>(length), isAlike);
}

std::optional<Settled> SettlingWatch::settled() const
{
    constexpr std::size_t longest = 16;
    // On the way to a short period deviations may take turns: such a one is not yet a long period.
    constexpr double turns = 1e3;
    std::size_t length = 1;
    while (length <= longest && !repeats(length, tolerance_)) {
        if (repeats(length, turns * tolerance_)) {
            return std::nullopt;
        }
        ++length;
    }
    if (length > longest) {
        return std::nullopt;
    }
    Settled result{static_cast<std::int64_t>(length), 0, 0.0};
    const auto compared = static_cast<std::ptrdiff_t>(length * static_cast<std::size_t>(repeats_));
    for (auto period = periods_.end() - compared; period != periods_.end(); ++period) {
        result.contacts += period->contacts;
        result.impulse += period->impulse;
    }
    // A contact is counted when it ends, so single periods may be one off.
    result.contacts = (2 * result.contacts + repeats_) / (2 * repeats_);
    result.impulse /= static_cast<double>(repeats_);
    return result;
}

}  // namespace signorini
