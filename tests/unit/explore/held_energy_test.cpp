// Motions of an energy to hold: the gentlest, the same on every grid, and the nearest to a state.

#include <cmath>

#include "catch.hpp"
#include "signorini/continuum.hpp"
#include "signorini/find_periodic.hpp"
#include "support.hpp"

using namespace signorini;
using test::onePhase;

TEST_CASE("held energy: the same motion on every grid")
{
    const PeriodicResult coarse = findPeriodic(50, 300, 100, {.energyRatio = 20.0});
    REQUIRE(coarse.motion);
    CHECK(coarse.how.objective == Objective::minPeakStrain);
    for (const std::int64_t factor : {3, 10, 30}) {
        const PeriodicResult fine =
            findPeriodic(50 * factor, 300 * factor, 100 * factor, {.energyRatio = 20.0});
        REQUIRE(fine.motion);
        const State expected = refined(coarse.motion->state, factor);
        CHECK((fine.motion->state.a - expected.a).lpNorm<Eigen::Infinity>() <= 1e-9);
        CHECK((fine.motion->state.b - expected.b).lpNorm<Eigen::Infinity>() <= 1e-9);
        CHECK(fine.motion->physical.peakCompression == Approx(0.01).epsilon(1e-12));
    }
    // Where the block is no whole number of cells: E/(2 E_1) g/L within one cell of its width.
    for (const double energy : {4.01, 5.5, 7.7, 20.3, 97.3}) {
        for (const std::int64_t cells : {100, 300, 1000, 3000}) {
            const PeriodicResult found =
                findPeriodic(cells / 2, 3 * cells, cells, {.energyRatio = energy});
            REQUIRE(found.motion);
            const double width = 2.0 * static_cast<double>(cells) / energy;
            const double peak = found.motion->physical.peakCompression / 1e-3;
            CAPTURE(energy, cells);
            CHECK(peak >= 0.5 * energy * (1.0 - 1e-9));
            CHECK(peak <= 0.5 * energy * (1.0 + 1.0 / std::floor(width)));
        }
    }
}

TEST_CASE("held energy: no sampled motion of the energy is gentler, pressing or grazing")
{
    const auto [schedule, energy] = GENERATE(table<Schedule, double>({{onePhase(20, 10, 60), 6.5},
                                                                      {onePhase(20, 8, 64), 12.0},
                                                                      {onePhase(12, 1, 47), 3.3},
                                                                      {onePhase(9, 2, 10), 30.0}}));
    const PeriodicResult found = findPeriodic(schedule, {.energyRatio = energy});
    CAPTURE(describe(schedule), found.detail);
    REQUIRE(found.motion);
    CHECK(found.motion->energyRatio == Approx(energy).epsilon(1e-12));
    const double peak = extremesOf(found.motion->state, schedule).peakCompression;
    for (const State& state : sampleMotions(schedule, energy, 500)) {
        REQUIRE(extremesOf(state, schedule).peakCompression >= peak * (1.0 - 1e-9));
    }
    const PeriodicResult asked =
        findPeriodic(schedule, {.objective = Objective::minPeakStrain, .energyRatio = energy});
    CHECK(asked.motion->state == found.motion->state);
}

TEST_CASE("held energy: no member of the energy is nearer to the target")
{
    const Schedule schedule = onePhase(20, 10, 60);
    for (unsigned seed = 1; seed < 6; ++seed) {
        const State target = test::randomState(20, seed);
        const PeriodicResult found = findPeriodic(
            schedule, {.objective = Objective::nearest, .target = target, .energyRatio = 9.0});
        REQUIRE(found.motion);
        CHECK(found.motion->energyRatio == Approx(9.0).epsilon(1e-12));
        const auto distance = [&target](const State& state) {
            return (state.a - target.a).squaredNorm() + (state.b - target.b).squaredNorm();
        };
        for (const State& state : sampleMotions(schedule, 9.0, 300, seed)) {
            REQUIRE(distance(state) >= distance(found.motion->state) - 1e-9);
        }
    }
    // A member of that energy is nearest to itself.
    const State member = sampleMotions(schedule, 9.0, 1, 3).front();
    const PeriodicResult self = findPeriodic(
        schedule, {.objective = Objective::nearest, .target = member, .energyRatio = 9.0});
    CHECK((self.motion->state.a - member.a).lpNorm<Eigen::Infinity>() <= 1e-9);
}

TEST_CASE("held energy: what the closed form cannot answer is refused by name")
{
    const auto refuses = [](const Schedule& schedule, const FindOptions& options) {
        CHECK_THROWS_WITH(findPeriodic(schedule, options), containsText("when an energy is held"));
    };
    refuses({4, {{1, 12}, {3, 12}}}, {.objective = Objective::minPeakStrain, .energyRatio = 6.0});
    refuses(onePhase(20, 10, 60), {.formulation = Formulation::state,
                                   .objective = Objective::minPeakStrain,
                                   .energyRatio = 6.0});
    refuses(onePhase(20, 1, 79),
            {.objective = Objective::nearest, .target = test::randomState(20), .energyRatio = 6.0});
    const PeriodicResult limited = findPeriodic(
        onePhase(20, 10, 60),
        {.objective = Objective::minPeakStrain, .strainLimit = 2.5, .energyRatio = 6.0});
    CHECK(limited.status == Status::none);
}

TEST_CASE("held energy: a strain limit is met by the gentlest motion, or refused with a proof")
{
    for (const auto& [schedule, energy] : {std::pair{onePhase(20, 10, 60), 6.5},
                                           {onePhase(20, 1, 79), 3.3},
                                           {onePhase(40, 20, 120), 20.0}}) {
        const PeriodicResult free = findPeriodic(schedule, {.energyRatio = energy});
        const double peak = extremesOf(free.motion->state, schedule).peakCompression;
        CAPTURE(describe(schedule), peak);
        const PeriodicResult met =
            findPeriodic(schedule, {.strainLimit = 1.0001 * peak, .energyRatio = energy});
        CHECK(met.status == Status::found);
        CHECK(met.how.route == "closed-form");
        const PeriodicResult none =
            findPeriodic(schedule, {.strainLimit = 0.85 * peak, .energyRatio = energy});
        REQUIRE(none.status == Status::none);
        CHECK(none.absence->reason == Reason::constraints);
        CHECK(isProof(none));
        CHECK_THAT(describe(std::get<EnergyExclusion>(none.absence->proof)),
                   containsText("within the strain limit"));
        // A limit that is said to be tighter than it was proves nothing.
        PeriodicResult tampered = none;
        std::get<EnergyExclusion>(tampered.absence->proof).strainLimit = 2.0 * peak;
        CHECK_FALSE(isProof(tampered));
    }
}
