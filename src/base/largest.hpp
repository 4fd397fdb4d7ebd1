#pragma once
/// \file
/// The largest of what a list holds.

#include <algorithm>
#include <cmath>
#include <functional>

namespace signorini {

/// The largest get(one) of a list, a member or a function of one; 0 if none is above.
template <typename List, typename Get = std::identity>
[[nodiscard]] double largestOf(const List& list, Get get = {})
{
    double largest = 0.0;
    for (const auto& one : list) {
        largest = std::max(largest, std::invoke(get, one));
    }
    return largest;
}

/// The same of |get(one)|.
template <typename List, typename Get = std::identity>
[[nodiscard]] double largestSizeOf(const List& list, Get get = {})
{
    return largestOf(list, [&get](const auto& one) { return std::abs(std::invoke(get, one)); });
}

}  // namespace signorini
