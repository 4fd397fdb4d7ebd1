#include "scene_response_answer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "excited_amplitude.hpp"
#include "faults.hpp"
#include "harmonic_network_contact.hpp"

namespace signorini::answers {

bool SceneFrequency::touches() const
{
    return std::any_of(distance.begin(), distance.end(), [](double least) { return least < 0.0; });
}

Status SceneResponse::status() const
{
    const bool isKnown = std::none_of(frequencies.begin(), frequencies.end(),
                                      [](const SceneFrequency& at) { return at.reason; });
    return isComplete && isKnown ? Status::found : Status::undecided;
}

std::vector<std::int64_t> stepsOf(const SceneResponse& asked)
{
    const SceneRange& range = asked.range;
    // A frequency that is one of the grid may be given in few digits.
    constexpr double near = 1e-9;
    const double second = static_cast<double>(range.cycles) / asked.scales.time;
    const double least = std::ceil(second / range.mostHertz * (1.0 - near));
    const double most = std::floor(second / range.leastHertz * (1.0 + near));
    const auto shortest = static_cast<double>(std::max<std::int64_t>(2, 2 * range.cycles));
    constexpr auto longest = static_cast<double>(maxHarmonicSteps);
    if (!(std::max(least, shortest) <= most && most <= longest)) {
        const bool isLow = most > longest;
        Faults faults;
        faults.add(isLow ? "leastFrequencyRatio" : "mostFrequencyRatio",
                   isLow ? range.leastHertz : range.mostHertz,
                   fmt::format("a range that holds {:.6g}/n Hz of some whole n = {}..{}", second,
                               shortest, longest));
        faults.throwIfAny();
    }
    std::vector<std::int64_t> all;
    for (auto n = static_cast<std::int64_t>(std::max(least, shortest));
         n <= static_cast<std::int64_t>(most); ++n) {
        all.push_back(n);
    }
    return all;
}

SceneResponse responseOf(const Assembly& assembly, const SceneRange& range)
{
    const Network network = networkOf(assembly);
    return {range, network.scales, severalOf(assembly, network)};
}

std::optional<SceneFrequency> frequencyAt(const SceneResponse& asked, std::int64_t steps,
                                          const Cancel& cancel)
{
    if (isRequested(cancel)) {
        return std::nullopt;
    }
    const SceneRange& range = asked.range;
    const NetworkScales& scales = asked.scales;
    SceneFrequency at;
    at.steps = steps;
    at.hertz = static_cast<double>(range.cycles) / (static_cast<double>(steps) * scales.time);
    if (const double first = asked.bars.reference.frequency; first > 0.0) {
        at.ratio = 2.0 * std::numbers::pi * at.hertz / first;
    }
    at.amplitude = displacementAt(at.hertz, range.amplitude, range.derivative);
    const double unit = range.place == Excited::tip ? scales.force() : scales.displacement;
    const HarmonicNetwork given{networkOf(asked.bars.assembly), range.place, at.amplitude / unit,
                                steps, range.cycles};
    try {
        at.distance = openDistances(given);
        for (double& distance : at.distance) {
            distance *= scales.displacement;
        }
        for (NetworkHarmonicMotion& motion : harmonicContacts(given)) {
            at.motions.push_back({std::move(motion), scales});
        }
    } catch (const Resonance& fault) {
        at.reason = fault.what();
    }
    return at;
}

}  // namespace signorini::answers
