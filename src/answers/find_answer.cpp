#include "find_answer.hpp"

#include "stepped_bar.hpp"

namespace signorini::answers {

Bar unitsOf(const Scene& scene)
{
    Bar bar = firstMaterial(scene);
    if (!isUniform(scene.segments)) {
        bar.young.reset();
    }
    return bar;
}

double forceUnit(const Bar& bar)
{
    return bar.axialStiffness * scales(bar).strain;
}

double impulseUnit(const Bar& bar)
{
    return forceUnit(bar) * scales(bar).time;
}

double amplitudeUnit(Excited place, const Bar& bar)
{
    return place == Excited::tip ? forceUnit(bar) : scales(bar).displacement;
}

std::vector<StopPlace> stopsIn(const Scene& scene)
{
    std::vector<StopPlace> stops{{Stop::right, scene.bar.gap}};
    if (scene.secondStop) {
        stops.push_back({Stop::left, -*scene.secondStop});
    }
    return stops;
}

FindAnswer answerOf(PeriodicResult result, const FindOptions& options, const std::string& how)
{
    FindAnswer answer{std::move(result)};
    if (const auto& target = options.target) {
        answer.target = {how, {}};
        if (const auto& motion = answer.result.motion) {
            const State& at = motion->state;
            answer.target->distance =
                std::sqrt(energyRatio({at.a - target->a, at.b - target->b}) / energyRatio(*target));
        }
    }
    return answer;
}

std::optional<std::string> FindAnswer::detail() const
{
    const auto* exclusion =
        result.absence ? std::get_if<EnergyExclusion>(&result.absence->proof) : nullptr;
    if (!result.detail.empty()) {
        return result.detail;
    }
    return exclusion != nullptr ? std::optional(describe(*exclusion)) : std::nullopt;
}

std::optional<EnergyRange> FindAnswer::energies() const
{
    if (result.set.energy && hasUnit()) {
        return result.set.energy;
    }
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    return result.motion ? std::optional(EnergyRange{unknown, unknown}) : std::nullopt;
}

}  // namespace signorini::answers
