#include "calls.hpp"

#include <cmath>

#include "exact_answer.hpp"
#include "exact_figure.hpp"
#include "forced_answer.hpp"
#include "harmonic_answer.hpp"
#include "motion.hpp"
#include "response_answer.hpp"
#include "scene_answer.hpp"
#include "scene_figures.hpp"
#include "scene_harmonic_answer.hpp"
#include "share_work.hpp"
#include "signorini/figures.hpp"
#include "signorini/response.hpp"
#include "stepped_bar.hpp"
#include "stops.hpp"

namespace signorini::python {

using answers::ExactAnswer;
using answers::ForcedAnswer;
using answers::ForcedMotionOf;
using answers::HarmonicAnswer;
using answers::HarmonicContactOf;
using answers::HarmonicMotionOf;
using answers::ResponseAnswer;

namespace {

void addMotionOf(py::module_& module)
{
    classOf<ForcedMotionOf>(module)
        ->has("impulse_ratio", "[EA g/c] a period.",
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
    const Bar bar = answers::unitsOf(scene);
    if (!asked.has("amplitude") && canRest(schedule.phases, schedule.stops)) {
        throw std::invalid_argument(
            "amplitude is missing: allowed numbers > 0 [N or m]: without a gap motions are as "
            "small as one likes");
    }
    const Damping damping = asked.damping();
    const Forcing forcing{asked.place(), asked.get<std::int64_t>("cycles"), {}};
    const ForcedLimits limits{asked.strainLimit(scales(bar).strain)};
    const auto amplitude = asked.maybe<double>("amplitude");
    const auto derivative = asked.get<int>("derivative");
    return findPatiently(asked, steps(schedule), [=](const Wires&) {
        return answers::answerOf(forcedMotions(schedule, damping, forcing, limits, scene.segments),
                                 scene, amplitude, derivative);
    });
}

HarmonicAnswer findHarmonic(const Asked& asked)
{
    const Scene scene = asked.scene();
    validate(scene);
    const ExactPeriod period =
        exactPeriod(asked.get<std::int64_t>("numerator"), asked.get<std::int64_t>("denominator"));
    const auto cycles = asked.get<std::int64_t>("cycles");
    const Damping damping = asked.damping();
    const Excited place = asked.place();
    const auto amplitude = asked.displacement(4.0 * static_cast<double>(cycles) / period.value(),
                                              answers::unitsOf(scene));
    const auto contacts = asked.get<std::int64_t>("contacts");
    const auto limit = asked.maybe<double>("strain_limit");
    return patiently([=](const Wires& wires) {
        return answers::within(limit, answers::answerOf(period, damping, place, cycles, *amplitude,
                                                        scene, contacts, wires.cancel));
    });
}

answers::SceneHarmonicAnswer findHarmonicBars(const Asked& asked)
{
    const Assembly assembly = asked.assembly();
    const auto cycles = asked.get<std::int64_t>("cycles");
    const std::int64_t steps = asked.steps(assembly, cycles);
    const Excited place = asked.place();
    const auto amplitude = asked.get<double>("amplitude");
    const auto derivative = asked.get<int>("derivative");
    const auto limit = asked.maybe<double>("strain_limit");
    return patiently([=](const Wires&) {
        return answers::within(
            limit, answers::answerOf(assembly, place, cycles, steps, amplitude, derivative));
    });
}

answers::ForceRange forceRange(const Asked& asked)
{
    const Assembly assembly = asked.assembly();
    const auto low = asked.inUnit("low", "N");
    const auto high = asked.inUnit("high", "N");
    const auto time = asked.get<double>("time");
    if (!(low <= high && std::isfinite(high - low))) {
        throwFault("low, high", fmt::format("{}, {}", low, high), "finite low <= high [N]");
    }
    return patiently(
        [=](const Wires&) { return answers::forceRangeOf(assembly, low, high, time); });
}

/// What is asked of a response, without answers yet.
ResponseAnswer responseAsked(const Asked& asked)
{
    const Scene scene = asked.scene();
    validate(scene);
    const Bar bar = answers::unitsOf(scene);
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
            most < answers::likelyHertz ||
                    !std::string_view(error.what()).starts_with("frequency ratios")
                ? error.what()
                : fmt::format("{}; {:.6g} [omega_1] looks like Hz: to=\"{:.6g}Hz\"", error.what(),
                              most, most));
    }
    return answer;
}

ResponseAnswer response(const Asked& asked)
{
    ResponseAnswer answer = responseAsked(asked);
    const auto threads = asked.get<std::int64_t>("threads");
    const bool stability = asked.get<bool>("stability");
    return patiently(
        [answer, stability, threads](const Wires& wires) mutable {
            answer.frequencies = shareOut(
                stepsOf(answer.range), threads,
                [&](std::int64_t n) {
                    return answers::frequencyAt(answer.range, n, stability, wires.cancel);
                },
                wires.progress);
            return answer;
        },
        asked.progress());
}

/// Under the harmonic itself in place of a staircase.
ExactAnswer exactResponse(const Asked& asked)
{
    const ResponseAnswer question = responseAsked(asked);
    const auto threads = asked.get<std::int64_t>("threads");
    return patiently(
        [question, threads](const Wires& wires) {
            ExactAnswer answer{
                question.range, question.scene, question.bar, question.amplitude, {}, {}};
            answer.frequencies = shareOut(
                stepsOf(answer.range), threads,
                [&](std::int64_t n) { return exactAt(answer.range, n, wires.cancel); },
                wires.progress);
            answer.branches = exactBranches(answer.range, answer.frequencies, wires.cancel);
            return answer;
        },
        asked.progress());
}

answers::SceneResponse responseOfBars(const Asked& asked)
{
    const Assembly assembly = asked.assembly();
    const Network network = networkOf(assembly);
    const double first = answers::firstHertz(referenceOf(network));
    const bool vibrates = first > 0.0;
    const Bar units =  // or one whose omega_1 is 1 Hz
        vibrates ? answers::unitsOf(assembly, network) : Bar{.waveSpeed = 4.0};
    const auto hertz = [&](const char* name) {
        if (!vibrates && !py::isinstance<py::str>(asked.object(name))) {
            throw std::invalid_argument(
                fmt::format("{}: allowed text in Hz, \"530Hz\": these bars do not vibrate", name));
        }
        return asked.frequency(name, units) * (vibrates ? first : 1.0);
    };
    const answers::SceneRange range{asked.place(),
                                    asked.get<double>("amplitude"),
                                    asked.get<int>("derivative"),
                                    asked.get<std::int64_t>("cycles"),
                                    hertz("start"),
                                    hertz("to"),
                                    asked.get<bool>("exact"),
                                    asked.get<bool>("stability")};
    const auto threads = asked.get<std::int64_t>("threads");
    return patiently(
        [=](const Wires& wires) {
            answers::SceneResponse answer = answers::responseOf(assembly, range);
            answer.frequencies = shareOut(
                stepsOf(answer), threads,
                [&](std::int64_t n) { return frequencyAt(answer, n, wires.cancel); },
                wires.progress);
            return answer;
        },
        asked.progress());
}

}  // namespace

