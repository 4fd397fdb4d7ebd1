#include "forced_set.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "forced_case.hpp"
#include "names.hpp"
#include "portable.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

constexpr auto forcedKindNames = std::to_array<Named<ForcedKind>>({
    {ForcedKind::empty, "empty"},
    {ForcedKind::point, "point"},
    {ForcedKind::segment, "segment"},
    {ForcedKind::ray, "ray"},
    {ForcedKind::polytope, "polytope"},
});

}  // namespace

std::string_view name(ForcedKind kind)
{
    return nameIn(forcedKindNames, kind);
}

bool canRest(const ForcedSet& set)
{
    return canRest(set.schedule.phases, set.schedule.stops);
}

ForcedLine lineOf(const ForcedSet& set)
{
    ForcedLine line;
    line.foot = {set.foot[0], set.foot[1]};
    line.direction = {set.direction[0], set.direction[1]};
    line.low = set.low;
    line.high = set.high;
    line.canRest = canRest(set);
    return line;
}

void describeLine(ForcedSet& set, const ForcedLine& line)
{
    set.foot = {line.foot.c, line.foot.s};
    if (set.forcing.shape.empty()) {
        set.direction = {line.direction.c, line.direction.s};
    }
    set.low = line.low;
    set.high = line.high;
    const double offset = portable::hypot(line.foot.c, line.foot.s);
    set.leastAmplitude = portable::hypot(offset, std::clamp(0.0, line.low, line.high));
    set.mostAmplitude = portable::hypot(offset, std::max(std::abs(line.low), std::abs(line.high)));
    set.kind = std::isinf(set.mostAmplitude) ? ForcedKind::ray
               : line.low < line.high        ? ForcedKind::segment
                                             : ForcedKind::point;
}

void describePolytope(ForcedSet& set, ForcedPolytope polytope)
{
    std::tie(set.leastAmplitude, set.mostAmplitude) = amplitudesOf(polytope);
    set.corners = std::move(polytope.corners);
    set.kind = ForcedKind::polytope;
}

bool describeTouch(ForcedSet& set, ForcedLine line)
{
    if (line.canRest || line.blocking || !std::isfinite(line.low) || !std::isfinite(line.high)) {
        return false;
    }
    set.detail.clear();
    line.low = line.high = 0.5 * (line.low + line.high);
    describeLine(set, line);
    return true;
}

double worstResidual(const ForcedSet& set, const MotionAt& motionAt)
{
    if (canRest(set)) {
        const auto motions = motionsOf(set, std::min(1.0, 0.5 * set.mostAmplitude), motionAt);
        return motions.empty() ? std::numeric_limits<double>::infinity() : motions.front().residual;
    }
    if (set.kind != ForcedKind::polytope) {
        const ForcedLine line = lineOf(set);
        return motionAt(line.at(std::clamp(0.0, line.low, line.high)), {}).residual;
    }
    double worst = motionIn(set, nearestPlace(set.corners), motionAt).residual;
    for (const ForcedCorner& corner : set.corners) {
        if (portable::hypot(corner.place[0], corner.place[1]) <=
            1e3 * std::max(1.0, set.leastAmplitude)) {
            worst =
                std::max(worst, motionAt({corner.place[0], corner.place[1]}, corner.free).residual);
        }
    }
    return worst;
}

void believe(ForcedSet& set, const MotionAt& motionAt)
{
    if (const double residual = worstResidual(set, motionAt); !(residual <= forcedTolerance)) {
        set.kind = ForcedKind::empty;
        set.corners.clear();
        set.detail = doubtOf(residual);
        return;
    }
    set.status = Status::found;
}

ForcedMotion motionIn(const ForcedSet& set, const std::array<double, 2>& place,
                      const MotionAt& motionAt)
{
    const ForcedCorner corner = meanAt(set.corners, place);
    return motionAt({corner.place[0], corner.place[1]}, corner.free);
}

std::vector<ForcedMotion> motionsOf(const ForcedSet& set, double amplitude,
                                    const MotionAt& motionAt)
{
    if (set.kind != ForcedKind::polytope) {
        const ForcedLine line = lineOf(set);
        return motionsOnLine(line, amplitude, [&](double t) { return motionAt(line.at(t), {}); });
    }
    if (amplitude < set.leastAmplitude || amplitude > set.mostAmplitude) {
        return {};
    }
    return {motionIn(set, placeOfAmplitude(set.corners, amplitude), motionAt)};
}

Reason reasonOf(const std::vector<ForcedCondition>& conflict)
{
    const auto has = [&conflict](ForcedRule rule) {
        return std::any_of(conflict.begin(), conflict.end(),
                           [rule](const ForcedCondition& c) { return c.rule == rule; });
    };
    return has(ForcedRule::strain)        ? Reason::constraints
           : has(ForcedRule::penetration) ? Reason::penetration
           : has(ForcedRule::pressure) || has(ForcedRule::held) || has(ForcedRule::rest)
               ? Reason::contactSign
               : Reason::gap;
}

}  // namespace signorini
