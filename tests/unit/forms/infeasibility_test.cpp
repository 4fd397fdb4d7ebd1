#include "infeasibility.hpp"

#include <limits>

#include "catch.hpp"
#include "formulation.hpp"
#include "signorini/demands.hpp"
#include "signorini/one_phase_set.hpp"
#include "support.hpp"

using namespace signorini;

namespace {

/// x + y = 3, x - y <= -1, 2 <= x, y free: feasible only for x <= 1. Infeasible.
Program impossible()
{
    Program program = emptyProgram(2);
    program.equalities.resize(1, 2);
    program.equalities.insert(0, 0) = 1.0;
    program.equalities.insert(0, 1) = 1.0;
    program.equalityRhs = Eigen::VectorXd::Constant(1, 3.0);
    program.inequalities.resize(1, 2);
    program.inequalities.insert(0, 0) = 1.0;
    program.inequalities.insert(0, 1) = -1.0;
    program.inequalityRhs = Eigen::VectorXd::Constant(1, -1.0);
    program.lower[0] = 2.0;
    return program;
}

}  // namespace

TEST_CASE("infeasibility: a proof is checked exactly, and wrong ones are not accepted")
{
    const Program program = impossible();
    const InfeasibilityProof proof{{{0, 1}}, {{0, 1}}};  // 2x = 2 at most, but x >= 2
    CHECK(isProof(proof, program));
    CHECK_FALSE(isProof(InfeasibilityProof{{{0, -1}}, {{0, 1}}}, program));
    CHECK_FALSE(isProof(InfeasibilityProof{{{0, 1}}, {}}, program));
    CHECK_FALSE(isProof(InfeasibilityProof{{{0, 1}}, {{0, -1}}}, program));
    CHECK_FALSE(isProof(InfeasibilityProof{{{1, 1}}, {{0, 1}}}, program));
    CHECK_FALSE(isProof(InfeasibilityProof{{{0, 1}}, {{-1, 1}}}, program));
    CHECK_FALSE(isProof(InfeasibilityProof{}, program));
    Program touching = program;
    touching.lower[0] = 1.0;  // now x = 1, y = 2 is feasible: equality is no contradiction
    CHECK_FALSE(isProof(proof, touching));
    touching.lower[0] = 1.0 + std::numeric_limits<double>::epsilon();
    CHECK(isProof(proof, touching));
}

TEST_CASE("infeasibility: an infinite bound that the combination needs is no proof")
{
    Program program = impossible();
    program.lower[0] = -std::numeric_limits<double>::infinity();
    CHECK_FALSE(isProof(InfeasibilityProof{{{0, 1}}, {{0, 1}}}, program));
}

TEST_CASE("infeasibility: proofs are found from the duals of an elastic program", "[glpk]")
{
    const auto solver = makeSolver("glpk-simplex");
    const auto proof = proveInfeasible(impossible(), *solver);
    REQUIRE(proof);
    CHECK(isProof(*proof, impossible()));
    Program possible = impossible();
    possible.lower[0] = 0.5;
    CHECK_FALSE(proveInfeasible(possible, *solver));
}

TEST_CASE("infeasibility: bounds that contradict a single row are found without a solver")
{
    Program program = impossible();
    CHECK_FALSE(proveByOneRow(program));
    program.lower = Eigen::Vector2d{2.0, 2.0};
    const auto proof = proveByOneRow(program);
    REQUIRE(proof);
    CHECK(isProof(*proof, program));
}

TEST_CASE("infeasibility: every absence of one-phase motions up to N = 5 is proved in each form",
          "[glpk]")
{
    const auto solver = makeSolver("glpk-simplex");
    test::forAllSchedules(5, 2, [&](const Schedule& schedule) {
        if (!onePhaseSet(schedule).reason) {
            return;
        }
        for (const Formulation form :
             {Formulation::state, Formulation::reduced, Formulation::lumped}) {
            const Program program = formulate(schedule, form).program;
            const auto proof = proveInfeasible(program, *solver);
            INFO(describe(schedule) << " " << name(form));
            REQUIRE(proof);
            REQUIRE(isProof(*proof, program));
        }
    });
}
