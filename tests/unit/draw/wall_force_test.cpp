#include "field.hpp"

#include <random>

#include "catch.hpp"
#include "signorini/find_periodic.hpp"

using namespace signorini;

namespace {

/// The force by stepping both waves through the bar, cell by cell: in contact the tip stands still,
/// so the wave to the left is minus the one that came, and the wall carries their difference.
std::vector<double> steppedForce(State state, const Schedule& schedule)
{
    std::vector<double> force;
    const Eigen::Index last = state.cells() - 1;
    const auto step = [&](bool isContact) {
        const double arrived = state.a[last];
        const double returned = -state.b[0];
        for (Eigen::Index i = last; i > 0; --i) {
            state.a[i] = state.a[i - 1];
        }
        for (Eigen::Index i = 0; i < last; ++i) {
            state.b[i] = state.b[i + 1];
        }
        state.a[0] = returned;
        state.b[last] = isContact ? -arrived : arrived;
        force.push_back(isContact ? arrived - state.b[last] : 0.0);
    };
    for (const Phase& phase : schedule.phases) {
        for (std::int64_t m = 0; m < phase.contact; ++m) {
            step(true);
        }
        for (std::int64_t m = 0; m < phase.free; ++m) {
            step(false);
        }
    }
    return force;
}

}  // namespace

TEST_CASE("wall force: twice the arriving wave, as stepping through the bar shows")
{
    for (const Schedule& schedule : {Schedule{8, {{5, 23}}}, Schedule{12, {{6, 36}}},
                                     Schedule{12, {{8, 34}}}, Schedule{4, {{1, 12}, {3, 12}}}}) {
        const PeriodicResult result = findPeriodic(schedule);
        INFO(describe(schedule));
        REQUIRE(result.motion);
        CHECK(wallForces(Motion(result.motion->state, schedule)) ==
              steppedForce(result.motion->state, schedule));
    }
}

TEST_CASE("wall force: contact is where the wall presses, not where a schedule allows it")
{
    // The tent of family (4, 7, 1) on 12 cells: of 8 contact steps the first two are without force.
    const PeriodicResult result = findPeriodic(8, 34, 12);
    REQUIRE(result.motion);
    const std::vector<Pressed> all =
        pressed(wallForces(Motion(result.motion->state, result.schedule)));
    REQUIRE(all.size() == 1);
    CHECK(all.front().from == 2);
    CHECK(all.front().to == 6);
}

TEST_CASE("wall force: none where the wall is only touched")
{
    const PeriodicResult grazing = findPeriodic(2, 6, 2);
    REQUIRE(grazing.motion);
    REQUIRE(grazing.motion->contact == Contact::grazing);
    const std::vector<double> force = wallForces(Motion(grazing.motion->state, grazing.schedule));
    CHECK(pressed(force).empty());
    CHECK(pressed({}).empty());
}
