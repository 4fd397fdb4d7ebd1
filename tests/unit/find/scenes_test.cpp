// Scenes with other stops: gaps of any sign, and a second stop, against an independent program.

#include <array>
#include <cmath>
#include <set>
#include <string>

#include "catch.hpp"
#include "sanitized.hpp"
#include "scene_oracle.hpp"
#include "signorini/find_periodic.hpp"

using namespace signorini;

namespace {

constexpr double gap = 1e-3;

const Scene pressed = Bar{.gap = -gap};
const Scene touching = Bar{.gap = 0.0};
const Scene between(Bar{}, gap);

/// Options that a scene needs to be decided.
FindOptions in(const Scene& scene)
{
    FindOptions options;
    options.scene = scene;
    if (scene.bar.gap == 0.0 && !scene.secondStop) {
        options.energyRatio = 1.0;
    }
    return options;
}

std::set<std::pair<std::int64_t, std::int64_t>> existing(const Scene& scene,
                                                         std::int64_t mostContact,
                                                         std::int64_t mostFree, bool isMirrored)
{
    std::set<std::pair<std::int64_t, std::int64_t>> found;
    for (std::int64_t contact = 1; contact <= mostContact; ++contact) {
        for (std::int64_t free = 1; free <= mostFree; ++free) {
            Schedule schedule{4, {{contact, free}}};
            if (isMirrored) {
                schedule.phases.push_back({contact, free, Stop::left});
            }
            const PeriodicResult result = findPeriodic(schedule, in(scene));
            REQUIRE(result.status != Status::undecided);
            if (result.motion) {
                CHECK(result.motion->isSymmetric == isMirrored);
                found.emplace(contact, free);
            } else {
                CHECK(isProof(result));
            }
        }
    }
    return found;
}

}  // namespace

TEST_CASE("scenes: on four cells 32 schedules exist where the bar is pressed at rest")
{
    CHECK(existing(pressed, 16, 24, false).size() == 32);
}

TEST_CASE("scenes: on four cells 12 schedules exist without a gap")
{
    // By HiGHS from rows of its own.
    CHECK(existing(touching, 16, 24, false) ==
          std::set<std::pair<std::int64_t, std::int64_t>>{{1, 4},
                                                          {1, 8},
                                                          {1, 9},
                                                          {1, 11},
                                                          {2, 8},
                                                          {2, 10},
                                                          {3, 7},
                                                          {3, 9},
                                                          {4, 8},
                                                          {5, 7},
                                                          {6, 6},
                                                          {7, 5}});
}

TEST_CASE("scenes: on four cells these schedules touch two stops at equal distances in turn")
{
    CHECK(existing(between, 8, 12, true) ==
          std::set<std::pair<std::int64_t, std::int64_t>>{{1, 5},
                                                          {1, 6},
                                                          {1, 7},
                                                          {2, 4},
                                                          {2, 6},
                                                          {3, 2},
                                                          {3, 3},
                                                          {3, 5},
                                                          {4, 4},
                                                          {5, 3},
                                                          {6, 2},
                                                          {7, 1}});
}

