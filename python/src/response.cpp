
#include <pybind11/stl.h>

#include "described.hpp"
#include "faults.hpp"
#include "force.hpp"
#include "patience.hpp"
#include "response_answer.hpp"
#include "share_work.hpp"
#include "signorini/figures.hpp"
#include "stops.hpp"

namespace signorini::python {

using answers::FrequencyOf;
using answers::PermanentOf;
using answers::ResponseAnswer;
template <>
struct Members<FrequencyOf> {
    static constexpr auto list = std::tuple{&FrequencyOf::value, &FrequencyOf::bar,
                                            &FrequencyOf::segments, &FrequencyOf::cycles};
};
template <>
struct Members<ResponseAnswer> {
    using T = ResponseAnswer;
    static constexpr auto list =
        std::tuple{&T::range,       &T::scene,      &T::bar,        &T::amplitude,
                   &T::frequencies, &T::isComplete, &T::yieldStress};
};

namespace {

ResponseAnswer response(double damping, const std::string& force, double amplitude, int derivative,
                        double least, double most, std::int64_t cycles, std::int64_t cells,
                        bool stability, std::int64_t threads, const Scene& scene,
                        const py::object& progress)
{
    validate(scene);
    const Bar bar = answers::unitsOf(scene);
    const Excited place = placeOf(force);
    ResponseAnswer answer{{.cells = cells,
                           .damping = {damping},
                           .place = place,
                           .amplitude = amplitude / amplitudeUnit(place, bar, derivative),
                           .derivative = derivative,
                           .cycles = cycles,
                           .leastFrequencyRatio = least,
                           .mostFrequencyRatio = most,
                           .stops = stopsOf(scene),
                           .segments = scene.segments},
                          scene,
                          bar,
                          amplitude,
                          {}};
    (void)stepsOf(answer.range);
    Faults faults;
    faults.requireWhole("threads", threads, maxThreads);
    faults.throwIfAny();
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
        progress);
}

}  // namespace

void addResponse(py::module_& module)
{
    classOf<PermanentOf>(module);
    classOf<FrequencyOf>(module);
    classOf<ResponseAnswer>(module)->more().def("_figure", [](const ResponseAnswer& answer) {
        return asJson(responseFigure(answer.frequencies, answer.range, answer.bar));
    });
    module.def("response", &response);
}

}  // namespace signorini::python
