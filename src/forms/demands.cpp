#include "signorini/demands.hpp"

#include <algorithm>
#include <cmath>

#include "demand_names.hpp"
#include "faults.hpp"

namespace signorini {

namespace {

/// Squares of distances to a target must be finite.
constexpr double largestTarget = 1e100;

}  // namespace

std::string_view name(Objective objective)
{
    return nameIn(objectiveNames, objective);
}

bool Demands::areLimits() const
{
    return std::isfinite(strainLimit) || std::isfinite(tipFloor) || !fixed.empty() ||
           energyRatio.has_value();
}

bool Demands::needsExactRoute() const
{
    return energyRatio &&
           (objective == Objective::minPeakStrain || objective == Objective::nearest);
}

void validate(const Demands& demands, const Schedule& schedule)
{
    Faults faults;
    if (!(demands.strainLimit > 0.0)) {
        faults.add("strainLimit", demands.strainLimit, "> 0");
    }
    if (!(demands.tipFloor < schedule.stops.right)) {
        faults.add("tipFloor", demands.tipFloor,
                   fmt::format("below the wall: < {} [g]", schedule.stops.right));
    }
    if (demands.energyRatio &&
        !(std::isfinite(*demands.energyRatio) && *demands.energyRatio > 0.0)) {
        faults.add("energyRatio", *demands.energyRatio, "finite and > 0");
    }
    for (const FixedValue& fixed : demands.fixed) {
        if (fixed.cell < 1 || fixed.cell > schedule.cells) {
            faults.add("cell of a fixed value", fixed.cell, fmt::format("1..{}", schedule.cells));
        }
        if (!std::isfinite(fixed.value)) {
            faults.add("fixed value", fixed.value, "finite numbers");
        }
    }
    const bool wantsTarget = demands.objective == Objective::nearest;
    if (wantsTarget != demands.target.has_value()) {
        faults.add("target", demands.target ? "given" : "missing",
                   "a state with objective nearest, and only then");
    } else if (demands.target) {
        const State& target = *demands.target;
        if (target.a.size() != schedule.cells || target.b.size() != schedule.cells) {
            faults.add("cells of the target", target.a.size(), fmt::format("{}", schedule.cells));
        } else if (!target.a.allFinite() || !target.b.allFinite()) {
            faults.add("target", "NaN or infinity", "finite numbers");
        } else if (amplitude(target) > largestTarget) {
            faults.add("amplitude of the target", amplitude(target),
                       fmt::format("at most {}", largestTarget));
        }
    }
    if (demands.energyRatio && demands.objective != Objective::automatic &&
        demands.objective != Objective::any && !demands.needsExactRoute()) {
        faults.add("objective", name(demands.objective),
                   "auto|any|min-peak-strain|nearest when an energy is held");
    }
    faults.throwIfAny();
}

double violation(const Demands& demands, const State& state, const Extremes& seen,
                 double energyRatio)
{
    double worst = std::max(
        {0.0, seen.peakCompression / demands.strainLimit - 1.0, demands.tipFloor - seen.lowestTip});
    for (const FixedValue& fixed : demands.fixed) {
        const Eigen::VectorXd& wave = fixed.wave == Wave::a ? state.a : state.b;
        const double size = std::max(1.0, std::abs(fixed.value));
        worst = std::max(worst, std::abs(wave[fixed.cell - 1] - fixed.value) / size);
    }
    if (demands.energyRatio) {
        worst = std::max(worst, std::abs(energyRatio / *demands.energyRatio - 1.0));
    }
    return worst;
}

double violation(const Demands& demands, const State& state, const Schedule& schedule)
{
    const bool hasLimits = std::isfinite(demands.strainLimit) || std::isfinite(demands.tipFloor);
    const Extremes seen = hasLimits ? extremesOf(state, schedule) : Extremes();
    return violation(demands, state, seen, energyRatio(state));
}

}  // namespace signorini
