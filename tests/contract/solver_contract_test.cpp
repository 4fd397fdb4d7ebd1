// What every back end owes its callers. One suite, run by all of them from one table; a back end
// that is missing in the table, or in solvers/README.md, fails the first test.

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

using namespace signorini;
using test::onePhase;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What is expected of one back end.
struct Expected {
    std::string_view name;
    Capabilities can;
    double minimum;         ///< relative accuracy of a minimum
    std::int64_t unknowns;  ///< most variables beyond the equalities; 0: any number
};

constexpr Capabilities simplex{
    .detectsInfeasibility = true, .duals = true, .iterationLimit = true, .timeLimit = true};
constexpr Capabilities interior{.duals = true};
constexpr Capabilities local{.quadraticObjective = true,
                             .energyEquality = true,
                             .iterationLimit = true,
                             .timeLimit = true,
                             .start = true,
                             .cancel = true};

/// Simplex methods find vertices, good to rounding; GLPK's interior point and Ipopt stop at an
/// optimality error of 1e-8, which degenerate programs magnify; NLopt stops at the first small
/// step.
const Expected table[] = {
    {"glpk-simplex", simplex, 1e-9, 0}, {"glpk-interior", interior, 1e-6, 0},
    {"glpk-exact", simplex, 1e-9, 0},   {"ipopt", local, 1e-6, 0},
    {"nlopt-slsqp", local, 1e-6, 400},  {"nlopt-auglag", local, 1e-6, 400},
    {"nlopt-cobyla", local, 1e-6, 40},
};

/// Minima of quadratic programs: the energy of a motion, and what is promised of it.
double energyAccuracy(const Expected& expected)
{
    return expected.name == "ipopt" ? 1e-8 : 1e-6;
}

/// action(expected, solver) for each back end of this build, each in a section of its name.
template <typename Action>
void forEachBackend(Action action)
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

bool isCloseTo(double value, double exact, double tolerance)
{
    return std::abs(value - exact) <= tolerance * std::max(1.0, std::abs(exact));
}

/// A claim of optimality, checked by nobody else's word.
void checkOptimal(const SolverResult& result, const Program& program, double tolerance = 1e-7)
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

void checkNotOptimal(const SolverResult& result)
{
    INFO(result.detail);
    CHECK(result.status != SolverStatus::optimal);
    CHECK(result.status != SolverStatus::notRun);
    CHECK_FALSE(result.detail.empty());
}

Program programOf(const Schedule& schedule)
{
    return formulate(schedule, Formulation::state).program;
}

/// E/E_1 = (2/N) sum(a^2 + b^2) in the unknowns of the state program.
Eigen::VectorXd energyWeights(const Schedule& schedule, const Program& program)
{
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(program.variables());
    weights.head(2 * schedule.cells).setConstant(2.0 / static_cast<double>(schedule.cells));
    return weights;
}

Program leastEnergy(const Schedule& schedule)
{
    Program program = programOf(schedule);
    program.quadratic = 2.0 * energyWeights(schedule, program);
    return program;
}

Program withEnergy(const Schedule& schedule, double ratio)
{
    Program program = programOf(schedule);
    program.energy = EnergyEquality{energyWeights(schedule, program), ratio};
    return program;
}

/// Small whole costs on a and b, none on the prefix sums.
Program withCosts(const Schedule& schedule)
{
    Program program = programOf(schedule);
    for (Eigen::Index i = 0; i < 2 * schedule.cells; ++i) {
        program.linear[i] = static_cast<double>((5 * i + 3) % 7) - 3.0;
    }
    return program;
}

/// The least cost over a simplex, or point, of motions is that of a vertex: one class carries all.
double leastCost(const Schedule& schedule, const Program& program)
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
void appendRow(Eigen::SparseMatrix<double, Eigen::RowMajor>& rows, Eigen::VectorXd& rhs,
               const Eigen::VectorXd& row, double right)
{
    Eigen::MatrixXd dense(rows.rows() + 1, row.size());
    dense << Eigen::MatrixXd(rows), row.transpose();
    rows = dense.sparseView();
    rhs.conservativeResize(rhs.size() + 1);
    rhs[rhs.size() - 1] = right;
}

}  // namespace

