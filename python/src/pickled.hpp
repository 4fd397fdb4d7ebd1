#pragma once
/// \file
/// C++ values as tuples of Python's own, and back: what a pickle holds. And whether two are equal.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <array>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "members.hpp"

namespace signorini::python {

namespace py = pybind11;

/// How a value of type T travels: `put` to Python, `get` back, `same` for two of them.
template <typename T>
struct Travel {
    // Structs: a tuple of their members.
    static py::object put(const T& value)
    {
        return std::apply(
            [&](auto... member) {
                return py::make_tuple(
                    Travel<std::remove_cvref_t<decltype(value.*member)>>::put(value.*member)...);
            },
            Members<T>::list);
    }
    static T get(const py::handle& source)
    {
        const auto tuple = py::cast<py::tuple>(source);
        T value{};
        std::size_t at = 0;
        std::apply(
            [&](auto... member) {
                if (tuple.size() != sizeof...(member)) {
                    throw py::value_error("a pickle of another version of signorini");
                }
                ((value.*member =
                      Travel<std::remove_cvref_t<decltype(value.*member)>>::get(tuple[at++])),
                 ...);
            },
            Members<T>::list);
        return value;
    }
    static bool same(const T& one, const T& other)
    {
        return std::apply(
            [&](auto... member) {
                return (Travel<std::remove_cvref_t<decltype(one.*member)>>::same(one.*member,
                                                                                 other.*member) &&
                        ...);
            },
            Members<T>::list);
    }
};

/// Numbers, truth values and text are Python's own.
template <typename T>
requires(std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) struct Travel<T> {
    static py::object put(const T& value) { return py::cast(value); }
    static T get(const py::handle& source) { return py::cast<T>(source); }
    /// Two that are no numbers are the same.
    static bool same(const T& one, const T& other)
    {
        if constexpr (std::is_floating_point_v<T>) {
            return one == other || (one != one && other != other);
        } else {
            return one == other;
        }
    }
};

template <typename T>
requires std::is_enum_v<T>
struct Travel<T> {
    static py::object put(const T& value) { return py::int_(static_cast<int>(value)); }
    static T get(const py::handle& source) { return static_cast<T>(py::cast<int>(source)); }
    static bool same(const T& one, const T& other) { return one == other; }
};

template <typename T>
struct Travel<std::optional<T>> {
    static py::object put(const std::optional<T>& value)
    {
        return value ? py::object(py::make_tuple(Travel<T>::put(*value))) : py::none();
    }
    static std::optional<T> get(const py::handle& source)
    {
        if (source.is_none()) {
            return std::nullopt;
        }
        return Travel<T>::get(py::cast<py::tuple>(source)[0]);
    }
    static bool same(const std::optional<T>& one, const std::optional<T>& other)
    {
        return one.has_value() == other.has_value() && (!one || Travel<T>::same(*one, *other));
    }
};

template <typename T>
struct Travel<std::shared_ptr<const T>> {
    static py::object put(const std::shared_ptr<const T>& value) { return Travel<T>::put(*value); }
    static std::shared_ptr<const T> get(const py::handle& source)
    {
        return std::make_shared<const T>(Travel<T>::get(source));
    }
    static bool same(const std::shared_ptr<const T>& one, const std::shared_ptr<const T>& other)
    {
        return one == other || Travel<T>::same(*one, *other);
    }
};

/// Lists; of numbers as one string of bytes.
template <typename T>
struct Travel<std::vector<T>> {
    static constexpr bool isBytes = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;
    static py::object put(const std::vector<T>& values)
    {
        if constexpr (isBytes) {
            return py::bytes(reinterpret_cast<const char*>(values.data()),
                             values.size() * sizeof(T));
        } else {
            py::list list;
            for (const auto& value : values) {
                list.append(Travel<T>::put(value));
            }
            return list;
        }
    }
    static std::vector<T> get(const py::handle& source)
    {
        std::vector<T> values;
        if constexpr (isBytes) {
            const auto bytes = py::cast<std::string>(source);
            values.resize(bytes.size() / sizeof(T));
            if (!values.empty()) {
                std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
            }
        } else {
            for (const py::handle& item : py::cast<py::list>(source)) {
                values.push_back(Travel<T>::get(item));
            }
        }
        return values;
    }
    static bool same(const std::vector<T>& one, const std::vector<T>& other)
    {
        if (one.size() != other.size()) {
            return false;
        }
        for (std::size_t k = 0; k < one.size(); ++k) {
            if (!Travel<T>::same(one[k], other[k])) {
                return false;
            }
        }
        return true;
    }
};

template <>
struct Travel<Eigen::VectorXd> {
    static py::object put(const Eigen::VectorXd& values)
    {
        return py::bytes(reinterpret_cast<const char*>(values.data()),
                         static_cast<std::size_t>(values.size()) * sizeof(double));
    }
    static Eigen::VectorXd get(const py::handle& source)
    {
        const auto bytes = py::cast<std::string>(source);
        Eigen::VectorXd values(static_cast<Eigen::Index>(bytes.size() / sizeof(double)));
        if (values.size() > 0) {
            std::memcpy(values.data(), bytes.data(), bytes.size());
        }
        return values;
    }
    static bool same(const Eigen::VectorXd& one, const Eigen::VectorXd& other)
    {
        return one.size() == other.size() && one == other;
    }
};

template <typename T, std::size_t size>
struct Travel<std::array<T, size>> {
    static py::object put(const std::array<T, size>& values)
    {
        return Travel<std::vector<T>>::put({values.begin(), values.end()});
    }
    static std::array<T, size> get(const py::handle& source)
    {
        const std::vector<T> list = Travel<std::vector<T>>::get(source);
        if (list.size() != size) {
            throw py::value_error("a pickle of another version of signorini");
        }
        std::array<T, size> values{};
        std::copy(list.begin(), list.end(), values.begin());
        return values;
    }
    static bool same(const std::array<T, size>& one, const std::array<T, size>& other)
    {
        return one == other;
    }
};

template <typename... Ts>
struct Travel<std::variant<Ts...>> {
    using Variant = std::variant<Ts...>;
    static py::object put(const Variant& value)
    {
        return py::make_tuple(value.index(),
                              std::visit(
                                  [](const auto& held) {
                                      return Travel<std::remove_cvref_t<decltype(held)>>::put(held);
                                  },
                                  value));
    }
    static Variant get(const py::handle& source)
    {
        const auto tuple = py::cast<py::tuple>(source);
        const auto index = py::cast<std::size_t>(tuple[0]);
        Variant value;
        const py::object held = tuple[1];
        std::size_t at = 0;
        ((at++ == index ? void(value = Travel<Ts>::get(held)) : void()), ...);
        return value;
    }
    static bool same(const Variant& one, const Variant& other)
    {
        return one.index() == other.index() &&
               std::visit(
                   [&other](const auto& held) {
                       using T = std::remove_cvref_t<decltype(held)>;
                       return Travel<T>::same(held, std::get<T>(other));
                   },
                   one);
    }
};

}  // namespace signorini::python
