#include "signorini/demands.hpp"
#include "infeasibility.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"
#include "formulation.hpp"
#include "has_solver.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/motion.hpp"
#include "signorini/one_phase_set.hpp"
#include "support.hpp"

using namespace signorini;
using test::onePhase;

namespace {

/// -min s over a fine sample of x and t, inside steps too, from the travelling waves themselves:
/// s = -(P(t + L - x) + P(t + L + x)), with P read off a refined march.
double sampledPeak(const State& state, const Schedule& schedule, std::int64_t factor)
{
    Schedule fine = schedule;
    fine.cells *= factor;
    for (Phase& phase : fine.phases) {
        phase.contact *= factor;
        phase.free *= factor;
    }
    const Motion motion(refined(state, factor), fine);
    double peak = -std::numeric_limits<double>::infinity();
    for (std::int64_t m = 0; m < motion.steps(); ++m) {
        for (std::int64_t i = 1; i <= fine.cells; ++i) {
            peak = std::max(peak, -motion.strain(i, m));
        }
    }
    return peak;
}

}  // namespace

TEST_CASE("demands: the deepest compression over all x and t is 2 max p, not seen at instants t_m")
{
    // One spike: at the instants t_m of its own grid the largest -s is p, inside a step it is 2p.
    const Schedule schedule = onePhase(8, 5, 23);
    const OnePhaseSet r = onePhaseSet(schedule);
    std::vector<double> z(3, 0.0);
    z[1] = r.set.sum;
    const State spike = motionOf(r, z);
    CHECK(extremesOf(spike, schedule).peakCompression == Approx(2.0 * r.set.sum));
    CHECK(sampledPeak(spike, schedule, 1) < 1.5 * r.set.sum);
    CHECK(sampledPeak(spike, schedule, 2) == Approx(2.0 * r.set.sum));
    CHECK(sampledPeak(spike, schedule, 5) == Approx(2.0 * r.set.sum));

    std::mt19937_64 generator(8);
    for (int k = 0; k < 20; ++k) {
        const State state = motionOf(r, drawAmplitudes(r.set, generator));
        CHECK(extremesOf(state, schedule).peakCompression ==
              Approx(sampledPeak(state, schedule, 2)));
    }
}

TEST_CASE("demands: extremes are those of the field")
{
    const Schedule schedule = onePhase(7, 3, 23);
    const State state = leastEnergyMotion(onePhaseSet(schedule));
    const Motion motion(state, schedule);
    double lowest = 1.0;
    for (std::int64_t m = 0; m <= motion.steps(); ++m) {
        lowest = std::min(lowest, motion.displacement(7, m));
    }
    CHECK(extremesOf(state, schedule).lowestTip == Approx(lowest));
    CHECK(extremesOf(state, schedule).impulse > 0.0);
}

TEST_CASE("demands: a strain limit just met is met, one just missed is proved impossible")
{
    for (const Schedule& schedule : {onePhase(300, 150, 900), onePhase(5, 1, 12)}) {
        const PeriodicResult least = findPeriodic(schedule);
        const double peak = extremesOf(least.motion->state, schedule).peakCompression;
        const PeriodicResult met = findPeriodic(schedule, {.strainLimit = peak * (1 + 1e-12)});
        CHECK(met.status == Status::found);
        CHECK(met.how.route == "closed-form");
        if (test::hasSolver("glpk-simplex") || test::hasSolver("ipopt")) {
            const PeriodicResult missed = findPeriodic(schedule, {.strainLimit = 0.99 * peak});
            CHECK(missed.status == Status::none);
            CHECK(missed.absence->reason == Reason::constraints);
            CHECK(std::get<ProgramProof>(missed.absence->proof).demands.strainLimit == 0.99 * peak);
            CHECK(isProof(missed));
        }
    }
}

TEST_CASE("demands: the same verdict in state, reduced and lumped unknowns", "[glpk]")
{
    for (const double limit : {1.9, 2.1}) {
        for (const Formulation form :
             {Formulation::state, Formulation::reduced, Formulation::lumped}) {
            const PeriodicResult result = findPeriodic(
                15, 90, 30, {.solver = "glpk-simplex", .formulation = form, .strainLimit = limit});
            INFO(name(form) << " " << limit << " " << result.detail);
            CHECK(result.status == (limit > 2.0 ? Status::found : Status::none));
        }
    }
    for (const double floor : {-1.9, -2.1}) {
        for (const Formulation form :
             {Formulation::state, Formulation::reduced, Formulation::lumped}) {
            const PeriodicResult result = findPeriodic(
                15, 90, 30, {.solver = "glpk-simplex", .formulation = form, .tipFloor = floor});
            INFO(name(form) << " " << floor << " " << result.detail);
            CHECK(result.status == (floor < -2.0 ? Status::found : Status::none));
        }
    }
}

