// The solver libraries as witnesses of the closed form: the same verdict, the same minima.

#include "catch.hpp"
#include "formulation.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/one_phase_set.hpp"
#include "solver.hpp"
#include "support.hpp"

using namespace signorini;

namespace {

bool has(std::string_view solver)
{
    return findBackend(solver).available();
}

}  // namespace

TEST_CASE("witness: LP back ends agree with the closed form on every schedule up to N = 8")
{
    for (const std::string solver : {"glpk-simplex", "glpk-exact", "glpk-interior"}) {
        if (!has(solver)) {
            continue;
        }
        const auto engine = makeSolver(solver);
        for (const Formulation form : {Formulation::state, Formulation::reduced}) {
            int found = 0;
            int total = 0;
            test::forAllSchedules(8, 2, [&](const Schedule& schedule) {
                const OnePhaseSet exact = onePhaseSet(schedule);
                const Formulated formulated = formulate(schedule, form);
                const SolverResult answer = engine->solve(formulated.program);
                INFO(solver << " " << name(form) << " " << describe(schedule) << " "
                            << answer.detail);
                REQUIRE((answer.status == SolverStatus::optimal) == !exact.reason);
                if (answer.status == SolverStatus::optimal) {
                    ++found;
                    const State state = stateOf(formulated, answer.x);
                    REQUIRE(verify(state, schedule, 1e-6).residuals.worst() < 1e-6);
                } else if (solver != "glpk-interior") {  // which cannot tell, and says failed
                    REQUIRE(answer.status == SolverStatus::infeasible);
                }
                ++total;
            });
            CHECK(total == 4016);
            CHECK(found == 244);
        }
    }
}

TEST_CASE("witness: least energies by quadratic programs agree with E_min, up to the paper's case")
{
    const auto check = [](const std::string& solver, Formulation form, const Schedule& schedule,
                          double accuracy) {
        if (!has(solver)) {
            return;
        }
        const PeriodicResult result = findPeriodic(
            schedule, {.solver = solver, .formulation = form, .objective = Objective::minEnergy});
        INFO(solver << " " << name(form) << " " << describe(schedule) << " " << result.detail);
        REQUIRE(result.status == Status::found);
        CHECK(result.motion->energyRatio == Approx(result.set.energy->least).epsilon(accuracy));
    };
    for (const Formulation form : {Formulation::state, Formulation::reduced}) {
        for (const Schedule& schedule :
             {test::onePhase(3, 1, 9), test::onePhase(5, 3, 14), test::onePhase(9, 3, 20),
              test::onePhase(30, 15, 90), test::onePhase(30, 1, 119), test::onePhase(12, 6, 36)}) {
            check("ipopt", form, schedule, 1e-8);
            check("nlopt-slsqp", form, schedule, 1e-6);
        }
        check("ipopt", form, test::onePhase(300, 150, 900), 1e-8);
        check("nlopt-slsqp", form, test::onePhase(300, 150, 900), 1e-6);
    }
}

TEST_CASE("witness: every LP back end finds the paper's case in both formulations")
{
    for (const std::string solver : {"glpk-simplex", "glpk-exact", "glpk-interior"}) {
        for (const Formulation form : {Formulation::state, Formulation::reduced}) {
            if (!has(solver)) {
                continue;
            }
            const PeriodicResult result =
                findPeriodic(150, 900, 300, {.solver = solver, .formulation = form});
            INFO(solver << " " << name(form) << " " << result.detail);
            CHECK(result.status == Status::found);
            CHECK(result.motion->residuals.worst() <= 1e-7);
        }
    }
}

TEST_CASE("witness: a held energy by nonlinear programs, where a limit leaves the closed form")
{
    for (const std::string solver : {"ipopt", "nlopt-auglag"}) {
        if (!has(solver)) {
            continue;
        }
        const PeriodicResult result =
            findPeriodic(15, 90, 30, {.solver = solver, .strainLimit = 5.5, .energyRatio = 6.0});
        INFO(solver << " " << result.detail);
        REQUIRE(result.status == Status::found);
        CHECK(result.motion->energyRatio == Approx(6.0).epsilon(1e-7));
        CHECK(result.motion->physical.peakCompression <= 0.0055 * (1 + 1e-7));
    }
}
