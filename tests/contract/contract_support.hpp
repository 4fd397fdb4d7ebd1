#pragma once
/// \file
/// What each back end is expected to do, and the programs that ask for it.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <thread>
#include <vector>
#include "catch.hpp"
#include "formulation.hpp"
#include "signorini/one_phase_set.hpp"
#include "solver.hpp"
#include "support.hpp"

namespace signorini::test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// What is expected of one back end.
struct Expected {
    std::string_view name;
    Capabilities can;
    double minimum;         ///< relative accuracy of a minimum
    std::int64_t unknowns;  ///< most variables beyond the equalities; 0: any number
};

inline constexpr Capabilities simplex{.detectsInfeasibility = true,
                                      .duals = true,
                                      .iterationLimit = true,
                                      .timeLimit = true,
                                      .cancel = true};
inline constexpr Capabilities interior{.duals = true, .cancel = true};
inline constexpr Capabilities local{.quadraticObjective = true,
                                    .energyEquality = true,
                                    .iterationLimit = true,
                                    .timeLimit = true,
                                    .start = true,
                                    .cancel = true};

/// Simplex methods find vertices, good to rounding; GLPK's interior point and Ipopt stop at an
/// optimality error of 1e-8, which degenerate programs magnify; NLopt stops at the first small
/// step.
inline const Expected table[] = {
    {"glpk-simplex", simplex, 1e-9, 0}, {"glpk-interior", interior, 1e-6, 0},
    {"glpk-exact", simplex, 1e-9, 0},   {"ipopt", local, 1e-6, 0},
    {"nlopt-slsqp", local, 1e-6, 400},  {"nlopt-auglag", local, 1e-6, 400},
    {"nlopt-cobyla", local, 1e-6, 40},
};

/// Minima of quadratic programs: the energy of a motion, and what is promised of it.
inline double energyAccuracy(const Expected& expected)
{
    return expected.name == "ipopt" ? 1e-8 : 1e-6;
}

/// action(expected, solver) for each back end of this build, each in a section of its name.
template <typename Action>
inline void forEachBackend(Action action)
{
    for (const Expected& expected : table) {
        if (findBackend(expected.name).available()) {
            DYNAMIC_SECTION(expected.name)
            {
                action(expected, *makeSolver(expected.name));
            }
        }
    }
    SUCCEED("a build without solver libraries has nothing to show here");
}

inline bool isCloseTo(double value, double exact, double tolerance)
{
    return std::abs(value - exact) <= tolerance * std::max(1.0, std::abs(exact));
}

/// A row, or x_i and its bound: what it adds up to, how far beyond its right side, and its largest
/// and the sum of its |coefficients|.
struct PlainRow {
    long double excess = 0.0L;
    long double rhs = 0.0L;
    long double largest = 1.0L;
    long double sum = 1.0L;
    long double atZero = 0.0L;  ///< excess of x = 0
};

/// Rows and bounds one by one, as the definitions in program.hpp say, and with none of its code.
inline std::vector<PlainRow> plainRows(const Program& program, const Eigen::VectorXd& x)
{
    std::vector<PlainRow> rows;
    const auto add = [&](const auto& matrix, const Eigen::VectorXd& rhs, bool isEquality) {
        for (Eigen::Index i = 0; i < rhs.size(); ++i) {
            PlainRow row{.rhs = rhs[i], .largest = 0.0L, .sum = 0.0L};
            long double value = 0.0L;
            for (Eigen::Index j = 0; j < x.size(); ++j) {
                const long double entry = matrix.coeff(i, j);
                value += entry * static_cast<long double>(x[j]);
                row.largest = std::max(row.largest, std::abs(entry));
                row.sum += std::abs(entry);
            }
            row.excess = isEquality ? std::abs(value - row.rhs) : value - row.rhs;
            row.atZero = isEquality ? std::abs(row.rhs) : -row.rhs;
            rows.push_back(row);
        }
    };
    add(program.equalities, program.equalityRhs, true);
    add(program.inequalities, program.inequalityRhs, false);
    for (Eigen::Index j = 0; j < x.size(); ++j) {
        const long double value = x[j];
        const long double low = program.lower[j];
        const long double high = program.upper[j];
        rows.push_back({.excess = low - value, .rhs = low, .atZero = low});
        rows.push_back({.excess = value - high, .rhs = high, .atZero = -high});
    }
    return rows;
}

