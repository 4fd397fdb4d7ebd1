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
#include "engine_names.hpp"
#include "excited_names.hpp"
#include "faults.hpp"
#include "find_answer.hpp"
#include "mapped.hpp"
#include "names.hpp"
#include "scene.hpp"
#include "signorini/figures.hpp"
#include "signorini/output.hpp"

namespace signorini::python {

/// Bars in a row, scaled by one. \throws std::invalid_argument.
[[nodiscard]] Assembly assemblyIn(const std::string& words, const Bar& bar, double gravity = 0.0);

/// Arguments of one call; what is None was not given.
class Asked : public py::dict {
public:
    using py::dict::dict;

    [[nodiscard]] py::object object(const char* name) const
    {
        PyObject* held = PyDict_GetItem(ptr(), keyOf(name));
        return held != nullptr ? py::reinterpret_borrow<py::object>(held) : py::none();
    }
    [[nodiscard]] bool has(const char* name) const { return !object(name).is_none(); }

    /// \throws py::type_error naming the argument unless it is of this kind, or None;
    /// std::invalid_argument where an option of that name does not take such a number.
    template <typename T>
    [[nodiscard]] std::optional<T> maybe(const char* name) const
    {
        const py::object held = object(name);
        if (held.is_none()) {
            return std::nullopt;
        }
        if constexpr (std::is_same_v<T, double>) {
            if (py::isinstance<py::str>(held)) {
                const double value = quantityOf(name, py::cast<std::string>(held), unitOf(name));
                requireFits(name, value);
                return value;
            }
        }
        try {
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
    [[nodiscard]] T get(const char* name) const
    {
        std::optional<T> value = maybe<T>(name);
        if (!value) {
            refuseKind(name, kindOf<T>());
        }
        return *std::move(value);
    }
    /// The same into its place, which keeps what is there where none is given.
    template <typename T>
    void read(const char* name, T& place) const
    {
        place = maybe<T>(name).value_or(place);
    }
    /// In such units.
    void read(const char* name, double& place, double unit) const
    {
        place = has(name) ? get<double>(name) / unit : place;
    }
    /// A frequency in ω₁, or as text in Hz: those of a bar.
    [[nodiscard]] double frequency(const char* name, const Bar& bar) const;
    /// A number, or text with the unit in which the program takes it.
    [[nodiscard]] double inUnit(const char* name, const char* unit) const;
    /// One of the names of a table. \throws std::invalid_argument naming the argument.
    template <typename Table>
    [[nodiscard]] auto named(const char* name, const Table& table) const
    {
        const auto word = get<std::string>(name);
        const auto value = valueIn(table, word);
        if (!value) {
            throwFault(name, word, namesIn(table));
        }
        return *value;
    }

    [[nodiscard]] Bar bar() const { return get<Bar>("bar"); }
    [[nodiscard]] Scene scene() const { return get<Scene>("scene"); }
    /// A whole one, or its phases, and "cells".
    [[nodiscard]] Schedule schedule() const;
    /// Of "energy" or "energy_ratio", if one is given.
    [[nodiscard]] std::optional<double> energyRatio(const Bar& bar) const;
    [[nodiscard]] Damping damping() const
    {
        const Damping damping{get<double>("damping")};
        warnIf(damping.ratio > likelyPercent, "damping above 1: percent are \"5%\" or 0.05");
        return damping;
    }
    /// The same, or none.
    [[nodiscard]] Damping dampingIfGiven() const { return has("damping") ? damping() : Damping{}; }
    /// Of "words", with the scales of "scene" and "gravity". \throws std::invalid_argument.
    [[nodiscard]] Assembly assembly() const;
    /// Of "period", "frequency" or "hertz" of bars, in steps.
    [[nodiscard]] std::int64_t steps(const Assembly& assembly, std::int64_t cycles) const;
    /// "tip" or "base", of "force".
    [[nodiscard]] Excited place() const { return named("force", excitedNames); }
    /// "amplitude" [N] or [m], where "derivative" is not 0 that of a base which moves with so many
    /// ω/ω₁.
    [[nodiscard]] std::optional<double> displacement(double frequencyRatio, const Bar& bar) const;

    /// How a curve is traced, of any bars.
    template <typename Options>
    void readCurve(Options& options) const
    {
        options.points = get<std::int64_t>("points");
        options.solver = solverOfEngine(get<std::string>("engine"));
        options.resolution = get<double>("resolution");
        options.tolerance = get<double>("tolerance");
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
    [[nodiscard]] static PyObject* keyOf(const char* name);
    /// In which the program takes an option of that name.
    [[nodiscard]] std::string unitOf(const char* name) const;
    void requireFits(const char* name, double value) const;
    [[noreturn]] void refuseKind(const char* name, const char* kind) const;
};

/// What a job may use: to ask whether it is to end, and to say how far it is.
struct Wires {
    Cancel cancel;
    std::function<void(double done, double total)> progress;

    /// Options of the library that end and tell so.
    template <typename Options>
    [[nodiscard]] Options on(Options options) const
    {
        options.cancel = cancel;
        if constexpr (requires { options.progress; }) {
            options.progress = progress;
        }
        return options;
    }
};

/// Long calls: Python stays alive, Ctrl-C ends them, and they say how far they are.
///
/// The job is done by a thread of its own without Python's lock; the calling thread looks every 10
/// ms whether a signal came and hands progress on. So nothing in the library waits for Python, and
/// a callback is called in the thread that called us. A job that does not stop within 40 ms of an
/// interrupt is left to end by itself unless it says otherwise: it owns all that it uses.
void runPatiently(const py::object& progress, std::function<void(const Wires&)> job,
                  bool canBeLeft);

/// The same for a job with a result.
template <typename Job>
[[nodiscard]] auto patiently(const py::object& progress, Job job, bool canBeLeft = true)
{
    using Result = decltype(job(std::declval<const Wires&>()));
    const auto result = std::make_shared<std::optional<Result>>();
    runPatiently(
        progress, [result, job](const Wires& wires) mutable { result->emplace(job(wires)); },
        canBeLeft);
    return std::move(**result);
}
template <typename Job>
[[nodiscard]] auto patiently(const Asked& asked, Job job)
{
    return patiently(asked.object("progress"), job);
}

/// What `find(wires)` answers, tried beside its motions if "stability" is asked for.
/// \throws std::invalid_argument where a period then has too many steps.
template <typename Find>
[[nodiscard]] auto findPatiently(const Asked& asked, std::int64_t steps, Find find)
{
    const bool triesStability = asked.get<bool>("stability");
    if (triesStability) {
        requireTried(steps);
    }
    return patiently(asked, [=](const Wires& wires) {
        auto answer = find(wires);
        if (triesStability) {
            tryStability(answer, wires.cancel);
        }
        return answer;
    });
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
