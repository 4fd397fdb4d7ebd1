#pragma once
/// \file
/// Forced motions: those of one schedule, the response, and what a bar settles on.

#include <pybind11/pybind11.h>

namespace signorini::python {

namespace py = pybind11;

void addForced(py::module_& module);

void addResponse(py::module_& module);

void addSweep(py::module_& module);

}  // namespace signorini::python
