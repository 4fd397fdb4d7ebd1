#include "scene_harmonic_answer.hpp"

#include "harmonic_network_contact.hpp"

namespace signorini::answers {

SceneHarmonicAnswer answerOf(const Assembly& assembly, Excited place, std::int64_t cycles,
                             std::int64_t steps, double amplitude)
{
    HarmonicNetwork given{networkOf(assembly), place, 1.0, steps, cycles};
    const NetworkScales& scales = given.network.scales;
    given.amplitude = amplitude / (place == Excited::tip ? scales.force() : scales.displacement);
    SceneHarmonicAnswer answer{
        place, cycles, amplitude, steps, scales, severalOf(assembly, given.network), {}};
    for (NetworkHarmonicMotion& motion : harmonicContacts(given)) {
        answer.motions.push_back({std::move(motion), scales});
    }
    return answer;
}

std::optional<double> SceneHarmonicAnswer::frequencyRatio() const
{
    const double first = bars.reference.frequency;
    return first > 0.0 ? std::optional(2.0 * std::numbers::pi * frequency() / first) : std::nullopt;
}

std::optional<std::string> SceneHarmonicAnswer::detail() const
{
    return status() == Status::undecided
               ? std::optional<std::string>(
                     "no motion with one contact in a period: computed, not proved")
               : std::nullopt;
}

}  // namespace signorini::answers
