#include "tolerated.hpp"
#include "formulation.hpp"

#include <algorithm>
#include <cmath>

namespace signorini {

namespace {

/// Does the proof hold for whatever values within the tolerance of the prescribed ones? They are
/// the last rows of the equalities; each moves to where the proof is weakest.
bool coversTolerance(const InfeasibilityProof& proof, Program program, const Demands& demands,
                     double tolerance)
{
    const auto fixed = static_cast<std::int64_t>(demands.fixed.size());
    const std::int64_t last = program.equalities.rows();
    const std::int64_t first = last - fixed;
    for (const Multiplier& row : proof.equalities) {
        if (row.row >= first && row.row < last) {
            const double value = demands.fixed[static_cast<std::size_t>(row.row - first)].value;
            const double allowed = tolerance * std::max(1.0, std::abs(value));
            program.equalityRhs[row.row] += row.value > 0 ? allowed : -allowed;
        }
    }
    return isProof(proof, program);
}

/// The rows of the limits and fixed values, relaxed as far as inequalities are.
Program relaxedRows(const Schedule& schedule, Demands& demands, Formulation formulation,
                    double tolerance)
{
    demands.objective = Objective::any;
    demands.target.reset();
    demands.energyRatio.reset();
    return pose(schedule, relaxed(demands, tolerance), formulation).program;
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

bool isUnmet(const InfeasibilityProof& proof, const Schedule& schedule, Demands demands,
             Formulation formulation, double tolerance)
{
    return tolerance >= 0.0 &&
           coversTolerance(proof, relaxedRows(schedule, demands, formulation, tolerance), demands,
                           tolerance);
}

std::optional<InfeasibilityProof> proveUnmet(const Schedule& schedule, Demands demands,
                                             Formulation formulation, const Solver* simplex,
                                             const SolverOptions& options)
{
    const Program program = relaxedRows(schedule, demands, formulation, options.tolerance);
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
