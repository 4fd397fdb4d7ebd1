#pragma once
/// \file
/// Numbers that a caller gives, in any array of NumPy or what can be made one.

#include <pybind11/numpy.h>

#include <cstdint>

namespace signorini::python {

namespace py = pybind11;

using Numbers = py::array_t<double, py::array::forcecast>;

/// Of an array that a method makes: 800 MB.
inline constexpr std::int64_t mostCells = 100'000'000;

/// No text, no complex numbers.
/// \throws py::type_error naming the argument
[[nodiscard]] Numbers numbersOf(const py::object& given, const char* name);

}  // namespace signorini::python
