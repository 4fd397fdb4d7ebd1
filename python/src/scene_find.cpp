#include "calls.hpp"

#include "demand_names.hpp"
#include "scene_continuum_answer.hpp"
#include "scene_figures.hpp"
#include "scene_find_answer.hpp"
#include "scene_question_answer.hpp"
#include "signorini/figures.hpp"
#include "signorini/output.hpp"
#include "state_table.hpp"

namespace signorini::python {

namespace {

using answers::SceneContinuumAnswer;
using answers::SceneCurvePoint;
using answers::SceneFindAnswer;
using answers::SceneForcedAnswer;
using answers::SceneQuestionAnswer;

/// A schedule of bars as a call names it.
struct AskedBars {
    Assembly assembly;
    Network network;
    std::vector<ContactSpan> schedule;

    explicit AskedBars(const Asked& asked)
        : assembly(asked.assembly()),
          network(networkOf(assembly)),
          schedule(spansOf(py::cast<std::vector<std::string>>(asked.object("steps")),
                           network.contacts.size()))
    {
        answers::limitStrain(network, assembly, asked.maybe<double>("strain_limit"));
    }
};

/// What is asked of a motion, and how it is looked for.
struct AskedWish {
    FindOptions options = {};
    NetworkWish wish = {};

    AskedWish(const Asked& asked, const Assembly& assembly, const Network& network)
    {
        options.solver = asked.get<std::string>("solver");
        options.objective = asked.named("objective", objectiveNames);
        options.tolerance = asked.get<double>("tolerance");
        options.timeLimit = asked.maybe<double>("time_limit").value_or(options.timeLimit);
        wish.objective = options.objective;
        wish.energy =
            heldEnergy(network, asked.maybe<double>("energy"), asked.maybe<double>("energy_ratio"));
        if (const auto file = asked.maybe<std::string>("target")) {
            wish.target = readNearestWaves(*file, network, answers::barOf(assembly));
        }
    }
};

SceneFindAnswer findInBars(const Asked& asked)
{
    const AskedBars of(asked);
    AskedWish asks(asked, of.assembly, of.network);
    return findPatiently(asked, stepsOf(of.schedule), [=](const Wires& wires) mutable {
        asks.options.cancel = wires.cancel;
        return answers::answerOf(of.assembly, of.network, of.schedule, asks.wish, asks.options);
    });
}

SceneQuestionAnswer findPeriodInBars(const Asked& asked)
{
    const Assembly assembly = asked.assembly();
    Network network = networkOf(assembly);
    answers::limitStrain(network, assembly, asked.maybe<double>("strain_limit"));
    const std::int64_t steps = asked.steps(assembly, 1);
    AskedWish asks(asked, assembly, network);
    return findPatiently(asked, steps, [=](const Wires& wires) mutable {
        asks.options.cancel = wires.cancel;
        return answers::questionOf(assembly, network, steps, asks.wish, asks.options,
                                   wires.progress);
    });
}

SceneForcedAnswer findForcedInBars(const Asked& asked)
{
    const AskedBars of(asked);
    const Forcing forcing{asked.place(), asked.get<std::int64_t>("cycles"), {}};
    const auto amplitude = asked.maybe<double>("amplitude");
    const auto derivative = asked.get<int>("derivative");
    return findPatiently(asked, stepsOf(of.schedule), [=](const Wires&) {
        return answers::forcedAnswerOf(of.assembly, of.network, of.schedule, forcing, amplitude,
                                       derivative);
    });
}

/// Waves of a point of another curve, or in a file.
std::optional<std::vector<double>> wavesOf(const Asked& asked, const char* name,
                                           const AskedBars& of)
{
    if (!asked.has(name)) {
        return std::nullopt;
    }
    if (py::isinstance<SceneCurvePoint>(asked.object(name))) {
        return asked.get<SceneCurvePoint>(name).point().motion.waves;
    }
    return readNearestWaves(asked.get<std::string>(name), of.network, answers::barOf(of.assembly));
}

SceneContinuumAnswer continuumInBars(const Asked& asked)
{
    const AskedBars of(asked);
    const double energy =
        *heldEnergy(of.network, asked.maybe<double>("energy"), asked.maybe<double>("energy_ratio"));
    NetworkCurveOptions options;
    asked.readCurve(options);
    options.from = wavesOf(asked, "start", of);
    options.to = wavesOf(asked, "to", of);
    options.direction = wavesOf(asked, "direction", of);
    options.isSample = asked.get<bool>("sample");
    options.seed = asked.maybe<std::uint64_t>("seed").value_or(options.seed);
    return patiently(
        [=](const Wires& wires) mutable {
            options.cancel = wires.cancel;
            options.progress = wires.progress;
            return answers::continuumOf(of.assembly, of.network, of.schedule, energy, options);
        },
        asked.progress());
}

const NetworkClaim& claimIn(const SceneFindAnswer& answer, std::size_t)
{
    if (!answer.motions.motion) {
        throw std::invalid_argument("no motion was found: there is nothing to draw or write");
    }
    return *answer.motions.motion;
}
const NetworkClaim& claimIn(const SceneForcedAnswer& answer, std::size_t which)
{
    return answer.motions.at(which).claim;
}
const NetworkClaim& claimIn(const SceneCurvePoint& point, std::size_t)
{
    return point.point().motion;
}

template <typename Answer>
const answers::SceneSchedule& scheduleIn(const Answer& answer)
{
    return answer.schedule;
}
const answers::SceneSchedule& scheduleIn(const SceneCurvePoint& point)
{
    return point.of->schedule;
}

/// Pictures and files of the motions of an answer.
template <typename Answer>
auto addMotions(py::module_& module)
{
    auto record = classOf<Answer>(module);
    record
        ->draws([](const Answer& a, std::size_t which) {
            return periodFigure(scheduleIn(a).network(), claimIn(a, which),
                                scheduleIn(a).bars.assembly.length);
        })
        .moves([](const Answer& a, std::size_t most, std::size_t which) {
            const Network network = scheduleIn(a).network();
            return barsFrames(scheduleIn(a).bars.assembly, network,
                              shownPeriod(network, claimIn(a, which)), most);
        })
        .more()
        .def(
            "write",
            [](const Answer& a, const std::string& path, std::size_t which) {
                const NetworkClaim& motion = claimIn(a, which);
                OutputFiles files;
                writeStateTable(files.stage(path), scheduleIn(a).network(),
                                {motion.waves, motion.displacements});
                files.commit();
            },
            "Writes the state of a motion at t = 0: a table from which `simulate` starts, and that "
            "`find` takes as a target. OSError if it cannot be written.",
            py::arg("path"), py::arg("index") = 0);
    return record;
}

}  // namespace

void addSceneFind(py::module_& module)
{
    addClasses<NetworkResiduals, answers::SceneForcedMotion, SceneQuestionAnswer>(module);
    addMotions<SceneFindAnswer>(module);
    addMotions<SceneForcedAnswer>(module);
    addMotions<SceneCurvePoint>(module)->drawsScene(
        [](const SceneCurvePoint& p) { return p.of->schedule.bars.assembly; });
    classOf<SceneContinuumAnswer>(module)
        ->can("member", {"lambda_"},
              "The point of the curve nearest to a lambda. ValueError out of range.",
              [](const SceneContinuumAnswer& c, double lambda) {
                  return SceneCurvePoint{c.of, pointAt(c.curve(), lambda)};
              })
        .draws(&sceneContinuumFigure);
    addCall(module, "find_bars", &findInBars);
    addCall(module, "continuum_bars", &continuumInBars);
    addCall(module, "find_period_bars", &findPeriodInBars);
    addCall(module, "find_forced_bars", &findForcedInBars);
}

}  // namespace signorini::python
