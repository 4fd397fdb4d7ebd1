#pragma once
/// \file
/// Families and modes, one by one and in lists.

#include <pybind11/pybind11.h>

namespace signorini::python {

namespace py = pybind11;

void addLists(py::module_& module);

}  // namespace signorini::python
