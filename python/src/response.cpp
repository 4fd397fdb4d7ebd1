
#include <pybind11/stl.h>

#include "asked.hpp"
#include "calls.hpp"
#include "described.hpp"
#include "patience.hpp"
#include "response_answer.hpp"
#include "share_work.hpp"
#include "signorini/figures.hpp"
#include "stops.hpp"

namespace signorini::python {

using answers::ResponseAnswer;

namespace {

ResponseAnswer response(const Asked& asked)
{
    const Scene scene = asked.scene();
    validate(scene);
    const Bar bar = answers::unitsOf(scene);
    const Excited place = asked.place();
    const auto derivative = asked.get<int>("derivative");
    if (!asked.has("amplitude")) {
        throw std::invalid_argument("amplitude is missing: allowed numbers > 0 [N or m]");
    }
    const auto amplitude = asked.get<double>("amplitude");
    ResponseAnswer answer{{.cells = asked.maybe<std::int64_t>("cells").value_or(usualCells),
                           .damping = {asked.get<double>("damping")},
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
    (void)stepsOf(answer.range);
    const auto threads = asked.threads();
    const bool stability = asked.get<bool>("stability");
    return patiently(
        [answer, stability, threads](const Wires& wires) mutable {
            const std::vector<std::int64_t> steps = stepsOf(answer.range);
            std::vector<std::optional<FrequencyResponse>> responses(steps.size());
            StabilityOptions options;
            options.cancel = wires.cancel;
            options.segments = answer.range.segments;
            const auto serve = [&](std::size_t k) {
                responses[k] = responseAt(answer.range, steps[k], wires.cancel);
                if (responses[k] && stability) {
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
        asked.progress());
}

}  // namespace

void addResponse(py::module_& module)
{
    classOf<answers::PermanentOf>(module);
    classOf<answers::FrequencyOf>(module);
    classOf<ResponseAnswer>(module)->more().def("_figure", [](const ResponseAnswer& answer) {
        return asJson(responseFigure(answer.frequencies, answer.range, answer.bar));
    });
    addCall(module, "response", &response);
}

}  // namespace signorini::python
