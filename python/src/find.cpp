#include "find.hpp"

#include <pybind11/stl.h>

#include <cmath>

#include "answer_parts.hpp"
#include "demand_names.hpp"
#include "described.hpp"
#include "faults.hpp"
#include "motion.hpp"
#include "patience.hpp"
#include "question_answer.hpp"
#include "scene.hpp"
#include "signorini/output.hpp"

namespace signorini::python {

namespace {

using Answer = answers::FindAnswer;
using Shared = std::shared_ptr<Answer>;

std::string represent(const Answer& answer)
{
    const PeriodicResult& r = answer.result;
    std::string text =
        fmt::format("Result({}, {}, T = {:.6g} s, omega/omega_1 = {:.6g}", name(r.status),
                    describe(r.schedule), r.period, r.frequencyRatio);
    if (r.motion) {
        text += fmt::format(", E = {}, {}", energyAsText(r.motion->energyRatio, r.scene.bar),
                            name(r.motion->contact));
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
    classOf<Answer>(module)
        ->more()
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
    options.energyRatio = energy ? ratioOf(*energy, scene.bar) : energyRatio;
    if (strainLimit) {
        requireLimit(*strainLimit);
        options.strainLimit = *strainLimit / scale.strain;
    }
    if (tipFloor) {
        options.tipFloor = *tipFloor / scale.displacement;
    }
    options.tolerance = tolerance;
    options.timeLimit = timeLimit.value_or(options.timeLimit);
    std::string how;
    if (target) {
        how = fmt::format("a state of {} cells", target->value->cells());
        options.target = *target->value;
    }
    if (isQuick(schedule, options)) {
        const py::gil_scoped_release release;
        return answers::answerOf(findPeriodic(schedule, options), options, how);
    }
    return answers::answerOf(patiently([schedule, options](const Wires& wires) mutable {
                                 options.cancel = wires.cancel;
                                 return findPeriodic(schedule, options);
                             }),
                             options, how);
}

}  // namespace

void addFind(py::module_& module)
{
    addParts(module);
    addResult(module);
    classOf<answers::QuestionAnswer>(module);
    module.def("find", &find);
    module.def("question", [](const std::string& option, const std::string& word,
                              std::int64_t steps, std::int64_t cells, const Scene& scene,
                              Number energyRatio, std::vector<Answer> sets) {
        FindOptions options;
        options.scene = scene;
        options.energyRatio = energyRatio;
        answers::QuestionAnswer answer = answers::questionOf({option, word, steps}, cells, options);
        answer.answers = std::move(sets);
        return answer;
    });
    module.def("schedules_of_period",
               [](std::int64_t cells, std::int64_t steps, const Scene& scene) {
                   return schedulesOfPeriod(cells, steps, stopsOf(scene).right);
               });
}

}  // namespace signorini::python
