#include <cmath>

#include "catch.hpp"
#include "has_solver.hpp"
#include "known_motions.hpp"
#include "signorini/amplitude_set.hpp"
#include "signorini/find_periodic.hpp"
#include "support.hpp"

using namespace signorini;
using test::onePhase;

namespace {

bool isVerifiedRange(const PeriodicResult& result)
{
    return result.absence && std::get<EnergyExclusion>(result.absence->proof).isVerified;
}

}  // namespace

TEST_CASE("claims: every extreme is refuted by a better known motion, and by no other")
{
    const Schedule schedule = onePhase(8, 5, 23);
    const OnePhaseSet r = onePhaseSet(schedule);
    const State least = leastEnergyMotion(r);
    const State most = motionOf(r, mostAmplitudes(r.set));
    const auto isRefuted = [&](Objective objective, const State& claimed, const State& known,
                               double strainLimit = 1e9) {
        Demands demands{.objective = objective, .strainLimit = strainLimit};
        if (objective == Objective::nearest) {
            demands.target = least;
        }
        const std::vector<State> motions{known};
        return refutation(demands, schedule, claimed, motions, 1e-7).has_value();
    };
    for (const Objective objective :
         {Objective::minEnergy, Objective::minPeakStrain, Objective::nearest}) {
        INFO(name(objective));
        CHECK(isRefuted(objective, most, least));
        CHECK_FALSE(isRefuted(objective, least, most));
        CHECK_FALSE(isRefuted(objective, least, least));
    }
    CHECK(isRefuted(Objective::maxEnergy, least, most));
    CHECK_FALSE(isRefuted(Objective::maxEnergy, most, least));
    CHECK_FALSE(isRefuted(Objective::any, most, least));
    // Equal for all amplitudes of one phase.
    CHECK_FALSE(isRefuted(Objective::maxImpulse, least, most));
    // A better motion that breaks a limit says nothing.
    const double limit = 1.01 * extremesOf(least, schedule).peakCompression;
    CHECK_FALSE(isRefuted(Objective::maxEnergy, least, most, limit));
}

TEST_CASE("claims: a climb that ends below the known most energy is withdrawn")
{
    int tried = 0;
    int withdrawn = 0;
    for (const std::string solver : {"glpk-simplex", "nlopt-slsqp"}) {
        if (!test::hasSolver(solver)) {
            continue;
        }
        for (const Formulation form : {Formulation::state, Formulation::reduced}) {
            for (const Schedule& schedule : {onePhase(3, 1, 11), onePhase(8, 5, 23)}) {
                const PeriodicResult result = findPeriodic(
                    schedule,
                    {.solver = solver, .formulation = form, .objective = Objective::maxEnergy});
                INFO(solver << " " << name(form) << " " << describe(schedule));
                ++tried;
                if (result.status == Status::found) {
                    CHECK(result.motion->energyRatio ==
                          Approx(result.set.energy->most).epsilon(1e-5));
                } else {
                    ++withdrawn;
                    CHECK(result.status == Status::undecided);
                    CHECK_FALSE(result.detail.empty());
                }
            }
        }
    }
    CHECK(withdrawn < std::max(tried, 1));  // some are right
}

TEST_CASE("claims: a held energy at an end of the range is found with several phases, too")
{
    const Schedule schedule{2, {{1, 7}, {1, 7}}};
    const EnergyRange range = *findPeriodic(schedule).set.energy;
    CHECK(range.most == 12.0);  // as of one phase, which the schedule repeats
    for (const double share : {0.0, 1e-9, 0.3, 0.7, 1.0}) {
        const double wanted = range.least + share * (range.most - range.least);
        const PeriodicResult result = findPeriodic(schedule, {.energyRatio = wanted});
        INFO(wanted << " " << result.detail);
        REQUIRE(result.status == Status::found);
        CHECK(result.motion->energyRatio == Approx(wanted).epsilon(1e-7));
        CHECK(result.motion->residuals.worst() <= 1e-7);
    }
}

