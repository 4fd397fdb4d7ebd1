#include "signorini/find_periodic.hpp"

#include <type_traits>

#include "catch.hpp"
#include "has_solver.hpp"
#include "solver.hpp"
#include "support.hpp"

using namespace signorini;
using test::onePhase;

namespace {

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
    CHECK(*result.set.kernelDimension == 150);
    CHECK(result.set.amplitudes->kind == SetKind::simplex);
    CHECK(result.set.amplitudes->dimension() == 149);
    CHECK(result.motion->contact == Contact::pressing);
    CHECK(result.motion->canonical == result.schedule.phases);
    CHECK(result.motion->energyRatio == 4.0);
    CHECK(result.motion->energy == Approx(2e-6).epsilon(1e-15));
    CHECK(result.set.energy->least == 4.0);
    CHECK(result.set.energy->most == 600.0);
    CHECK(result.motion->residuals.worst() == 0.0);
    CHECK(result.how.route == "closed-form");
    CHECK_FALSE(result.how.leftOut.empty());
    CHECK_FALSE(result.absence);
    CHECK(result.motion->state.cells() == 300);
}

TEST_CASE("findPeriodic: absence comes with a reason and a verified certificate, and no state")
{
    const PeriodicResult result = findPeriodic(20, 109, 40);
    CHECK(result.status == Status::none);
    CHECK(result.absence->reason == Reason::noLiveClass);
    CHECK(std::holds_alternative<FarkasCertificate>(result.absence->proof));
    CHECK(isProof(result));
    CHECK_FALSE(result.motion);
    CHECK_FALSE(result.set.energy);
}

TEST_CASE("findPeriodic: the objective chooses the end of the energy range")
{
    for (const Schedule& schedule : {onePhase(30, 15, 90), onePhase(20, 1, 79)}) {
        const auto solve = [&](Objective objective) {
            return findPeriodic(schedule, {.objective = objective});
        };
        const PeriodicResult least = solve(Objective::minEnergy);
        const PeriodicResult most = solve(Objective::maxEnergy);
        CHECK(least.motion->energyRatio == Approx(least.set.energy->least).epsilon(1e-13));
        CHECK(most.motion->energyRatio == Approx(least.set.energy->most).epsilon(1e-13));
        CHECK(most.status == Status::found);
        CHECK(most.motion->residuals.worst() < 1e-13);
    }
}

TEST_CASE("findPeriodic: physical units scale the answer and leave E/E_1 alone")
{
    FindOptions steel;
    steel.scene = barOfMaterial(1.0, 210e9, 7800.0, 1e-4, 1e-6);
    for (const Schedule& schedule :
         {onePhase(300, 150, 900), onePhase(5, 3, 14), onePhase(9, 3, 20)}) {
        const PeriodicResult unit = findPeriodic(schedule);
        const PeriodicResult scaled = findPeriodic(schedule, steel);
        CHECK(scaled.motion->energyRatio == Approx(unit.motion->energyRatio).epsilon(1e-12));
        CHECK(scaled.motion->state == unit.motion->state);
        CHECK(scaled.motion->energy ==
              Approx(unit.motion->energyRatio * 0.5 * steel.scene.bar.axialStiffness * 1e-12)
                  .epsilon(1e-12));
        CHECK(scaled.period == Approx(unit.period / steel.scene.bar.waveSpeed).epsilon(1e-12));
    }
    for (const double speed : {1e-6, 1.0, 1e9}) {
        for (const double gap : {1e-12, 1.0, 1e3}) {
            const PeriodicResult r =
                findPeriodic(150, 900, 300, {.scene = Bar{.waveSpeed = speed, .gap = gap}});
            CHECK(r.status == Status::found);
            CHECK(r.motion->energyRatio == 4.0);
        }
    }
}

TEST_CASE("findPeriodic: GLPK on the paper's equations agrees on every schedule up to N = 8",
          "[glpk]")
{
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
            REQUIRE(exact.motion->residuals.worst() < 1e-15);
            REQUIRE(witness.motion->residuals.worst() < 1e-9);
            REQUIRE(witness.motion->energyRatio >= exact.set.energy->least * (1 - 1e-9));
            REQUIRE(witness.motion->energyRatio <= exact.set.energy->most * (1 + 1e-9));
        } else {
            REQUIRE(isProof(exact));
        }
        ++total;
    });
    CHECK(total == 4016);
    CHECK(found > 200);
}

