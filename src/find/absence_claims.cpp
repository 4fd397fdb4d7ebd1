#include "absence_claims.hpp"

#include "backend_choice.hpp"
#include "formulation.hpp"
#include "lumped_proof.hpp"
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

std::optional<Absence> absenceByEnergy(const Request& request)
{
    const std::optional<double>& wanted = request.demands.energyRatio;
    const std::optional<EnergyRange>& range = request.known.set.energy;
    const double tolerance = request.options.tolerance;
    if (!wanted || !range || !isOutOfRange(*wanted, *range, tolerance)) {
        return std::nullopt;
    }
    return Absence{
        Reason::constraints,
        EnergyExclusion{.energyRatio = *wanted, .range = *range, .tolerance = tolerance}};
}

std::optional<Absence> absenceByProgram(const Request& request, Formulation formulation)
{
    auto proof = proofFor(request, request.demands, formulation);
    if (!proof) {
        return std::nullopt;
    }
    return Absence{reasonOfProgram(request),
                   ProgramProof{.multipliers = std::move(*proof),
                                .rows = formulation,
                                .demands = {.strainLimit = request.demands.strainLimit,
                                            .tipFloor = request.demands.tipFloor,
                                            .fixed = request.demands.fixed},
                                .tolerance = request.options.tolerance}};
}

}  // namespace signorini
