#include "signorini/formulation.hpp"

#include <cmath>

#include "catch.hpp"
#include "signorini/equations.hpp"
#include "signorini/reduction.hpp"
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
    const Reduction r = reduce(schedule);
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
