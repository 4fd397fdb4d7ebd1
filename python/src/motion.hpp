#pragma once
/// \file
/// The field of a motion as Python asks for it.

#include <pybind11/pybind11.h>

#include <memory>

#include "modes_answer.hpp"
#include "scene.hpp"
#include "signorini/modes.hpp"
#include "signorini/motion.hpp"
#include "signorini/output.hpp"
#include "stepped_bar.hpp"

namespace signorini::python {

/// A motion on a grid, with what it is made of: the field is prepared when it is first asked for.
class GridMotion {
public:
    GridMotion() = default;
    GridMotion(std::shared_ptr<const State> atStart, Schedule followed, Scene where)
        : state(std::move(atStart)),
          schedule(std::move(followed)),
          scene(std::move(where)),
          bar(scene.segments.empty() ? scene.bar : firstMaterial(scene))
    {
    }

    std::shared_ptr<const State> state;
    Schedule schedule;
    Scene scene;
    Bar bar;  ///< whose units are the scene's

    /// O(n + N) the first time.
    [[nodiscard]] const std::shared_ptr<const Motion>& field() const;

private:
    mutable std::shared_ptr<const Motion> field_ = nullptr;
};

using answers::ModeAnswer;
using answers::PolytopeAnswer;

void addMotion(py::module_& module);

/// u, v, s and the force on the wall, on arrays of x and t.
void addModeFields(Record<ModeAnswer>& record);
void addModeFields(Record<PolytopeAnswer>& record);

}  // namespace signorini::python
