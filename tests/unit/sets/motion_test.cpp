#include "signorini/motion.hpp"

#include "catch.hpp"
#include "signorini/one_phase_set.hpp"
#include "stepped_waves.hpp"
#include "support.hpp"

using namespace signorini;
using test::onePhase;

TEST_CASE("motion: the field equals step-by-step propagation at every cell and instant")
{
    const Schedule schedule = GENERATE(onePhase(8, 5, 23), onePhase(5, 1, 12), onePhase(6, 2, 22),
                                       Schedule{4, {{1, 12}, {3, 12}}});
    State state = test::randomState(schedule.cells);
    if (schedule.phases.size() == 1) {
        state = leastEnergyMotion(onePhaseSet(schedule));
    }
    const Motion motion(state, schedule);
    test::UniformWaves line(state);
    std::int64_t instant = 0;
    const auto compare = [&] {
        const State now = line.state();
        const Eigen::VectorXd u = displacement(now);
        for (std::int64_t i = 1; i <= schedule.cells; ++i) {
            REQUIRE(motion.velocity(i, instant) == Approx(velocity(now)[i - 1]).margin(1e-14));
            REQUIRE(motion.strain(i, instant) == Approx(strain(now)[i - 1]).margin(1e-14));
            REQUIRE(motion.displacement(i, instant) == Approx(u[i - 1]).margin(1e-13));
        }
        REQUIRE(motion.displacement(0, instant) == 0.0);
    };
    for (const Phase& phase : schedule.phases) {
        for (std::int64_t k = 0; k < phase.contact; ++k, ++instant) {
            compare();
            line.contact();
        }
        for (std::int64_t k = 0; k < phase.free; ++k, ++instant) {
            compare();
            line.free();
        }
    }
    CHECK(instant == motion.steps());
}

TEST_CASE("motion: the paper's tip is held at the wall in contact and never passes it")
{
    const Motion motion(leastEnergyMotion(onePhaseSet(onePhase(300, 150, 900))),
                        onePhase(300, 150, 900));
    for (std::int64_t m = 0; m <= 150; ++m) {
        CHECK(motion.displacement(300, m) == Approx(1.0).epsilon(1e-14));
    }
    for (std::int64_t m = 0; m <= 1050; ++m) {
        CHECK(motion.displacement(300, m) <= 1.0 + 1e-14);
    }
    CHECK(motion.displacement(300, 600) == Approx(-2.0));
}

TEST_CASE("motion: huge periods are folded to the time after which the motion repeats")
{
    const Schedule schedule = onePhase(2, 1, 4'000'000'007);
    const OnePhaseSet r = onePhaseSet(schedule);
    REQUIRE_FALSE(r.reason);
    CHECK(Motion(leastEnergyMotion(r), schedule).steps() < 24);
}

TEST_CASE("motion: thinning keeps both ends and the bound")
{
    CHECK(thinned(4, 100) == std::vector<std::int64_t>{0, 1, 2, 3, 4});
    CHECK(thinned(10, 4) == std::vector<std::int64_t>{0, 4, 8, 10});
    CHECK(thinned(1'000'000'000, 1001).size() == 1001);
    CHECK(thinned(1'000'000'001, 1001).size() <= 1001);
}

TEST_CASE("motion: a state of other cells is refused")
{
    CHECK_THROWS_AS(Motion(test::randomState(3), onePhase(4, 1, 1)), std::invalid_argument);
}
