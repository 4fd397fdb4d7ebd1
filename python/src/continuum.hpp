#pragma once
/// \file
/// Curves of motions of one energy.

#include <pybind11/pybind11.h>

namespace signorini::python {

namespace py = pybind11;

void addContinuum(py::module_& module);

}  // namespace signorini::python
