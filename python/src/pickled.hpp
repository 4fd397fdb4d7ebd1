#pragma once
/// \file
/// C++ values as bytes, and back: what a pickle holds. Two values are equal if their bytes are.

#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <complex>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "description.hpp"
#include "members.hpp"

namespace signorini::python {

namespace py = pybind11;

/// \throws ValueError that says so.
[[noreturn]] void refusePickle();

/// Where values go.
struct Writer {
    bool isCompared = false;  ///< then without stopwatches; a zero has no sign, and NaN is NaN
    std::string bytes = {};

    template <typename Number>
    void raw(Number number)
    {
        bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
};

/// Where they come from. \throws ValueError at the end of it.
struct Reader {
    std::string_view bytes;

    template <typename Number>
    [[nodiscard]] Number raw()
    {
        Number number{};
        if (bytes.size() < sizeof number) {
            refusePickle();
        }
        std::memcpy(&number, bytes.data(), sizeof number);
        bytes.remove_prefix(sizeof number);
        return number;
    }
    /// How many of what needs a byte at least.
    [[nodiscard]] std::size_t count()
    {
        const auto size = raw<std::uint64_t>();
        if (size > bytes.size()) {
            refusePickle();
        }
        return static_cast<std::size_t>(size);
    }
};

template <typename T>
inline constexpr bool isArray = false;
template <typename T, std::size_t size>
inline constexpr bool isArray<std::array<T, size>> = true;

/// Is it a list of a length of its own?
template <typename T>
inline constexpr bool isList = answers::isA<T, std::vector> || std::is_same_v<T, std::string> ||
                               std::is_same_v<T, Eigen::VectorXd>;

template <typename T>
void put(Writer& to, const T& value)
{
    if constexpr (std::is_floating_point_v<T>) {
        const T same = value == value ? value + T{0} : std::numeric_limits<T>::quiet_NaN();
        to.raw(to.isCompared ? same : value);
    } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
        to.raw(value);
    } else if constexpr (std::is_same_v<T, std::complex<double>>) {
        put(to, value.real());
        put(to, value.imag());
    } else if constexpr (answers::isA<T, std::optional>) {
        to.raw(value.has_value());
        if (value) {
            put(to, *value);
        }
    } else if constexpr (answers::isA<T, std::variant>) {
        to.raw(static_cast<std::uint64_t>(value.index()));
        std::visit([&to](const auto& held) { put(to, held); }, value);
    } else if constexpr (answers::isA<T, std::shared_ptr>) {
        put(to, *value);
    } else if constexpr (isArray<T>) {
        for (const auto& item : value) {
            put(to, item);
        }
    } else if constexpr (isList<T>) {
        to.raw(static_cast<std::uint64_t>(value.size()));
        for (const typename T::value_type& item : value) {
            put(to, item);
        }
    } else if constexpr (requires { value.seconds; }) {
        T timeless = value;
        timeless.seconds = to.isCompared ? 0.0 : value.seconds;
        withMembers(timeless, [&to](const auto&... member) { (put(to, member), ...); });
    } else {
        withMembers(value, [&to](const auto&... member) { (put(to, member), ...); });
    }
}

/// \throws ValueError on what is none of the library's values.
template <typename T>
void check(const T& value)
{
    bool isReal = true;
    if constexpr (std::is_same_v<T, State>) {
        isReal = value.a.size() == value.b.size();
    } else if constexpr (std::is_same_v<T, Mode>) {
        isReal = findMode(value.a, value.b, value.gapSign) == value;
    } else if constexpr (std::is_same_v<T, ModePolytope>) {
        const std::vector<ModePolytope> real = polytopesOf(value.chains);
        isReal = std::find(real.begin(), real.end(), value) != real.end();
    } else if constexpr (std::is_enum_v<T> && requires { name(value); }) {
        (void)name(value);  // throws where there is none
    } else if constexpr (requires { validate(value); }) {
        validate(value);
    }
    if (!isReal) {
        refusePickle();
    }
}

template <typename T>
[[nodiscard]] T take(Reader& from)
{
    if constexpr (std::is_same_v<T, bool>) {
        const auto bit = from.raw<unsigned char>();
        if (bit > 1) {
            refusePickle();
        }
        return bit == 1;
    } else if constexpr (std::is_arithmetic_v<T>) {
        return from.raw<T>();
    } else if constexpr (std::is_same_v<T, std::complex<double>>) {
        const auto real = from.raw<double>();
        return {real, from.raw<double>()};
    } else if constexpr (answers::isA<T, std::optional>) {
        return take<bool>(from) ? T(take<typename T::value_type>(from)) : T();
    } else if constexpr (answers::isA<T, std::variant>) {
        const auto index = from.raw<std::uint64_t>();
        T value;
        const auto takeOne = [&]<std::size_t... k>(std::index_sequence<k...>)
        {
            return ((index == k && (value = take<std::variant_alternative_t<k, T>>(from), true)) ||
                    ...);
        };
        if (!takeOne(std::make_index_sequence<std::variant_size_v<T>>())) {
            refusePickle();
        }
        return value;
    } else if constexpr (answers::isA<T, std::shared_ptr>) {
        return std::make_shared<typename T::element_type>(
            take<std::remove_const_t<typename T::element_type>>(from));
    } else if constexpr (isList<T>) {
        std::vector<typename T::value_type> list;
        for (std::size_t left = from.count(); left > 0; --left) {
            list.push_back(take<typename T::value_type>(from));
        }
        if constexpr (std::is_same_v<T, Eigen::VectorXd>) {
            return Eigen::VectorXd::Map(list.data(), static_cast<Eigen::Index>(list.size()));
        } else {
            return T(list.begin(), list.end());
        }
    } else {
        T value{};
        if constexpr (std::is_enum_v<T>) {
            value = from.raw<T>();
        } else if constexpr (isArray<T>) {
            for (auto& item : value) {
                item = take<std::remove_cvref_t<decltype(item)>>(from);
            }
        } else {
            withMembers(value, [&from](auto&... member) {
                ((member = take<std::remove_cvref_t<decltype(member)>>(from)), ...);
            });
        }
        check(value);
        return value;
    }
}

/// What a set was decided with: it is solved for anew.
template <>
inline void put(Writer& /*to*/, const std::shared_ptr<const NetworkForced>& /*value*/)
{
}
template <>
inline std::shared_ptr<const NetworkForced> take(Reader& /*from*/)
{
    return {};
}

template <typename T>
[[nodiscard]] std::string bytesOf(const T& value, bool isCompared)
{
    Writer to{isCompared};
    put(to, value);
    return to.bytes;
}

/// The bytes of an object of a class, and a new value of all of them, nullptr
/// if some are left.
using BytesOf = std::string (*)(py::handle value, bool isCompared);
using MadeOf = void* (*)(Reader& from);

}  // namespace signorini::python
