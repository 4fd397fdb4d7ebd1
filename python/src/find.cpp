#include "find.hpp"

#include <pybind11/stl.h>

#include <cmath>

#include "demand_names.hpp"
#include "faults.hpp"
#include "motion.hpp"
#include "parts.hpp"
#include "patience.hpp"
#include "scene.hpp"
#include "signorini/output.hpp"

namespace signorini::python {

namespace {

using Shared = std::shared_ptr<Answer>;

/// A getter that reads the motion, None if there is none.
template <typename Get>
auto ofMotion(Get get)
{
    return [get](const Answer& answer) -> py::object {
        const auto& motion = answer.result.motion;
        return motion ? asObject(get(*motion)) : py::none();
    };
}

/// Without a gap nothing but the energy held gives a motion its size.
bool hasUnit(const Answer& answer)
{
    return answer.result.scene.bar.gap != 0.0;
}

py::object certificateOf(const Answer& answer)
{
    if (!answer.result.absence) {
        return py::none();
    }
    return std::visit([](const auto& proof) { return py::cast(proof); },
                      answer.result.absence->proof);
}

py::object detailOf(const PeriodicResult& result)
{
    if (!result.detail.empty()) {
        return py::str(result.detail);
    }
    if (result.absence) {
        if (const auto* exclusion = std::get_if<EnergyExclusion>(&result.absence->proof)) {
            return py::str(describe(*exclusion));
        }
    }
    return py::none();
}

/// [-], in the norm of the energy, relative to the target's.
double distance(const State& from, const State& target)
{
    return std::sqrt(energyRatio({from.a - target.a, from.b - target.b}) / energyRatio(target));
}

std::string represent(const Answer& answer)
{
    const PeriodicResult& r = answer.result;
    std::string text =
        fmt::format("Result({}, {}, T = {:.6g} s, omega/omega_1 = {:.6g}", name(r.status),
                    describe(r.schedule), r.period, r.frequencyRatio);
    if (r.motion) {
        text += fmt::format(", E = {:.6g} E_1, {}", r.motion->energyRatio, name(r.motion->contact));
    }
    if (r.set.kind && *r.set.kind != SetKind::empty) {
        text += fmt::format(", {} of dimension {}", name(*r.set.kind), r.set.dimension);
    }
    if (r.absence) {
        text += fmt::format(", {}", name(r.absence->reason));
    }
    return text + (r.detail.empty() ? ")" : fmt::format(": {})", r.detail));
}

void addResult(py::module_& module)
{
    Record<Answer> record(module, "Result", R"(What is known of a schedule.

`status` is "found", "none" (proved) or "undecided" (`detail` says why). Times, energies and forces
are in SI units, names that end in ``_ratio`` have none: energies in E_1, periods in L/c,
frequencies in omega_1.
)");
    record
        .key(
            "bar", [](const Answer& a) { return a.result.scene.bar; }, "Asked about.")
        .key(
            "stops", [](const Answer& a) { return stopsIn(a.result.scene); },
            "[{\"side\", \"place\" [m]}, ...].")
        .key(
            "segments", [](const Answer& a) { return a.result.scene.segments; },
            "[Segment, ...] of a stepped bar, clamp first.")
        .key(
            "static_force", [](const Answer& a) { return staticForce(a.result.scene); },
            "What the bar at rest presses on the wall with [N].")
        .key(
            "status", [](const Answer& a) { return nameOf(a.result.status); },
            "\"found\", \"none\" or \"undecided\".")
        .key(
            "cells", [](const Answer& a) { return a.result.schedule.cells; }, "N.")
        .key(
            "schedule", [](const Answer& a) { return a.result.schedule; }, "Asked about.")
        .key(
            "period", [](const Answer& a) { return a.result.period; }, "T [s].")
        .key(
            "period_ratio", [](const Answer& a) { return period(a.result.schedule); }, "c T/L.")
        .key(
            "frequency_ratio", [](const Answer& a) { return a.result.frequencyRatio; },
            "omega/omega_1.")
        .key(
            "kernel_dimension",
            [](const Answer& a) { return orNone(a.result.set.kernelDimension); }, "dim ker(W - 1).")
        .key(
            "solution_set",
            [](const Answer& a) {
                return orNone(a.result.set.kind, [&a](SetKind kind) {
                    return py::cast(SolutionSet{kind, a.result.set.dimension});
                });
            },
            "What the set of all motions looks like.")
        .key(
            "family", [](const Answer& a) { return orNone(a.result.set.family); },
            "To which it belongs: a FamilyPlace, of one contact that presses.")
        .key(
            "objective", [](const Answer& a) { return nameOf(a.result.how.objective); },
            "Which motion of the set this is.")
        .key("contact", ofMotion([](const FoundMotion& m) { return nameOf(m.contact); }),
             "\"pressing\" or \"grazing\".")
        .key("canonical_schedule",
             ofMotion([](const FoundMotion& m) { return pairsOf(m.canonical); }),
             "[(n_c, n_f), ...] with contact exactly where the wall is pressed.")
        .key("energy", ofMotion([](const FoundMotion& m) { return m.energy; }), "E [J].")
        .key(
            "energy_ratio",
            [](const Answer& a) -> py::object {
                return a.result.motion && hasUnit(a) ? py::cast(a.result.motion->energyRatio)
                                                     : py::none();
            },
            "E/E_1; None without a gap.")
        .key(
            "energy_ratio_range",
            [](const Answer& a) -> py::object {
                if (a.result.set.energy && hasUnit(a)) {
                    return boundsOf(*a.result.set.energy);
                }
                return a.result.motion ? py::object(py::make_tuple(py::none(), py::none()))
                                       : py::none();
            },
            "(least, most) E/E_1 of the whole set; None where unbounded or unknown.")
        .key(
            "energy_section", [](const Answer& a) { return orNone(a.result.set.held); },
            "The motions of the energy that was held: an EnergySection.")
        .key("physical", ofMotion([](const FoundMotion& m) { return m.physical; }),
             "What can be measured, in SI units: a Physical.")
        .key("admissible", ofMotion([](const FoundMotion& m) { return m.physical.isAdmissible(); }),
             "Is s > -1 everywhere?")
        .key("residuals", ofMotion([](const FoundMotion& m) { return m.residuals; }),
             "Recomputed by code that did not solve.")
        .key(
            "reason",
            [](const Answer& a) {
                return orNone(a.result.absence,
                              [](const Absence& absence) { return nameOf(absence.reason); });
            },
            "Why there is no motion, in a word.")
        .key("certificate", &certificateOf, "The proof that there is none.")
        .key(
            "route", [](const Answer& a) { return a.result.how.route; }, "Taken.")
        .key(
            "route_reason", [](const Answer& a) { return a.result.how.reason; }, "Why that one.")
        .key(
            "left_out", [](const Answer& a) { return a.result.how.leftOut; },
            "What the request did not need.")
        .key(
            "solver", [](const Answer& a) { return a.result.how.solver; }, "Who solved.")
        .keyIfAny("repetitions", ofMotion([](const FoundMotion& m) { return m.repetitions; }),
                  "How often the motion repeats within the period of the schedule.")
        .keyIfAny("pressing_phases", ofMotion([](const FoundMotion& m) { return m.pressing; }),
                  "For each phase: is the wall pressed at all?")
        .keyIfAny("symmetric", ofMotion([](const FoundMotion& m) { return m.isSymmetric; }),
                  "Two stops: is the second half of the period the first, mirrored?")
        .keyIfAny("peak_strain",
                  ofMotion([](const FoundMotion& m) { return m.physical.peakCompression; }),
                  "Deepest compression [-].")
        .keyIfAny(
            "target",
            [](const Answer& a) {
                return orNone(a.target, [](const Target& t) { return py::str(t.how); });
            },
            "How the target came onto the cells.")
        .keyIfAny(
            "distance",
            [](const Answer& a) -> py::object {
                if (!a.target || !a.result.motion) {
                    return py::none();
                }
                return py::float_(distance(a.result.motion->state, a.target->state));
            },
            "To the target [-], relative, in the norm of the energy.")
        .keyIfAny(
            "detail", [](const Answer& a) { return detailOf(a.result); },
            "Why undecided, or what the proof says.");
    record.more()
        .def_property_readonly(
            "state",
            [](const Shared& a) -> py::object {
                const auto& motion = a->result.motion;
                return motion ? py::cast(StateOf{std::shared_ptr<const State>(a, &motion->state),
                                                 firstMaterial(a->result.scene),
                                                 a->result.scene.segments})
                              : py::none();
            },
            "At t = 0, the start of the first contact: a State, or None.")
        .def_property_readonly(
            "motion",
            [](const Shared& a) -> py::object {
                const auto& motion = a->result.motion;
                return motion ? py::cast(GridMotion{std::shared_ptr<const State>(a, &motion->state),
                                                    a->result.schedule, a->result.scene})
                              : py::none();
            },
            "The field over one period: a Motion, or None.")
        .def_property_readonly(
            "scene", [](const Answer& a) { return a.result.scene; }, "Asked about: a Scene.")
        .def(
            "is_proof", [](const Answer& a) { return isProof(a.result); },
            "Checks the certificate once more, against rows made anew.")
        .def("__repr__", &represent);
}

/// Calls that end at once stay in the calling thread.
bool isQuick(const Schedule& schedule, const FindOptions& options)
{
    constexpr std::int64_t fewCells = 5000;
    return schedule.phases.size() == 1 && schedule.cells <= fewCells && options.solver == "auto" &&
           options.formulation == Formulation::automatic && !options.target &&
           std::isinf(options.strainLimit) && std::isinf(options.tipFloor);
}

template <typename Table>
auto named(const Table& table, const char* argument, const std::string& text)
{
    const auto value = valueIn(table, text);
    if (!value) {
        Faults faults;
        faults.add(argument, text, namesIn(table));
        faults.throwIfAny();
    }
    return *value;
}

using Number = std::optional<double>;

Answer find(const py::tuple& words, std::optional<std::int64_t> cells, const Scene& scene,
            const std::string& solver, const std::string& formulation, const std::string& objective,
            const std::optional<StateOf>& target, Number energy, Number energyRatio,
            Number strainLimit, Number tipFloor, double tolerance, Number timeLimit)
{
    const Schedule schedule = scheduleOf(words, cells);
    const Scales scale = scales(scene.bar);
    FindOptions options;
    options.scene = scene;
    options.solver = solver;
    options.formulation = named(formulationNames, "formulation", formulation);
    options.objective = named(objectiveNames, "objective", objective);
    if (energy && energyRatio) {
        throw std::invalid_argument("energy clashes with energy_ratio: allowed one of them");
    }
    options.energyRatio = energy ? Number(*energy / scale.energy) : energyRatio;
    if (strainLimit) {
        options.strainLimit = *strainLimit / scale.strain;
    }
    if (tipFloor) {
        options.tipFloor = *tipFloor / scale.displacement;
    }
    options.tolerance = tolerance;
    options.timeLimit = timeLimit.value_or(options.timeLimit);
    std::optional<Target> near;
    if (target) {
        near = {*target->value, fmt::format("a state of {} cells", target->value->cells())};
        options.target = near->state;
    }
    if (isQuick(schedule, options)) {
        const py::gil_scoped_release release;
        return {findPeriodic(schedule, options), std::move(near)};
    }
    return {patiently([schedule, options](const Wires& wires) mutable {
                options.cancel = wires.cancel;
                return findPeriodic(schedule, options);
            }),
            std::move(near)};
}

}  // namespace

void addFind(py::module_& module)
{
    addParts(module);
    addResult(module);
    module.def("find", &find);
    module.def("schedules_of_period",
               [](std::int64_t cells, std::int64_t steps, const Scene& scene) {
                   return schedulesOfPeriod(cells, steps, stopsOf(scene).right);
               });
}

}  // namespace signorini::python
