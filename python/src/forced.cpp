#include "forced.hpp"

#include <pybind11/stl.h>

#include <cmath>

#include "described.hpp"
#include "excited_names.hpp"
#include "faults.hpp"
#include "force.hpp"
#include "motion.hpp"
#include "patience.hpp"
#include "scene.hpp"
#include "signorini/response.hpp"
#include "stops.hpp"

namespace signorini::python {

using answers::ForcedAnswer;
template <>
struct Members<ForcedAnswer> {
    static constexpr auto list =
        std::tuple{&ForcedAnswer::set,   &ForcedAnswer::scene,   &ForcedAnswer::bar,
                   &ForcedAnswer::asked, &ForcedAnswer::motions, &ForcedAnswer::exclusion};
};

namespace {

void addMotionOf(py::module_& module)
{
    classOf<MotionOf>(module)
        ->more()
        .def_property_readonly(
            "impulse_ratio", [](const MotionOf& m) { return m.value.extremes.impulse; },
            "[EA g/c] a period.")
        .def_property_readonly(
            "peak_force_ratio", [](const MotionOf& m) { return m.value.extremes.peakForce; },
            "[EA g/L]")
        .def_property_readonly(
            "tip_lowest_ratio", [](const MotionOf& m) { return m.value.extremes.lowestTip; }, "[g]")
        .def_property_readonly(
            "state",
            [](const std::shared_ptr<MotionOf>& m) {
                return StateOf{std::shared_ptr<const State>(m, &m->value.state), m->bar,
                               m->segments};
            },
            "At the start of contact: a State.");
}

ForcedAnswer findForced(const py::tuple& words, std::optional<std::int64_t> cells,
                        const Scene& scene, double damping, const std::string& force,
                        std::optional<double> asked, std::int64_t cycles,
                        std::optional<double> strainLimit)
{
    Schedule schedule = scheduleOf(words, cells);
    schedule.stops = stopsOf(scene);
    validate(schedule);
    const Bar& bar = scene.bar;
    if (!asked && canRest(schedule.phases, schedule.stops)) {
        throw std::invalid_argument(
            "amplitude is missing: allowed numbers > 0 [N or m]: without a gap motions are as "
            "small as one likes");
    }
    const Forcing forcing{placeOf(force), cycles, {}};
    ForcedLimits limits;
    if (strainLimit) {
        requireLimit(*strainLimit);
        limits.strain = *strainLimit / scales(bar).strain;
    }
    return patiently([=](const Wires&) {
        return answers::answerOf(forcedMotions(schedule, {damping}, forcing, limits), scene, asked);
    });
}

}  // namespace

void addForced(py::module_& module)
{
    addMotionOf(module);
    classOf<ForcedAnswer>(module);
    module.def("find_forced", &findForced);
}

Excited placeOf(const std::string& force)
{
    return valueOf("force", force, excitedNames);
}

}  // namespace signorini::python
