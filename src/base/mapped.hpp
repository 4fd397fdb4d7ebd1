#pragma once
/// \file
/// A list made of another one.

#include <functional>
#include <type_traits>
#include <vector>

namespace signorini {

/// get(one) of each of a list, a member or a function of one, in their order.
template <typename List, typename Get>
[[nodiscard]] auto mapped(const List& list, Get get)
{
    using Held = std::invoke_result_t<Get&, decltype(*list.begin())>;
    std::vector<std::remove_cvref_t<Held>> all;
    all.reserve(list.size());
    for (const auto& one : list) {
        all.push_back(std::invoke(get, one));
    }
    return all;
}

}  // namespace signorini
