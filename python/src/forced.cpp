#include "calls.hpp"

#include <cmath>

#include "asked_period.hpp"
#include "exact_answer.hpp"
#include "exact_figure.hpp"
#include "forced_answer.hpp"
#include "harmonic_answer.hpp"
#include "response_answer.hpp"
#include "scene_answer.hpp"
#include "scene_figures.hpp"
#include "scene_harmonic_answer.hpp"
#include "share_work.hpp"
#include "signorini/response.hpp"
#include "stops.hpp"

namespace signorini::python {

namespace {

void addMotionOf(py::module_& module)
{
    Record<ForcedMotionOf>(module)
        .has("impulse_ratio", "[EA g/c] a period.",
             [](const ForcedMotionOf& m) { return m.value.extremes.impulse; })
        .has("peak_force_ratio", "[EA g/L]",
             [](const ForcedMotionOf& m) { return m.value.extremes.peakForce; })
        .has("tip_lowest_ratio", "[g]",
             [](const ForcedMotionOf& m) { return m.value.extremes.lowestTip; })
        .has("state", "At the start of contact: a State.",
             [](const std::shared_ptr<ForcedMotionOf>& m) {
                 return StateOf{{m, &m->value.state}, m->bar, m->segments};
             });
}

ForcedAnswer findForced(const Asked& asked)
{
    const Scene scene = asked.scene();
    Schedule schedule = asked.schedule();
    schedule.stops = stopsOf(scene);
    validate(schedule);
    const auto question = forcedAsked(asked, scene, schedule);
    return findPatiently(asked, steps(schedule), [=](const Wires&) { return question(); });
}

HarmonicAnswer findHarmonic(const Asked& asked)
{
    const Scene scene = asked.scene();
    validate(scene);
    const auto question = harmonicAsked(asked, scene, asked.cells());
    return patiently(asked, [=](const Wires& wires) { return question(wires.cancel); });
}

SceneHarmonicAnswer findHarmonicBars(const Asked& asked)
{
    const auto question = harmonicAsked(asked, asked.assembly());
    return patiently(asked, [=](const Wires& wires) { return question(wires.cancel); });
}

ForceRange forceRange(const Asked& asked)
{
    const Assembly assembly = asked.assembly();
    const double low = quantityOf("low", asked.get<Quantity>("low"), "N");
    const double high = quantityOf("high", asked.get<Quantity>("high"), "N");
    const auto time = asked.get<double>("time");
    if (!(low <= high && std::isfinite(high - low))) {
        throwFault("low, high", fmt::format("{}, {}", low, high), "finite low <= high [N]");
    }
    return patiently(asked, [=](const Wires&) { return forceRangeOf(assembly, low, high, time); });
}

/// What is answered at each frequency of a range, on threads.
template <typename Answer, typename Range, typename At>
Answer overFrequencies(const Asked& asked, Answer answer, Range range, At at)
{
    const auto threads = asked.get<std::int64_t>("threads");
    return patiently(asked, [=](const Wires& wires) mutable {
        answer.frequencies = shareOut(
            stepsOf(range), threads, [&](std::int64_t n) { return at(answer, n, wires.cancel); },
            wires.progress);
        if constexpr (requires { answer.branches; }) {
            answer.branches = exactBranches(range, answer.frequencies, wires.cancel);
        }
        return answer;
    });
}

ResponseAnswer ofBar(const Asked& asked)
{
    const Scene scene = asked.scene();
    validate(scene);
    return responseAsked(asked, scene, asked.cells());
}

ResponseAnswer response(const Asked& asked)
{
    const ResponseAnswer answer = ofBar(asked);
    const bool stability = asked.has("stability");
    return overFrequencies(asked, answer, answer.range, [=](const auto& of, auto n, auto cancel) {
        return frequencyAt(of.range, n, stability, cancel);
    });
}

/// Under the harmonic itself in place of a staircase.
ExactAnswer exactResponse(const Asked& asked)
{
    const ResponseAnswer like = ofBar(asked);
    refuseIf(
        like.range.derivative > 0,
        "amplitude_velocity, amplitude_acceleration: allowed only of several bars or segments");
    return overFrequencies(
        asked, ExactAnswer{like.range, like.scene, like.bar, like.amplitude, {}, {}}, like.range,
        [](const auto& of, auto n, auto cancel) { return exactAt(of.range, n, cancel); });
}

SceneResponse responseOfBars(const Asked& asked)
{
    const SceneResponse answer = responseAsked(asked, asked.assembly());
    return overFrequencies(asked, answer, answer, [](const auto& of, auto n, auto cancel) {
        return frequencyAt(of, n, cancel);
    });
}

}  // namespace

void addForced(py::module_& module)
{
    addClasses<HarmonicContactOf, HarmonicMotionOf, SceneHarmonicContact, SceneHarmonicMotion,
               PermanentOf, FrequencyOf, ExactFrequencyOf, BranchPointOf, BranchMarkOf,
               ExactBranchOf, SceneFrequency, ForceRange>(module);
    addMotionOf(module);
    Record<ForcedAnswer>(module)
        .draws([](const ForcedAnswer& a, std::size_t k) {
            return motionFigure(a.motions.at(k).value, a.scene);
        })
        .moves([](const ForcedAnswer& a, std::size_t most, std::size_t k) {
            const Motion field = fieldOf(a.motions.at(k).value, a.scene.segments);
            return motionFrames(MotionSamples(field, a.scene), most);
        });
    module.def("find_forced", &findForced);
    const auto field = [](const HarmonicAnswer& a, std::size_t k) {
        return HarmonicField(a.given(), a.motions.at(k).value);
    };
    Record<HarmonicAnswer>(module)
        .draws([field](const HarmonicAnswer& a, std::size_t k) {
            return harmonicFigure(field(a, k), a.scene);
        })
        .moves([field](const HarmonicAnswer& a, std::size_t most, std::size_t k) {
            return motionFrames(MotionSamples(field(a, k), a.scene, usualCells), most);
        });
    module.def("find_harmonic", &findHarmonic);
    Record<SceneHarmonicAnswer>(module)
        .draws([](const SceneHarmonicAnswer& a, std::size_t k) { return harmonicFigure(a, k); })
        .moves([](const SceneHarmonicAnswer& a, std::size_t most, std::size_t k) {
            return barsFrames(a.bars.assembly, networkOf(a.bars.assembly), shownPeriod(a, k), most);
        });
    module.def("find_harmonic_bars", &findHarmonicBars);
    module.def("force_range", &forceRange);
    Record<ResponseAnswer>(module).draws([](const ResponseAnswer& answer) {
        return responseFigure(answer.frequencies, answer.range, answer.bar);
    });
    module.def("response", &response);
    Record<ExactAnswer>(module).draws([](const ExactAnswer& answer) {
        return exactFigure(answer.frequencies, answer.branches, answer.range, answer.bar);
    });
    module.def("exact_response", &exactResponse);
    Record<SceneResponse>(module).draws(&sceneResponseFigure);
    module.def("response_bars", &responseOfBars);
}

}  // namespace signorini::python
