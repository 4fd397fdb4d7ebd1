#pragma once
/// \file
/// Numbers that a caller gives, in any array of NumPy or what can be made one.

#include <pybind11/numpy.h>

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "options.hpp"

namespace signorini::python {

namespace py = pybind11;

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// A number in the unit of its argument, or text with a unit of its own: "0.1mm".
using Quantity = std::variant<double, std::string>;

/// The program's options that are called as an argument is.
[[nodiscard]] std::vector<const answers::Option*> optionsNamed(const std::string& argument);

/// In which the program takes such an option; "-" if there is none.
[[nodiscard]] std::string unitOfOption(const std::string& name);

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

}  // namespace signorini::python
