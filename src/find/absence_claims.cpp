#include "absence_claims.hpp"

#include <cmath>

#include "backend_choice.hpp"
#include "formulation.hpp"
#include "limited_energy.hpp"
#include "lumped_proof.hpp"
#include "stops.hpp"
#include "tolerated.hpp"

namespace signorini {

namespace {

std::optional<InfeasibilityProof> proofFor(const Request& request, const Demands& demands,
                                           Formulation formulation)
{
    const auto simplex = simplexWithDuals();
    return proveUnmet(
        request.schedule, demands, formulation, simplex.get(),
        {.tolerance = request.options.tolerance, .timeLimit = request.options.timeLimit});
}

/// Why a program without solution has none.
Reason reasonOfProgram(const Request& request)
{
    const Known& known = request.known;
    if (known.onePhase) {
        return known.onePhase->reason.value_or(Reason::constraints);
    }
    if (known.reason != Reason::penetration) {
        return known.reason;
    }
    const bool isEmpty = known.sums ? known.sums->absence.has_value()
                                    : proofFor(request, Demands{}, Formulation::lumped).has_value();
    return request.demands.areLimits() && !isEmpty ? Reason::constraints : Reason::penetration;
}

}  // namespace

std::optional<Absence> absenceOfAll(const Request& request)
{
    const Known& known = request.known;
    if (known.onePhase && known.onePhase->reason) {
        return Absence{*known.onePhase->reason, proveAbsence(*known.onePhase)};
    }
    if (known.sums && known.sums->absence) {
        const Program program = formulate(request.schedule, Formulation::lumped).program;
        return Absence{known.reason, ProgramProof{.multipliers = proofOf(*known.sums, program),
                                                  .rows = Formulation::lumped}};
    }
    return std::nullopt;
}

std::optional<Absence> absenceBesideRest(const Request& request)
{
    const Schedule& schedule = request.schedule;
    if (!schedule.stops.left || !canRest(schedule.phases, schedule.stops)) {
        return std::nullopt;
    }
    FindOptions alone{.scene = request.options.scene, .energyRatio = 1.0};
    alone.scene.secondStop.reset();
    return findPeriodic(schedule, alone).absence;
}

std::optional<Absence> absenceByEnergy(const Request& request)
{
    const std::optional<double>& wanted = request.demands.energyRatio;
    const std::optional<EnergyRange>& range = request.known.set.energy;
    const double tolerance = request.options.tolerance;
    if (!wanted || !range) {
        return std::nullopt;
    }
    EnergyExclusion exclusion{.energyRatio = *wanted, .range = *range, .tolerance = tolerance};
    if (!isOutOfRange(*wanted, *range, tolerance)) {
        const double limit = request.demands.strainLimit;
        if (!std::isfinite(limit)) {
            return std::nullopt;
        }
        const auto within = energyWithin(request.known, limit * (1.0 + tolerance));
        if (!within) {
            return std::nullopt;
        }
        exclusion.strainLimit = limit;
        exclusion.range.most = within->most;
        if (!isOutOfRange(*wanted, exclusion.range, tolerance)) {
            return std::nullopt;
        }
    }
    return Absence{Reason::constraints, exclusion};
}

std::optional<Absence> absenceByProgram(const Request& request, Formulation formulation)
{
    // Limits alone are excluded over sums, too, by rows that others can check.
    const Formulation rows = formulation == Formulation::reduced && request.demands.fixed.empty()
                                 ? Formulation::lumped
                                 : formulation;
    auto proof = proofFor(request, request.demands, rows);
    if (!proof) {
        return std::nullopt;
    }
    return Absence{reasonOfProgram(request),
                   ProgramProof{.multipliers = std::move(*proof),
                                .rows = rows,
                                .demands = {.strainLimit = request.demands.strainLimit,
                                            .tipFloor = request.demands.tipFloor,
                                            .fixed = request.demands.fixed},
                                .tolerance = request.options.tolerance}};
}

}  // namespace signorini
