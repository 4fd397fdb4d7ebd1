#include "continuum_answer.hpp"

namespace signorini::answers {

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
