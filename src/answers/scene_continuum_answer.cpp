#include "scene_continuum_answer.hpp"

namespace signorini::answers {

Question<SceneContinuumAnswer> continuumAsked(const Call& call, const BarsAsked& bars,
                                              const WavesOf& wavesOf)
{
    requireCurve(call);
    const double energy = energyAsked(call, bars.network).value();
    NetworkCurveOptions options;
    options.from = wavesOf("--from", bars);
    options.to = wavesOf("--to", bars);
    options.direction = wavesOf("--direction", bars);
    options.isSample = call.has("--sample");
    options.seed = static_cast<std::uint64_t>(
        call.whole("--seed").value_or(static_cast<std::int64_t>(options.seed)));
    readCurve(call, options);
    return [=](const Watch& watch) {
        return SceneContinuumAnswer{std::make_shared<const SceneCurve>(
            SceneCurve{scheduleOf(bars.assembly, bars.network, bars.spans),
                       traceContinuum(bars.network, bars.spans, energy, watch.on(options))})};
    };
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

}  // namespace signorini::answers
