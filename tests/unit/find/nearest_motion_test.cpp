#include <Eigen/QR>
#include <cmath>
#include <random>

#include "catch.hpp"
#include "formulation.hpp"
#include "signorini/amplitude_set.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/one_phase_set.hpp"
#include "solver.hpp"
#include "support.hpp"

using namespace signorini;
using test::onePhase;

namespace {

double squaredDistance(const std::vector<double>& z, const std::vector<double>& target)
{
    double sum = 0.0;
    for (std::size_t j = 0; j < z.size(); ++j) {
        sum += (z[j] - target[j]) * (z[j] - target[j]);
    }
    return sum;
}

/// Every choice of partial sums that lie on a bound, equal shifts between them; the best inside.
std::vector<double> nearestByEnumeration(const AmplitudeSet& box, const std::vector<double>& target)
{
    const std::size_t d = target.size();
    std::vector<double> best;
    const auto choices = static_cast<std::size_t>(std::pow(3.0, static_cast<double>(d - 1)));
    for (std::size_t choice = 0; choice < choices; ++choice) {
        std::vector<double> z(d);
        std::size_t from = 0;
        double at = 0.0;
        std::size_t rest = choice;
        for (std::size_t j = 1; j <= d; ++j, rest /= 3) {
            const bool isEnd = j == d;
            if (!isEnd && rest % 3 == 0) {
                continue;
            }
            const double value = isEnd ? box.sum : rest % 3 == 1 ? box.lower : box.upper;
            double total = 0.0;
            for (std::size_t k = from; k < j; ++k) {
                total += target[k];
            }
            for (std::size_t k = from; k < j; ++k) {
                z[k] = target[k] + (value - at - total) / static_cast<double>(j - from);
            }
            from = j;
            at = value;
        }
        if (distanceOutside(box, z) < 1e-9 &&
            (best.empty() || squaredDistance(z, target) < squaredDistance(best, target))) {
            best = z;
        }
    }
    return best;
}

std::vector<double> randomValues(std::size_t count, double size, std::mt19937_64& generator)
{
    std::normal_distribution<double> normal(0.0, size);
    std::vector<double> values(count);
    for (double& value : values) {
        value = normal(generator);
    }
    return values;
}

/// The minimum of a small quadratic program: the best feasible point among those that minimise it
/// with some of its inequalities and bounds made equations. Empty if those are too many to try.
std::optional<Eigen::VectorXd> minimumByEnumeration(const Program& program)
{
    const Eigen::Index n = program.variables();
    const Eigen::MatrixXd equal(program.equalities);
    std::vector<std::pair<Eigen::RowVectorXd, double>> rows;
    const Eigen::MatrixXd below(program.inequalities);
    for (Eigen::Index k = 0; k < below.rows(); ++k) {
        rows.emplace_back(below.row(k), program.inequalityRhs[k]);
    }
    for (Eigen::Index i = 0; i < n; ++i) {
        if (std::isfinite(program.lower[i])) {
            rows.emplace_back(-Eigen::RowVectorXd::Unit(n, i), -program.lower[i]);
        }
        if (std::isfinite(program.upper[i])) {
            rows.emplace_back(Eigen::RowVectorXd::Unit(n, i), program.upper[i]);
        }
    }
    if (rows.size() > 12 || n > 16) {
        return std::nullopt;
    }
    std::optional<Eigen::VectorXd> best;
    for (unsigned choice = 0; choice < 1u << rows.size(); ++choice) {
        Eigen::MatrixXd active = equal;
        Eigen::VectorXd rhs = program.equalityRhs;
        for (std::size_t k = 0; k < rows.size(); ++k) {
            if ((choice >> k & 1u) != 0) {
                active.conservativeResize(active.rows() + 1, n);
                active.row(active.rows() - 1) = rows[k].first;
                rhs.conservativeResize(rhs.size() + 1);
                rhs[rhs.size() - 1] = rows[k].second;
            }
        }
        const Eigen::Index m = active.rows();
        Eigen::MatrixXd kkt = Eigen::MatrixXd::Zero(n + m, n + m);
        kkt.topLeftCorner(n, n) = program.quadratic.asDiagonal();
        kkt.topRightCorner(n, m) = active.transpose();
        kkt.bottomLeftCorner(m, n) = active;
        Eigen::VectorXd right(n + m);
        right << -program.linear, rhs;
        const Eigen::VectorXd x = kkt.completeOrthogonalDecomposition().solve(right).head(n);
        if (violation(program, x) < 1e-9 &&
            (!best || objective(program, x) < objective(program, *best))) {
            best = x;
        }
    }
    return best;
}

double apart(const State& left, const State& right)
{
    return std::max((left.a - right.a).lpNorm<Eigen::Infinity>(),
                    (left.b - right.b).lpNorm<Eigen::Infinity>());
}

State constantState(std::int64_t cells, double a, double b)
{
    return {Eigen::VectorXd::Constant(cells, a), Eigen::VectorXd::Constant(cells, b)};
}

}  // namespace

TEST_CASE("nearest: in a box it is the best of all choices of bounds, for near and far targets")
{
    std::mt19937_64 generator(11);
    for (const double size : {0.1, 1.0, 4.0, 50.0}) {
        for (std::size_t d = 2; d <= 7; ++d) {
            for (int k = 0; k < 10; ++k) {
                const AmplitudeSet box{.kind = SetKind::box,
                                       .count = static_cast<std::int64_t>(d),
                                       .sum = -3.0,
                                       .lower = -4.0,
                                       .upper = 1.0};
                const std::vector<double> target = randomValues(d, size, generator);
                const std::vector<double> z = nearestAmplitudes(box, target);
                const std::vector<double> best = nearestByEnumeration(box, target);
                REQUIRE(distanceOutside(box, z) < 1e-13);
                for (std::size_t j = 0; j < d; ++j) {
                    REQUIRE(z[j] == Approx(best[j]).margin(1e-11));
                }
            }
        }
    }
}

