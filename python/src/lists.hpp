#pragma once
/// \file
/// Families, modes and polytopes, one by one and in lists.

#include <pybind11/pybind11.h>

#include "arrays.hpp"
#include "motion.hpp"

namespace signorini::python {

namespace py = pybind11;

/// A function of the period [L/c] on an array of them.
template <typename F>
[[nodiscard]] py::object onPeriods(const py::object& periods, F f)
{
    return Grid(py::float_(0.0), periods).of([f](double, double period) { return f(period); });
}

/// Families, modes, and their motions.
void addLists(py::module_& module);
/// Motions with several contacts, on no grid.
void addPolytopes(py::module_& module);
/// The motions of both.
void addModeMotions(py::module_& module);

}  // namespace signorini::python
