#include "response_answer.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::answers {

namespace {

/// --from to --to. Frequencies are in ω₁: where the grid has none so high, hertz may have been
/// meant.
void takeFrequencies(const Call& call, ResponseRange& range, const Bar& bar)
{
    const double hertz = firstHertz(bar);
    const FrequencyOption from(call, "--from", "--from-hertz");
    const FrequencyOption to(call, "--to", "--to-hertz");
    const double least = from.ratioFor(hertz, range.leastFrequencyRatio);
    const double most = to.ratioFor(hertz, range.mostFrequencyRatio);
    requireOrder(call, least, most);
    range.leastFrequencyRatio = least;
    range.mostFrequencyRatio = most;
    const double unit = 4.0 * static_cast<double>(range.cells * range.cycles);
    const double fewest = 2.0 * static_cast<double>(range.cycles);  // steps
    const bool isAbove = unit / most <= fewest;
    const double first = std::max(std::ceil(unit / most), fewest);
    if (least < likelyHertz || (!isAbove && first <= std::floor(unit / least))) {
        return;
    }
    const auto [name, text] = givenEnd(call, isAbove ? "--to" : "--from");
    const FrequencyOption& wrong = isAbove ? to : from;
    std::string allowed =
        isAbove ? fmt::format("below {:.6g} [ω₁] on {} cells", unit / fewest, range.cells)
                : "4NK/n for some whole n, n > 2K [ω₁]";
    if (wrong.hertz) {
        allowed += fmt::format("; ω₁ is {:.6g} Hz ({})", hertz, sizeOf(bar));
    } else if (wrong.ratio) {
        allowed += looksLikeHertz(call, name, *wrong.ratio, hertz, sizeOf(bar));
    }
    refuse(name, text, allowed);
}

}  // namespace

ResponseAnswer responseAsked(const Call& call, const Scene& scene, std::int64_t cells)
{
    ResponseAnswer answer{{}, scene, unitsOf(scene), 0.0, {}};
    ResponseRange& range = answer.range;
    const ForceOptions force(call);
    call.read("--cycles", range.cycles);
    takeContacts(call, range);
    range.cells = cells;
    range.stops = stopsOf(scene);
    range.segments = scene.segments;
    takeFrequencies(call, range, answer.bar);
    range.damping = force.damping();
    if (!force.ratio || !(range.damping.rho() < 1.0)) {
        refuse("--damping", force.ratio ? fmt::format("{}", *force.ratio) : "missing",
               "numbers > 0 [-] with exp(-πζ) < 1");
    }
    force.requirePlace();
    force.requireAmplitude();
    range.place = *force.place;
    range.amplitude = force.scaledAmplitude(answer.bar);
    range.derivative = force.derivative;
    answer.amplitude = *force.amplitude;
    answer.yieldStress = yieldStressOf(call, answer.bar);
    return answer;
}

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
