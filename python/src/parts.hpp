#pragma once
/// \file
/// The smaller records that answers hold.

#include "record.hpp"
#include "signorini/find_periodic.hpp"

namespace signorini::python {

/// Kind and dimension of a set of motions.
struct SolutionSet {
    SetKind kind = SetKind::empty;
    std::int64_t dimension = -1;
};

template <>
struct Members<SolutionSet> {
    static constexpr auto list = std::tuple{&SolutionSet::kind, &SolutionSet::dimension};
};

void addParts(py::module_& module);

}  // namespace signorini::python
