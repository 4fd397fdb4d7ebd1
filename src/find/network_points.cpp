#include "network_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "backend_choice.hpp"
#include "infinity.hpp"
#include "network_motions.hpp"

namespace signorini {

namespace {

constexpr const char* outOfReach = "the kernel of W - 1 is out of reach";

/// The point of a given energy on the way from one to another, of energies below and above.
Eigen::VectorXd between(const Eigen::VectorXd& low, const Eigen::VectorXd& high, double energy)
{
    const Eigen::VectorXd way = high - low;
    const double slope = low.dot(way);
    const double rise = std::max(0.0, energy - low.squaredNorm());
    const double root = std::sqrt(slope * slope + way.squaredNorm() * rise);
    return low + (rise > 0.0 ? rise / (slope + root) : 0.0) * way;
}

/// That of waves which are everywhere as large as the limit on strain; infinite without.
double energyWithin(const Network& network)
{
    double energy = 0.0;
    for (const CellRow& row : network.rows) {
        const double wave = network.strainLimit * row.speed;
        energy += row.impedance * static_cast<double>(row.cells) * wave * wave;
    }
    return energy;
}

}  // namespace

NetworkPoints::NetworkPoints(const NetworkBlocks& blocks, const FindOptions& options)
    : blocks_(blocks), options_(options), kernel_(kernelOf<double>(blocks))
{
    if (!kernel_) {
        return;
    }
    rows_ = rowsOf(blocks, *kernel_);
    program_ = emptyProgram(rows_.system.rows.cols());
    enterRows();
}

void NetworkPoints::enterRows()
{
    const RowSystem& system = rows_.system;
    const Eigen::Index below = system.rows.rows() - system.equalities;
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(system.rows.rows(), program_.variables());
    all.leftCols(system.rows.cols()) = system.rows;
    Eigen::VectorXd rhs = system.rhs;
    if (all.cols() > system.rows.cols()) {  // the last unknown is the limit on strain
        for (std::size_t k = 0; k < rows_.conditions.size(); ++k) {
            const BlockCondition& of = rows_.conditions[k];
            if (of.kind == BlockCondition::Kind::strain) {
                const auto row = static_cast<Eigen::Index>(k);
                const double speed = blocks_.network().rows[of.contact].speed;
                all(row, all.cols() - 1) = speed;
                rhs[row] += speed * limits_[k];
            }
        }
    }
    program_.equalities = all.topRows(system.equalities).sparseView();
    program_.equalityRhs = rhs.head(system.equalities);
    program_.inequalities = (-all.bottomRows(below)).sparseView();
    program_.inequalityRhs = -rhs.tail(below);
}

bool NetworkPoints::addStrains(const Eigen::VectorXd& z, double limit)
{
    const bool isBroken = addBrokenStrains(rows_, blocks_, *kernel_, limit,
                                           Eigen::VectorXd(z.head(rows_.system.rows.cols())),
                                           steadyInputs(*kernel_)) > 0;
    limits_.resize(rows_.conditions.size(), limit);
    return isBroken;
}

NetworkPoint NetworkPoints::solved()
{
    constexpr double rounding = 1e-9;
    const Eigen::Index coordinates = rows_.system.rows.cols();
    NetworkPoint point;
    std::int64_t iterations = 0;
    for (;;) {
        point = solvedOnce();
        iterations += point.iterations;
        point.iterations = iterations;
        if (!point.detail.empty()) {
            return point;
        }
        const double limit = program_.variables() > coordinates
                                 ? point.z[coordinates] * (1.0 + rounding)
                                 : blocks_.network().strainLimit;
        if (!addStrains(point.z, limit) || isOver(point)) {
            return point;
        }
        enterRows();
    }
}

NetworkPoint NetworkPoints::leastStrained()
{
    // One more unknown, the limit, is to be least. What it allows at first is all.
    const Eigen::Index unknowns = rows_.system.rows.cols();
    program_ = emptyProgram(unknowns + 1);
    program_.lower[unknowns] = 0.0;
    program_.linear[unknowns] = 1.0;
    enterRows();
    NetworkPoint point = solved();
    if (point.detail.empty()) {
        point.z.conservativeResize(unknowns);
    }
    return point;
}

bool NetworkPoints::isOver(NetworkPoint& point) const
{
    const bool isLate = watch_.seconds() > options_.timeLimit;
    if (isLate || isRequested(options_.cancel)) {
        point.detail =
            isLate ? "the time limit was reached while limits on strain were added" : "cancelled";
    }
    return !point.detail.empty();
}

NetworkPoint NetworkPoints::solvedOnce() const
{
    NetworkPoint point;
    if (!kernel_) {
        point.detail = outOfReach;
        return point;
    }
    if (program_.variables() == 0) {
        return point;  // a single one
    }
    point.solver = backendFor(program_, options_.solver);
    const auto backend = makeSolver(point.solver);
    const SolverResult answer = backend->solve(
        program_, {.tolerance = std::min(options_.tolerance, 1e-9),
                   .iterationLimit = options_.iterationLimit,
                   .timeLimit = options_.timeLimit,
                   .cancel = backend->capabilities().cancel ? options_.cancel : Cancel()});
    point.iterations = answer.iterations;
    point.z = answer.x;
    point.isUnbounded = answer.status == SolverStatus::unbounded;
    if (answer.status != SolverStatus::optimal) {
        point.detail = fmt::format("{}: {}", point.solver, answer.detail);
    }
    return point;
}

NetworkPoint NetworkPoints::extreme(Objective objective)
{
    if (kernel_ && objective == Objective::minPeakStrain) {
        return leastStrained();
    }
    program_.linear.setZero();
    program_.quadratic.resize(0);
    if (kernel_ && objective == Objective::minEnergy) {
        program_.quadratic.setConstant(program_.variables(), 2.0);
        program_.linear = 2.0 * steadyCoordinates(blocks_, *kernel_);
    } else {
        // Where nothing can press the impulse is rounding.
        constexpr double rounding = 1e-11;
        const double size = rows_.system.rows.rowwise().norm().sum();
        program_.linear = -rows_.impulse;
        if (rows_.impulse.norm() <= rounding * size) {
            program_.linear.setZero();
        }
    }
    return solved();
}

NetworkPoint NetworkPoints::climbed(const Eigen::VectorXd& made, double box, double enough)
{
    constexpr int directions = 16;
    program_.quadratic.resize(0);
    program_.lower = -made.array() - box;
    program_.upper = -made.array() + box;
    NetworkPoint best;
    double highest = -1.0;
    for (int k = 0; k < directions && highest < enough; ++k) {
        const double sign = k % 2 == 0 ? 1.0 : -1.0;
        const int turns = k / 2 + 1;
        Eigen::VectorXd& cost = program_.linear;
        for (Eigen::Index i = 0; i < cost.size(); ++i) {
            cost[i] = sign * std::cos(static_cast<double>((i + 1) * turns));
        }
        for (double reached = -1.0;;) {
            NetworkPoint vertex = solved();
            best.iterations += vertex.iterations;
            if (vertex.isUnbounded) {
                best.isUnbounded = true;
                return best;
            }
            if (!vertex.detail.empty()) {
                best.detail = vertex.detail;
                break;
            }
            vertex.z += made;
            const double found = vertex.z.squaredNorm();
            cost = -2.0 * vertex.z;
            if (found > highest) {
                highest = found;
                best.z = std::move(vertex.z);
                best.solver = vertex.solver;
            }
            if (found >= enough || !(found > reached * (1.0 + 1e-9))) {
                break;
            }
            reached = found;
        }
    }
    if (highest >= 0.0) {
        best.detail.clear();
    }
    return best;
}

double NetworkPoints::steadyEnergy(const Eigen::VectorXd& made) const
{
    return energyOf(blocks_.network(), wavesAt(blocks_, *kernel_, Eigen::VectorXd(0.0 * made),
                                               steadyInputs(*kernel_))) -
           made.squaredNorm();
}

NetworkPoint NetworkPoints::ofEnergy(double wanted, std::span<const double> leastWaves)
{
    NetworkPoint least;
    if (!kernel_) {
        least.detail = outOfReach;
        return least;
    }
    const Eigen::VectorXd made = steadyCoordinates(blocks_, *kernel_);
    least.z = coordinatesOf(blocks_, *kernel_, leastWaves);
    const double asked = wanted;
    const double steady = steadyEnergy(made);
    wanted -= steady;
    const double lowest = least.z.squaredNorm();
    if (wanted < lowest - options_.tolerance * asked) {
        least.detail = fmt::format(
            "the least energy found is {:.9g} times the one asked for, and nothing proves that "
            "there is none below it",
            (lowest + steady) / asked);
        return least;
    }
    if (wanted > lowest) {
        // No motion of the energy is outside of this box, and every vertex on its faces has more.
        NetworkPoint vertex = climbed(made, std::sqrt(wanted) * (1.0 + 1e-6), wanted);
        least.iterations = vertex.iterations;
        const double highest =
            std::max(lowest, vertex.detail.empty() ? vertex.z.squaredNorm() : 0.0);
        if (highest >= wanted) {
            least.z = between(least.z, vertex.z, wanted);
            least.solver = vertex.solver;
        } else {
            constexpr double rounding = 1e-12;
            const double share = (highest + steady) / asked;
            least.detail = fmt::format(
                "{} found, and nothing proves that there is none above",
                share > rounding
                    ? fmt::format("energies up to {:.9g} times the one asked for were", share)
                    : "no energy but 0 was");
        }
    }
    least.z -= made;
    return least;
}

NetworkPoint NetworkPoints::ofMostEnergy(double beyond)
{
    NetworkPoint most;
    if (!kernel_) {
        most.detail = outOfReach;
        return most;
    }
    const Eigen::VectorXd made = steadyCoordinates(blocks_, *kernel_);
    const double limited = energyWithin(blocks_.network());
    double enough = infinity;
    // Conditions on strain are added where they are broken: in a box as large as they leave, or
    // wider where the most is at its faces.
    constexpr double widest = 1e6;
    for (double spare = limited < infinity ? 1.0 : widest; spare <= widest; spare *= 100.0) {
        enough = spare * (limited + made.squaredNorm());
        most = climbed(made, std::sqrt(enough), enough);
        if (most.detail.empty() && !most.isUnbounded && most.z.squaredNorm() < 0.999 * enough) {
            break;
        }
    }
    if (!most.detail.empty()) {
        return most;
    }
    const double found = most.z.squaredNorm();
    constexpr double rounding = 1e-18;
    if (most.isUnbounded || found >= std::min(beyond, enough) * (1.0 - 1e-6)) {
        most.detail = "the energies of the schedule seem to have no bound, and no motion the most";
        return most;
    }
    if (found <= rounding * std::min(limited, 1.0)) {
        most.z.setZero();  // rest
    }
    most.z -= made;
    return most;
}

NetworkClaim NetworkPoints::motion(const NetworkPoint& point) const
{
    NetworkClaim claim{
        wavesAt(blocks_, *kernel_, Eigen::VectorXd(point.z), steadyInputs(*kernel_))};
    claim.displacements = displacementsAt(blocks_, rows_, claim.waves);
    return claim;
}

}  // namespace signorini
