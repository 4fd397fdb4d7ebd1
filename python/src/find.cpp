#include "calls.hpp"

#include <cmath>

#include "continuum_answer.hpp"
#include "question_answer.hpp"
#include "scene_continuum_answer.hpp"
#include "scene_figures.hpp"
#include "scene_find_answer.hpp"
#include "scene_forced_answer.hpp"
#include "scene_question_answer.hpp"
#include "state_table.hpp"

namespace signorini::answers {

template <>
inline constexpr std::tuple membersOf<FindAnswer>{&FindAnswer::result, &FindAnswer::target,
                                                  &FindAnswer::stability};
template <>
inline constexpr std::tuple membersOf<ContinuumAnswer>{&ContinuumAnswer::curve};

}  // namespace signorini::answers

namespace signorini::python {

namespace {

/// The field of what was found.
std::optional<GridMotion> motionIn(const std::shared_ptr<FindAnswer>& a)
{
    const auto& found = a->result;
    return found.motion
               ? std::optional(GridMotion({a, &found.motion->state}, found.schedule, found.scene))
               : std::nullopt;
}

void addResult(py::module_& module)
{
    Record<FindAnswer>(module)
        .has("state", "At t = 0, the start of the first contact: a State, or None.",
             [](const std::shared_ptr<FindAnswer>& a) -> std::optional<StateOf> {
                 const auto motion = motionIn(a);
                 return motion ? std::optional(motion->start()) : std::nullopt;
             })
        .has("motion", "The field over one period: a Motion, or None.", &motionIn)
        .has("scene", "Asked about: a Scene.", [](const FindAnswer& a) { return a.result.scene; })
        .can("is_proof", "Checks the certificate once more, against rows made anew.",
             [](const FindAnswer& a) { return isProof(a.result); });
}

/// Searches that end at once stay in the calling thread.
bool isQuick(const Schedule& schedule, const FindOptions& options)
{
    constexpr std::int64_t fewCells = 5000;
    return schedule.phases.size() == 1 && schedule.cells <= fewCells && options.solver == "auto" &&
           options.formulation == Formulation::automatic && !options.target &&
           std::isinf(options.strainLimit) && std::isinf(options.tipFloor);
}

/// A search for motions of one bar, the same for each schedule.
struct Search {
    FindOptions options;
    std::string how = {};  ///< what the target is

