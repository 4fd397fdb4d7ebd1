#include "propagation.hpp"

#include "catch.hpp"
#include "equations.hpp"
#include "signorini/one_phase_set.hpp"
#include "support.hpp"

using namespace signorini;

TEST_CASE("propagation: a contact step and a free step are the boundary conditions (17)-(19)")
{
    const State before = test::randomState(4);
    const bool inContact = GENERATE(true, false);
    DelayLine line(before);
    CHECK(line.incoming() == before.a[3]);
    if (inContact) {
        line.contactStep();
    } else {
        line.freeStep();
    }
    const State after = line.state();
    for (Eigen::Index i = 1; i < 4; ++i) {
        CHECK(after.a[i] == before.a[i - 1]);
        CHECK(after.b[i - 1] == before.b[i]);
    }
    CHECK(after.a[0] == -before.b[0]);
    CHECK(after.b[3] == (inContact ? -before.a[3] : before.a[3]));
}

TEST_CASE("propagation: many steps at once equal steps one by one, at any length")
{
    const std::int64_t count = GENERATE(0, 1, 5, 6, 7, 11, 12, 13, 23, 24, 25, 100);
    const State start = test::randomState(3);
    DelayLine jump(start);
    DelayLine walk(start);
    jump.contact(2);
    jump.free(count);
    jump.contact(count);
    walk.contact(2);
    for (std::int64_t k = 0; k < count; ++k) {
        walk.freeStep();
    }
    for (std::int64_t k = 0; k < count; ++k) {
        walk.contactStep();
    }
    CHECK(jump.state() == walk.state());
    CHECK(jump.distance(walk.state()) == 0.0);
}

TEST_CASE("propagation: one period is W of (30)")
{
    for (const Schedule& schedule :
         {test::onePhase(1, 1, 2), test::onePhase(3, 2, 9), test::onePhase(4, 11, 30),
          Schedule{5, {{1, 1}, {1, 13}, {4, 7}}}}) {
        const State start = test::randomState(schedule.cells);
        DelayLine line(start);
        line.period(schedule);
        CHECK(test::stacked(line.state()) == periodMap(schedule) * test::stacked(start));
    }
}

TEST_CASE("propagation: energy is conserved exactly in sum")
{
    const State start = test::randomState(6);
    DelayLine line(start);
    line.contact(5);
    line.free(17);
    CHECK(energyRatio(line.state()) == Approx(energyRatio(start)).epsilon(1e-15));
}

TEST_CASE("propagation: 10^6 periods bring a periodic state back bit for bit")
{
    const Schedule schedule = test::onePhase(8, 5, 23);
    const OnePhaseSet whole = onePhaseSet(schedule);
    std::mt19937_64 generator(7);
    const State start = motionOf(whole, drawAmplitudes(whole.set, generator));
    DelayLine line(start);
    for (int period = 0; period < 1'000'000; ++period) {
        line.period(schedule);
    }
    CHECK(line.state() == start);
    CHECK(line.distance(start) == 0.0);
}

TEST_CASE("propagation: malformed states are refused")
{
    CHECK_THROWS_AS(DelayLine(State{}), std::invalid_argument);
    CHECK_THROWS_AS(DelayLine(State{Eigen::VectorXd(2), Eigen::VectorXd(3)}),
                    std::invalid_argument);
    CHECK_THROWS_AS((void)DelayLine(test::randomState(2)).distance(test::randomState(3)),
                    std::invalid_argument);
}
