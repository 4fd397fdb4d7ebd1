#pragma once
/// \file
/// Calls: their arguments by name, as the package around the module hands them on, how they are
/// answered, and what each file adds to the module.

#include <fmt/format.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "arrays.hpp"
#include "call.hpp"
#include "excited_names.hpp"
#include "faults.hpp"
#include "find_answer.hpp"
#include "mapped.hpp"
#include "names.hpp"
#include "scene.hpp"
#include "scene_answer.hpp"
#include "signorini/figures.hpp"
#include "signorini/output.hpp"
#include "units.hpp"
#include "watch.hpp"

namespace signorini::python {

/// An option as an argument: "--from" is "start".
[[nodiscard]] std::string nameOf(std::string_view option);

/// Arguments of one call, by their names or those of the program's options; what is None was not
/// given.
class Asked : public py::dict, public Call {
public:
    using py::dict::dict;

    [[nodiscard]] py::object object(std::string_view name) const
    {
        PyObject* held = PyDict_GetItem(ptr(), keyOf(name));
        return held != nullptr ? py::reinterpret_borrow<py::object>(held) : py::none();
    }
    [[nodiscard]] bool has(std::string_view name) const override;
    [[nodiscard]] std::string text(std::string_view option) const override;
    [[nodiscard]] std::optional<double> number(std::string_view option) const override;
    [[nodiscard]] std::optional<std::int64_t> whole(std::string_view option) const override
    {
        return maybe<std::int64_t>(option);
    }
    [[nodiscard]] std::string called(std::string_view option) const override
    {
        return nameOf(option);
    }
    [[nodiscard]] std::string with(std::string_view option, const std::string& value) const override
    {
        return numberIn(value, "-") ? fmt::format("{}={}", nameOf(option), value)
                                    : fmt::format("{}=\"{}\"", nameOf(option), value);
    }

    /// \throws py::type_error naming the argument unless it is of this kind, or None;
    /// std::invalid_argument where an option of that name does not take such a number.
    template <typename T>
    [[nodiscard]] std::optional<T> maybe(std::string_view name) const
    {
        const py::object held = object(name);
        if (held.is_none()) {
            return std::nullopt;
        }
        try {
            if constexpr (std::is_same_v<T, double>) {
                if (py::isinstance<py::str>(held)) {
                    const double value =
                        quantityOf(nameOf(name), py::cast<std::string>(held), unitOfOption(name));
                    requireFits(name, value);
                    return value;
                }
            }
            const auto value = py::cast<T>(held);
            if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
                requireFits(name, static_cast<double>(value));
            }
            return value;
        } catch (const py::cast_error&) {
            refuseKind(name, kindOf<T>());
        }
    }
    /// The same of one that is always given.
    template <typename T>
    [[nodiscard]] T get(std::string_view name) const
    {
        std::optional<T> value = maybe<T>(name);
        if (!value) {
            refuseKind(name, kindOf<T>());
        }
        return *std::move(value);
    }

    [[nodiscard]] Bar bar() const { return get<Bar>("bar"); }
    [[nodiscard]] Scene scene() const { return get<Scene>("scene"); }
    /// A whole one, or its phases, and "cells".
    [[nodiscard]] Schedule schedule() const;
    [[nodiscard]] Damping damping() const { return {number("--damping").value_or(0.0)}; }
    /// Of "words", with the scales of "scene" and "gravity". \throws std::invalid_argument.
    [[nodiscard]] Assembly assembly() const;
    /// "tip" or "base", of "force".
    [[nodiscard]] Excited place() const { return named("--force", excitedNames).value(); }
    /// Cells where none are given.
    [[nodiscard]] std::int64_t cells() const { return whole("--cells").value_or(usualCells); }
    /// A fault of the library in the words of this call, one of these questions.
    [[nodiscard]] std::string inOptions(const std::string& message, unsigned questions) const
    {
        return answers::inOptions(message, questions,
                                  [this](std::string_view name) { return text(name); });
    }

private:
    template <typename T>
    static constexpr const char* kindOf()
    {
        if constexpr (std::is_same_v<T, bool>) {
            return "bool";
        } else if constexpr (std::is_integral_v<T>) {
            return "int, at most 64 bits";
        } else if constexpr (std::is_arithmetic_v<T>) {
            return "float, or text with its unit";
        } else if constexpr (std::is_same_v<T, std::string>) {
            return "str";
        } else if constexpr (std::is_same_v<T, StateOf>) {
            return "State, or the name of a file";
        } else {
            return "Scene or Bar";
        }
    }
    /// Names of arguments are few, and made into Python's text once.
    [[nodiscard]] static PyObject* keyOf(std::string_view name);
    void requireFits(std::string_view name, double value) const;
    [[noreturn]] void refuseKind(std::string_view name, const char* kind) const;
};

/// Long calls: Python stays alive, Ctrl-C ends them, and they say how far they are.
///
/// The job is done by a thread of its own without Python's lock; the calling thread looks every 10
/// ms whether a signal came and hands progress on. So nothing in the library waits for Python, and
/// a callback is called in the thread that called us. A job that does not stop within 40 ms of an
/// interrupt is left to end by itself unless it says otherwise: it owns all that it uses.
void runPatiently(const py::object& progress, std::function<void(const Watch&)> job,
                  bool canBeLeft);

/// The same for a job with a result.
template <typename Job>
[[nodiscard]] auto patiently(const py::object& progress, Job job, bool canBeLeft = true)
{
    using Result = decltype(job(std::declval<const Watch&>()));
    const auto result = std::make_shared<std::optional<Result>>();
    const auto own = std::make_shared<Job>(std::move(job));  // which need not be copied
    runPatiently(
        progress, [=](const Watch& watch) { result->emplace((*own)(watch)); }, canBeLeft);
    return std::move(**result);
}
template <typename Job>
[[nodiscard]] auto patiently(const Asked& asked, Job job)
{
    return patiently(asked.object("progress"), std::move(job));
}

/// A call of the module: the question that is made of its arguments, answered.
template <typename Make>
void addCall(py::module_& module, const char* name, Make make)
{
    module.def(name, [make](const Asked& asked) { return patiently(asked, make(asked)); });
}

void addScene(py::module_& module);
void addMotion(py::module_& module);
void addFind(py::module_& module);
void addModes(py::module_& module);
void addAtlas(py::module_& module);
void addForced(py::module_& module);
void addSimulate(py::module_& module);
void addSweep(py::module_& module);

}  // namespace signorini::python