/// The largest relative violation at x.
inline double plainViolation(const Program& program, const Eigen::VectorXd& x)
{
    const std::vector<PlainRow> rows = plainRows(program, x);
    long double unit = 0.0L;
    for (const PlainRow& row : rows) {
        if (row.atZero > 0.0L && row.sum > 0.0L) {
            unit = std::max(unit, std::abs(row.rhs) / row.sum);
        }
    }
    if (program.energy) {
        unit = std::max(unit, std::sqrt(static_cast<long double>(program.energy->value) /
                                        program.energy->weights.sum()));
    }
    unit = unit > 0.0L ? unit : 1.0L;
    long double worst = 0.0L;
    for (const PlainRow& row : rows) {
        if (row.excess > 0.0L) {
            worst = std::max(worst, row.excess / std::max(std::abs(row.rhs), unit * row.largest));
        }
    }
    if (program.energy) {
        long double value = 0.0L;
        for (Eigen::Index j = 0; j < x.size(); ++j) {
            value += static_cast<long double>(program.energy->weights[j]) * x[j] * x[j];
        }
        const long double wanted = program.energy->value;
        worst = std::max(worst, std::abs(value - wanted) / wanted);
    }
    return static_cast<double>(worst);
}

inline double plainObjective(const Program& program, const Eigen::VectorXd& x)
{
    long double value = 0.0L;
    for (Eigen::Index j = 0; j < x.size(); ++j) {
        const long double at = x[j];
        value += static_cast<long double>(program.linear[j]) * at;
        if (program.quadratic.size() > 0) {
            value += 0.5L * static_cast<long double>(program.quadratic[j]) * at * at;
        }
    }
    return static_cast<double>(value);
}

/// A claim of optimality, checked by nobody else's word: what the result says of its x is computed
/// once more from the numbers of the program.
inline void checkOptimal(const SolverResult& result, const Program& program,
                         double tolerance = 1e-7)
{
    INFO(result.detail);
    REQUIRE(result.status == SolverStatus::optimal);
    REQUIRE(result.x.size() == program.variables());
    const double violated = plainViolation(program, result.x);
    CHECK(violated <= tolerance);
    constexpr double rounding = 1e-12;
    CHECK(std::abs(result.violation - violated) <= rounding);
    CHECK(isCloseTo(result.objective, plainObjective(program, result.x), rounding));
    CHECK(result.iterations >= 0);
    CHECK(result.setupSeconds >= 0.0);
    CHECK(result.solveSeconds >= 0.0);
}

inline void checkNotOptimal(const SolverResult& result)
{
    INFO(result.detail);
    CHECK(result.status != SolverStatus::optimal);
    CHECK(result.status != SolverStatus::notRun);
    CHECK_FALSE(result.detail.empty());
}

inline Program programOf(const Schedule& schedule)
{
    return formulate(schedule, Formulation::state).program;
}

/// E/E_1 = (2/N) sum(a^2 + b^2) in the unknowns of the state program.
inline Eigen::VectorXd energyWeights(const Schedule& schedule, const Program& program)
{
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(program.variables());
    weights.head(2 * schedule.cells).setConstant(2.0 / static_cast<double>(schedule.cells));
    return weights;
}

inline Program leastEnergy(const Schedule& schedule)
{
    Program program = programOf(schedule);
    program.quadratic = 2.0 * energyWeights(schedule, program);
    return program;
}

inline Program withEnergy(const Schedule& schedule, double ratio)
{
    Program program = programOf(schedule);
    program.energy = EnergyEquality{energyWeights(schedule, program), ratio};
    return program;
}

/// Small whole costs on a and b, none on the prefix sums.
inline Program withCosts(const Schedule& schedule)
{
    Program program = programOf(schedule);
    for (Eigen::Index i = 0; i < 2 * schedule.cells; ++i) {
        program.linear[i] = static_cast<double>((5 * i + 3) % 7) - 3.0;
    }
    return program;
}

/// The least cost over a simplex, or point, of motions is that of a vertex: one class carries all.
inline double leastCost(const Schedule& schedule, const Program& program)
{
    const OnePhaseSet r = onePhaseSet(schedule);
    REQUIRE((r.set.kind == SetKind::simplex || r.set.kind == SetKind::point));
    double least = infinity;
    for (std::int64_t j = 0; j < r.set.count; ++j) {
        std::vector<double> z(static_cast<std::size_t>(r.set.count), 0.0);
        z[static_cast<std::size_t>(j)] = r.set.sum;
        const Eigen::VectorXd x = test::stacked(motionOf(r, z));
        least = std::min(least, program.linear.head(x.size()).dot(x));
    }
    return least;
}

/// One row of a sparse matrix, appended.
inline void appendRow(Eigen::SparseMatrix<double, Eigen::RowMajor>& rows, Eigen::VectorXd& rhs,
                      const Eigen::VectorXd& row, double right)
{
    Eigen::MatrixXd dense(rows.rows() + 1, row.size());
    dense << Eigen::MatrixXd(rows), row.transpose();
    rows = dense.sparseView();
    rhs.conservativeResize(rhs.size() + 1);
    rhs[rhs.size() - 1] = right;
}

}  // namespace signorini::test
