#pragma once
/// \file
/// Bar, schedule and state as Python has them.

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>

#include "parts.hpp"
#include "record.hpp"
#include "signorini/bar.hpp"
#include "signorini/motion.hpp"
#include "signorini/schedule.hpp"

namespace signorini::python {

/// A state, shared with the answer it is part of, and what gives it units: a uniform bar, that of
/// the first material, and its segments.
struct StateOf {
    std::shared_ptr<const State> value;
    Bar bar;
    std::vector<Segment> segments = {};
};

using answers::forceUnit;
using answers::impulseUnit;

/// E/E_1 of an energy [J] to hold. \throws ValueError unless it is finite and > 0.
[[nodiscard]] double ratioOf(double energy, const Bar& bar);

/// A whole number; errors name it. \throws TypeError, ValueError.
[[nodiscard]] std::int64_t wholeOf(const py::handle& value, const char* name);

/// The schedule in the arguments of a call: n_c, n_f, n_c, n_f, ..., or pairs of them, or one
/// Schedule; a phase on the second stop is (n_c, n_f, "left"). \throws ValueError, TypeError.
[[nodiscard]] Schedule scheduleOf(const py::tuple& words, std::optional<std::int64_t> cells);

/// Cells where nothing is said.
inline constexpr std::int64_t usualCells = 300;

/// Adds Bar, Segment, Scene, Schedule and State to the module.
void addScene(py::module_& module);
void addState(py::module_& module);

}  // namespace signorini::python
