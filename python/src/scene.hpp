#pragma once
/// \file
/// Bar, schedule, state and motion as Python has them.

#include <memory>
#include <optional>

#include "modes_answer.hpp"
#include "parts.hpp"
#include "record.hpp"
#include "signorini/motion.hpp"
#include "stepped_bar.hpp"

namespace signorini::python {

/// A state, shared with the answer it is part of, and what gives it units: a uniform bar, that of
/// the first material, and its segments.
struct StateOf {
    std::shared_ptr<const State> value;
    Bar bar;
    std::vector<Segment> segments = {};
};

/// Cells where nothing is said.
inline constexpr std::int64_t usualCells = 300;

/// Of [(n_c, n_f, is it on the second stop?), ...]. \throws ValueError.
[[nodiscard]] Schedule scheduleOf(const py::list& phases, std::optional<std::int64_t> cells);

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

    /// At t = 0.
    [[nodiscard]] StateOf start() const { return {state, bar, scene.segments}; }
    /// O(n + N) the first time.
    [[nodiscard]] const std::shared_ptr<const Motion>& field() const;

private:
    mutable std::shared_ptr<const Motion> field_ = nullptr;
};

}  // namespace signorini::python
