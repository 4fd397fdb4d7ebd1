#pragma once
/// \file
/// Long calls: Python stays alive, Ctrl-C ends them, and they say how far they are.
///
/// The work is done by a thread of its own without Python's lock; the calling thread looks every 10
/// ms whether a signal came and hands progress on. So nothing in the library waits for Python, and
/// a callback is called in the thread that called us. Work that does not stop within 40 ms of an
/// interrupt is left to end by itself: it owns all that it uses.

#include <pybind11/pybind11.h>

#include <functional>
#include <memory>
#include <optional>

#include "signorini/control.hpp"

namespace signorini::python {

namespace py = pybind11;

/// What a job may use: to ask whether it is to end, and to say how far it is.
struct Wires {
    Cancel cancel;
    std::function<void(double done, double total)> progress;
};

/// Runs a job as said above. `canBeLeft`: may it go on alone after an interrupt?
void runPatiently(std::function<void(const Wires&)> job, const py::object& progress,
                  bool canBeLeft);

/// The same for a job with a result. The job owns, or shares, all that it uses.
template <typename Job>
[[nodiscard]] auto patiently(Job job, const py::object& progress = py::none(),
                             bool canBeLeft = true)
{
    using Result = decltype(job(std::declval<const Wires&>()));
    const auto result = std::make_shared<std::optional<Result>>();
    runPatiently([result, job](const Wires& wires) mutable { result->emplace(job(wires)); },
                 progress, canBeLeft);
    return std::move(**result);
}

}  // namespace signorini::python