TEST_CASE("contract: every back end stands in the table of this suite and in the documentation")
{
    std::ifstream file(SIGNORINI_BACKENDS_README);
    const std::string readme(std::istreambuf_iterator<char>(file), {});
    REQUIRE_FALSE(readme.empty());
    for (const Backend& backend : backends()) {
        const bool solvesSchedulesOnly = backend.available() && backend.make == nullptr;
        if (solvesSchedulesOnly) {
            continue;
        }
        INFO(backend.name);
        CHECK(std::any_of(std::begin(table), std::end(table),
                          [&](const Expected& row) { return row.name == backend.name; }));
        CHECK_THAT(readme, containsText("\n| `" + std::string(backend.name) + "` |"));
    }
    for (const Expected& expected : table) {
        CHECK_NOTHROW(findBackend(expected.name));
    }
}

TEST_CASE("contract: a back end can what the table says, no more and no less")
{
    forEachBackend([](const Expected& expected, const Solver& solver) {
        CHECK(solver.name() == expected.name);
        CHECK(solver.capabilities() == expected.can);
        CHECK(solver.row().mostUnknowns == expected.unknowns);
    });
}

TEST_CASE("contract: found: motions that exist are found, at the least cost")
{
    forEachBackend([](const Expected& expected, const Solver& solver) {
        for (const Schedule& schedule : {onePhase(3, 1, 9), onePhase(12, 6, 36)}) {
            const Program any = programOf(schedule);
            checkOptimal(solver.solve(any), any);
            const Program program = withCosts(schedule);
            const SolverResult result = solver.solve(program);
            checkOptimal(result, program);
            CHECK(isCloseTo(result.objective, leastCost(schedule, program), expected.minimum));
        }
    });
}

TEST_CASE("contract: found: the least energy is that of the closed form")
{
    forEachBackend([](const Expected& expected, const Solver& solver) {
        if (!expected.can.quadraticObjective) {
            return;
        }
        const auto check = [&](const Schedule& schedule, double exact) {
            const Program program = leastEnergy(schedule);
            const SolverResult result = solver.solve(program);
            checkOptimal(result, program);
            CHECK(isCloseTo(result.objective, exact, energyAccuracy(expected)));
        };
        check(onePhase(3, 1, 9), 18.0);
        check(onePhase(8, 5, 23), 16.0 / 3.0);
        check(onePhase(30, 15, 90), 4.0);
        if (expected.unknowns == 0 || expected.unknowns >= 150) {
            check(onePhase(300, 150, 900), 4.0);
        } else {
            CHECK_THROWS_WITH(solver.solve(leastEnergy(onePhase(300, 150, 900))),
                              containsText("independent equalities = 149"));
        }
    });
}

TEST_CASE("contract: none: motions that do not exist are never found")
{
    forEachBackend([](const Expected& expected, const Solver& solver) {
        for (const Schedule& schedule : {onePhase(2, 2, 4), onePhase(3, 1, 8), onePhase(4, 2, 13),
                                         onePhase(30, 15, 120), onePhase(40, 20, 109)}) {
            INFO(describe(schedule));
            const SolverResult result = solver.solve(programOf(schedule));
            checkNotOptimal(result);
            if (expected.can.detectsInfeasibility) {
                CHECK(result.status == SolverStatus::infeasible);
            }
        }
    });
}

TEST_CASE("contract: small schedules: what is claimed is true without exception")
{
    forEachBackend([](const Expected&, const Solver& solver) {
        test::forAllSchedules(3, 2, [&](const Schedule& schedule) {
            const bool exists = !onePhaseSet(schedule).reason;
            const SolverResult result = solver.solve(programOf(schedule));
            INFO(describe(schedule) << ": " << result.detail);
            CHECK((result.status == SolverStatus::optimal) == exists);
            CHECK_FALSE((exists && result.status == SolverStatus::infeasible));
        });
    });
}

