#pragma once
/// \file
/// The members of the library's plain structs, as C++ itself counts them: what makes two of them
/// equal, and what a pickle holds.

#include <tuple>
#include <type_traits>
#include <utility>

#include "description.hpp"
#include "signorini/signorini.hpp"

namespace signorini::python {

/// Pointers to the members of a T that count, where that is not simply all of them.
template <typename T>
struct Members {
};
template <>
struct Members<Scene> {
    static constexpr auto list = std::tuple{&Scene::bar, &Scene::secondStop, &Scene::segments};
};

template <typename A, typename B>
struct Members<std::pair<A, B>> {
    static constexpr auto list = std::tuple{&std::pair<A, B>::first, &std::pair<A, B>::second};
};

template <typename T>
concept HasList = requires
{
    Members<T>::list;
};

/// Can two of them be compared, and pickled?
template <typename T>
inline constexpr bool isKept = HasList<T> || std::is_aggregate_v<T>;

namespace detail {

/// Becomes any member in a braced list.
struct AnyMember {
    template <typename T>
    operator T() const;  // NOLINT: that it converts is its purpose
};

template <typename T, typename... Given>
constexpr std::size_t countMembers()
{
    if constexpr (requires { T{Given{}..., AnyMember{}}; }) {
        return countMembers<T, Given..., AnyMember>();
    } else {
        return sizeof...(Given);
    }
}

}  // namespace detail

/// An answer, and what Python has of it beside its keys.
template <typename Answer, typename More>
struct With : Answer {
    More more;
};
template <typename D, typename Answer, typename More>
void describe(D& d, answers::Type<With<Answer, More>>)
{
    describe(d, answers::Type<Answer>());
}

/// Calls a function with all members of a value, in the order of their declaration.
template <typename T, typename Do>
constexpr void withMembers(T& value, Do doWith)
{
    using Plain = std::remove_const_t<T>;
    if constexpr (HasList<Plain>) {
        std::apply([&](auto... member) { doWith(value.*member...); }, Members<Plain>::list);
    } else if constexpr (answers::isA<Plain, With>) {
        [&]<typename Answer, typename More>(const With<Answer, More>&) {
            using Base = std::conditional_t<std::is_const_v<T>, const Answer, Answer>;
            withMembers(static_cast<Base&>(value), doWith);
        }(value);
        doWith(value.more);
    } else {
        constexpr std::size_t count = detail::countMembers<Plain>();
        static_assert(count > 0 && count <= 21, "as many as there are lines here");
#define SIGNORINI_IF_MEMBERS(number, ...) \
    if constexpr (count == (number)) {    \
        auto& [__VA_ARGS__] = value;      \
        doWith(__VA_ARGS__);              \
    }
        SIGNORINI_IF_MEMBERS(1, a)
        SIGNORINI_IF_MEMBERS(2, a, b)
        SIGNORINI_IF_MEMBERS(3, a, b, c)
        SIGNORINI_IF_MEMBERS(4, a, b, c, d)
        SIGNORINI_IF_MEMBERS(5, a, b, c, d, e)
        SIGNORINI_IF_MEMBERS(6, a, b, c, d, e, f)
        SIGNORINI_IF_MEMBERS(7, a, b, c, d, e, f, g)
        SIGNORINI_IF_MEMBERS(8, a, b, c, d, e, f, g, h)
        SIGNORINI_IF_MEMBERS(9, a, b, c, d, e, f, g, h, i)
        SIGNORINI_IF_MEMBERS(10, a, b, c, d, e, f, g, h, i, j)
        SIGNORINI_IF_MEMBERS(11, a, b, c, d, e, f, g, h, i, j, k)
        SIGNORINI_IF_MEMBERS(12, a, b, c, d, e, f, g, h, i, j, k, l)
        SIGNORINI_IF_MEMBERS(13, a, b, c, d, e, f, g, h, i, j, k, l, m)
        SIGNORINI_IF_MEMBERS(14, a, b, c, d, e, f, g, h, i, j, k, l, m, n)
        SIGNORINI_IF_MEMBERS(15, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o)
        SIGNORINI_IF_MEMBERS(16, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p)
        SIGNORINI_IF_MEMBERS(17, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q)
        SIGNORINI_IF_MEMBERS(18, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r)
        SIGNORINI_IF_MEMBERS(19, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s)
        SIGNORINI_IF_MEMBERS(20, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t)
        SIGNORINI_IF_MEMBERS(21, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u)
#undef SIGNORINI_IF_MEMBERS
    }
}

}  // namespace signorini::python
