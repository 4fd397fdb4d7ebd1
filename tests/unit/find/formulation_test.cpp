#include "formulation.hpp"

#include <cmath>

#include "catch.hpp"
#include "equations.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/one_phase_set.hpp"
#include "signorini/verification.hpp"
#include "solver.hpp"
#include "support.hpp"

using namespace signorini;
using test::onePhase;

namespace {

/// The unknowns of the program that belong to a state: a, b, and the prefix sums of (12).
Eigen::VectorXd unknowns(const State& state, const Schedule& schedule)
{
    const Eigen::VectorXd x = test::stacked(state);
    const Eigen::VectorXd y = inequalities(schedule).penetration * x;
    Eigen::VectorXd all(x.size() + y.size());
    all << x, y;
    return all;
}

}  // namespace

TEST_CASE("formulation: exactly the motions of a schedule satisfy the state program")
{
    const Schedule schedule = onePhase(8, 5, 23);
    const Formulated formulated = formulate(schedule, Formulation::state);
    const Program& program = formulated.program;
    validate(program);
    const OnePhaseSet r = onePhaseSet(schedule);
    std::mt19937_64 generator(3);
    for (int k = 0; k < 50; ++k) {
        const State motion = motionOf(r, drawAmplitudes(r.set, generator));
        CHECK(violation(program, unknowns(motion, schedule)) < 1e-14);
        CHECK(stateOf(formulated, unknowns(motion, schedule)) == motion);
    }
    CHECK(violation(program, unknowns(test::randomState(8), schedule)) > 1e-3);
    const State still{Eigen::VectorXd::Zero(8), Eigen::VectorXd::Zero(8)};
    CHECK(violation(program, unknowns(still, schedule)) == 1.0);
}

TEST_CASE("formulation: rows stay sparse and are counted once")
{
    const Formulated formulated = formulate(onePhase(300, 150, 900), Formulation::state);
    const Program& program = formulated.program;
    CHECK(program.variables() == 600 + 900);
    CHECK(program.equalities.rows() == 600 + 1 + 900);
    CHECK(program.inequalities.rows() == 150);
    CHECK(program.equalities.nonZeros() <= 2 * 600 + 600 + 3 * 900);
    CHECK(program.inequalities.nonZeros() == 150);
    CHECK(formulated.leftOut.size() == 3);
}

TEST_CASE("formulation: long schedules are folded, and that is said")
{
    const Formulated formulated = formulate(onePhase(2, 1, 1'000'001), Formulation::state);
    CHECK(formulated.program.variables() < 4 + 16);
    CHECK(formulated.leftOut.size() == 4);
}

TEST_CASE("formulation: several phases close one by one")
{
    const Schedule schedule{4, {{1, 12}, {3, 12}}};
    const Program program = formulate(schedule, Formulation::state).program;
    CHECK(program.lower[8 + 11] == 0.0);
    CHECK(std::isinf(program.lower[8 + 23]));  // implied by periodicity
    CHECK(program.upper[8 + 5] == 0.0);
}

TEST_CASE("formulation: reduced and lumped unknowns give the same verdict as the paper's own rows",
          "[glpk]")
{
    const auto solver = makeSolver("glpk-simplex");
    std::mt19937_64 generator(12);
    int found = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const Schedule schedule = test::randomSchedule(generator, 8, 4);
        INFO(describe(schedule));
        const auto solve = [&](Formulation form) {
            const Formulated formulated = formulate(schedule, form);
            const SolverResult answer = solver->solve(formulated.program);
            if (answer.status == SolverStatus::optimal) {
                const State state = stateOf(formulated, answer.x);
                REQUIRE(verify(state, schedule).residuals.worst() < 1e-7);
            }
            return answer.status;
        };
        const SolverStatus paper = solve(Formulation::state);
        REQUIRE((paper == SolverStatus::optimal || paper == SolverStatus::infeasible));
        REQUIRE(solve(Formulation::reduced) == paper);
        REQUIRE(solve(Formulation::lumped) == paper);
        found += paper == SolverStatus::optimal ? 1 : 0;
    }
    CHECK(found > 100);
}

TEST_CASE("formulation: a motion of least energy known for several phases")
{
    struct Known {
        Schedule schedule;
        double energy;
    };
    for (const Known& known :
         {Known{{4, {{1, 10}, {1, 14}}}, 16.0}, Known{{4, {{1, 12}, {1, 14}}}, 8.0},
          Known{{4, {{1, 12}, {3, 12}}}, 16.0 / 3.0}, Known{{4, {{1, 13}, {2, 12}}}, 6.0},
          Known{{5, {{1, 1}, {1, 13}}}, 50.0}}) {
        const PeriodicResult result = findPeriodic(known.schedule);
        INFO(describe(known.schedule) << " " << result.detail);
        REQUIRE(result.status == Status::found);
        CHECK(result.motion->energyRatio == Approx(known.energy).epsilon(1e-7));
        CHECK(result.motion->canonical == known.schedule.phases);
    }
}

TEST_CASE("formulation: the lumped program does not grow with N, the reduced one linearly")
{
    const auto entries = [](std::int64_t factor, Formulation form) {
        const Schedule schedule{4 * factor, {{factor, 12 * factor}, {3 * factor, 12 * factor}}};
        const Program program = formulate(schedule, form).program;
        return program.equalities.nonZeros() + program.inequalities.nonZeros() +
               program.variables();
    };
    CHECK(entries(1000, Formulation::lumped) == entries(10, Formulation::lumped));
    CHECK(entries(1000, Formulation::reduced) < 101 * entries(10, Formulation::reduced));
}
