#pragma once
/// \file
/// What each file adds to the module: classes of answers, and the calls that give them; and what
/// all of them are made with.

#include <pybind11/stl.h>

#include "arrays.hpp"
#include "asked.hpp"
#include "described.hpp"
#include "find_answer.hpp"
#include "patience.hpp"

namespace signorini::python {

namespace py = pybind11;

/// What `find(wires)` answers, tried beside its motions if "stability" is asked for.
/// \throws std::invalid_argument where a period then has too many steps.
template <typename Find>
[[nodiscard]] auto findPatiently(const Asked& asked, std::int64_t steps, Find find)
{
    const bool triesStability = asked.get<bool>("stability");
    if (triesStability) {
        answers::requireTried(steps);
    }
    return patiently([=](const Wires& wires) mutable {
        auto answer = find(wires);
        if (triesStability) {
            tryStability(answer, wires.cancel);
        }
        return answer;
    });
}

void addFind(py::module_& module);
void addContinuum(py::module_& module);
/// Families and modes; polytopes, and the motions of both.
void addLists(py::module_& module);
void addPolytopes(py::module_& module);
/// In files: made, and asked.
void addAtlas(py::module_& module);
/// Of one schedule, or under an exact harmonic; of all frequencies.
void addForced(py::module_& module);
void addSweep(py::module_& module);
/// The bar, event by event.
void addSimulate(py::module_& module);
/// Several bars in a row: motions of a schedule, and what they do event by event.
void addSceneFind(py::module_& module);
void addSceneSimulation(py::module_& module);

}  // namespace signorini::python
