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

/// Cells where nothing is said.
inline constexpr std::int64_t usualCells = 300;

/// Of [(n_c, n_f, is it on the second stop?), ...]. \throws ValueError.
[[nodiscard]] Schedule scheduleOf(const py::list& phases, std::optional<std::int64_t> cells);

/// Adds Bar, Segment, Scene, Schedule and State to the module.
void addScene(py::module_& module);
void addState(py::module_& module);

}  // namespace signorini::python