TEST_CASE("contract: degenerate: grazing motions, whose set may have no interior, are found")
{
    forEachBackend([](const Expected&, const Solver& solver) {
        for (const Schedule& schedule :
             {onePhase(3, 4, 20), onePhase(4, 1, 31), onePhase(6, 1, 31), onePhase(6, 10, 38)}) {
            INFO(describe(schedule));
            const OnePhaseSet r = onePhaseSet(schedule);
            REQUIRE_FALSE(r.reason);
            REQUIRE(r.set.kind == SetKind::box);
            const Program program = programOf(schedule);
            checkOptimal(solver.solve(program), program);
        }
    });
}

TEST_CASE("contract: boundary: one cell more or less decides")
{
    forEachBackend([](const Expected&, const Solver& solver) {
        for (const std::int64_t cells : {4, 9, 13}) {
            for (const std::int64_t step : {-1, 0, 1}) {
                // The main branch ends at n_c = N: its last motion has E/E_1 = N^2.
                const Schedule schedule = onePhase(cells, cells - 1 + step, 2 * cells + 2);
                INFO(describe(schedule));
                const Program program = programOf(schedule);
                const SolverResult result = solver.solve(program);
                if (onePhaseSet(schedule).reason) {
                    checkNotOptimal(result);
                } else {
                    checkOptimal(result, program);
                }
            }
        }
    });
}

TEST_CASE("contract: boundary: a right side that is barely too large is not met")
{
    forEachBackend([](const Expected&, const Solver& solver) {
        Program program = emptyProgram(2);  // x + y = s, 0 <= x, y <= 1
        program.lower.setZero();
        program.upper.setOnes();
        appendRow(program.equalities, program.equalityRhs, Eigen::Vector2d(1, 1), 2.0);
        checkOptimal(solver.solve(program), program);
        program.equalityRhs[0] = 2.0 + 1e-5;
        checkNotOptimal(solver.solve(program));
    });
}

TEST_CASE("contract: bad scaling: SI units change neither verdict nor motion")
{
    const Schedule exists = onePhase(3, 1, 9);
    const Schedule none = onePhase(3, 1, 8);
    forEachBackend([&](const Expected&, const Solver& solver) {
        for (const double unit : {1e-10, 1e-6, 1e6}) {
            for (const double rowFactor : {1.0, 1e-10, 1e8}) {
                INFO("unit " << unit << ", row factor " << rowFactor);
                const auto rescaled = [&](const Schedule& schedule) {
                    Program program = programOf(schedule);
                    program.equalityRhs *= unit * rowFactor;
                    program.equalities *= rowFactor;
                    return program;
                };
                const Program program = rescaled(exists);
                const SolverResult result = solver.solve(program);
                checkOptimal(result, program);
                const Eigen::VectorXd still = Eigen::VectorXd::Zero(program.variables());
                CHECK(violation(program, still) == Approx(1.0));
                CHECK(result.x.head(6).squaredNorm() * 2.0 / 3.0 ==
                      Approx(18.0 * unit * unit).epsilon(1e-5));
                checkNotOptimal(solver.solve(rescaled(none)));
            }
        }
    });
}

TEST_CASE("contract: empty: a program without rows is solved by its bounds")
{
    forEachBackend([](const Expected& expected, const Solver& solver) {
        Program program = emptyProgram(3);
        checkOptimal(solver.solve(program), program);
        program.lower = Eigen::Vector3d(-1, 0, 2);
        program.upper = Eigen::Vector3d(1, 3, 2);
        checkOptimal(solver.solve(program), program);
        program.linear = Eigen::Vector3d(1, -2, 5);
        const SolverResult result = solver.solve(program);
        checkOptimal(result, program);
        CHECK(isCloseTo(result.objective, 3.0, expected.minimum));
    });
}