TEST_CASE("demands: the energy of a motion can be held at any value of the range")
{
    for (const Schedule& schedule :
         {onePhase(300, 150, 900), onePhase(30, 15, 90), onePhase(20, 1, 79)}) {
        const EnergyRange range = *findPeriodic(schedule).set.energy;
        for (const double share : {0.0, 0.01, 0.5, 0.99, 1.0}) {
            const double wanted = range.least + share * (range.most - range.least);
            const PeriodicResult result = findPeriodic(schedule, {.energyRatio = wanted});
            INFO(describe(schedule) << " " << wanted);
            CHECK(result.status == Status::found);
            CHECK(result.motion->energyRatio == Approx(wanted).epsilon(1e-12));
        }
        CHECK(findPeriodic(schedule, {.energyRatio = 0.999 * range.least}).status == Status::none);
        CHECK(findPeriodic(schedule, {.energyRatio = 1.001 * range.most}).status == Status::none);
    }
}

TEST_CASE("demands: least energy by a quadratic program agrees with the closed form")
{
    for (const std::string solver : {"ipopt", "nlopt-slsqp"}) {
        if (!test::hasSolver(solver)) {
            continue;
        }
        const double accuracy = solver == "ipopt" ? 1e-8 : 1e-6;
        for (const Formulation form :
             {Formulation::state, Formulation::reduced, Formulation::lumped}) {
            for (const Schedule& schedule :
                 {onePhase(3, 1, 9), onePhase(8, 5, 23), onePhase(10, 5, 30)}) {
                const PeriodicResult result =
                    findPeriodic(schedule, {.solver = solver,
                                            .formulation = form,
                                            .objective = Objective::minEnergy,
                                            .tolerance = 1e-6});
                INFO(solver << " " << name(form) << " " << describe(schedule) << " "
                            << result.detail);
                REQUIRE(result.status == Status::found);
                CHECK(result.motion->energyRatio ==
                      Approx(result.set.energy->least).epsilon(accuracy));
            }
        }
    }
}

TEST_CASE("demands: the nearest motion to a motion is that motion, to another state its projection")
{
    const Schedule schedule = onePhase(8, 5, 23);
    const OnePhaseSet r = onePhaseSet(schedule);
    std::mt19937_64 generator(6);
    const State member = motionOf(r, drawAmplitudes(r.set, generator));
    for (const std::string solver : {"auto", "ipopt"}) {
        if (solver == "ipopt" && !test::hasSolver(solver)) {
            continue;
        }
        const PeriodicResult same = findPeriodic(
            schedule, {.solver = solver, .objective = Objective::nearest, .target = member});
        REQUIRE(same.status == Status::found);
        CHECK((same.motion->state.a - member.a).lpNorm<Eigen::Infinity>() < 1e-5);
        CHECK((same.motion->state.b - member.b).lpNorm<Eigen::Infinity>() < 1e-5);
    }

    // No drawn motion is nearer to a random state than the one that is returned.
    const State target = test::randomState(8, 5);
    const PeriodicResult near =
        findPeriodic(schedule, {.objective = Objective::nearest, .target = target});
    REQUIRE(near.status == Status::found);
    const auto distance = [&target](const State& s) {
        return (s.a - target.a).squaredNorm() + (s.b - target.b).squaredNorm();
    };
    for (int k = 0; k < 200; ++k) {
        CHECK(distance(near.motion->state) <=
              distance(motionOf(r, drawAmplitudes(r.set, generator))) + 1e-12);
    }
    if (test::hasSolver("ipopt")) {
        const PeriodicResult witness = findPeriodic(
            schedule, {.solver = "ipopt", .objective = Objective::nearest, .target = target});
        REQUIRE(witness.status == Status::found);
        CHECK(distance(witness.motion->state) ==
              Approx(distance(near.motion->state)).epsilon(1e-6));
    }
}

TEST_CASE("demands: the nearest motion to a state far beyond all motions is on the boundary")
{
    // Of z >= 0 with sum S, (S, 0, ...) is nearest to (x, 0, ...), and to (-x, 0, ...) the motion
    // with equal amplitudes in the other classes: whatever x >= S is.
    const Schedule schedule = onePhase(8, 5, 23);
    const OnePhaseSet r = onePhaseSet(schedule);
    const auto count = static_cast<std::size_t>(r.set.count);
    REQUIRE(count >= 3);
    std::vector<double> vertex(count, 0.0);
    vertex[1] = r.set.sum;
    std::vector<double> opposite(count, r.set.sum / static_cast<double>(count - 1));
    opposite[1] = 0.0;
    const State corner = motionOf(r, vertex);
    for (const double size : {1.0, 1e3, 1e9, 1e15, 1e18, 1e99}) {
        for (const double sign : {1.0, -1.0}) {
            INFO(sign * size);
            const State expected = motionOf(r, sign > 0.0 ? vertex : opposite);
            const State target{sign * size * corner.a, sign * size * corner.b};
            const PeriodicResult near =
                findPeriodic(schedule, {.objective = Objective::nearest, .target = target});
            REQUIRE(near.status == Status::found);
            REQUIRE((near.motion->state.a - expected.a).lpNorm<Eigen::Infinity>() <
                    1e-14 * r.set.sum);
            REQUIRE((near.motion->state.b - expected.b).lpNorm<Eigen::Infinity>() <
                    1e-14 * r.set.sum);
        }
    }
}

