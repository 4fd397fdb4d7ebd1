
#include <pybind11/stl.h>

#include "excited_names.hpp"
#include "faults.hpp"
#include "force.hpp"
#include "motion.hpp"
#include "patience.hpp"
#include "scene.hpp"
#include "share_work.hpp"
#include "signorini/response.hpp"
#include "stepped_bar.hpp"
#include "stops.hpp"

namespace signorini::python {

/// The tip that never leaves the wall, and its units.
struct PermanentOf {
    PermanentContact value;
    Bar bar;
};
template <>
struct Members<PermanentOf> {
    static constexpr auto list = std::tuple{&PermanentOf::value, &PermanentOf::bar};
};

/// All motions at one frequency.
struct FrequencyOf {
    FrequencyResponse value;
    Bar bar;
    std::vector<Segment> segments;
};
template <>
struct Members<FrequencyOf> {
    static constexpr auto list =
        std::tuple{&FrequencyOf::value, &FrequencyOf::bar, &FrequencyOf::segments};
};

/// A response.
struct ResponseAnswer {
    ResponseRange range;
    Scene scene;
    Bar bar;  ///< what units mean: of the first material
    std::vector<FrequencyResponse> frequencies;
    bool wantsStability = false;
};
template <>
struct Members<ResponseAnswer> {
    static constexpr auto list =
        std::tuple{&ResponseAnswer::range, &ResponseAnswer::scene, &ResponseAnswer::bar,
                   &ResponseAnswer::frequencies, &ResponseAnswer::wantsStability};
};

namespace {

void addRecords(py::module_& module)
{
    const auto physical = [](const PermanentOf& p) { return physicalOf(p.value.extremes, p.bar); };
    Record<PermanentOf>(module, "PermanentContact", "The tip that never leaves the wall.")
        .key(
            "least_force",
            [](const PermanentOf& p) {
                return p.value.leastForce * amplitudeUnit(Excited::tip, p.bar);
            },
            "Of the tip on the wall, whatever the phase [N].")
        .key(
            "peak_force", [physical](const PermanentOf& p) { return physical(p).peakForce; }, "[N]")
        .key(
            "impulse", [physical](const PermanentOf& p) { return physical(p).impulse; },
            "[N s] a period.")
        .key("physical", physical, "What can be measured, in SI units: a Physical.")
        .key(
            "admissible", [physical](const PermanentOf& p) { return physical(p).isAdmissible(); },
            "Is s > -1 everywhere?")
        .key(
            "residual", [](const PermanentOf& p) { return p.value.residual; },
            "The worst that was seen walking along it; relative.");
    Record<FrequencyOf>(module, "ForcedFrequency", "All motions at one frequency.")
        .key(
            "steps", [](const FrequencyOf& f) { return f.value.steps; }, "n, of a period.")
        .key(
            "frequency_ratio", [](const FrequencyOf& f) { return f.value.frequencyRatio; },
            "omega/omega_1 of the excitation.")
        .key(
            "frequency",
            [](const FrequencyOf& f) { return f.value.frequencyRatio / 4.0 / scales(f.bar).time; },
            "[Hz]")
        .key(
            "touches", [](const FrequencyOf& f) { return f.value.touches; },
            "Would the bar without a wall go beyond it?")
        .key(
            "linear_peak",
            [](const FrequencyOf& f) { return f.value.linearPeak * scales(f.bar).displacement; },
            "max u(L) without a wall [m].")
        .key(
            "undecided", [](const FrequencyOf& f) { return f.value.undecided; },
            "Schedules that were not decided.")
        .key(
            "reason",
            [](const FrequencyOf& f) {
                return f.value.undecided > 0 ? py::object(py::str(f.value.detail))
                                             : py::object(py::none());
            },
            "Why the first of them was not, or None.")
        .key(
            "permanent_contact",
            [](const FrequencyOf& f) -> std::optional<PermanentOf> {
                if (!f.value.permanent) {
                    return std::nullopt;
                }
                return PermanentOf{*f.value.permanent, f.bar};
            },
            "The tip that never leaves the wall, where the bar presses on it at rest, or None.")
        .key(
            "motions",
            [](const FrequencyOf& f) {
                std::vector<MotionOf> list;
                for (const ForcedMotion& motion : f.value.motions) {
                    list.push_back({motion, f.bar, true, f.segments});
                }
                return list;
            },
            "[ForcedMotion, ...] by ascending contact steps, then impulse.");
    Record<ResponseAnswer>(module, "ResponseData", "Forced motions over a range of frequencies.")
        .key(
            "cells", [](const ResponseAnswer& a) { return a.range.cells; }, "N.")
        .key(
            "bar", [](const ResponseAnswer& a) { return a.scene.bar; }, "Asked about.")
        .key(
            "stops", [](const ResponseAnswer& a) { return stopsIn(a.scene); },
            "[{\"side\", \"place\" [m]}, ...].")
        .key(
            "segments", [](const ResponseAnswer& a) { return a.scene.segments; }, "[Segment, ...].")
        .key(
            "static_force", [](const ResponseAnswer& a) { return staticForce(a.scene); },
            "What the bar at rest presses on the wall with [N].")
        .key(
            "damping",
            [](const ResponseAnswer& a) {
                return Of<Damping>{a.range.damping, a.bar};
            },
            "A dashpot.")
        .key(
            "force", [](const ResponseAnswer& a) { return nameOf(a.range.place); },
            "\"tip\" or \"base\".")
        .key(
            "amplitude",
            [](const ResponseAnswer& a) {
                return a.range.amplitude * amplitudeUnit(a.range.place, a.bar);
            },
            "[N] or [m].")
        .key(
            "cycles", [](const ResponseAnswer& a) { return a.range.cycles; }, "K.")
        .key(
            "contacts", [](const ResponseAnswer& a) { return a.range.contacts; },
            "Most contacts in a period.")
        .key(
            "band",
            [](const ResponseAnswer& a) {
                return a.range.contacts > 1 ? py::object(py::float_(a.range.band))
                                            : py::object(py::none());
            },
            "How far amplitudes of two contacts may lie from the amplitude, relative, or None.")
        .key(
            "frequency_ratio_range",
            [](const ResponseAnswer& a) {
                return py::make_tuple(a.range.leastFrequencyRatio, a.range.mostFrequencyRatio);
            },
            "(least, most) omega/omega_1.")
        .key(
            "frequencies",
            [](const ResponseAnswer& a) {
                std::vector<FrequencyOf> list;
                for (const FrequencyResponse& response : a.frequencies) {
                    list.push_back({response, a.bar, a.scene.segments});
                }
                return list;
            },
            "[ForcedFrequency, ...].");
}

ResponseAnswer response(double damping, const std::string& force, double amplitude, double least,
                        double most, std::int64_t cycles, std::int64_t cells, bool stability,
                        std::int64_t threads, const Scene& scene, const py::object& progress)
{
    validate(scene);
    Bar bar = firstMaterial(scene);
    if (!isUniform(scene.segments)) {
        bar.young.reset();  // it is known of the first segment only
    }
    const Excited place = placeOf(force);
    ResponseAnswer answer{{.cells = cells,
                           .damping = {damping},
                           .place = place,
                           .amplitude = amplitude / amplitudeUnit(place, bar),
                           .cycles = cycles,
                           .leastFrequencyRatio = least,
                           .mostFrequencyRatio = most,
                           .stops = stopsOf(scene),
                           .segments = scene.segments},
                          scene,
                          bar,
                          {},
                          stability};
    (void)stepsOf(answer.range);
    Faults faults;
    faults.requireWhole("threads", threads, maxThreads);
    faults.throwIfAny();
    return patiently(
        [answer, threads](const Wires& wires) mutable {
            const std::vector<std::int64_t> steps = stepsOf(answer.range);
            std::vector<std::optional<FrequencyResponse>> responses(steps.size());
            StabilityOptions options;
            options.cancel = wires.cancel;
            options.segments = answer.range.segments;
            const auto serve = [&](std::size_t k) {
                responses[k] = responseAt(answer.range, steps[k], wires.cancel);
                if (responses[k] && answer.wantsStability) {
                    for (ForcedMotion& motion : responses[k]->motions) {
                        motion.stability = stabilityOf(motion, options).stability;
                    }
                }
                return responses[k].has_value() && !isRequested(wires.cancel);
            };
            shareWork(steps.size(), threads, serve, wires.progress);
            for (std::optional<FrequencyResponse>& at : responses) {
                if (at) {
                    answer.frequencies.push_back(std::move(*at));
                }
            }
            return answer;
        },
        progress);
}

}  // namespace

void addResponse(py::module_& module)
{
    addRecords(module);
    module.def("response", &response);
}

}  // namespace signorini::python
