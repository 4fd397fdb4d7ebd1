#include "forced.hpp"

#include <pybind11/stl.h>

#include <cmath>

#include "described.hpp"
#include "excited_amplitude.hpp"
#include "excited_names.hpp"
#include "force.hpp"
#include "harmonic_answer.hpp"
#include "motion.hpp"
#include "patience.hpp"
#include "scene.hpp"
#include "signorini/response.hpp"
#include "stops.hpp"

namespace signorini::python {

using answers::ForcedAnswer;
using answers::HarmonicAnswer;
using answers::HarmonicContactOf;
using answers::HarmonicMotionOf;
SIGNORINI_MEMBERS(HarmonicPiece, &T::end, &T::wave);
SIGNORINI_MEMBERS(HarmonicContact, &T::begin, &T::end, &T::stop, &T::isPinned, &T::front,
                  &T::travel, &T::impulse, &T::peakForce, &T::speed);
SIGNORINI_MEMBERS(HarmonicMotion, &T::phase, &T::contacts, &T::pieces, &T::extremes, &T::residual);
SIGNORINI_MEMBERS(HarmonicProof, &T::isProved, &T::within, &T::aloneWithin, &T::why);
SIGNORINI_MEMBERS(HarmonicMotionOf, &T::value, &T::bar, &T::growth, &T::proof, &T::attracts);
SIGNORINI_MEMBERS(HarmonicAnswer, &T::period, &T::damping, &T::place, &T::cycles, &T::amplitude,
                  &T::scene, &T::bar, &T::contacts, &T::motions, &T::settledContacts,
                  &T::settledCycles);
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
                        std::optional<double> asked, int derivative, std::int64_t cycles,
                        std::optional<double> strainLimit)
{
    Schedule schedule = scheduleOf(words, cells);
    schedule.stops = stopsOf(scene);
    validate(schedule);
    const Bar bar = answers::unitsOf(scene);
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
    const double ratio = 4.0 * static_cast<double>(schedule.cells) * static_cast<double>(cycles) /
                         static_cast<double>(steps(schedule));
    const std::optional<double> amplitude =
        asked ? std::optional(displaced(*asked, derivative, ratio, bar)) : std::nullopt;
    return patiently([=](const Wires&) {
        return answers::answerOf(
            forcedMotions(schedule, {damping}, forcing, limits, scene.segments), scene, amplitude);
    });
}

HarmonicAnswer findHarmonic(std::int64_t numerator, std::int64_t denominator, const Scene& scene,
                            double damping, const std::string& force, double amplitude,
                            int derivative, std::int64_t cycles, std::int64_t contacts)
{
    validate(scene);
    Faults faults;
    faults.requireWhole("contacts", contacts, maxHarmonicContacts);
    faults.throwIfAny();
    const ExactPeriod period = exactPeriod(numerator, denominator);
    const double ratio = 4.0 * static_cast<double>(cycles) / period.value();
    const double meant = displaced(amplitude, derivative, ratio, answers::unitsOf(scene));
    return patiently([=](const Wires&) {
        return answers::answerOf(period, {damping}, placeOf(force), cycles, meant, scene, contacts);
    });
}

}  // namespace

void addForced(py::module_& module)
{
    addMotionOf(module);
    classOf<ForcedAnswer>(module);
    module.def("find_forced", &findForced);
    classOf<HarmonicContactOf>(module);
    classOf<HarmonicMotionOf>(module);
    classOf<HarmonicAnswer>(module);
    module.def("find_harmonic", &findHarmonic);
}

double displaced(double amplitude, int derivative, double frequencyRatio, const Bar& bar)
{
    const double hertz = frequencyRatio * (0.25 / scales(bar).time);
    return derivative == 0 ? amplitude : displacementAt(hertz, amplitude, derivative);
}

Excited placeOf(const std::string& force)
{
    return valueOf("force", force, excitedNames);
}

}  // namespace signorini::python