TEST_CASE("demands: least peak strain and most impulse by linear programs", "[glpk]")
{
    const Schedule schedule = onePhase(30, 15, 90);
    const auto solve = [&](Objective objective, Formulation form) {
        return findPeriodic(
            schedule, {.solver = "glpk-simplex", .formulation = form, .objective = objective});
    };
    const PeriodicResult least = findPeriodic(schedule);
    for (const Formulation form : {Formulation::state, Formulation::reduced, Formulation::lumped}) {
        INFO(name(form));
        const PeriodicResult peak = solve(Objective::minPeakStrain, form);
        REQUIRE(peak.status == Status::found);
        CHECK(peak.motion->physical.peakCompression ==
              Approx(least.motion->physical.peakCompression).epsilon(1e-7));
        const PeriodicResult impulse = solve(Objective::maxImpulse, form);
        REQUIRE(impulse.status == Status::found);
        CHECK(extremesOf(impulse.motion->state, schedule).impulse ==
              Approx(extremesOf(least.motion->state, schedule).impulse).epsilon(1e-7));
    }
}

TEST_CASE("demands: most energy in closed form, and climbing vertices never exceeds it", "[glpk]")
{
    const Schedule schedule = onePhase(8, 5, 23);
    const PeriodicResult most = findPeriodic(schedule, {.objective = Objective::maxEnergy});
    CHECK(most.motion->energyRatio == Approx(16.0));
    const PeriodicResult climbed =
        findPeriodic(schedule, {.solver = "glpk-simplex", .objective = Objective::maxEnergy});
    REQUIRE(climbed.status == Status::found);
    CHECK(climbed.motion->energyRatio == Approx(16.0));
    CHECK_THAT(climbed.how.reason, containsText("not proved"));
    CHECK_THAT(most.how.reason, containsText("exact"));
}

TEST_CASE("demands: prescribed parts of the initial state are kept, contradictory ones proved so",
          "[glpk]")
{
    const Schedule schedule = onePhase(8, 5, 23);
    const OnePhaseSet r = onePhaseSet(schedule);
    std::mt19937_64 generator(2);
    const State member = motionOf(r, drawAmplitudes(r.set, generator));
    const std::vector<FixedValue> fixed{{Wave::a, 8, member.a[7]}, {Wave::b, 2, member.b[1]}};
    const PeriodicResult kept = findPeriodic(schedule, {.fixed = fixed});
    REQUIRE(kept.status == Status::found);
    CHECK(kept.motion->state.a[7] == Approx(member.a[7]).margin(1e-9));
    CHECK(kept.motion->state.b[1] == Approx(member.b[1]).margin(1e-9));

    const PeriodicResult impossible =
        findPeriodic(schedule, {.fixed = {{Wave::a, 8, 100.0 * r.set.sum}}});
    CHECK(impossible.status == Status::none);
    CHECK(impossible.absence->reason == Reason::constraints);
    CHECK(isProof(impossible));
}

TEST_CASE("demands: wrong demands are refused by name")
{
    const auto refuses = [](FindOptions options, const char* text) {
        CHECK_THROWS_WITH(findPeriodic(5, 23, 8, options), containsText(text));
    };
    const double nan = std::nan("");
    refuses({.strainLimit = 0.0}, "strainLimit = 0");
    refuses({.strainLimit = nan}, "strainLimit = nan");
    refuses({.tipFloor = 1.0}, "tipFloor");
    refuses({.energyRatio = -1.0}, "energyRatio = -1");
    refuses({.energyRatio = nan}, "energyRatio = nan");
    refuses({.objective = Objective::nearest}, "target");
    refuses({.target = test::randomState(8)}, "target");
    refuses({.objective = Objective::nearest, .target = test::randomState(7)},
            "cells of the target = 7");
    State broken = test::randomState(8);
    broken.a[0] = nan;
    refuses({.objective = Objective::nearest, .target = broken}, "NaN");
    refuses({.fixed = {{Wave::a, 9, 1.0}}}, "cell of a fixed value = 9");
    refuses({.fixed = {{Wave::a, 1, nan}}}, "fixed value = nan");
    refuses({.objective = Objective::minEnergy, .energyRatio = 20.0}, "objective = min-energy");
    refuses({.iterationLimit = -1}, "iterationLimit = -1");
}

TEST_CASE("demands: what no back end of a build can do is said")
{
    if (test::hasSolver("ipopt") || test::hasSolver("nlopt-slsqp")) {
        return;
    }
    // Within a limit that the nearest motion breaks it is a quadratic program.
    const double limit = 1.0001 * findPeriodic(1, 79, 20).motion->physical.peakCompression / 1e-3;
    CHECK_THROWS_AS(findPeriodic(1, 79, 20,
                                 {.objective = Objective::nearest,
                                  .target = test::randomState(20),
                                  .strainLimit = limit}),
                    BackendUnavailable);
}
