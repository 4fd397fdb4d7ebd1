#include "scene_continuum_answer.hpp"

namespace signorini::answers {

std::vector<SceneCurvePoint> SceneContinuumAnswer::points() const
{
    std::vector<SceneCurvePoint> all;
    for (std::size_t k = 0; k < curve().points.size(); ++k) {
        all.push_back({of, k});
    }
    return all;
}

std::optional<SceneCurvePoint> SceneContinuumAnswer::member() const
{
    return asked ? std::optional(SceneCurvePoint{of, *asked}) : std::nullopt;
}

std::optional<SceneFloor> SceneContinuumAnswer::certificate() const
{
    const LeastMotion& known = curve().known;
    if (curve().status != Status::none || known.status != Status::none ||
        known.provedEnergy == 0.0) {
        return std::nullopt;
    }
    return floorOf(of->schedule, known);
}

SceneContinuumAnswer continuumOf(const Assembly& assembly, const Network& network,
                                 const std::vector<ContactSpan>& schedule, double energy,
                                 const NetworkCurveOptions& options)
{
    return {std::make_shared<const SceneCurve>(
        SceneCurve{scheduleOf(assembly, network, schedule),
                   traceContinuum(network, schedule, energy, options)})};
}

}  // namespace signorini::answers
