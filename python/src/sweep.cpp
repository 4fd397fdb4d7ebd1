#include <pybind11/stl.h>

#include "described.hpp"
#include "excited_names.hpp"
#include "faults.hpp"
#include "force.hpp"
#include "patience.hpp"
#include "share_work.hpp"
#include "signorini/figures.hpp"
#include "sweep_answer.hpp"

namespace signorini::python {

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

namespace {

SweepAnswer sweep(const std::string& over, double least, double most, const std::string& force,
                  double damping, double amplitude, int derivative, double frequency,
                  std::int64_t points, const std::string& direction, std::int64_t periods,
                  bool rest, std::optional<double> resolve, std::int64_t cells,
                  std::int64_t threads, const Scene& scene, const py::object& progress)
{
    validate(scene);
    const Bar bar = answers::unitsOf(scene);
    SweepRange range{.over = valueOf("over", over, sweptNames),
                     .points = points,
                     .periods = periods,
                     .isCarried = !rest,
                     .cells = static_cast<double>(cells),
                     .place = placeOf(force),
                     .derivative = derivative,
                     .frequencyRatio = frequency,
                     .damping = {damping},
                     .stops = stopsOf(scene),
                     .segments = scene.segments,
                     .resolution = resolve.value_or(0.0) / scales(bar).time};
    const double unit = answers::unitOf(range.over, range.place, bar);
    range.least = least / unit;
    range.most = most / unit;
    range.amplitude = range.over == Swept::amplitude
                          ? range.least
                          : amplitude / amplitudeUnit(range.place, bar, derivative);
    std::vector<SweepDirection> directions{SweepDirection::up, SweepDirection::down};
    if (direction != "both") {
        directions = {valueOf("direction", direction, sweepDirections)};
    }
    Faults faults;
    faults.requirePositive("start", least, "ω₁, N or m, m, -");
    faults.requirePositive("to", most, "ω₁, N or m, m, -");
    if (most < least) {
        faults.add("to", most, fmt::format("at least start = {}", least));
    }
    if (resolve) {
        faults.requirePositive("resolve", *resolve, "s");
    }
    faults.throwIfAny();
    (void)valuesOf(range);
    faults.requireWhole("threads", threads, maxThreads);
    faults.throwIfAny();
    return patiently(
        [=](const Wires& wires) {
            SweepAnswer answer{range, scene, bar, {}, true, {}};
            answer.points = signorini::sweep(range, directions, wires.cancel, wires.progress,
                                             [threads](std::size_t count, const auto& serve) {
                                                 shareWork(count, threads, serve, {});
                                             });
            answer.isComplete =
                answer.points.size() == directions.size() * static_cast<std::size_t>(points);
            return answer;
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
    module.def("sweep", &sweep);
}

}  // namespace signorini::python