TEST_CASE("nearest: a common part of the targets, however large, changes nothing")
{
    std::mt19937_64 generator(12);
    for (const SetKind kind : {SetKind::simplex, SetKind::box}) {
        const AmplitudeSet set{.kind = kind, .count = 40, .sum = 8.0, .lower = -2.0, .upper = 9.0};
        // Multiples of 1/8 stay themselves next to 2^40.
        std::vector<double> target = randomValues(40, 8.0, generator);
        for (double& value : target) {
            value = std::round(value * 8.0) / 8.0;
        }
        const std::vector<double> z = nearestAmplitudes(set, target);
        std::vector<double> far = target;
        for (double& value : far) {
            value += 1099511627776.0;
        }
        const std::vector<double> same = nearestAmplitudes(set, far);
        CHECK(distanceOutside(set, same) < 1e-14);
        for (std::size_t j = 0; j < z.size(); ++j) {
            CHECK(same[j] == Approx(z[j]).margin(1e-13));
        }
    }
}

TEST_CASE("nearest: the closed form answers grazing sets and targets of any size")
{
    for (const double size : {1.0, 1e5, 1e7, 1e12}) {
        for (const Schedule& schedule :
             {onePhase(8, 4, 28), onePhase(8, 5, 23), onePhase(20, 1, 79)}) {
            const State target = constantState(schedule.cells, size, -size);
            const PeriodicResult result =
                findPeriodic(schedule, {.objective = Objective::nearest, .target = target});
            INFO(describe(schedule) << " " << size << " " << result.detail);
            if (onePhaseSet(schedule).reason) {
                CHECK(result.status == Status::none);
                continue;
            }
            REQUIRE(result.status == Status::found);
            CHECK(result.how.route == "closed-form");
            // All targets of a class are alike up to sign, so all amplitudes are equal.
            CHECK(result.motion->energyRatio >= result.set.energy->least * (1 - 1e-14));
            CHECK(result.motion->residuals.worst() < 1e-12);
        }
    }
}

TEST_CASE("nearest: several phases, the minimum of the quadratic program found by enumeration")
{
    int compared = 0;
    for (const Schedule& schedule :
         {Schedule{5, {{1, 1}, {2, 56}}}, Schedule{2, {{1, 7}, {1, 7}}},
          Schedule{4, {{1, 12}, {3, 12}}}, Schedule{3, {{1, 5}, {1, 11}}},
          Schedule{3, {{1, 3}, {1, 3}}}, Schedule{4, {{1, 9}, {1, 13}}},
          Schedule{2, {{1, 3}, {1, 5}}}, Schedule{3, {{2, 8}, {2, 8}}}}) {
        for (const unsigned seed : {1u, 2u, 3u}) {
            State target = test::randomState(schedule.cells, seed);
            for (const double size : {1.0, 1000.0}) {
                target.a *= size;
                target.b *= size;
                const Demands demands{.objective = Objective::nearest, .target = target};
                const Formulated reduced = pose(schedule, demands, Formulation::reduced);
                const auto x = minimumByEnumeration(reduced.program);
                if (!x) {
                    continue;
                }
                const PeriodicResult result =
                    findPeriodic(schedule, {.objective = Objective::nearest, .target = target});
                INFO(describe(schedule) << " " << seed << " " << size << " " << result.detail);
                if (result.how.route != "lumped" || result.status != Status::found) {
                    continue;  // a solver's, or withdrawn: judged by other tests
                }
                ++compared;
                CHECK(apart(result.motion->state, stateOf(reduced, *x)) < 1e-7 * size);
            }
        }
    }
    CHECK(compared >= 12);
}

TEST_CASE("nearest: within a strain limit a solver's motion is off by no more than it says",
          "[glpk][ipopt]")
{
    int compared = 0;
    for (const Schedule& schedule : {onePhase(2, 1, 7), onePhase(4, 1, 14), onePhase(8, 5, 23)}) {
        const double least = findPeriodic(schedule).motion->physical.peakCompression / 1e-3;
        for (const unsigned seed : {1u, 2u, 3u}) {
            const State target = test::randomState(schedule.cells, seed);
            const Demands demands{
                .objective = Objective::nearest, .target = target, .strainLimit = 1.2 * least};
            const Formulated reduced = pose(schedule, demands, Formulation::reduced);
            const auto x = minimumByEnumeration(reduced.program);
            if (!x) {
                continue;
            }
            for (const std::string solver : {"auto", "ipopt"}) {
                const PeriodicResult result =
                    findPeriodic(schedule, {.solver = solver,
                                            .objective = Objective::nearest,
                                            .target = target,
                                            .strainLimit = 1.2 * least});
                INFO(describe(schedule) << " " << seed << " " << solver << " " << result.detail);
                CHECK(result.status != Status::none);
                if (result.status == Status::found) {
                    ++compared;
                    const State truth = stateOf(reduced, *x);
                    // Found: off by at most sqrt(tolerance) of the root mean square of 2N waves.
                    const double allowed =
                        std::sqrt(1e-7 * (truth.a.squaredNorm() + truth.b.squaredNorm()));
                    CHECK(apart(result.motion->state, truth) <= 1.1 * allowed);
                }
            }
        }
    }
    CHECK(compared > 0);
}
