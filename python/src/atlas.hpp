#pragma once
/// \file
/// Atlases in files: made, and asked.

#include <pybind11/pybind11.h>

namespace signorini::python {

namespace py = pybind11;

void addAtlas(py::module_& module);

}  // namespace signorini::python
