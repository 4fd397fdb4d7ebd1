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

/// A claim of optimality, checked by nobody else's word.
inline void checkOptimal(const SolverResult& result, const Program& program,
                         double tolerance = 1e-7)
{
    INFO(result.detail);
    REQUIRE(result.status == SolverStatus::optimal);
    REQUIRE(result.x.size() == program.variables());
    CHECK(violation(program, result.x) <= tolerance);
    CHECK(result.violation == violation(program, result.x));
    CHECK(result.objective == objective(program, result.x));
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
