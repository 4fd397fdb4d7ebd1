#pragma once
/// \file
/// C++ values as tuples of Python's own, and back: what a pickle holds. And whether two are equal.

#include <pybind11/complex.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <complex>
#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "members.hpp"

namespace signorini::python {

namespace py = pybind11;

/// The state of a pickle of this class: what it holds, and a sum over it, the class and the
/// version.
[[nodiscard]] py::tuple sealed(const py::handle& type, const py::object& content);

/// What it holds. \throws ValueError if it was changed on its way, or is not of this version and
/// class.
[[nodiscard]] py::tuple opened(const py::handle& type, const py::object& state);

/// \throws ValueError that says so.
[[noreturn]] void refusePickle();

/// Pickles of a class: `put` makes a tuple of a T, `get` what holds a T of such a tuple.
template <typename T, typename Put, typename Get>
[[nodiscard]] auto pickling(Put put, Get get)
{
    return py::pickle(
        [put](const T& value) { return py::object(sealed(py::type::of<T>(), put(value))); },
        [get](const py::object& state) {
            try {
                return get(opened(py::type::of<T>(), state));
            } catch (const std::bad_alloc&) {
                throw;
            } catch (const std::exception&) {
                refusePickle();
            }
        });
}

/// Numbers of a string of bytes, as a list of `Values` has them.
template <typename Values>
[[nodiscard]] Values numbersIn(const py::handle& source)
{
    using Number = typename Values::value_type;
    const std::string bytes = py::cast<py::bytes>(source);
    if (bytes.size() % sizeof(Number) != 0) {
        refusePickle();
    }
    Values values(static_cast<decltype(Values().size())>(bytes.size() / sizeof(Number)));
    if (!bytes.empty()) {
        std::memcpy(values.data(), bytes.data(), bytes.size());
    }
    return values;
}

/// How a value of type T travels: `put` to Python, `get` back, `same` for two of them.
template <typename T>
struct Travel {
    // Structs: a tuple of their members.
    static py::object put(const T& value)
    {
        return std::apply(
            [](const auto&... member) {
                return py::make_tuple(
                    Travel<std::remove_cvref_t<decltype(member)>>::put(member)...);
            },
            membersOf(value));
    }
    static T get(const py::handle& source)
    {
        const auto tuple = py::cast<py::tuple>(source);
        T value{};
        std::size_t at = 0;
        std::apply(
            [&](auto&... member) {
                if (tuple.size() != sizeof...(member)) {
                    refusePickle();
                }
                ((member = Travel<std::remove_cvref_t<decltype(member)>>::get(tuple[at++])), ...);
            },
            membersOf(value));
        if constexpr (std::is_same_v<T, State>) {
            if (value.a.size() != value.b.size()) {
                refusePickle();
            }
        } else if constexpr (std::is_same_v<T, Mode>) {
            if (findMode(value.a, value.b, value.gapSign) != value) {
                refusePickle();
            }
        } else if constexpr (std::is_same_v<T, ModePolytope>) {
            const std::vector<ModePolytope> real = polytopesOf(value.chains);
            if (std::find(real.begin(), real.end(), value) == real.end()) {
                refusePickle();
            }
        } else if constexpr (requires { validate(value); }) {
            validate(value);
        }
        return value;
    }
    static bool same(const T& one, const T& other)
    {
        if constexpr (std::is_same_v<T, SolverReport>) {
            // How long it took is no part of an answer.
            return one.name == other.name && one.iterations == other.iterations;
        }
        return [&]<std::size_t... k>(const auto& these, const auto& those,
                                     std::index_sequence<k...>)
        {
            return (Travel<std::remove_cvref_t<decltype(std::get<k>(these))>>::same(
                        std::get<k>(these), std::get<k>(those)) &&
                    ...);
        }
        (membersOf(one), membersOf(other),
         std::make_index_sequence<std::tuple_size_v<decltype(membersOf(one))>>());
    }
};

/// Numbers, truth values and text are Python's own.
template <typename T>
requires(std::is_arithmetic_v<T> || std::is_same_v<T, std::string> ||
         std::is_same_v<T, std::complex<double>>) struct Travel<T> {
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
    static T get(const py::handle& source)
    {
        const auto value = static_cast<T>(py::cast<int>(source));
        if constexpr (requires { name(value); }) {
            (void)name(value);  // throws where there is none
        }
        return value;
    }
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
        const auto held = py::cast<py::tuple>(source);
        if (held.size() != 1) {
            refusePickle();
        }
        return Travel<T>::get(held[0]);
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

/// What a set was decided with: it is solved for anew.
template <>
struct Travel<std::shared_ptr<const NetworkForced>> {
    using T = std::shared_ptr<const NetworkForced>;
    static py::object put(const T& /*value*/) { return py::none(); }
    static T get(const py::handle& /*source*/) { return {}; }
    static bool same(const T& /*one*/, const T& /*other*/) { return true; }
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
        if constexpr (isBytes) {
            return numbersIn<std::vector<T>>(source);
        } else {
            std::vector<T> values;
            for (const py::handle& item : py::cast<py::list>(source)) {
                values.push_back(Travel<T>::get(item));
            }
            return values;
        }
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
        return numbersIn<Eigen::VectorXd>(source);
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
            refusePickle();
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
        if (tuple.size() != 2 || index >= sizeof...(Ts)) {
            refusePickle();
        }
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
