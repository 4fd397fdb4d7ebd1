#include <fmt/format.h>

#include <cmath>

#include "absence_claims.hpp"
#include "backend_choice.hpp"
#include "known_motions.hpp"
#include "limited_energy.hpp"
#include "nearest_motion.hpp"
#include "routes.hpp"

namespace signorini {

namespace {

Provenance sumsProvenance(const Request& request)
{
    Provenance how{.route = "lumped",
                   .leftOut = {"matrices of (27)-(32): steps are signed shifts",
                               "solver libraries: so few sums are decided in rational arithmetic",
                               "single amplitudes: equal ones reach every sum at least energy",
                               "rows of (32) inside sign blocks: prefix sums are monotone there",
                               "closure of the last flight: periodicity implies it"},
                   .solver = {.name = std::string(closedForm)}};
    if (request.isOfAnySize()) {
        how.objective = Objective::maxImpulse;
    } else if (request.demands.objective != Objective::automatic) {
        how.objective = request.demands.objective;
    } else if (!request.demands.energyRatio) {
        how.objective = Objective::minEnergy;
    }
    if (const auto& sums = request.known.sums) {
        how.reason =
            fmt::format("{}: exact, {} sums of amplitudes decide",
                        request.schedule.stops.left ? "two stops" : "several contact phases",
                        sums->live.size());
        if (sums->classes.schedule != request.schedule) {
            how.leftOut.emplace_back("steps beyond 2N in contact and 4N in flight: they repeat");
        }
    }
    return how;
}

/// The motion that the objective asks for, if the sums know it.
std::optional<State> candidate(const LumpedSet& sums, const LumpedShape& shape,
                               const Demands& demands, double tolerance)
{
    const bool isMostKnown = std::isfinite(shape.energy.most);
    switch (demands.objective) {
        case Objective::automatic:
        case Objective::any:
        case Objective::minEnergy: {
            const bool isHeldAtMost = demands.energyRatio && isMostKnown &&
                                      *demands.energyRatio >= shape.energy.most * (1.0 - tolerance);
            return isHeldAtMost ? mostEnergyMotion(sums, shape) : equalMotion(sums, sums.leastSums);
        }
        case Objective::maxEnergy:
            return isMostKnown ? std::optional(mostEnergyMotion(sums, shape)) : std::nullopt;
        case Objective::nearest:
            return nearestMotion(sums, shape, *demands.target);
        default:
            return std::nullopt;
    }
}

std::optional<State> motionHoldingEnergy(const Request& request)
{
    const Known& known = request.known;
    const Demands& demands = request.demands;
    if (!known.sums || known.sums->absence || !request.allowsExact() || !demands.energyRatio) {
        return std::nullopt;
    }
    std::optional<State> state;
    if (std::isfinite(demands.strainLimit)) {
        state = motionWithin(known, demands.strainLimit, *demands.energyRatio);
    } else if (std::isfinite(known.shape.energy.most)) {
        state = motionOfEnergy(equalMotion(*known.sums, known.sums->leastSums),
                               mostEnergyMotion(*known.sums, known.shape), *demands.energyRatio);
    }
    return state && request.isMetBy(*state) ? state : std::nullopt;
}

}  // namespace

std::optional<Claim> refuseRoute(const Request& request)
{
    if (request.known.outOfReach.empty()) {
        return std::nullopt;
    }
    return Claim{{.solver = {.name = request.options.solver}}, request.known.outOfReach};
}

std::optional<Claim> sumsRoute(const Request& request)
{
    const Known& known = request.known;
    if (known.onePhase || !request.allowsExact()) {
        return std::nullopt;
    }
    const Stopwatch watch;
    const auto claim = [&](auto&& answer) {
        Claim made{sumsProvenance(request), std::forward<decltype(answer)>(answer)};
        made.how.solver.seconds = known.seconds + watch.seconds();
        return made;
    };
    for (const auto& find : {absenceOfAll, absenceBesideRest, absenceByEnergy}) {
        if (auto absence = find(request)) {
            return claim(std::move(*absence));
        }
    }
    if (known.sums) {
        auto state =
            request.isOfAnySize()
                ? std::optional(request.sized(equalMotion(*known.sums, known.sums->leastSums)))
                : candidate(*known.sums, known.shape, request.demands, request.options.tolerance);
        if (state && request.isMetBy(*state)) {
            return claim(std::move(*state));
        }
    }
    if (request.options.solver == closedForm) {
        if (auto state = motionHoldingEnergy(request)) {
            return claim(std::move(*state));
        }
        return claim(noExactAnswer);
    }
    return std::nullopt;
}

bool holdsEnergyInSums(const Request& request)
{
    return motionHoldingEnergy(request).has_value();
}

std::optional<Claim> heldEnergyRoute(const Request& request)
{
    auto state = motionHoldingEnergy(request);
    if (!state) {
        return std::nullopt;
    }
    Claim claim{sumsProvenance(request), std::move(*state)};
    claim.how.reason +=
        "; a motion of this energy between those of least and most, as the flattest is known for "
        "one "
        "contact phase only";
    claim.how.solver.seconds = request.known.seconds;
    return claim;
}

}  // namespace signorini