TEST_CASE("claims: between the least and the most a straight way holds every energy")
{
    for (const Schedule& schedule : {onePhase(8, 5, 23), onePhase(20, 1, 79), onePhase(9, 3, 20)}) {
        const OnePhaseSet r = onePhaseSet(schedule);
        const EnergyRange range = energyRange(r);
        for (const double share : {0.0, 1e-9, 0.3, 0.7, 1.0}) {
            const double wanted = range.least + share * (range.most - range.least);
            const State state =
                motionOfEnergy(leastEnergyMotion(r), motionOf(r, mostAmplitudes(r.set)), wanted);
            INFO(describe(schedule) << " " << wanted);
            CHECK(energyRatio(state) == Approx(wanted).epsilon(1e-12));
            CHECK(verify(state, schedule).residuals.worst() < 1e-12);
        }
    }
}

TEST_CASE("claims: an energy beyond the range by less than the tolerance is met, beyond it absent")
{
    for (const Schedule& schedule :
         {onePhase(30, 15, 90), onePhase(2, 1, 7), Schedule{2, {{1, 7}, {1, 7}}}}) {
        const EnergyRange range = *findPeriodic(schedule).set.energy;
        for (const double tolerance : {1e-9, 1e-7, 1e-4}) {
            for (const auto& [end, sign] : {std::pair{range.least, -1.0}, {range.most, 1.0}}) {
                const auto statusAt = [&, e = end, s = sign](double beyond) {
                    return findPeriodic(schedule, {.energyRatio = e * (1.0 + s * beyond),
                                                   .tolerance = tolerance})
                        .status;
                };
                INFO(describe(schedule) << " " << end << " " << tolerance);
                CHECK(statusAt(0.9 * tolerance) == Status::found);
                CHECK(statusAt(1.1 * tolerance) == Status::none);
            }
        }
    }
}

TEST_CASE("claims: a strain limit within the tolerance is met on every route, beyond it on none",
          "[glpk]")
{
    const Schedule schedule = onePhase(10, 5, 30);  // peak strain 2 g/L
    for (const std::string solver : {"auto", "glpk-simplex"}) {
        for (const Formulation form :
             {Formulation::automatic, Formulation::state, Formulation::reduced}) {
            const auto statusAt = [&](double beyond) {
                return findPeriodic(schedule, {.solver = solver,
                                               .formulation = form,
                                               .strainLimit = 2.0 * (1.0 - beyond)})
                    .status;
            };
            INFO(solver << " " << name(form));
            CHECK(statusAt(0.0) == Status::found);
            CHECK(statusAt(5e-8) == Status::found);
            CHECK(statusAt(1.5e-7) != Status::found);
            CHECK(statusAt(1e-5) == Status::none);
        }
    }
}

TEST_CASE("claims: an energy range is called verified only where other code proves its end")
{
    for (const Schedule& schedule : {onePhase(30, 15, 90), onePhase(20, 1, 79), onePhase(8, 5, 23),
                                     onePhase(3, 1, 11), onePhase(300, 150, 900)}) {
        const EnergyRange range = *findPeriodic(schedule).set.energy;
        for (const double wanted : {0.5 * range.least, range.least * (1 - 1e-6),
                                    range.most * (1 + 1e-6), 2.0 * range.most}) {
            const PeriodicResult result = findPeriodic(schedule, {.energyRatio = wanted});
            INFO(describe(schedule) << " " << wanted);
            CHECK(result.status == Status::none);
            CHECK(isVerifiedRange(result));
            CHECK(isProof(result));
        }
    }
    for (const Schedule& schedule :
         {Schedule{2, {{1, 7}, {1, 7}}}, Schedule{4, {{1, 12}, {3, 12}}}}) {
        const EnergyRange range = *findPeriodic(schedule).set.energy;
        const PeriodicResult low =
            findPeriodic(schedule, {.energyRatio = range.least * (1 - 1e-6)});
        INFO(describe(schedule));
        CHECK(low.status == Status::none);
        CHECK(isVerifiedRange(low));
        CHECK(isProof(low));
        if (std::isfinite(range.most)) {
            const PeriodicResult high =
                findPeriodic(schedule, {.energyRatio = range.most * (1 + 1e-6)});
            CHECK(high.status == Status::none);
            CHECK(isVerifiedRange(high));
            CHECK(isProof(high));
        }
    }
}
