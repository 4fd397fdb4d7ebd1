// The same suite at the edges: odd programs, limits, cancelling, wrong use.

#include <random>

#include "catch.hpp"
#include "contract_support.hpp"
#include "sanitized.hpp"

using namespace signorini;
using namespace signorini::test;

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

TEST_CASE("contract: tall: many more rows than unknowns, with an optimum that was planted")
{
    forEachBackend([](const Expected& expected, const Solver& solver) {
        if (!expected.can.detectsInfeasibility) {
            return;  // bounds of a million leave GLPK's interior method unstable
        }
        std::mt19937_64 generator(12);
        const auto draw = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(generator);
        };
        for (int i = 0; i < drawn(40); ++i) {
            const Eigen::Index n = 2 + i % 5;
            const auto drawAll = [&] {
                return Eigen::VectorXd(
                    Eigen::VectorXd::NullaryExpr(n, [&] { return draw(-1, 1); }));
            };
            const Eigen::VectorXd optimum = drawAll();
            Program program = emptyProgram(n);
            program.lower.setConstant(-1e6);
            program.upper.setConstant(1e6);
            program.lower[0] = optimum[0];
            program.linear[0] = draw(0.1, 1.0);  // its multiplier
            for (int row = 0; row < 150; ++row) {
                const Eigen::VectorXd one = drawAll();
                const bool isTight = row % 10 == 0 && row / 10 < n - 1;
                appendRow(program.inequalities, program.inequalityRhs, one,
                          one.dot(optimum) + (isTight ? 0.0 : draw(0.0, 1.0)));
                if (isTight) {
                    program.linear -= draw(0.1, 1.0) * one;
                }
            }
            const SolverResult result = solver.solve(program);
            checkOptimal(result, program);
            CHECK(isCloseTo(result.objective, program.linear.dot(optimum), expected.minimum));
            REQUIRE(result.inequalityDuals.size() == program.inequalities.rows());
            const Eigen::VectorXd costs =
                program.linear - program.inequalities.transpose() * result.inequalityDuals;
            CHECK(costs.tail(n - 1).cwiseAbs().maxCoeff() <= 1e-6);
            CHECK(costs[0] >= -1e-6);
            CHECK(result.inequalityDuals.maxCoeff() <= 1e-7);

            Program contradiction = program;  // what all rows leave of a way, and more
            appendRow(contradiction.inequalities, contradiction.inequalityRhs, program.linear,
                      result.objective - 0.01);
            CHECK(solver.solve(contradiction).status == SolverStatus::infeasible);

            Program endless = emptyProgram(n);
            for (int row = 0; row < 150; ++row) {
                Eigen::VectorXd one = drawAll();
                one[0] = -std::abs(one[0]);  // x_0 may grow
                appendRow(endless.inequalities, endless.inequalityRhs, one, draw(0, 1));
            }
            endless.linear[0] = -1.0;
            checkNotOptimal(solver.solve(endless));
        }
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
        if (!expected.can.energyEquality) {
            const Program linear = programOf(onePhase(300, 150, 900));
            // Wherever it stops, nothing is left behind: leaks are the sanitizers' to find.
            int last = 0;
            for (auto status = SolverStatus::cancelled; status == SolverStatus::cancelled;) {
                int looks = 0;
                status = solver.solve(linear, {.cancel = [&] { return ++looks > last; }}).status;
                last += 1 + last / 4;
            }
            CHECK(last > 4);
            checkOptimal(solver.solve(linear, {.cancel = [] { return false; }}), linear);
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
