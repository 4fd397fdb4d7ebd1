#include "response_answer.hpp"

#include <cmath>

#include "excited_amplitude.hpp"

namespace signorini::answers {

std::optional<PermanentOf> FrequencyOf::permanent() const
{
    return value.permanent ? std::optional(PermanentOf{*value.permanent, bar}) : std::nullopt;
}

std::int64_t FrequencyOf::cells() const
{
    return std::llround(value.frequencyRatio * static_cast<double>(value.steps) / 4.0 /
                        static_cast<double>(cycles));
}

std::vector<ForcedMotionOf> FrequencyOf::motions() const
{
    std::vector<ForcedMotionOf> list;
    for (const ForcedMotion& motion : value.motions) {
        list.push_back({motion, bar, true, segments});
    }
    return list;
}

std::size_t ResponseAnswer::motions() const
{
    std::size_t count = 0;
    for (const FrequencyResponse& response : frequencies) {
        count += response.motions.size();
    }
    return count;
}

double ResponseAnswer::amplitudeAt(const FrequencyResponse& response) const
{
    return displacementOf(range.amplitude, range.derivative, response.frequencyRatio) *
           amplitudeUnit(range.place, bar);
}

std::int64_t ResponseAnswer::undecided() const
{
    std::int64_t count = 0;
    for (const FrequencyResponse& response : frequencies) {
        count += response.undecided;
    }
    return count;
}

std::vector<FrequencyOf> ResponseAnswer::listed() const
{
    std::vector<FrequencyOf> list;
    for (const FrequencyResponse& response : frequencies) {
        list.push_back({response, bar, scene.segments, range.cycles});
    }
    return list;
}

std::optional<FrequencyResponse> frequencyAt(const ResponseRange& range, std::int64_t steps,
                                             bool triesStability, const Cancel& cancel)
{
    std::optional<FrequencyResponse> response = responseAt(range, steps, cancel);
    if (response && triesStability) {
        for (ForcedMotion& motion : response->motions) {
            tryStability(motion, range.segments, cancel);
        }
    }
    return isRequested(cancel) ? std::nullopt : std::move(response);
}

}  // namespace signorini::answers