    explicit Search(const Asked& asked) : options(findAsked(asked, asked.scene()))
    {
        if (const auto target = asked.maybe<StateOf>("target")) {
            how = fmt::format("a state of {} cells", target->value->cells());
            options.target = *target->value;
        }
    }
    [[nodiscard]] FindAnswer find(const Asked& asked, const Schedule& schedule) const
    {
        const auto question =
            tried<FindAnswer>(asked, steps(schedule), [=, of = *this](const Watch& watch) {
                return answerOf(findPeriodic(schedule, watch.on(of.options)), of.options, of.how);
            });
        if (asked.has("stability") || !isQuick(schedule, options)) {
            return patiently(asked, question);
        }
        const py::gil_scoped_release release;
        return question({});
    }
};

/// Of a period, a motion of each set.
py::dict findPeriod(const Asked& asked)
{
    const Search search(asked);
    const FindOptions& options = search.options;
    const std::int64_t cells = asked.cells();
    const auto [option, word] = asked.period();
    QuestionAnswer answer =
        questionOf(periodOnGrid(option, word, cells, options.scene.bar), cells, options);
    const auto schedules =
        schedulesOfPeriod(cells, answer.asked.steps, stopsOf(options.scene).right);
    answer.asked.word = asked.get<std::string>("said");
    answer.answers =
        mapped(schedules, [&](const Schedule& one) { return search.find(asked, one); });
    return dictionaryOf(answer);
}

/// One number of each point.
auto ofPoints(double ContinuumPoint::*member)
{
    return [member](const std::shared_ptr<ContinuumAnswer>& answer) {
        return view(answer->curve->points, member, answer);
    };
}

void addCurve(py::module_& module)
{
    Record<PointOf>(module)
        .has("state", "At t = 0: a State.",
             [](const PointOf& p) {
                 return StateOf{{p.point, &p.point->state}, p.curve->scene.bar};
             })
        .has("motion", "The field over one period: a Motion.", [](const PointOf& p) {
            return GridMotion({p.point, &p.point->state}, p.curve->schedule, p.curve->scene);
        });
    Record<ContinuumAnswer>(module)
        .has("lambda_", "Of each point, shape (points,).", ofPoints(&ContinuumPoint::lambda))
        .has("peak_strain", "Of each point [-].", ofPoints(&ContinuumPoint::peakStrain))
        .has("residual", "Of each point.", ofPoints(&ContinuumPoint::residual))
        .can("member", {"lambda_"},
             "The motion at a lambda: exact for the split pulse, else the nearest point. "
             "ValueError out of range.",
             [](const ContinuumAnswer& c, double lambda) {
                 return *ContinuumAnswer{c.curve, memberAt(*c.curve, lambda)}.member();
             })
        .draws([](const ContinuumAnswer& c) { return continuumFigure(*c.curve); });
}

/// Bars, and their schedule if a call has one.
BarsAsked barsIn(const Asked& asked)
{
    BarsAsked bars(asked, asked.assembly());
    if (asked.has("steps")) {
        bars.spans =
            spansOf(asked.get<std::vector<std::string>>("steps"), bars.network.contacts.size());
    }
    return bars;
}

/// Waves of a point of another curve, or in a file.
WavesOf wavesIn(const Asked& asked)
{
    return [&asked](const char* name, const BarsAsked& bars) -> std::optional<std::vector<double>> {
        if (!asked.has(name)) {
            return std::nullopt;
        }
        if (py::isinstance<SceneCurvePoint>(asked.object(name))) {
            return asked.get<SceneCurvePoint>(name).point().motion.waves;
        }
        return readNearestWaves(asked.get<std::string>(name), bars.network, barOf(bars.assembly));
    };
}

/// Pictures and files of the motions of an answer.
template <typename Answer>
void addMotions(Record<Answer>&& record)
{
    record
        .draws([](const Answer& a, std::size_t which) {
            const SceneSchedule& of = a.followed();
            return periodFigure(of.network(), a.claim(which), of.bars.assembly.length);
        })
        .moves([](const Answer& a, std::size_t most, std::size_t which) {
            const SceneSchedule& of = a.followed();
            const Network network = of.network();
            return barsFrames(of.bars.assembly, network, shownPeriod(network, a.claim(which)),
                              most);
        })
        .more()
        .def(
            "write",
            [](const Answer& a, const std::string& path, std::size_t which) {
                const NetworkClaim& motion = a.claim(which);
                OutputFiles files;
                writeStateTable(files.stage(path), a.followed().network(),
                                {motion.waves, motion.displacements});
                files.commit();
            },
            "Writes the state of a motion at t = 0: a table from which `simulate` starts, and that "
            "`find` takes as a target. OSError if it cannot be written.",
            py::arg("path"), py::arg("index") = 0);
}

}  // namespace

void addFind(py::module_& module)
{
    addClasses<Physical, FarkasCertificate, ProgramProof, SteppedProof, EnergyFloorProof,
               EnergyExclusion, SolutionSet, HeldEnergy, SolverReport, TentPlace, Of<Damping>,
               NetworkResiduals, SceneForcedMotion, SceneQuestionAnswer>(module);
    Record<Residuals>(module).can("worst", "The largest of them.", &Residuals::worst);
    addResult(module);
    addCurve(module);
    addMotions(Record<SceneFindAnswer>(module));
    addMotions(Record<SceneForcedAnswer>(module));
    Record<SceneCurvePoint> point(module);
    point.drawsScene([](const SceneCurvePoint& p) { return p.of->schedule.bars.assembly; });
    addMotions(std::move(point));
    Record<SceneContinuumAnswer>(module)
        .can("member", {"lambda_"},
             "The point of the curve nearest to a lambda. ValueError out of range.",
             [](const SceneContinuumAnswer& c, double lambda) {
                 return SceneCurvePoint{c.of, pointAt(c.curve(), lambda)};
             })
        .draws(&sceneContinuumFigure);
    module.def("find",
               [](const Asked& asked) { return Search(asked).find(asked, asked.schedule()); });
    module.def("find_period", &findPeriod);
    addCall(module, "continuum", [](const Asked& asked) {
        return continuumAsked(asked, asked.scene(), asked.schedule(), [&](const char* option) {
            return *asked.get<StateOf>(option).value;
        });
    });
    addCall(module, "find_bars",
            [](const Asked& asked) { return motionAsked(asked, barsIn(asked), wavesIn(asked)); });
    addCall(module, "continuum_bars", [](const Asked& asked) {
        return continuumAsked(asked, barsIn(asked), wavesIn(asked));
    });
    addCall(module, "find_period_bars",
            [](const Asked& asked) { return periodAsked(asked, barsIn(asked), wavesIn(asked)); });
    addCall(module, "find_forced_bars",
            [](const Asked& asked) { return forcedAsked(asked, barsIn(asked)); });
}

}  // namespace signorini::python
