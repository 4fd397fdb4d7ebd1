#include "signorini/find_periodic.hpp"

#include <type_traits>

#include "catch.hpp"
#include "solver.hpp"
#include "support.hpp"

using namespace signorini;
using test::onePhase;

namespace {

bool hasGlpk()
{
    return findBackend("glpk-simplex").available();
}

template <typename Steps>
concept CanFind = requires(Steps steps)
{
    findPeriodic(steps, steps);
};

}  // namespace

TEST_CASE("findPeriodic: the paper's case, end to end")
{
    const PeriodicResult result = findPeriodic(150, 900);
    CHECK(result.status == Status::found);
    CHECK(result.detail.empty());
    CHECK(result.period == 3.5);
    CHECK(result.frequencyRatio == Approx(8.0 / 7.0).epsilon(1e-15));
    CHECK(*result.kernelDimension == 150);
    CHECK(result.solutionSet->kind == SetKind::simplex);
    CHECK(result.solutionSet->dimension() == 149);
    CHECK(result.contact == Contact::pressing);
    CHECK(result.canonical == result.schedule.phases);
    CHECK(result.energyRatio == 4.0);
    CHECK(result.energy == Approx(2e-6).epsilon(1e-15));
    CHECK(result.energyRange->least == 4.0);
    CHECK(result.energyRange->most == 600.0);
    CHECK(result.residuals.worst() == 0.0);
    CHECK(result.route == "closed-form");
    CHECK_FALSE(result.leftOut.empty());
    CHECK_FALSE(result.certificate);
    CHECK(result.state.cells() == 300);
}

TEST_CASE("findPeriodic: absence comes with a reason and a verified certificate, and no state")
{
    const PeriodicResult result = findPeriodic(20, 109, 40);
    CHECK(result.status == Status::none);
    CHECK(result.reason == Reason::noLiveClass);
    REQUIRE(result.certificate);
    CHECK(isProof(*result.certificate, result.schedule));
    CHECK(result.state.cells() == 0);
    CHECK_FALSE(result.energyRange);
}

TEST_CASE("findPeriodic: the objective chooses the end of the energy range")
{
    for (const Schedule& schedule : {onePhase(30, 15, 90), onePhase(20, 1, 79)}) {
        const auto solve = [&](Objective objective) {
            return findPeriodic(schedule, {.objective = objective});
        };
        const PeriodicResult least = solve(Objective::minEnergy);
        const PeriodicResult most = solve(Objective::maxEnergy);
        CHECK(least.energyRatio == Approx(least.energyRange->least).epsilon(1e-13));
        CHECK(most.energyRatio == Approx(least.energyRange->most).epsilon(1e-13));
        CHECK(most.status == Status::found);
        CHECK(most.residuals.worst() < 1e-13);
    }
}

TEST_CASE("findPeriodic: physical units scale the answer and leave E/E_1 alone")
{
    FindOptions steel;
    steel.bar = barOfMaterial(1.0, 210e9, 7800.0, 1e-4, 1e-6);
    for (const Schedule& schedule :
         {onePhase(300, 150, 900), onePhase(5, 3, 14), onePhase(9, 3, 20)}) {
        const PeriodicResult unit = findPeriodic(schedule);
        const PeriodicResult scaled = findPeriodic(schedule, steel);
        CHECK(scaled.energyRatio == Approx(unit.energyRatio).epsilon(1e-12));
        CHECK(scaled.state == unit.state);
        CHECK(scaled.energy ==
              Approx(unit.energyRatio * 0.5 * steel.bar.axialStiffness * 1e-12).epsilon(1e-12));
        CHECK(scaled.period == Approx(unit.period / steel.bar.waveSpeed).epsilon(1e-12));
    }
    for (const double speed : {1e-6, 1.0, 1e9}) {
        for (const double gap : {1e-12, 1.0, 1e3}) {
            const PeriodicResult r =
                findPeriodic(150, 900, 300, {.bar = {.waveSpeed = speed, .gap = gap}});
            CHECK(r.status == Status::found);
            CHECK(r.energyRatio == 4.0);
        }
    }
}

TEST_CASE("findPeriodic: GLPK on the paper's equations agrees on every schedule up to N = 8")
{
    if (!hasGlpk()) {
        CHECK_THROWS_AS(findPeriodic(1, 9, 3, {.solver = "glpk-simplex"}), BackendUnavailable);
        return;
    }
    int found = 0;
    int total = 0;
    test::forAllSchedules(8, 2, [&](const Schedule& schedule) {
        const PeriodicResult exact = findPeriodic(schedule);
        const PeriodicResult witness =
            findPeriodic(schedule, {.solver = "glpk-simplex", .formulation = Formulation::state});
        INFO(describe(schedule) << ": " << witness.detail);
        REQUIRE(exact.status != Status::undecided);
        REQUIRE(witness.status == exact.status);
        if (exact.status == Status::found) {
            ++found;
            REQUIRE(exact.residuals.worst() < 1e-15);
            REQUIRE(witness.residuals.worst() < 1e-9);
            REQUIRE(witness.energyRatio >= exact.energyRange->least * (1 - 1e-9));
            REQUIRE(witness.energyRatio <= exact.energyRange->most * (1 + 1e-9));
        } else {
            REQUIRE(isProof(*exact.certificate, schedule));
        }
        ++total;
    });
    CHECK(total == 4016);
    CHECK(found > 200);
}

