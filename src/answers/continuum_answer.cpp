#include "continuum_answer.hpp"

#include "find_answer.hpp"
#include "stops.hpp"

namespace signorini::answers {

void requireCurve(const Call& call)
{
    requireOneEnergy(call);
    refuseIf(!call.has("--energy") && !call.has("--energy-ratio"),
             "--energy-ratio is missing: allowed finite numbers > 0 [E_1], or --energy in joules");
    const int ends = (call.has("--to") ? 1 : 0) + (call.has("--direction") ? 1 : 0);
    refuseIf((call.has("--from") ? 1 : 0) != ends,
             "--from: allowed only together with one of --to and --direction");
    refuseIf(ends != 0 && (call.has("--seed") || call.has("--sample")),
             "--seed and --sample clash with --from: allowed one of them");
}

namespace {

Trace traceAsked(const Call& call, const std::function<State(const char* option)>& stateOf)
{
    const auto seed = call.whole("--seed");
    const auto seedOr = [&seed](std::uint64_t usual) {
        return seed ? static_cast<std::uint64_t>(*seed) : usual;
    };
    if (!call.has("--from")) {
        return call.has("--sample") ? Trace(trace::Sample{seedOr(trace::Sample{}.seed)})
               : seed               ? Trace(trace::RandomPath{seedOr(0)})
                                    : Trace(trace::SplitPulse{});
    }
    State from = stateOf("--from");
    if (call.has("--to")) {
        return trace::Path{std::move(from), stateOf("--to")};
    }
    return trace::Walk{std::move(from), stateOf("--direction")};
}

}  // namespace

Question<ContinuumAnswer> continuumAsked(const Call& call, const Scene& scene, Schedule schedule,
                                         const std::function<State(const char* option)>& stateOf)
{
    requireCurve(call);
    const double ratio = energyAsked(call, scene.bar).value();
    ContinuumOptions options;
    options.scene = scene;
    options.trace = traceAsked(call, stateOf);
    readCurve(call, options);
    call.read("--strain-limit", options.strainLimit);
    schedule.stops = stopsOf(scene);
    validate(schedule);
    return [=](const Watch& watch) {
        return ContinuumAnswer{
            std::make_shared<const Continuum>(traceContinuum(schedule, ratio, watch.on(options)))};
    };
}

Physical PointOf::physical() const
{
    return physicalOf(extremesOf(point->state, curve->schedule), curve->scene.bar);
}

std::vector<PointOf> ContinuumAnswer::points() const
{
    std::vector<PointOf> list;
    for (const ContinuumPoint& point : curve->points) {
        list.push_back({curve, std::shared_ptr<const ContinuumPoint>(curve, &point)});
    }
    return list;
}

std::optional<PointOf> ContinuumAnswer::member() const
{
    return asked ? std::optional(PointOf{
                       curve, std::make_shared<const ContinuumPoint>(asked->point), asked->isExact})
                 : std::nullopt;
}

double joules(double energyRatio, const Continuum& curve)
{
    return energyRatio * scales(curve.scene.bar).energy;
}

std::optional<std::int64_t> dimensionOf(const Continuum& curve)
{
    return curve.dimension >= 0 && curve.components != 0 ? std::optional(curve.dimension)
                                                         : std::nullopt;
}

}  // namespace signorini::answers
