#include "network_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "backend_choice.hpp"

namespace signorini {

namespace {

/// The point of a given energy on the way from one to another, of energies below and above.
Eigen::VectorXd between(const Eigen::VectorXd& low, const Eigen::VectorXd& high, double energy)
{
    const Eigen::VectorXd way = high - low;
    const double slope = low.dot(way);
    const double rise = std::max(0.0, energy - low.squaredNorm());
    const double root = std::sqrt(slope * slope + way.squaredNorm() * rise);
    return low + (rise > 0.0 ? rise / (slope + root) : 0.0) * way;
}

}  // namespace

NetworkPoints::NetworkPoints(const NetworkBlocks& blocks, const FindOptions& options)
    : blocks_(blocks), options_(options)
{
    if (auto kernel = kernelOf<double>(blocks)) {
        kernel_ = std::move(*kernel);
    }
    const NetworkRows<double> rows = rowsOf(blocks, kernel_);
    const RowSystem& system = rows.system;
    const Eigen::Index below = system.rows.rows() - system.equalities;
    impulse_ = rows.impulse;
    program_ = emptyProgram(system.rows.cols());
    program_.equalities = system.rows.topRows(system.equalities).sparseView();
    program_.equalityRhs = system.rhs.head(system.equalities);
    program_.inequalities = (-system.rows.bottomRows(below)).sparseView();
    program_.inequalityRhs = -system.rhs.tail(below);
}

NetworkPoint NetworkPoints::solved(const std::string& solver) const
{
    NetworkPoint point;
    point.solver = backendFor(program_, solver);
    const auto backend = makeSolver(point.solver);
    const SolverResult answer = backend->solve(
        program_, {.tolerance = std::min(options_.tolerance, 1e-9),
                   .iterationLimit = options_.iterationLimit,
                   .timeLimit = options_.timeLimit,
                   .cancel = backend->capabilities().cancel ? options_.cancel : Cancel()});
    point.iterations = answer.iterations;
    point.z = answer.x;
    if (answer.status != SolverStatus::optimal) {
        point.detail = fmt::format("{}: {}", point.solver, answer.detail);
    }
    return point;
}

NetworkPoint NetworkPoints::extreme(Objective objective)
{
    program_.linear.setZero();
    program_.quadratic.resize(0);
    if (objective == Objective::minEnergy) {
        program_.quadratic.setConstant(program_.variables(), 2.0);
    } else {
        program_.linear = -impulse_;
    }
    return solved(options_.solver);
}

NetworkPoint NetworkPoints::ofEnergy(double wanted)
{
    constexpr int directions = 8;
    NetworkPoint least = extreme(Objective::minEnergy);
    if (!least.detail.empty()) {
        return least;
    }
    const double unit = 2.0 / static_cast<double>(blocks_.network().cells());  // 1/E_1
    const double lowest = least.z.squaredNorm();
    if (wanted < lowest * (1.0 - options_.tolerance)) {
        least.detail = fmt::format(
            "the least energy found is {:.9g} E_1, and nothing proves that there is none below it",
            lowest * unit);
        return least;
    }
    double highest = lowest;
    program_.quadratic.resize(0);
    for (int k = 0; k < directions && wanted > lowest; ++k) {
        Eigen::VectorXd& cost = program_.linear;
        for (Eigen::Index i = 0; i < cost.size(); ++i) {
            cost[i] = std::cos(static_cast<double>((i + 1) * (k + 1)));
        }
        for (double reached = -1.0;;) {
            const NetworkPoint vertex = solved(std::string(automaticChoice));
            if (!vertex.detail.empty()) {
                break;
            }
            const double found = vertex.z.squaredNorm();
            highest = std::max(highest, found);
            if (found >= wanted) {
                least.z = between(least.z, vertex.z, wanted);
                return least;
            }
            if (!(found > reached * (1.0 + 1e-9))) {
                break;
            }
            reached = found;
            cost = -2.0 * vertex.z;
        }
    }
    if (wanted > lowest) {
        least.detail = fmt::format(
            "energies up to {:.9g} E_1 were found, and nothing proves that there is none above",
            highest * unit);
    }
    return least;
}

std::vector<double> NetworkPoints::waves(const NetworkPoint& point) const
{
    return wavesAt(blocks_, kernel_, Eigen::VectorXd(point.z), Eigen::VectorXd());
}

}  // namespace signorini
