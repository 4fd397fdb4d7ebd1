#include "calls.hpp"

#include <cmath>

#include "demand_names.hpp"
#include "find_answer.hpp"
#include "motion.hpp"
#include "question_answer.hpp"
#include "signorini/output.hpp"

namespace signorini::python {

template <>
struct Members<answers::FindAnswer> {
    static constexpr auto list =
        std::tuple{&answers::FindAnswer::result, &answers::FindAnswer::target,
                   &answers::FindAnswer::stability};
};

namespace {

using Answer = answers::FindAnswer;
using SharedFind = std::shared_ptr<Answer>;

void addResult(py::module_& module)
{
    classOf<Answer>(module)
        ->has("state", "At t = 0, the start of the first contact: a State, or None.",
              [](const SharedFind& a) -> std::optional<StateOf> {
                  const auto& motion = a->result.motion;
                  return motion ? std::optional(StateOf{{a, &motion->state},
                                                        firstMaterial(a->result.scene),
                                                        a->result.scene.segments})
                                : std::nullopt;
              })
        .has("motion", "The field over one period: a Motion, or None.",
             [](const SharedFind& a) -> std::optional<GridMotion> {
                 const auto& motion = a->result.motion;
                 return motion ? std::optional(GridMotion{
                                     {a, &motion->state}, a->result.schedule, a->result.scene})
                               : std::nullopt;
             })
        .has("scene", "Asked about: a Scene.", [](const Answer& a) { return a.result.scene; })
        .more()
        .def(
            "is_proof", [](const Answer& a) { return isProof(a.result); },
            "Checks the certificate once more, against rows made anew.");
}

/// Calls that end at once stay in the calling thread.
bool isQuick(const Schedule& schedule, const FindOptions& options)
{
    constexpr std::int64_t fewCells = 5000;
    return schedule.phases.size() == 1 && schedule.cells <= fewCells && options.solver == "auto" &&
           options.formulation == Formulation::automatic && !options.target &&
           std::isinf(options.strainLimit) && std::isinf(options.tipFloor);
}

Answer find(const Asked& asked)
{
    const Schedule schedule = asked.schedule();
    FindOptions options;
    options.scene = asked.scene();
    const Bar units = answers::unitsOf(options.scene);
    const Scales scale = scales(units);
    options.solver = asked.get<std::string>("solver");
    options.formulation = asked.named("formulation", formulationNames);
    options.objective = asked.named("objective", objectiveNames);
    options.energyRatio = asked.energyRatio(units);
    options.strainLimit = asked.strainLimit(scale.strain);
    if (const auto floor = asked.maybe<double>("tip_floor")) {
        options.tipFloor = *floor / scale.displacement;
    }
    options.tolerance = asked.get<double>("tolerance");
    options.timeLimit = asked.maybe<double>("time_limit").value_or(options.timeLimit);
    const auto target = asked.maybe<StateOf>("target");
    std::string how;
    if (target) {
        how = fmt::format("a state of {} cells", target->value->cells());
        options.target = *target->value;
    }
    if (!asked.get<bool>("stability") && isQuick(schedule, options)) {
        const py::gil_scoped_release release;
        return answers::answerOf(findPeriodic(schedule, options), options, how);
    }
    return findPatiently(asked, steps(schedule), [=](const Wires& wires) mutable {
        options.cancel = wires.cancel;
        return answers::answerOf(findPeriodic(schedule, options), options, how);
    });
}

}  // namespace

void addFind(py::module_& module)
{
    addClasses<Physical, FarkasCertificate, ProgramProof, SteppedProof, EnergyFloorProof,
               EnergyExclusion, answers::SolutionSet, HeldEnergy, SolverReport, TentPlace,
               Of<Damping>>(module);
    classOf<Residuals>(module)->more().def("worst", &Residuals::worst, "The largest of them.");
    addResult(module);
    addCall(module, "find", &find);
    module.def("question", [](const py::dict& given, std::vector<Answer> sets) {
        const Asked asked(given);
        FindOptions options;
        options.scene = asked.scene();
        options.energyRatio = asked.energyRatio(answers::unitsOf(options.scene));
        answers::QuestionAnswer answer =
            answers::questionOf({asked.get<std::string>("option"), asked.get<std::string>("word"),
                                 asked.get<std::int64_t>("steps")},
                                asked.get<std::int64_t>("cells"), options);
        answer.answers = std::move(sets);
        return dictionaryOf(answer);
    });
    module.def("period_on_grid",
               [](const std::string& name, const std::string& word, std::int64_t cells,
                  const Bar& bar) { return answers::periodOnGrid(name, word, cells, bar).steps; });
    module.def("period_exactly", [](const std::string& name, const std::string& word,
                                    std::int64_t cells, const Bar& bar, std::int64_t cycles) {
        const ExactPeriod exact = answers::periodExactly(name, word, cells, bar, cycles);
        return std::pair(exact.numerator, exact.denominator);
    });
    module.def("schedules_of_period",
               [](std::int64_t cells, std::int64_t steps, const Scene& scene) {
                   return schedulesOfPeriod(cells, steps, stopsOf(scene).right);
               });
}

}  // namespace signorini::python