void addForced(py::module_& module)
{
    addClasses<HarmonicContactOf, HarmonicMotionOf, answers::SceneHarmonicMotion,
               answers::PermanentOf, answers::FrequencyOf, answers::ExactFrequencyOf,
               answers::BranchPointOf, answers::BranchMarkOf, answers::ExactBranchOf,
               answers::SceneFrequency, answers::ForceRange>(module);
    addMotionOf(module);
    classOf<ForcedAnswer>(module)
        ->draws([](const ForcedAnswer& a, std::size_t k) {
            return motionFigure(a.motions.at(k).value, a.scene);
        })
        .moves([](const ForcedAnswer& a, std::size_t most, std::size_t k) {
            const Motion field = answers::fieldOf(a.motions.at(k).value, a.scene.segments);
            return motionFrames(MotionSamples(field, a.scene), most);
        });
    addCall(module, "find_forced", &findForced);
    const auto field = [](const HarmonicAnswer& a, std::size_t k) {
        return HarmonicField(a.given(), a.motions.at(k).value);
    };
    classOf<HarmonicAnswer>(module)
        ->draws([field](const HarmonicAnswer& a, std::size_t k) {
            return harmonicFigure(field(a, k), a.scene);
        })
        .moves([field](const HarmonicAnswer& a, std::size_t most, std::size_t k) {
            return motionFrames(MotionSamples(field(a, k), a.scene, usualCells), most);
        });
    addCall(module, "find_harmonic", &findHarmonic);
    classOf<answers::SceneHarmonicAnswer>(module)
        ->draws([](const answers::SceneHarmonicAnswer& a, std::size_t k) {
            return harmonicFigure(a, k);
        })
        .moves([](const answers::SceneHarmonicAnswer& a, std::size_t most, std::size_t k) {
            return barsFrames(a.bars.assembly, networkOf(a.bars.assembly), shownPeriod(a, k), most);
        });
    addCall(module, "find_harmonic_bars", &findHarmonicBars);
    addCall(module, "force_range", &forceRange);
    classOf<ResponseAnswer>(module)->draws([](const ResponseAnswer& answer) {
        return responseFigure(answer.frequencies, answer.range, answer.bar);
    });
    addCall(module, "response", &response);
    classOf<ExactAnswer>(module)->draws([](const ExactAnswer& answer) {
        return exactFigure(answer.frequencies, answer.branches, answer.range, answer.bar);
    });
    addCall(module, "exact_response", &exactResponse);
    classOf<answers::SceneResponse>(module)->draws(&sceneResponseFigure);
    addCall(module, "response_bars", &responseOfBars);
}

}  // namespace signorini::python