TEST_CASE("findPeriodic: GLPK finds the paper's case and a motion of two contact phases", "[glpk]")
{
    const PeriodicResult one =
        findPeriodic(150, 900, 300, {.solver = "glpk-simplex", .formulation = Formulation::state});
    CHECK(one.status == Status::found);
    CHECK(one.motion->residuals.worst() < 1e-9);
    CHECK(one.how.solver.name == "glpk-simplex");

    const PeriodicResult two = findPeriodic(Schedule{4, {{1, 12}, {3, 12}}});
    CHECK(two.status == Status::found);
    CHECK(two.motion->residuals.worst() < 1e-9);
    CHECK(*two.set.kernelDimension == 4);

    const PeriodicResult none = findPeriodic(Schedule{4, {{1, 1}, {1, 1}}});
    CHECK(none.status == Status::none);
    CHECK(isProof(none));
}

TEST_CASE("findPeriodic: a limit leaves the question undecided", "[glpk]")
{
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
    CHECK_THROWS_WITH(findPeriodic(1, 9, 3, {.scene = Bar{.length = -1.0}}),
                      containsText("length = -1"));
    CHECK_THROWS_WITH(findPeriodic(1, 9, 3, {.solver = "magic"}), containsText("solver = magic"));
    CHECK_THROWS_WITH(findPeriodic(1, 9, 3, {.tolerance = 1.0}), containsText("tolerance = 1"));
    CHECK_THROWS_WITH(findPeriodic(1, 9, 3, {.timeLimit = 0.0}), containsText("timeLimit = 0"));
    CHECK_THROWS_WITH(
        findPeriodic(1, 9, 3, {.solver = "closed-form", .formulation = Formulation::state}),
        containsText("formulation = state"));
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
            CHECK(r.motion->energyRatio == Approx(4.0 / 3.0).epsilon(4e-4));
        } else {
            CHECK(r.status == Status::undecided);
            CHECK_THAT(r.detail, containsText("least energy"));
            CHECK_FALSE(r.motion);
        }
    }
}

TEST_CASE("findPeriodic: the closed form takes several phases, too, and names itself")
{
    const Schedule schedule{4, {{1, 12}, {3, 12}}};
    const PeriodicResult usual = findPeriodic(schedule);
    CHECK(usual.how.solver.name == "closed-form");
    CHECK(usual.how.route == "lumped");
    const PeriodicResult asked = findPeriodic(schedule, {.solver = usual.how.solver.name});
    REQUIRE(asked.motion);
    CHECK(asked.motion->state == usual.motion->state);
    // The nearest motion within a limit is a program's: the closed form says that it does not know.
    const PeriodicResult beyond =
        findPeriodic(schedule, {.solver = "closed-form", .objective = Objective::maxImpulse});
    CHECK(beyond.status == Status::undecided);
    CHECK_THAT(beyond.detail, containsText("try solver auto"));
}

TEST_CASE("findPeriodic: whoever answers is a name that may be asked for")
{
    const Schedule far{maxCells, {{maxCells / 3, 3 * maxCells}, {maxCells / 7, 3 * maxCells + 1}}};
    for (const Schedule& schedule :
         {onePhase(8, 5, 23), onePhase(2, 2, 4), Schedule{4, {{1, 12}, {3, 12}}},
          Schedule{4, {{1, 1}, {1, 1}}}, far}) {
        INFO(describe(schedule));
        const std::string name = findPeriodic(schedule).how.solver.name;
        CHECK((name == "auto" || findBackend(name).available()));
    }
}

