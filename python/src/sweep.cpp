#include <pybind11/stl.h>

#include "described.hpp"
#include "excited_names.hpp"
#include "faults.hpp"
#include "force.hpp"
#include "journal.hpp"
#include "patience.hpp"
#include "share_work.hpp"
#include "signorini/figures.hpp"
#include "study_answer.hpp"

namespace signorini::python {

using answers::StudyCase;
using answers::StudyPoint;
using answers::SweepAnswer;
using answers::SweepPointOf;

SIGNORINI_MEMBERS(SweepPoint, &T::value, &T::frequencyRatio, &T::direction, &T::settling,
                  &T::watched, &T::contacts, &T::impulse, &T::meanContacts, &T::meanImpulse,
                  &T::impulses, &T::meanForce, &T::tip, &T::strain);
SIGNORINI_MEMBERS(SweepRange, &T::over, &T::least, &T::most, &T::points, &T::periods, &T::isCarried,
                  &T::cells, &T::place, &T::amplitude, &T::derivative, &T::frequencyRatio,
                  &T::damping, &T::stops, &T::segments, &T::resolution);
SIGNORINI_MEMBERS(SweepPointOf, &T::value, &T::over, &T::place, &T::bar);
SIGNORINI_MEMBERS(SweepAnswer, &T::range, &T::scene, &T::bar, &T::points, &T::isComplete,
                  &T::yieldStress);

SIGNORINI_MEMBERS(StudyPoint, &T::gap, &T::damping, &T::amplitude, &T::impulse, &T::frequency,
                  &T::meanForce, &T::strain, &T::stress, &T::from, &T::to, &T::irregular);

namespace {

/// A sweep without points, its numbers being in SI units. \throws std::invalid_argument.
SweepAnswer asked(SweepRange range, const Scene& scene, double least, double most, double amplitude)
{
    validate(scene);
    const Bar bar = answers::unitsOf(scene);
    const double unit = answers::unitOf(range.over, range.place, bar);
    range.least = least / unit;
    range.most = most / unit;
    range.amplitude = range.over == Swept::amplitude
                          ? range.least
                          : amplitude / amplitudeUnit(range.place, bar, range.derivative);
    range.stops = stopsOf(scene);
    range.segments = scene.segments;
    range.resolution /= scales(bar).time;
    Faults faults;
    faults.requirePositive("start", least, "ω₁, N or m, m, -");
    faults.requirePositive("to", most, "ω₁, N or m, m, -");
    if (most < least) {
        faults.add("to", most, fmt::format("at least start = {}", least));
    }
    faults.throwIfAny();
    (void)valuesOf(range);
    return {range, scene, bar, {}, true, {}};
}

void requireThreads(std::int64_t threads)
{
    Faults faults;
    faults.requireWhole("threads", threads, maxThreads);
    faults.throwIfAny();
}

SweepAnswer sweep(const std::string& over, double least, double most, const std::string& force,
                  double damping, double amplitude, int derivative, double frequency,
                  std::int64_t points, const std::string& direction, std::int64_t periods,
                  bool rest, std::optional<double> resolve, std::int64_t cells,
                  std::int64_t threads, const Scene& scene, const std::string& file,
                  const std::string& question, const py::object& progress)
{
    Faults faults;
    if (resolve) {
        faults.requirePositive("resolve", *resolve, "s");
    }
    faults.throwIfAny();
    std::vector<SweepDirection> directions{SweepDirection::up, SweepDirection::down};
    if (direction != "both") {
        directions = {valueOf("direction", direction, sweepDirections)};
    }
    SweepAnswer answer = asked({.over = valueOf("over", over, sweptNames),
                                .points = points,
                                .periods = periods,
                                .isCarried = !rest,
                                .cells = static_cast<double>(cells),
                                .place = placeOf(force),
                                .derivative = derivative,
                                .frequencyRatio = frequency,
                                .damping = {damping},
                                .resolution = resolve.value_or(0.0)},
                               scene, least, most, amplitude);
    requireThreads(threads);
    return patiently(
        [=](const Wires& wires) mutable {
            std::optional<Journal> journal;
            if (!file.empty()) {
                journal.emplace(file, question, true);
            }
            answer.points =
                sweepThrough(answer.range, nullptr, directions, journal ? &*journal : nullptr,
                             threads, {.cancel = wires.cancel, .show = wires.progress});
            answer.isComplete =
                answer.points.size() == directions.size() * static_cast<std::size_t>(points);
            return answer;
        },
        progress);
}

/// Cases are (scene, damping, amplitude).
std::vector<StudyPoint> study(const std::vector<std::tuple<Scene, double, double>>& cases,
                              const std::string& force, double least, double most,
                              std::int64_t points, std::int64_t periods, std::int64_t cells,
                              std::int64_t threads, const std::string& file,
                              const std::string& question, const py::object& progress)
{
    std::vector<StudyCase> all;
    for (const auto& [scene, damping, amplitude] : cases) {
        all.push_back({asked({.points = points,
                              .periods = periods,
                              .cells = static_cast<double>(cells),
                              .place = placeOf(force),
                              .damping = {damping}},
                             scene, least, most, amplitude),
                       amplitude});
    }
    requireThreads(threads);
    return patiently(
        [=](const Wires& wires) {
            const RowOf row = [&](std::size_t k) -> std::optional<std::string> {
                const auto point = answers::studyAt(all[k], wires.cancel);
                return point ? std::optional(answers::rowOf(*point)) : std::nullopt;
            };
            std::vector<std::string> keys;
            for (const StudyCase& one : all) {
                keys.push_back(answers::keyOf(one));
            }
            std::vector<StudyPoint> done;
            for (const std::string& text : tabulated({.file = file,
                                           .question = question,
                                           .header = answers::studyHeader(),
                                           .keys = keys,
                                           .resumes = true,
                                           .deal = byThreads(row, threads),
                                           .show = wires.progress})) {
                if (!text.empty()) {
                    done.push_back(answers::studyPointOf(text));
                }
            }
            return done;
        },
        progress);
}

}  // namespace

void addSweep(py::module_& module)
{
    classOf<SweepPointOf>(module);
    classOf<SweepAnswer>(module)->more().def("_figure", [](const SweepAnswer& answer) {
        return asJson(sweepFigure(answer.points, answer.range, answer.bar, {}));
    });
    classOf<StudyPoint>(module);
    module.def("sweep", &sweep);
    module.def("study", &study);
}

}  // namespace signorini::python
