#pragma once
/// \file
/// The bar, event by event.

#include <pybind11/pybind11.h>

namespace signorini::python {

namespace py = pybind11;

void addSimulate(py::module_& module);

}  // namespace signorini::python
