#pragma once
/// \file
/// The smaller records that answers hold.

#include "find_answer.hpp"
#include "record.hpp"

namespace signorini::python {

template <>
struct Members<answers::SolutionSet> {
    static constexpr auto list =
        std::tuple{&answers::SolutionSet::kind, &answers::SolutionSet::dimension};
};

void addParts(py::module_& module);

}  // namespace signorini::python
