#include "scene_continuum_answer.hpp"

namespace signorini::answers {

NetworkCurveOptions continuumAsked(
    const Call& call,
    const std::function<std::optional<std::vector<double>>(const char* option)>& wavesOf)
{
    NetworkCurveOptions options;
    options.from = wavesOf("--from");
    options.to = wavesOf("--to");
    options.direction = wavesOf("--direction");
    options.isSample = call.has("--sample");
    options.seed = static_cast<std::uint64_t>(
        call.whole("--seed").value_or(static_cast<std::int64_t>(options.seed)));
    readCurve(call, options);
    return options;
}

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
