#include <algorithm>

#include "absence_claims.hpp"
#include "backend_choice.hpp"
#include "echo.hpp"
#include "limited_energy.hpp"
#include "nearest_motion.hpp"
#include "routes.hpp"

namespace signorini {

namespace {

Provenance closedFormProvenance(const Request& request)
{
    Provenance how{.route = std::string(closedForm),
                   .reason = "one contact phase: exact, and without iteration",
                   .leftOut = {"matrices of (27)-(32): steps are signed shifts",
                               "solver libraries: the solution set is known in closed form",
                               "all but one row of (32) per sign block: prefix sums are monotone "
                               "inside"},
                   .solver = {.name = std::string(closedForm)}};
    how.objective = request.demands.objective;
    if (request.isOfAnySize()) {
        how.objective = Objective::maxImpulse;
    } else if (how.objective == Objective::automatic) {
        how.objective =
            request.demands.energyRatio ? Objective::minPeakStrain : Objective::minEnergy;
    }
    if (request.known.onePhase->schedule != request.schedule) {
        how.leftOut.emplace_back("steps beyond 2N in contact and 4N in flight: they repeat");
    }
    return how;
}

/// The motion of an energy to hold, the flattest where nothing else is asked for. Within the
/// tolerance an energy beyond an end is met by the end.
State motionOfHeldEnergy(const OnePhaseSet& whole, const Demands& demands)
{
    const double squares =
        std::clamp(squaresOf(*demands.energyRatio, whole.schedule.cells, whole.window),
                   leastSquares(whole.set), mostSquares(whole.set));
    switch (demands.objective) {
        case Objective::any:
            return motionOf(whole, amplitudesWithSquares(whole.set, squares));
        case Objective::nearest:
            return motionOf(whole, nearestWithSquares(
                                       whole.set, amplitudesOf(whole, *demands.target), squares));
        default:
            return motionOf(whole, flattestAmplitudes(whole.set, squares));
    }
}

/// The motion that fits the objective. Equal amplitudes have the least energy and the least peak
/// strain, and the impulse is the same for all amplitudes. Empty where rounding spoils it.
std::optional<State> candidate(const OnePhaseSet& whole, const Demands& demands)
{
    if (demands.energyRatio) {
        return motionOfHeldEnergy(whole, demands);
    }
    if (demands.objective == Objective::maxEnergy) {
        return motionOf(whole, mostAmplitudes(whole.set));
    }
    if (demands.objective == Objective::nearest) {
        return nearestMotion(whole, *demands.target);
    }
    return leastEnergyMotion(whole);
}

/// Limits on strain and tip are met by equal amplitudes or by none.
std::optional<Absence> absenceByLimits(const Request& request)
{
    const Demands& demands = request.demands;
    if (!demands.fixed.empty() || demands.energyRatio ||
        request.isMetBy(leastEnergyMotion(*request.known.onePhase))) {
        return std::nullopt;
    }
    return absenceByProgram(request, Formulation::lumped);
}

/// Of an energy to hold, if any motion will do: the flattest one keeps a limit on strain if one
/// does, others need not.
std::optional<State> motionWithinLimit(const Request& request)
{
    const Demands& demands = request.demands;
    if (!demands.energyRatio || !std::isfinite(demands.strainLimit) ||
        demands.objective != Objective::any) {
        return std::nullopt;
    }
    auto state = motionWithin(request.known, demands.strainLimit, *demands.energyRatio);
    return state && request.isMetBy(*state) ? state : std::nullopt;
}

}  // namespace

std::optional<Claim> closedFormRoute(const Request& request)
{
    if (!request.known.onePhase || !request.allowsExact()) {
        return std::nullopt;
    }
    const Stopwatch watch;
    const auto claim = [&](auto&& answer) {
        Claim made{closedFormProvenance(request), std::forward<decltype(answer)>(answer)};
        made.how.solver.seconds = request.known.seconds + watch.seconds();
        return made;
    };
    for (const auto& find : {absenceOfAll, absenceByEnergy}) {
        if (auto absence = find(request)) {
            return claim(std::move(*absence));
        }
    }
    auto state = request.isOfAnySize()
                     ? std::optional(request.sized(leastEnergyMotion(*request.known.onePhase)))
                     : candidate(*request.known.onePhase, request.demands);
    if (state) {
        if (request.isMetBy(*state)) {
            return claim(std::move(*state));
        }
        if (auto absence = absenceByLimits(request)) {
            return claim(std::move(*absence));
        }
        if (auto within = motionWithinLimit(request)) {
            return claim(std::move(*within));
        }
    }
    if (request.demands.needsExactRoute()) {
        return claim("the motion of this energy and objective breaks a limit: try objective any");
    }
    if (request.options.solver == closedForm) {
        return claim(noExactAnswer);
    }
    return std::nullopt;
}

}  // namespace signorini
