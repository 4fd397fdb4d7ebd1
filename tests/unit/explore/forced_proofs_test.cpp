// Proofs that there are no forced motions, and the intervals they are made of.

#include <cmath>
#include <random>

#include "catch.hpp"
#include "forced_case.hpp"
#include "forced_check.hpp"
#include "forced_support.hpp"
#include "interval.hpp"
#include "signorini/one_phase_set.hpp"
#include "signorini/response.hpp"
#include "solver.hpp"
#include "support.hpp"

using namespace signorini;
using test::onePhase;

TEST_CASE("intervals: no operation loses the true value")
{
    std::mt19937_64 generator(2);
    std::uniform_real_distribution<double> value(-3.0, 3.0);
    for (int k = 0; k < 20'000; ++k) {
        const double x = value(generator);
        const double y = value(generator);
        const auto holds = [](Interval interval, long double exact) {
            return interval.low <= exact && exact <= interval.high;
        };
        const long double u = x;
        const long double v = y;
        CHECK(holds(Interval(x) + y, u + v));
        CHECK(holds(Interval(x) - y, u - v));
        CHECK(holds(Interval(x) * y, u * v));
        CHECK(holds(Interval(x) / y, u / v));
        const Interval wide(std::min(x, y), std::max(x, y));
        CHECK(holds(wide * Interval(y), u * v));
        CHECK(holds(wide - wide, u - v));
    }
    const Interval all = Interval(1.0) / Interval(-1.0, 1.0);
    CHECK_FALSE(all.isPositive());
    CHECK_FALSE(all.isNegative());
}

namespace {

/// Each condition that a schedule of one phase may have in a step.
ForcedCondition conditionAt(const Schedule& schedule, std::int64_t m)
{
    return {m < schedule.phases.front().contact ? ForcedRule::pressure : ForcedRule::penetration,
            m};
}

}  // namespace

TEST_CASE("forced proofs: one shape has one amplitude, and a proof holds for it of any size")
{
    std::mt19937_64 generator(61);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    int proofs = 0;
    int possible = 0;
    constexpr int trials = 300;
    for (int k = 0; k < trials; ++k) {
        Schedule schedule = onePhase(4, 1 + k % 4, 12 + k % 5);
        Forcing forcing{k % 2 == 0 ? Excited::tip : Excited::base, 1, {}};
        for (std::int64_t m = 0; m < steps(schedule); ++m) {
            forcing.shape.push_back(value(generator));
        }
        const double rho = Damping{0.1}.rho();
        std::vector<Excitation> shapes = shapesOf(forcing, 4, steps(schedule));
        const ForcedSet set = forcedMotions(schedule, {0.1}, forcing);
        // u(L, 0) of the shape itself, so that it is met with 1/|u| only.
        const double amplitude =
            1.0 / std::abs(test::Dense(schedule, rho).broken(shapes.front()).gap + 1.0);
        const ForcedQuestion one{schedule, rho, shapes};
        for (const double part : {0.3, 0.7, 0.999, 1.001, 1.5, 40.0}) {
            REQUIRE(forbidsAmplitude(one, part * amplitude, {}));
        }
        possible += forbidsAmplitude(one, amplitude, {}) ? 0 : 1;
        // At rest nothing is left of it.
        Schedule resting = schedule;
        resting.stops.right = 0;
        REQUIRE(forbidsContact({resting, rho, shapes}, {}));
        if (set.status != Status::none) {
            continue;
        }
        ++proofs;
        REQUIRE(forbidsContact(one, set.conflict));
        for (double& x : shapes.front().values) {
            x = std::ldexp(x, 50);
        }
        REQUIRE(forbidsContact(one, set.conflict));
    }
    CHECK(proofs > 200);
    CHECK(possible > trials * 9 / 10);
}

TEST_CASE("forced proofs: without a gap no two conditions forbid motions that are there")
{
    std::mt19937_64 generator(62);
    int tried = 0;
    for (int k = 0; k < 700; ++k) {
        test::ForcedExample one = test::randomForced(generator);
        one.schedule.stops.right = 0;
        const ForcedSet set = forcedMotions(one.schedule, one.damping, one.forcing);
        if (set.status != Status::found) {
            continue;
        }
        const std::int64_t n = steps(one.schedule);
        const auto shapes = shapesOf(one.forcing, one.schedule.cells, n);
        const ForcedQuestion question{one.schedule, one.damping.rho(), shapes};
        for (std::int64_t i = 0; i < n; ++i) {
            for (std::int64_t j = 0; j < i; ++j) {
                const ForcedCondition two[] = {conditionAt(one.schedule, i),
                                               conditionAt(one.schedule, j)};
                REQUIRE_FALSE(forbidsContact(question, two));
                ++tried;
            }
        }
    }
    CHECK(tried > 1000);
}

TEST_CASE("forced proofs: amplitudes are not forbidden by conditions that are none, nor by waves")
{
    const Schedule schedule = onePhase(30, 12, 96);
    const auto shapes = shapesOf({}, 30, 108);
    const ForcedQuestion question{schedule, 0.9, shapes};
    const ForcedSet set = forcedMotions(schedule, dampingOfRho(0.9), {});
    const double beyond = 1.001 * set.mostAmplitude;
    const std::vector<ForcedCondition> conflict = exclusionOf(set, beyond).conflict;
    REQUIRE(forbidsAmplitude(question, beyond, conflict));
    for (const ForcedCondition& none :
         {ForcedCondition{ForcedRule::pressure, 12}, ForcedCondition{ForcedRule::penetration, 108},
          ForcedCondition{ForcedRule::closure, 60}}) {
        std::vector<ForcedCondition> more = conflict;
        more.push_back(none);
        CHECK_FALSE(forbidsAmplitude(question, beyond, more));
        CHECK_FALSE(forbidsAmplitude(question, 0.5 * set.leastAmplitude, {&none, 1}));
    }
    // Waves that nothing damps: what is left of the bar's motions has no use for a force, but for
    // some amplitudes in between there are motions, and none of their conditions forbids them.
    if (preferred({.duals = true}) == nullptr) {
        return;
    }
    int inside = 0;
    for (std::int64_t contact = 1; contact < 9; ++contact) {
        for (std::int64_t n = 11; n < 25; ++n) {
            const Schedule undamped = onePhase(5, contact, n - contact);
            const ForcedSet some = forcedMotions(undamped, {}, {});
            if (some.status != Status::found || some.kind != ForcedKind::polytope ||
                !(some.mostAmplitude > some.leastAmplitude + 1e-3)) {
                continue;
            }
            const auto both = shapesOf({}, 5, n);
            const double amplitude =
                some.leastAmplitude +
                0.4 * (std::min(some.mostAmplitude, 9.0) - some.leastAmplitude);
            for (std::int64_t m = 0; m < n; ++m) {
                const ForcedCondition condition = conditionAt(undamped, m);
                REQUIRE_FALSE(forbidsAmplitude({undamped, 1.0, both}, amplitude, {&condition, 1}));
                ++inside;
            }
        }
    }
    CHECK(inside > 50);
}
