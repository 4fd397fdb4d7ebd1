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
    const Bar bar = unitsOf(scene);
    if (!asked.has("amplitude") && canRest(schedule.phases, schedule.stops)) {
        throw std::invalid_argument(
            "amplitude is missing: allowed numbers > 0 [N or m]: without a gap motions are as "
            "small as one likes");
    }
    const Damping damping = asked.damping();
    const Forcing forcing{asked.place(), asked.get<std::int64_t>("cycles"), {}};
    ForcedLimits limits;
    asked.read("strain_limit", limits.strain, scales(bar).strain);
    const auto amplitude = asked.maybe<double>("amplitude");
    const auto derivative = asked.get<int>("derivative");
    return findPatiently(asked, steps(schedule), [=](const Wires&) {
        return answerOf(forcedMotions(schedule, damping, forcing, limits, scene.segments), scene,
                        amplitude, derivative);
    });
}

HarmonicAnswer findHarmonic(const Asked& asked)
{
    const Scene scene = asked.scene();
    validate(scene);
    const auto cycles = asked.get<std::int64_t>("cycles");
    const ExactPeriod period =
        periodExactly(asked.get<std::string>("option"), asked.get<std::string>("word"),
                      asked.maybe<std::int64_t>("cells").value_or(usualCells), scene.bar, cycles);
    const Damping damping = asked.damping();
    const Excited place = asked.place();
    const auto amplitude =
        asked.displacement(4.0 * static_cast<double>(cycles) / period.value(), unitsOf(scene));
    const auto contacts = asked.get<std::int64_t>("contacts");
    const auto limit = asked.maybe<double>("strain_limit");
    return patiently(asked, [=](const Wires& wires) {
        return within(limit, answerOf(period, damping, place, cycles, *amplitude, scene, contacts,
                                      wires.cancel));
    });
}

SceneHarmonicAnswer findHarmonicBars(const Asked& asked)
{
    const Assembly assembly = asked.assembly();
    const auto cycles = asked.get<std::int64_t>("cycles");
    const std::int64_t steps = asked.steps(assembly, cycles);
    const Excited place = asked.place();
    const auto amplitude = asked.get<double>("amplitude");
    const auto derivative = asked.get<int>("derivative");
    const auto limit = asked.maybe<double>("strain_limit");
    const auto contacts = asked.get<std::int64_t>("contacts");
    return patiently(asked, [=](const Wires& wires) {
        return within(limit, answerOf(assembly, place, cycles, steps, amplitude, derivative,
                                      contacts, wires.cancel));
    });
}

ForceRange forceRange(const Asked& asked)
{
    const Assembly assembly = asked.assembly();
    const auto low = asked.inUnit("low", "N");
    const auto high = asked.inUnit("high", "N");
    const auto time = asked.get<double>("time");
    if (!(low <= high && std::isfinite(high - low))) {
        throwFault("low, high", fmt::format("{}, {}", low, high), "finite low <= high [N]");
    }
    return patiently(asked, [=](const Wires&) { return forceRangeOf(assembly, low, high, time); });
}

/// What is asked of a response, without answers yet.
ResponseAnswer responseAsked(const Asked& asked)
{
    const Scene scene = asked.scene();
    validate(scene);
    const Bar bar = unitsOf(scene);
    const Excited place = asked.place();
    const auto derivative = asked.get<int>("derivative");
    const auto amplitude = asked.get<double>("amplitude");
    ResponseAnswer answer{{.cells = asked.maybe<std::int64_t>("cells").value_or(usualCells),
                           .damping = asked.damping(),
                           .place = place,
                           .amplitude = amplitude / amplitudeUnit(place, bar, derivative),
                           .derivative = derivative,
                           .cycles = asked.get<std::int64_t>("cycles"),
                           .leastFrequencyRatio = asked.frequency("start", bar),
                           .mostFrequencyRatio = asked.frequency("to", bar),
                           .contacts = asked.maybe<std::int64_t>("contacts").value_or(1),
                           .band = asked.maybe<double>("band").value_or(ResponseRange{}.band),
                           .stops = stopsOf(scene),
                           .segments = scene.segments},
                          scene,
                          bar,
                          amplitude,
                          {}};
    try {
        (void)stepsOf(answer.range);
    } catch (const std::invalid_argument& error) {
        const double most = answer.range.mostFrequencyRatio;
        throw std::invalid_argument(
            most < likelyHertz || !std::string_view(error.what()).starts_with("frequency ratios")
                ? error.what()
                : fmt::format("{}; {:.6g} [omega_1] looks like Hz: to=\"{:.6g}Hz\"", error.what(),
                              most, most));
    }
    return answer;
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

ResponseAnswer response(const Asked& asked)
{
    const ResponseAnswer answer = responseAsked(asked);
    const bool stability = asked.get<bool>("stability");
    return overFrequencies(asked, answer, answer.range, [=](const auto& of, auto n, auto cancel) {
        return frequencyAt(of.range, n, stability, cancel);
    });
}

/// Under the harmonic itself in place of a staircase.
ExactAnswer exactResponse(const Asked& asked)
{
    const ResponseAnswer like = responseAsked(asked);
    return overFrequencies(
        asked, ExactAnswer{like.range, like.scene, like.bar, like.amplitude, {}, {}}, like.range,
        [](const auto& of, auto n, auto cancel) { return exactAt(of.range, n, cancel); });
}

SceneResponse responseOfBars(const Asked& asked)
{
    const Assembly assembly = asked.assembly();
    const Network network = networkOf(assembly);
    const double first = firstHertz(referenceOf(network));
    const bool vibrates = first > 0.0;
    const Bar units =  // or one whose omega_1 is 1 Hz
        vibrates ? unitsOf(assembly, network) : Bar{.waveSpeed = 4.0};
    const auto hertz = [&](const char* name) {
        if (!vibrates && !py::isinstance<py::str>(asked.object(name))) {
            throw std::invalid_argument(
                fmt::format("{}: allowed text in Hz, \"530Hz\": these bars do not vibrate", name));
        }
        return asked.frequency(name, units) * (vibrates ? first : 1.0);
    };
    const SceneRange range{asked.place(),
                           asked.get<double>("amplitude"),
                           asked.get<int>("derivative"),
                           asked.get<std::int64_t>("cycles"),
                           hertz("start"),
                           hertz("to"),
                           asked.get<bool>("exact"),
                           asked.get<bool>("stability"),
                           asked.maybe<std::int64_t>("contacts").value_or(1),
                           asked.maybe<double>("band").value_or(SceneRange{}.band)};
    const SceneResponse answer = responseOf(assembly, range);
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
