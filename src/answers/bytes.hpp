#pragma once
/// \file
/// C++ values as bytes, and back: what travels between the processes of one program, and what a
/// pickle of Python holds. Structs go member by member, as C++ itself counts these; lists after
/// their length, optionals and variants after what they hold.
///
/// Two values are equal if their bytes are.

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstring>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "description.hpp"

namespace signorini::answers {

/// Pointers to the members of a T that count, where that is not simply all of them.
template <typename T>
inline constexpr std::tuple<> membersOf{};

template <typename T>
inline constexpr bool isListed = std::tuple_size_v<std::remove_const_t<decltype(membersOf<T>)>> > 0;

/// Has it members that can be passed?
template <typename T>
inline constexpr bool isKept = isListed<T> || std::is_aggregate_v<T>;

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

/// Calls a function with all members of a value, in the order of their declaration.
template <typename T, typename Do>
constexpr void withMembers(T& value, Do doWith)
{
    using Plain = std::remove_const_t<T>;
    if constexpr (isListed<Plain>) {
        std::apply([&](auto... member) { doWith(value.*member...); }, membersOf<Plain>);
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

/// Where values go.
struct Writer {
    static constexpr bool reads = false;
    bool isCompared = false;  ///< then without stopwatches; a zero has no sign, and NaN is NaN
    std::string bytes = {};

    template <typename Number>
    void raw(Number number)
    {
        if constexpr (std::is_floating_point_v<Number>) {
            const Number same =
                std::isnan(number) ? std::numeric_limits<Number>::quiet_NaN() : number + Number{0};
            number = isCompared ? same : number;
        }
        bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
};

/// Where they come from. One that derives from it may `check` each value that it has read.
struct Reader {
    static constexpr bool reads = true;
    std::string_view bytes;

    [[noreturn]] static void refuse()
    {
        throw std::invalid_argument("bytes that are no value: damaged, or of another version");
    }
    /// \throws std::invalid_argument at the end of the bytes, and on a truth value that is none.
    template <typename Number>
    void raw(Number& number)
    {
        if (bytes.size() < sizeof number ||
            (std::is_same_v<Number, bool> && static_cast<unsigned char>(bytes.front()) > 1)) {
            refuse();
        }
        std::memcpy(&number, bytes.data(), sizeof number);
        bytes.remove_prefix(sizeof number);
    }
};

template <typename T>
inline constexpr bool isArray = false;
template <typename T, std::size_t size>
inline constexpr bool isArray<std::array<T, size>> = true;

/// Is it a list of a length of its own?
template <typename T>
inline constexpr bool isList =
    isA<T, std::vector> || std::is_same_v<T, std::string> || std::is_same_v<T, Eigen::VectorXd>;

template <typename Bytes, typename T>
void pass(Bytes& at, T& value);

/// The next value of a type: what a reader makes of it, `made(from, Type<T>())`, or member by
/// member.
template <typename T, typename Bytes>
[[nodiscard]] T take(Bytes& from)
{
    if constexpr (requires { made(from, Type<T>()); }) {
        return made(from, Type<T>());
    } else {
        T value{};
        pass(from, value);
        return value;
    }
}

/// How many, and each: what is there, or as many as are said to come.
template <typename Bytes, typename List>
void passList(Bytes& at, List& list)
{
    using Item = typename List::value_type;
    auto left = static_cast<std::uint64_t>(list.size());
    at.raw(left);
    if constexpr (Bytes::reads) {
        std::vector<Item> items;
        for (; left > 0; --left) {
            items.push_back(take<Item>(at));
        }
        if constexpr (std::is_same_v<List, Eigen::VectorXd>) {
            list = Eigen::VectorXd::Map(items.data(), static_cast<Eigen::Index>(items.size()));
        } else {
            list.assign(items.begin(), items.end());
        }
    } else {
        for (const Item& item : list) {
            pass(at, item);
        }
    }
}

/// Which of a variant, and that.
template <typename Bytes, typename Variant, std::size_t... k>
void passVariant(Bytes& at, Variant& value, std::index_sequence<k...>)
{
    auto index = static_cast<std::uint64_t>(value.index());
    at.raw(index);
    if constexpr (Bytes::reads) {
        if (!((index == k && (value.template emplace<k>(), true)) || ...)) {
            Bytes::refuse();
        }
    }
    std::visit([&at](auto& held) { pass(at, held); }, value);
}

/// A value into a Writer, or out of a Reader.
template <typename Bytes, typename T>
void pass(Bytes& at, T& value)
{
    using Plain = std::remove_const_t<T>;
    const auto passEach = [&at](auto&... member) { (pass(at, member), ...); };
    if constexpr (std::is_arithmetic_v<Plain> || std::is_enum_v<Plain>) {
        at.raw(value);
    } else if constexpr (std::is_same_v<Plain, std::complex<double>>) {
        std::array parts{value.real(), value.imag()};
        pass(at, parts);
        if constexpr (Bytes::reads) {
            value = {parts[0], parts[1]};
        }
    } else if constexpr (isA<Plain, std::optional>) {
        bool isThere = value.has_value();
        at.raw(isThere);
        if constexpr (Bytes::reads) {
            if (isThere) {
                value = take<typename Plain::value_type>(at);
            }
        } else if (isThere) {
            pass(at, *value);
        }
    } else if constexpr (isA<Plain, std::variant>) {
        passVariant(at, value, std::make_index_sequence<std::variant_size_v<Plain>>());
    } else if constexpr (isA<Plain, std::shared_ptr>) {
        using Held = typename Plain::element_type;
        if constexpr (Bytes::reads) {
            value = std::make_shared<Held>(take<std::remove_const_t<Held>>(at));
        } else {
            pass(at, *value);
        }
    } else if constexpr (isArray<Plain> || isA<Plain, std::tuple> || isA<Plain, std::pair>) {
        std::apply(passEach, value);
    } else if constexpr (isList<Plain>) {
        passList(at, value);
    } else if constexpr (!Bytes::reads && requires { value.seconds; }) {
        Plain timeless = value;
        timeless.seconds = at.isCompared ? 0.0 : value.seconds;
        withMembers(timeless, passEach);
    } else {
        withMembers(value, passEach);
    }
    if constexpr (requires { at.check(value); }) {
        at.check(value);
    }
}

}  // namespace signorini::answers