TEST_CASE("contract: fixed variables, repeated rows and a single solution need no care")
{
    forEachBackend([](const Expected& expected, const Solver& solver) {
        Program program = emptyProgram(3);  // minimise -z: x + y = 3, twice; x = 1; z <= y
        appendRow(program.equalities, program.equalityRhs, Eigen::Vector3d(1, 1, 0), 3.0);
        appendRow(program.equalities, program.equalityRhs, Eigen::Vector3d(-2, -2, 0), -6.0);
        appendRow(program.inequalities, program.inequalityRhs, Eigen::Vector3d(0, -1, 1), 0.0);
        program.lower = Eigen::Vector3d(1, -infinity, 0);
        program.upper = Eigen::Vector3d(1, infinity, infinity);
        program.linear = Eigen::Vector3d(0, 0, -1);
        const SolverResult result = solver.solve(program);
        checkOptimal(result, program);
        CHECK(isCloseTo(result.objective, -2.0, expected.minimum));

        Program single = program;
        appendRow(single.equalities, single.equalityRhs, Eigen::Vector3d(0, 1, 1), 2.5);
        checkOptimal(solver.solve(single), single);
        single.equalityRhs[2] = 1.5;  // z = -0.5
        checkNotOptimal(solver.solve(single));

        Program contradiction = program;
        contradiction.equalityRhs[1] = -5.0;
        checkNotOptimal(solver.solve(contradiction));
    });
}

TEST_CASE("contract: an objective without a lower bound is never minimised")
{
    forEachBackend([](const Expected&, const Solver& solver) {
        Program program = emptyProgram(2);
        appendRow(program.inequalities, program.inequalityRhs, Eigen::Vector2d(1, -1), 0.0);
        program.lower.setZero();
        program.linear = Eigen::Vector2d(-1, -1);
        checkNotOptimal(solver.solve(program));
    });
}

TEST_CASE("contract: multipliers have the documented signs and leave no gap")
{
    forEachBackend([](const Expected& expected, const Solver& solver) {
        const Schedule schedule = onePhase(12, 6, 36);
        const Program program = withCosts(schedule);
        const SolverResult result = solver.solve(program);
        checkOptimal(result, program);
        if (!expected.can.duals) {
            CHECK(result.equalityDuals.size() == 0);
            CHECK(result.inequalityDuals.size() == 0);
            return;
        }
        REQUIRE(result.equalityDuals.size() == program.equalities.rows());
        REQUIRE(result.inequalityDuals.size() == program.inequalities.rows());
        const Eigen::VectorXd costs = program.linear -
                                      program.equalities.transpose() * result.equalityDuals -
                                      program.inequalities.transpose() * result.inequalityDuals;
        for (Eigen::Index i = 0; i < costs.size(); ++i) {
            CHECK((costs[i] >= -1e-7 || program.upper[i] < infinity));
            CHECK((costs[i] <= 1e-7 || program.lower[i] > -infinity));
        }
        CHECK(result.inequalityDuals.maxCoeff() <= 1e-7);
        const double bound = result.equalityDuals.dot(program.equalityRhs) +
                             result.inequalityDuals.dot(program.inequalityRhs);
        CHECK(isCloseTo(bound, result.objective, 1e-6));  // all finite bounds are 0
    });
}

TEST_CASE("contract: limit hit: a limit is reported as one, and nothing false with it")
{
    const Program program = withCosts(onePhase(12, 6, 36));
    forEachBackend([&](const Expected& expected, const Solver& solver) {
        if (expected.can.iterationLimit) {
            const SolverResult result = solver.solve(program, {.iterationLimit = 1});
            INFO(result.detail);
            CHECK(result.status == SolverStatus::limit);
        }
        if (expected.can.timeLimit) {
            const SolverResult result = solver.solve(program, {.timeLimit = 1e-9});
            INFO(result.detail);  // one that takes less than a clock tick may finish
            CHECK((result.status == SolverStatus::limit || result.status == SolverStatus::optimal));
            checkOptimal(solver.solve(program, {.timeLimit = 60.0}), program);
        }
    });
}

TEST_CASE("contract: cancel: a search ends when asked to, before it starts or later")
{
    forEachBackend([](const Expected& expected, const Solver& solver) {
        if (!expected.can.cancel) {
            return;
        }
        const Program program = leastEnergy(onePhase(30, 15, 90));
        CHECK(solver.solve(program, {.cancel = [] { return true; }}).status ==
              SolverStatus::cancelled);

        // No motion has this energy, so the search goes on for a while.
        const Program endless = withEnergy(onePhase(30, 15, 90), 3.9);
        std::atomic<bool> during = false;
        std::thread other([&during] {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            during = true;
        });
        const SolverResult result =
            solver.solve(endless, {.cancel = [&during] { return during.load(); }});
        other.join();
        INFO(result.detail);
        CHECK(result.status != SolverStatus::optimal);
    });
}

