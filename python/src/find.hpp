#pragma once
/// \file
/// Answers of `find` as Python has them.

#include <pybind11/pybind11.h>

#include "find_answer.hpp"
#include "record.hpp"

namespace signorini::python {

template <>
struct Members<answers::FindAnswer> {
    static constexpr auto list =
        std::tuple{&answers::FindAnswer::result, &answers::FindAnswer::target};
};

/// Adds the classes that answers are made of, `Result`, and `find`.
void addFind(py::module_& module);
/// The smaller records that answers hold.
void addParts(py::module_& module);

}  // namespace signorini::python
