#include "program_solution.hpp"

#include <cmath>

namespace signorini {

namespace {

/// Where to start for a held energy: equal amplitudes, where a solver would otherwise start, are a
/// stationary point of the energy on the set. This takes them apart, the same way in every run.
Eigen::VectorXd startWithEnergy(const Program& program)
{
    const EnergyEquality& energy = *program.energy;
    Eigen::VectorXd x = Eigen::VectorXd::Zero(program.variables());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        const double wave = 1.0 + 0.5 * std::cos(2.4 * static_cast<double>(i));
        x[i] = energy.weights[i] > 0.0 ? wave : 0.0;
    }
    x *= std::sqrt(energy.value / energy.weights.dot(x.cwiseAbs2()));
    return x.cwiseMax(program.lower).cwiseMin(program.upper);
}

/// Most energy is a convex maximum: from several directions, follow its linearisation from vertex
/// to vertex while the energy grows. The best vertex found is no proof of the most.
SolverResult climb(Formulated& formulated, const Solver& solver, const SolverOptions& settings)
{
    constexpr int directions = 8;
    const Eigen::VectorXd weights = energyWeights(formulated);
    const auto energy = [&weights](const Eigen::VectorXd& x) { return weights.dot(x.cwiseAbs2()); };
    SolverResult best;
    for (int k = 0; k < directions; ++k) {
        // Directions spread over the unknowns, the same in every run.
        Eigen::VectorXd& cost = formulated.program.linear;
        for (Eigen::Index i = 0; i < cost.size(); ++i) {
            cost[i] = std::cos(static_cast<double>((i + 1) * (k + 1)));
        }
        double reached = -1.0;
        while (true) {
            SolverResult next = solver.solve(formulated.program, settings);
            if (next.status != SolverStatus::optimal) {
                return best.status == SolverStatus::optimal ? best : next;
            }
            const double found = energy(next.x);
            if (!(found > reached * (1.0 + 1e-9))) {
                break;
            }
            reached = found;
            cost = -2.0 * weights.cwiseProduct(next.x);
            if (best.status != SolverStatus::optimal || found > energy(best.x)) {
                best = std::move(next);
            }
        }
    }
    return best;
}

}  // namespace

SolverResult solve(Formulated& formulated, Objective objective, const Solver& solver,
                   const SolverOptions& settings)
{
    if (objective == Objective::maxEnergy) {
        return climb(formulated, solver, settings);
    }
    SolverOptions started = settings;
    if (formulated.program.energy && solver.capabilities().start) {
        started.start = startWithEnergy(formulated.program);
    }
    return solver.solve(formulated.program, started);
}

}  // namespace signorini
