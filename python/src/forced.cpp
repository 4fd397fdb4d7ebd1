#include "calls.hpp"

#include <cmath>

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
    Record<ForcedMotionOf>(module).has(
        "state", "At the start of contact: a State.", [](const std::shared_ptr<ForcedMotionOf>& m) {
            return StateOf{{m, &m->value.state}, m->bar, m->segments};
        });
}

Question<ForcedAnswer> forced(const Asked& asked)
{
    const Scene scene = asked.scene();
    Schedule schedule = asked.schedule();
    schedule.stops = stopsOf(scene);
    validate(schedule);
    return forcedAsked(asked, scene, schedule);
}

Question<ForceRange> forceRange(const Asked& asked)
{
    const Assembly assembly = asked.assembly();
    const double low = quantityOf("low", asked.get<Quantity>("low"), "N");
    const double high = quantityOf("high", asked.get<Quantity>("high"), "N");
    const auto time = asked.get<double>("time");
    if (!(low <= high && std::isfinite(high - low))) {
        throwFault("low, high", fmt::format("{}, {}", low, high), "finite low <= high [N]");
    }
    return [=](const Watch&) { return forceRangeOf(assembly, low, high, time); };
}

/// What is answered at each frequency of a range, on threads.
template <typename Answer, typename Range, typename At>
Question<Answer> overFrequencies(const Asked& asked, Answer answer, Range range, At at)
{
    const auto threads = asked.get<std::int64_t>("threads");
    return [=](const Watch& watch) mutable {
        answer.frequencies = shareOut(
            stepsOf(range), threads, [&](std::int64_t n) { return at(answer, n, watch.cancel); },
            watch.show);
        if constexpr (requires { answer.branches; }) {
            answer.branches = exactBranches(range, answer.frequencies, watch.cancel);
        }
        return answer;
    };
}

Question<ResponseAnswer> response(const Asked& asked)
{
    const ResponseAnswer answer = responseAsked(asked, asked.scene(), asked.cells());
    const bool stability = asked.has("stability");
    return overFrequencies(asked, answer, answer.range, [=](const auto& of, auto n, auto cancel) {
        return frequencyAt(of.range, n, stability, cancel);
    });
}

/// Under the harmonic itself in place of a staircase.
Question<ExactAnswer> exactResponse(const Asked& asked)
{
    const ResponseAnswer like = responseAsked(asked, asked.scene(), asked.cells());
    refuseIf(
        like.range.derivative > 0,
        "amplitude_velocity, amplitude_acceleration: allowed only of several bars or segments");
    refuseIf(like.range.contacts > 1,
             "contacts: allowed 1 of a uniform bar: what it settles on is listed anyway");
    return overFrequencies(
        asked, ExactAnswer{like.range, like.scene, like.bar, like.amplitude, {}, {}}, like.range,
        [](const auto& of, auto n, auto cancel) { return exactAt(of.range, n, cancel); });
}

Question<SceneResponse> responseOfBars(const Asked& asked)
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
    addCall(module, "find_forced", &forced);
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
    addCall(module, "find_harmonic",
            [](const Asked& asked) { return harmonicAsked(asked, asked.scene(), asked.cells()); });
    Record<SceneHarmonicAnswer>(module)
        .draws([](const SceneHarmonicAnswer& a, std::size_t k) { return harmonicFigure(a, k); })
        .moves([](const SceneHarmonicAnswer& a, std::size_t most, std::size_t k) {
            return barsFrames(a.bars.assembly, networkOf(a.bars.assembly), shownPeriod(a, k), most);
        });
    addCall(module, "find_harmonic_bars",
            [](const Asked& asked) { return harmonicAsked(asked, asked.assembly()); });
    addCall(module, "force_range", &forceRange);
    Record<ResponseAnswer>(module).draws([](const ResponseAnswer& answer) {
        return responseFigure(answer.frequencies, answer.range, answer.bar);
    });
    addCall(module, "response", &response);
    Record<ExactAnswer>(module).draws([](const ExactAnswer& answer) {
        return exactFigure(answer.frequencies, answer.branches, answer.range, answer.bar);
    });
    addCall(module, "exact_response", &exactResponse);
    Record<SceneResponse>(module).draws(&sceneResponseFigure);
    addCall(module, "response_bars", &responseOfBars);
}

}  // namespace signorini::python