TEST_CASE(
    "scenes: 10,000 random schedules each, found and proved absent as an independent program "
    "says")
{
    const auto& [name, scene] = GENERATE(values<std::pair<const char*, Scene>>(
        {{"gap < 0", pressed},
         {"no gap", touching},
         {"two stops", between},
         {"two stops, h = 1.7 g", Scene(Bar{}, 1.7e-3)},
         {"pressed between two stops", Scene(Bar{.gap = -gap}, 2.5e-3)},
         {"no gap, two stops", Scene(Bar{.gap = 0.0}, 0.5)}}));
    DYNAMIC_SECTION(name)
    {
        std::mt19937_64 generator(17);
        const Stops stops = stopsOf(scene);
        const bool needsLeft = stops.right == 0 && stops.left;
        int found = 0;
        for (int k = 0; k < test::drawn(10'000); ++k) {
            Schedule schedule = test::randomScene(generator, stops, 8);
            if (needsLeft) {
                schedule.phases.back().stop = Stop::left;
            }
            INFO(describe(schedule));
            const PeriodicResult result = findPeriodic(schedule, in(scene));
            const bool exists = test::OracleRows(schedule).isFeasible();
            REQUIRE(result.status == (exists ? Status::found : Status::none));
            if (exists) {
                ++found;
                REQUIRE(result.motion->residuals.worst() <= 1e-9);
            } else {
                REQUIRE(isProof(result));
            }
        }
        CHECK(found > test::drawn(50));
    }
}

TEST_CASE("scenes: the linear programs of all formulations agree with the exact sets", "[glpk]")
{
    const auto& [name, scene] = GENERATE(values<std::pair<const char*, Scene>>(
        {{"gap < 0", pressed},
         {"no gap", touching},
         {"two stops", between},
         {"pressed between two stops", Scene(Bar{.gap = -gap}, 2.5e-3)}}));
    const Formulation formulation =
        GENERATE(Formulation::state, Formulation::reduced, Formulation::lumped);
    std::mt19937_64 generator(18);
    FindOptions options = in(scene);
    for (int k = 0; k < 150; ++k) {
        const Schedule schedule = test::randomScene(generator, stopsOf(scene), 5);
        INFO(name << ", " << describe(schedule));
        options.solver = "auto";
        options.formulation = Formulation::automatic;
        const Status exact = findPeriodic(schedule, options).status;
        options.solver = "glpk-simplex";
        options.formulation = formulation;
        const PeriodicResult result = findPeriodic(schedule, options);
        REQUIRE(result.status == exact);
        if (result.status == Status::none) {
            REQUIRE(isProof(result));
        }
    }
}

TEST_CASE("scenes: least energies are those of a quadratic program", "[ipopt]")
{
    const Scene scene = GENERATE(values<Scene>({pressed, between, Scene(Bar{}, 1.7e-3)}));
    std::mt19937_64 generator(19);
    int compared = 0;
    while (compared < 25) {
        const Schedule schedule = test::randomScene(generator, stopsOf(scene), 6);
        FindOptions options = in(scene);
        const PeriodicResult exact = findPeriodic(schedule, options);
        if (!exact.motion) {
            continue;
        }
        INFO(describe(schedule));
        options.solver = "ipopt";
        options.formulation = Formulation::reduced;
        options.objective = Objective::minEnergy;
        const PeriodicResult local = findPeriodic(schedule, options);
        REQUIRE(local.motion);
        CHECK(local.motion->energyRatio == Approx(exact.motion->energyRatio).epsilon(1e-5));
        ++compared;
    }
}

TEST_CASE("scenes: without a gap the energy sets the size, and is needed")
{
    FindOptions options = in(touching);
    options.energyRatio = 0.25;
    const PeriodicResult found = findPeriodic(3, 7, 4, options);
    REQUIRE(found.motion);
    CHECK(found.set.kind == SetKind::cone);
    CHECK(found.motion->energyRatio == Approx(0.25).epsilon(1e-12));
    CHECK(found.motion->energy == Approx(0.25 * 0.5).epsilon(1e-12));  // EA L/2 = 1/2 J
    options.energyRatio = 1.0;
    const PeriodicResult larger = findPeriodic(3, 7, 4, options);
    CHECK((larger.motion->state.a - 2.0 * found.motion->state.a).norm() < 1e-12);
    options.energyRatio.reset();
    CHECK_THROWS_WITH(findPeriodic(3, 7, 4, options), containsText("energyRatio = not given"));
    options.energyRatio = 1.0;
    options.strainLimit = 1.0;
    CHECK_THROWS_WITH(findPeriodic(3, 7, 4, options), containsText("where the gap is 0"));
    options = in(Scene(Bar{.gap = 0.0}, 0.5));
    CHECK_THROWS_WITH(findPeriodic(3, 7, 4, options), containsText("second stop"));
}

TEST_CASE("scenes: without a gap, beside a stop out of reach, motions are those of one stop")
{
    std::mt19937_64 generator(23);
    const Scene scene(Bar{.gap = 0.0}, 0.5);
    FindOptions options = in(scene);
    options.energyRatio = 1e-8;
    int found = 0;
    int absent = 0;
    for (int k = 0; k < 1000; ++k) {
        Schedule schedule = test::randomScene(generator, stopsOf(scene), 8);
        for (Phase& phase : schedule.phases) {
            phase.stop = Stop::right;
        }
        INFO(describe(schedule));
        const PeriodicResult result = findPeriodic(schedule, options);
        schedule.stops.left.reset();
        const bool exists = test::OracleRows(schedule).isFeasible();
        REQUIRE(result.status == (exists ? Status::found : Status::none));
        found += exists ? 1 : 0;
        if (!exists) {
            REQUIRE(isProof(result));
            REQUIRE(!std::holds_alternative<EnergyExclusion>(result.absence->proof));
            ++absent;
        }
    }
    CHECK(found > 50);
    CHECK(absent > 500);
}

TEST_CASE("scenes: a bar pressed at rest swings about its static force")
{
    // The contact that hardly ends: motions of all amplitudes are around p = 1/2 everywhere.
    const PeriodicResult held = findPeriodic(15, 1, 4, in(pressed));
    REQUIRE(held.motion);
    CHECK(held.motion->physical.impulse * held.motion->physical.frequency ==
          Approx(staticForce(pressed)));
    const Stops still = stopsOf(pressed);
    const State rest{Eigen::VectorXd::Constant(4, 0.5), Eigen::VectorXd::Constant(4, -0.5)};
    CHECK(march(rest, 40, 1e-9, still).residual == 0.0);
    CHECK(march(rest, 40, 1e-9, still).phases == std::vector<Phase>{{40, 0}});
    CHECK(energyRatio(rest) == Approx(1.0));
}

TEST_CASE("scenes: a motion between two stops mirrors itself, or has a mirrored twin")
{
    std::mt19937_64 generator(20);
    const Stops stops = stopsOf(between);
    int compared = 0;
    while (compared < 60) {
        const Schedule schedule = test::randomScene(generator, stops, 6);
        Schedule mirrored = schedule;
        for (Phase& phase : mirrored.phases) {
            phase.stop = phase.stop == Stop::right ? Stop::left : Stop::right;
        }
        const PeriodicResult one = findPeriodic(schedule, in(between));
        const PeriodicResult other = findPeriodic(mirrored, in(between));
        INFO(describe(schedule));
        REQUIRE(one.status == other.status);
        if (one.motion) {
            CHECK((one.motion->state.a + other.motion->state.a).norm() < 1e-9);
            CHECK(one.motion->physical.impulse == Approx(other.motion->physical.impulse));
            ++compared;
        }
    }
}
