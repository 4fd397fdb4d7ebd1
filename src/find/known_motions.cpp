#include "known_motions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nearest_motion.hpp"

namespace signorini {

namespace {

/// What an objective makes small, and how it is called.
struct Measure {
    double value;
    const char* name;
};

std::optional<Measure> measure(const Demands& demands, const Schedule& schedule, const State& state)
{
    switch (demands.objective) {
        case Objective::minEnergy:
            return Measure{energyRatio(state), "least energy"};
        case Objective::maxEnergy:
            return Measure{-energyRatio(state), "most energy"};
        case Objective::minPeakStrain:
            return Measure{extremesOf(state, schedule).peakCompression, "least peak strain"};
        case Objective::maxImpulse:
            return Measure{-extremesOf(state, schedule).impulse, "most impulse"};
        case Objective::nearest:
            return Measure{(state.a - demands.target->a).squaredNorm() +
                               (state.b - demands.target->b).squaredNorm(),
                           "least distance"};
        default:
            return std::nullopt;
    }
}

/// The largest difference of a wave.
double distance(const State& left, const State& right)
{
    return std::max((left.a - right.a).lpNorm<Eigen::Infinity>(),
                    (left.b - right.b).lpNorm<Eigen::Infinity>());
}

/// |claimed - target|^2 - |known - target|^2, without the digits that a far target costs.
double distanceGain(const State& known, const State& claimed, const State& target)
{
    return (claimed.a - known.a).dot((claimed.a - target.a) + (known.a - target.a)) +
           (claimed.b - known.b).dot((claimed.b - target.b) + (known.b - target.b));
}

/// The nearest motion is unique: a claim of it is judged by its own place, which a distance to a
/// far target does not show.
bool isBetter(const Demands& demands, const State& known, const State& claimed,
              const Measure& knownMeasure, const Measure& claimedMeasure, double tolerance)
{
    if (demands.objective == Objective::nearest) {
        return distanceGain(known, claimed, *demands.target) > 0.0 &&
               distance(claimed, known) > std::sqrt(tolerance) * amplitude(known);
    }
    const double gain = claimedMeasure.value - knownMeasure.value;
    const double allowed =
        demands.objective == Objective::minEnergy ? std::sqrt(tolerance) : 10.0 * tolerance;
    return gain > allowed * std::abs(knownMeasure.value);
}

std::vector<State> motionsOf(const OnePhaseSet& whole, const Demands& demands)
{
    std::vector<State> known{leastEnergyMotion(whole), motionOf(whole, mostAmplitudes(whole.set))};
    if (demands.target) {
        if (auto nearest = nearestMotion(whole, *demands.target)) {
            known.push_back(std::move(*nearest));
        }
    }
    return known;
}

std::vector<State> motionsOf(const LumpedSet& sums, const LumpedShape& shape,
                             const Demands& demands)
{
    std::vector<State> known{equalMotion(sums, sums.leastSums)};
    if (std::isfinite(shape.energy.most)) {
        known.push_back(mostEnergyMotion(sums, shape));
    }
    if (demands.target) {
        if (auto nearest = nearestMotion(sums, shape, *demands.target)) {
            known.push_back(std::move(*nearest));
        }
    }
    return known;
}

}  // namespace

std::vector<State> knownMotions(const Request& request)
{
    const Known& known = request.known;
    if (known.onePhase && !known.onePhase->reason) {
        return motionsOf(*known.onePhase, request.demands);
    }
    if (known.sums && !known.sums->absence) {
        return motionsOf(*known.sums, known.shape, request.demands);
    }
    return {};
}

std::optional<std::string> refutation(const Demands& claim, const Schedule& schedule,
                                      const State& claimed, std::span<const State> known,
                                      double tolerance)
{
    const auto ours = measure(claim, schedule, claimed);
    if (!ours) {
        return std::nullopt;
    }
    for (const State& other : known) {
        const Measure theirs = *measure(claim, schedule, other);
        if (violation(claim, other, schedule) <= tolerance &&
            isBetter(claim, other, claimed, theirs, *ours, tolerance)) {
            return claim.objective == Objective::nearest
                       ? fmt::format("as the nearest that is {:.3g} g/L from one that is nearer",
                                     distance(claimed, other))
                       : fmt::format("as the one of {}, {:.9g}, though one of {:.9g} is known",
                                     ours->name, std::abs(ours->value), std::abs(theirs.value));
        }
    }
    return std::nullopt;
}

State motionOfEnergy(const State& least, const State& most, double energyRatio)
{
    // E(least + s (most - least)) = base + 2 s slope + s^2 square, with slope >= 0 as the first is
    // the least.
    const State way{most.a - least.a, most.b - least.b};
    const double square = signorini::energyRatio(way);
    const double base = signorini::energyRatio(least);
    const double slope = std::max(0.0, 0.5 * (signorini::energyRatio(most) - base - square));
    const double rise = std::max(0.0, energyRatio - base);
    const double root = std::sqrt(slope * slope + square * rise);
    const double share = rise == 0.0 ? 0.0 : std::clamp(rise / (slope + root), 0.0, 1.0);
    return {least.a + share * way.a, least.b + share * way.b};
}

}  // namespace signorini