TEST_CASE("findPeriodic: every absence is proved again from the answer alone")
{
    std::vector<PeriodicResult> absences;
    for (const Schedule& schedule :
         {onePhase(40, 20, 109), onePhase(2, 2, 4), onePhase(20, 8, 12),
          Schedule{4, {{1, 1}, {1, 1}}}, Schedule{40, {{20, 109}, {20, 110}}}}) {
        absences.push_back(findPeriodic(schedule));
    }
    const Schedule schedule = onePhase(8, 5, 23);
    absences.push_back(findPeriodic(schedule, {.strainLimit = 1e-3}));
    absences.push_back(findPeriodic(schedule, {.energyRatio = 1e-3}));
    absences.push_back(findPeriodic(schedule, {.energyRatio = 1e6}));
    if (test::hasSolver("glpk-simplex")) {
        absences.push_back(findPeriodic(schedule, {.tipFloor = 0.999}));
        absences.push_back(findPeriodic(schedule, {.fixed = {{Wave::a, 8, 1e4}}}));
        for (const Formulation form : {Formulation::state, Formulation::reduced}) {
            absences.push_back(findPeriodic(
                schedule, {.solver = "glpk-simplex", .formulation = form, .tipFloor = 0.5}));
        }
    }
    for (const PeriodicResult& result : absences) {
        INFO(describe(result.schedule) << " " << result.how.route << " " << result.detail);
        REQUIRE(result.status == Status::none);
        CHECK(isProof(result));
        PeriodicResult tampered = result;
        if (result.absence->reason != Reason::constraints) {
            tampered.schedule = onePhase(300, 150, 900);  // which has motions
            CHECK_FALSE(isProof(tampered));
            tampered = result;
        }
        tampered.absence->proof = FarkasCertificate{};
        CHECK_FALSE(isProof(tampered));
        tampered.absence->proof = ProgramProof{};
        CHECK_FALSE(isProof(tampered));
        tampered.absence->proof = ProgramProof{.rows = Formulation::lumped};
        CHECK_FALSE(isProof(tampered));
        tampered.absence->proof = EnergyExclusion{.energyRatio = std::nan("")};
        CHECK_FALSE(isProof(tampered));
        tampered = result;
        tampered.absence.reset();
        CHECK_FALSE(isProof(tampered));
        tampered = result;
        tampered.status = Status::undecided;
        CHECK_FALSE(isProof(tampered));
    }
    CHECK_FALSE(isProof(findPeriodic(schedule)));
    CHECK_FALSE(isProof(PeriodicResult{}));
}

TEST_CASE("findPeriodic: a proof of absence does not survive a change of what it says")
{
    const auto changed = [](PeriodicResult result, auto change) {
        change(result.absence->proof);
        return isProof(result);
    };
    const Schedule schedule = onePhase(8, 5, 23);
    const PeriodicResult paper = findPeriodic(40, 109, 40);
    REQUIRE(isProof(paper));
    CHECK_FALSE(changed(paper, [](auto& p) { std::get<FarkasCertificate>(p).gap = 1; }));

    const double peak = extremesOf(findPeriodic(schedule).motion->state, schedule).peakCompression;
    const PeriodicResult strain = findPeriodic(schedule, {.strainLimit = 0.5 * peak});
    REQUIRE(isProof(strain));
    const auto strainProof = [&](auto change) {
        return changed(strain, [&](auto& p) { change(std::get<ProgramProof>(p)); });
    };
    CHECK_FALSE(strainProof([&](ProgramProof& p) { p.demands.strainLimit = 1.01 * peak; }));
    CHECK_FALSE(strainProof([](ProgramProof& p) { p.demands = {}; }));
    CHECK_FALSE(strainProof([](ProgramProof& p) { p.demands.strainLimit = -1.0; }));
    CHECK_FALSE(strainProof([](ProgramProof& p) { p.tolerance = 1.1; }));
    CHECK_FALSE(strainProof([](ProgramProof& p) { p.tolerance = -1e-3; }));
    CHECK_FALSE(strainProof([](ProgramProof& p) { p.multipliers.equalities.clear(); }));
    CHECK_FALSE(strainProof([](ProgramProof& p) { p.multipliers.equalities = {{99, 1}}; }));
    CHECK_FALSE(strainProof([](ProgramProof& p) { p.multipliers.inequalities = {{0, -1}}; }));

    const PeriodicResult energy = findPeriodic(schedule, {.energyRatio = 1e-3});
    REQUIRE(isProof(energy));
    const auto energyProof = [&](auto change) {
        return changed(energy, [&](auto& p) { change(std::get<EnergyExclusion>(p)); });
    };
    const EnergyRange range = *energy.set.energy;
    CHECK_FALSE(energyProof([&](EnergyExclusion& p) { p.energyRatio = range.least; }));
    CHECK_FALSE(energyProof([&](EnergyExclusion& p) {
        p.energyRatio = 1.5 * range.least;
        p.range.least = 2.0 * range.least;  // a range that is not that of the schedule
    }));
    CHECK_FALSE(energyProof([](EnergyExclusion& p) { p.tolerance = -0.1; }));
    CHECK_FALSE(energyProof([](EnergyExclusion& p) { p.tolerance = 1e9; }));
}