TEST_CASE("contract: start: the search may begin at a motion, and stays right when it is wrong")
{
    forEachBackend([](const Expected& expected, const Solver& solver) {
        if (!expected.can.start) {
            return;
        }
        const Schedule schedule = onePhase(30, 15, 90);
        const Program program = leastEnergy(schedule);
        const SolverResult cold = solver.solve(program);
        for (const Eigen::VectorXd& start :
             {cold.x, Eigen::VectorXd(-cold.x),
              Eigen::VectorXd(Eigen::VectorXd::Constant(program.variables(), 1e3))}) {
            const SolverResult result = solver.solve(program, {.start = start});
            checkOptimal(result, program);
            CHECK(isCloseTo(result.objective, 4.0, energyAccuracy(expected)));
        }
    });
}

TEST_CASE("contract: NaN and malformed programs are refused")
{
    forEachBackend([](const Expected&, const Solver& solver) {
        Program program = programOf(onePhase(3, 1, 9));
        program.linear[2] = std::nan("");
        CHECK_THROWS_WITH(solver.solve(program), containsText("linear"));
        program = programOf(onePhase(3, 1, 9));
        program.equalities.valuePtr()[0] = std::nan("");
        CHECK_THROWS_WITH(solver.solve(program), containsText("equalities"));
        program = programOf(onePhase(3, 1, 9));
        program.upper.resize(2);
        CHECK_THROWS_AS(solver.solve(program), std::invalid_argument);
    });
}

TEST_CASE("contract: what a back end cannot do is refused by name")
{
    forEachBackend([](const Expected& expected, const Solver& solver) {
        const Schedule schedule = onePhase(3, 1, 9);
        const Program program = programOf(schedule);
        const auto check = [&](bool can, const Program& asked, const SolverOptions& options,
                               const char* what) {
            if (can) {
                CHECK_NOTHROW(solver.solve(asked, options));
            } else {
                CHECK_THROWS_WITH(solver.solve(asked, options), containsText(what));
            }
        };
        const Capabilities& can = expected.can;
        check(can.quadraticObjective, leastEnergy(schedule), {}, "a quadratic objective");
        check(can.energyEquality, withEnergy(schedule, 18.0), {}, "an energy equality");
        check(can.iterationLimit, program, {.iterationLimit = 1000}, "iterationLimit");
        check(can.timeLimit, program, {.timeLimit = 60.0}, "timeLimit");
        check(can.start, program, {.start = Eigen::VectorXd::Zero(program.variables())}, "start");
        check(can.cancel, program, {.cancel = [] { return false; }}, "cancel");
    });
}

TEST_CASE("contract: energy: a given energy is held, and one that no motion has is not found")
{
    forEachBackend([](const Expected& expected, const Solver& solver) {
        if (!expected.can.energyEquality) {
            return;
        }
        const Schedule schedule = onePhase(30, 15, 90);
        for (const double ratio : {4.5, 10.0, 40.0}) {
            INFO("E/E_1 = " << ratio);
            const Program program = withEnergy(schedule, ratio);
            const SolverResult result = solver.solve(program);
            checkOptimal(result, program);
            CHECK(energyRatio(State{result.x.head(30), result.x.segment(30, 30)}) ==
                  Approx(ratio).epsilon(1e-7));
        }
        checkNotOptimal(solver.solve(withEnergy(schedule, 3.9)));
        checkNotOptimal(solver.solve(withEnergy(schedule, 61.0)));
    });
}

TEST_CASE("contract: a tolerance that is asked for is held")
{
    forEachBackend([](const Expected&, const Solver& solver) {
        const Program program = withCosts(onePhase(12, 6, 36));
        for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
            const SolverResult result = solver.solve(program, {.tolerance = tolerance});
            INFO(tolerance << ": " << result.detail);
            if (result.status == SolverStatus::optimal) {
                CHECK(violation(program, result.x) <= tolerance);
            } else {
                CHECK(result.status == SolverStatus::failed);
                CHECK(tolerance < 1e-7);
            }
        }
    });
}