TEST_CASE("findPeriodic: GLPK finds the paper's case and a motion of two contact phases")
{
    if (!hasGlpk()) {
        return;
    }
    const PeriodicResult one =
        findPeriodic(150, 900, 300, {.solver = "glpk-simplex", .formulation = Formulation::state});
    CHECK(one.status == Status::found);
    CHECK(one.residuals.worst() < 1e-9);
    CHECK(one.solver.name == "glpk-simplex");

    const PeriodicResult two = findPeriodic(Schedule{4, {{1, 12}, {3, 12}}});
    CHECK(two.status == Status::found);
    CHECK(two.residuals.worst() < 1e-9);
    CHECK(*two.kernelDimension == 4);

    const PeriodicResult none = findPeriodic(Schedule{4, {{1, 1}, {1, 1}}});
    CHECK(none.status == Status::none);
    CHECK(none.programProof);
}

TEST_CASE("findPeriodic: a limit leaves the question undecided")
{
    if (!hasGlpk()) {
        return;
    }
    const PeriodicResult result = findPeriodic(
        1500, 12000, 3000,
        {.solver = "glpk-simplex", .formulation = Formulation::state, .timeLimit = 1e-3});
    CHECK(result.status == Status::undecided);
    CHECK_THAT(result.detail, containsText("limit"));
}

TEST_CASE("findPeriodic: big numbers are answered quickly or refused clearly")
{
    CHECK(findPeriodic(1, 1'000'000'000, 1).status == Status::none);
    CHECK(findPeriodic(1, 999'999'999'999, 1).status != Status::undecided);
    CHECK_THROWS_AS(findPeriodic(maxSteps, maxSteps), std::invalid_argument);
}

TEST_CASE("findPeriodic: wrong use throws with field, value and range")
{
    CHECK_THROWS_WITH(findPeriodic(0, 9), containsText("contact steps of phase 1 = 0"));
    CHECK_THROWS_WITH(findPeriodic(1, -9), containsText("free steps of phase 1 = -9"));
    CHECK_THROWS_WITH(findPeriodic(1, 9, 0), containsText("cells = 0"));
    CHECK_THROWS_WITH(findPeriodic(1, 9, 3, {.bar = {.gap = -1.0}}), containsText("gap = -1"));
    CHECK_THROWS_WITH(findPeriodic(1, 9, 3, {.solver = "magic"}), containsText("solver = magic"));
    CHECK_THROWS_WITH(findPeriodic(1, 9, 3, {.tolerance = 1.0}), containsText("tolerance = 1"));
    CHECK_THROWS_WITH(findPeriodic(1, 9, 3, {.timeLimit = 0.0}), containsText("timeLimit = 0"));
    CHECK_THROWS_WITH(
        findPeriodic(1, 9, 3, {.solver = "closed-form", .formulation = Formulation::state}),
        containsText("formulation = state"));
    CHECK_THROWS_WITH(findPeriodic(Schedule{4, {{1, 10}, {1, 14}}}, {.solver = "closed-form"}),
                      containsText("phases = 2"));
}

TEST_CASE("findPeriodic: fractional steps do not compile")
{
    STATIC_REQUIRE(CanFind<int>);
    STATIC_REQUIRE(CanFind<std::int64_t>);
    STATIC_REQUIRE_FALSE(CanFind<double>);
}

TEST_CASE("findPeriodic: a solver's least energy that is not the least is not believed")
{
    // A local method stops early on a box; whatever it says, found means the least energy.
    for (const char* solver : {"nlopt-auglag", "nlopt-slsqp", "ipopt"}) {
        const auto table = backends();
        const bool has = std::any_of(table.begin(), table.end(), [solver](const Backend& backend) {
            return backend.name == solver && backend.available();
        });
        if (!has) {
            continue;
        }
        const PeriodicResult r = findPeriodic(15, 105, 30,
                                              {.solver = solver,
                                               .formulation = Formulation::reduced,
                                               .objective = Objective::minEnergy});
        INFO(solver << ": " << r.detail);
        if (r.status == Status::found) {
            CHECK(r.energyRatio == Approx(4.0 / 3.0).epsilon(4e-4));
        } else {
            CHECK(r.status == Status::undecided);
            CHECK_THAT(r.detail, containsText("least energy"));
            CHECK(r.state.cells() == 0);
        }
    }
}
