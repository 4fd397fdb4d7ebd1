#include "stepped_motions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "backend_choice.hpp"

namespace signorini {

namespace {

SolverOptions settingsFor(const Solver& solver, const FindOptions& options)
{
    return {.tolerance = std::min(options.tolerance, 1e-9),
            .iterationLimit = options.iterationLimit,
            .timeLimit = options.timeLimit,
            .cancel = solver.capabilities().cancel ? options.cancel : Cancel()};
}

SteppedPoint solved(const Program& program, const FindOptions& options)
{
    SteppedPoint point;
    point.solver = backendFor(program, options.solver);
    const auto solver = makeSolver(point.solver);
    SolverResult answer = solver->solve(program, settingsFor(*solver, options));
    point.iterations = answer.iterations;
    if (answer.status == SolverStatus::optimal) {
        point.x = std::move(answer.x);
    } else {
        point.detail = fmt::format("{}: {}", point.solver, answer.detail);
    }
    return point;
}

/// The point of a given energy on the way from one to another, of energies below and above.
Eigen::VectorXd between(const Eigen::VectorXd& low, const Eigen::VectorXd& high,
                        const Eigen::VectorXd& weights, double energy)
{
    const Eigen::VectorXd way = high - low;
    const double square = weights.dot(way.cwiseAbs2());
    const double slope = weights.cwiseProduct(low).dot(way);
    const double rise = std::max(0.0, energy - weights.dot(low.cwiseAbs2()));
    const double root = std::sqrt(slope * slope + square * rise);
    return low + (rise > 0.0 ? rise / (slope + root) : 0.0) * way;
}

}  // namespace

Objective objectiveOf(const FindOptions& options)
{
    if (options.objective != Objective::automatic) {
        return options.objective;
    }
    if (options.energyRatio) {
        return Objective::any;
    }
    const bool canMinimise = options.solver == automaticChoice
                                 ? preferred({.quadraticObjective = true}) != nullptr
                                 : findBackend(options.solver).can.quadraticObjective;
    return canMinimise ? Objective::minEnergy : Objective::any;
}

SteppedPoint extremePoint(SteppedProgram& posed, Objective objective, const FindOptions& options)
{
    posed.program.linear.setZero();
    posed.program.quadratic.resize(0);
    if (objective == Objective::minEnergy) {
        posed.program.quadratic = 2.0 * posed.energyWeights;
    } else if (objective == Objective::maxImpulse) {
        posed.program.linear = -posed.impulse;
    }
    return solved(posed.program, options);
}

SteppedPoint pointOfEnergy(SteppedProgram& posed, const FindOptions& options)
{
    constexpr int directions = 8;
    const double wanted = *options.energyRatio;
    const auto energy = [&posed](const Eigen::VectorXd& x) {
        return posed.energyWeights.dot(x.cwiseAbs2());
    };
    SteppedPoint least = extremePoint(posed, Objective::minEnergy, options);
    if (!least.isFound()) {
        return least;
    }
    const double lowest = energy(least.x);
    if (wanted < lowest * (1.0 - options.tolerance)) {
        least.detail = fmt::format(
            "the least energy found is {:.9g} E_1, and nothing proves that "
            "there is none below it",
            lowest);
        return least;
    }
    if (wanted <= lowest) {
        return least;
    }
    double highest = lowest;
    posed.program.quadratic.resize(0);
    FindOptions linear = options;
    linear.solver = automaticChoice;
    for (int k = 0; k < directions; ++k) {
        Eigen::VectorXd& cost = posed.program.linear;
        for (Eigen::Index i = 0; i < cost.size(); ++i) {
            cost[i] = posed.energyWeights[i] * std::cos(static_cast<double>((i + 1) * (k + 1)));
        }
        for (double reached = -1.0;;) {
            const SteppedPoint vertex = solved(posed.program, linear);
            if (!vertex.isFound()) {
                break;
            }
            const double found = energy(vertex.x);
            highest = std::max(highest, found);
            if (found >= wanted) {
                least.x = between(least.x, vertex.x, posed.energyWeights, wanted);
                return least;
            }
            if (!(found > reached * (1.0 + 1e-9))) {
                break;
            }
            reached = found;
            cost = -2.0 * posed.energyWeights.cwiseProduct(vertex.x);
        }
    }
    least.detail = fmt::format(
        "energies up to {:.9g} E_1 were found, and nothing proves that "
        "there is none above",
        highest);
    return least;
}

}  // namespace signorini
