#pragma once
/// \file
/// Forced motions: those of one schedule, and the response.

#include <pybind11/pybind11.h>

namespace signorini::python {

namespace py = pybind11;

void addForced(py::module_& module);

void addResponse(py::module_& module);

}  // namespace signorini::python
