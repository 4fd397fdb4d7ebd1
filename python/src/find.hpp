#pragma once
/// \file
/// Answers of `find` as Python has them.

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>

#include "record.hpp"
#include "signorini/find_periodic.hpp"

namespace signorini::python {

/// What a motion was to be near.
struct Target {
    State state;
    std::string how;
};

template <>
struct Members<Target> {
    static constexpr auto list = std::tuple{&Target::state, &Target::how};
};

/// An answer about one schedule.
struct Answer {
    PeriodicResult result;
    std::optional<Target> target;
};

template <>
struct Members<Answer> {
    static constexpr auto list = std::tuple{&Answer::result, &Answer::target};
};

/// Adds the classes that answers are made of, `Result`, and `find`.
void addFind(py::module_& module);

}  // namespace signorini::python
