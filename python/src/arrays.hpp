#pragma once
/// \file
/// Numbers to and from Python: with their units, in any array of NumPy or what can be made one, on
/// our own memory; and functions on arrays of any shape.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "options.hpp"

namespace signorini::python {

namespace py = pybind11;
using namespace answers;

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// A number in the unit of its argument, or text with a unit of its own: "0.1mm".
using Quantity = std::variant<double, std::string>;

/// The program's options that are called as an argument is.
[[nodiscard]] const std::vector<const Option*>& optionsNamed(std::string_view argument);

/// In which the program takes such an option; "-" if there is none.
[[nodiscard]] std::string unitOfOption(std::string_view name);

/// Of an argument, in that unit.
/// \throws std::invalid_argument naming the argument
[[nodiscard]] double quantityOf(const std::string& name, const Quantity& given,
                                const std::string& unit);
[[nodiscard]] inline double quantityOf(const std::string& name, const Quantity& given)
{
    return quantityOf(name, given, unitOfOption(name));
}
[[nodiscard]] inline std::optional<double> quantityOf(const std::string& name,
                                                      const std::optional<Quantity>& given)
{
    return given ? std::optional(quantityOf(name, *given)) : std::nullopt;
}

/// Of an array that a method makes: 800 MB.
inline constexpr std::int64_t mostCells = 100'000'000;

/// A UserWarning about what is hardly meant. \throws py::error_already_set where warnings are
/// errors.
inline void warnIf(bool isOdd, const char* what)
{
    if (isOdd && PyErr_WarnEx(PyExc_UserWarning, what, 2) != 0) {
        throw py::error_already_set();
    }
}

/// No text, no complex numbers.
/// \throws py::type_error naming the argument
[[nodiscard]] Numbers numbersOf(const py::object& given, const char* name);

/// A read-only array on memory that `owner` keeps alive; `stride` in bytes.
[[nodiscard]] py::array_t<double> view(const double* first, std::size_t count,
                                       std::shared_ptr<const void> owner,
                                       std::size_t stride = sizeof(double));

/// The same for one member of each struct in a list.
template <typename T>
[[nodiscard]] py::array_t<double> view(const std::vector<T>& list, double T::*member,
                                       std::shared_ptr<const void> owner)
{
    const double* first = list.empty() ? nullptr : &(list.front().*member);
    return view(first, list.size(), std::move(owner), sizeof(T));
}

/// A fresh array with f(0), f(1), ...
template <typename F>
[[nodiscard]] py::array_t<double> filled(std::int64_t count, F f)
{
    py::array_t<double> array(static_cast<py::ssize_t>(count));
    double* to = array.mutable_data();
    const py::gil_scoped_release release;
    for (std::int64_t k = 0; k < count; ++k) {
        to[k] = f(k);
    }
    return array;
}

/// f of each number: an array of their shape, or a number if it is one.
template <typename F>
[[nodiscard]] py::object onEach(const py::object& numbers, F f)
{
    return py::vectorize(f)(numbersOf(numbers, "t"));
}

}  // namespace signorini::python
