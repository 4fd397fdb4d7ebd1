#pragma once
/// \file
/// Do contacts repeat? Of lists by ascending beginning.

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace signorini {

/// Those that begin in [from, to[.
template <typename Contact>
[[nodiscard]] std::span<const Contact> begunIn(const std::vector<Contact>& all, double from,
                                               double to)
{
    const auto at = [&](double time) {
        return std::lower_bound(all.begin(), all.end(), time,
                                [](const Contact& one, double t) { return one.begin < t; });
    };
    return {at(from), at(to)};
}

/// Are the second those of the first, so much later? `place`: which contact or stop one is of.
template <typename Contact, typename Place>
[[nodiscard]] bool areRepeated(std::span<const Contact> first, std::span<const Contact> second,
                               double later, double tolerance, Place Contact::*place)
{
    return std::equal(first.begin(), first.end(), second.begin(), second.end(),
                      [&](const Contact& a, const Contact& b) {
                          return std::abs(b.begin - a.begin - later) <= tolerance &&
                                 std::abs(b.end - a.end - later) <= tolerance &&
                                 a.*place == b.*place;
                      });
}

}  // namespace signorini
