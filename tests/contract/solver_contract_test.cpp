// What every back end owes its callers. One suite, run by all of them from one table; a back end
// that is missing in the table, or in solvers/README.md, fails the first test.

#include "catch.hpp"
#include "contract_support.hpp"

using namespace signorini;
using namespace signorini::test;

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
