#include "tolerated.hpp"
#include "formulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace signorini {

namespace {

/// Does the proof hold for whatever values within the tolerance of the prescribed ones? They are
/// the last rows of the equalities; each moves to where the proof is weakest.
bool coversTolerance(const InfeasibilityProof& proof, Program program, const Demands& demands,
                     double tolerance)
{
    const auto fixed = static_cast<std::int64_t>(demands.fixed.size());
    const std::int64_t first = program.equalities.rows() - fixed;
    for (const Multiplier& row : proof.equalities) {
        if (row.row >= first) {
            const double value = demands.fixed[static_cast<std::size_t>(row.row - first)].value;
            const double allowed = tolerance * std::max(1.0, std::abs(value));
            program.equalityRhs[row.row] += row.value > 0 ? allowed : -allowed;
        }
    }
    return isProof(proof, program);
}

}  // namespace

Demands relaxed(Demands demands, double tolerance)
{
    demands.strainLimit *= 1.0 + tolerance;
    demands.tipFloor -= tolerance;
    return demands;
}

bool isOutOfRange(double energyRatio, const EnergyRange& range, double tolerance)
{
    return energyRatio * (1.0 + tolerance) < range.least ||
           energyRatio * (1.0 - tolerance) > range.most;
}

std::optional<InfeasibilityProof> proveUnmet(const Schedule& schedule, Demands demands,
                                             Formulation formulation, const Solver* simplex,
                                             const SolverOptions& options)
{
    demands.objective = Objective::any;
    demands.target.reset();
    demands.energyRatio.reset();
    const Program program =
        pose(schedule, relaxed(demands, options.tolerance), formulation).program;
    auto proof = proveByOneRow(program);
    if (!proof && simplex != nullptr) {
        proof = proveInfeasible(program, *simplex, options);
    }
    if (proof && !coversTolerance(*proof, program, demands, options.tolerance)) {
        return std::nullopt;
    }
    return proof;
}

}  // namespace signorini
