#include <cmath>
#include <numbers>
#include <random>

#include "bar_check.hpp"
#include "catch.hpp"
#include "forced_case.hpp"
#include "forced_support.hpp"
#include "signorini/one_phase_set.hpp"
#include "signorini/response.hpp"
#include "support.hpp"

using namespace signorini;
using test::onePhase;

TEST_CASE("forced motions: the phases that a dense solver and a scan find are those of the line")
{
    std::mt19937_64 generator(5);
    int found = 0;
    int none = 0;
    for (int k = 0; k < 1500; ++k) {
        const test::ForcedExample one = test::randomForced(generator);
        const ForcedSet set = forcedMotions(one.schedule, one.damping, one.forcing);
        INFO(describe(one.schedule) << " zeta " << one.damping.ratio << " " << set.detail);
        if (set.status == Status::undecided) {
            continue;
        }
        const test::Dense dense(one.schedule, one.damping.rho());
        Harmonic harmonic{.place = one.forcing.place,
                          .cycles = one.forcing.cycles,
                          .steps = steps(one.schedule),
                          .stepsPerCrossing = static_cast<double>(one.schedule.cells)};
        if (!dense.isRegular()) {  // classes that never fly: proved absent all the same
            REQUIRE(set.status == Status::none);
            continue;
        }
        constexpr int scan = 180;
        for (int phase = 0; phase < scan; ++phase) {
            harmonic.phase = 2.0 * std::numbers::pi * (phase + 0.5) / scan;
            const auto amplitude = dense.amplitude(excitationOf(harmonic), 0.0);
            const auto roughly = dense.amplitude(excitationOf(harmonic), 1e-9);
            // The point of the line with this phase.
            const double c = std::cos(harmonic.phase);
            const double s = std::sin(harmonic.phase);
            const double t = (c * set.direction[0] + s * set.direction[1]) /
                             (c * set.foot[0] + s * set.foot[1]) *
                             std::hypot(set.foot[0], set.foot[1]) *
                             std::hypot(set.foot[0], set.foot[1]);
            const bool isAhead = c * set.foot[0] + s * set.foot[1] > 0.0;
            const double slack = 1e-6 * (1.0 + std::abs(t));
            if (set.reason && set.conflict.empty()) {  // nothing moves u(L, 0)
                REQUIRE((!amplitude || std::abs(*amplitude) > 1e10));
                continue;
            }
            if (amplitude && *amplitude > 0.0) {
                REQUIRE(set.status == Status::found);
                REQUIRE(isAhead);
                REQUIRE(t >= set.low - slack);
                REQUIRE(t <= set.high + slack);
                REQUIRE(*amplitude ==
                        Approx(std::hypot(std::hypot(set.foot[0], set.foot[1]), t)).epsilon(1e-6));
            }
            if (set.status == Status::found && isAhead && t > set.low + slack &&
                t < set.high - slack) {
                REQUIRE(roughly);
            }
        }
        set.status == Status::found ? ++found : ++none;
    }
    CHECK(found > 100);
    CHECK(none > 500);
}

TEST_CASE("forced motions: every motion simulated for ten periods returns to itself")
{
    std::mt19937_64 generator(6);
    int motions = 0;
    for (int k = 0; k < 1500; ++k) {
        const test::ForcedExample one = test::randomForced(generator);
        const ForcedSet set = forcedMotions(one.schedule, one.damping, one.forcing);
        if (set.status != Status::found) {
            continue;
        }
        REQUIRE(set.leastAmplitude <= set.mostAmplitude);
        std::vector<ForcedMotion> some{leastAmplitudeMotion(set)};
        const double larger =
            std::min(1.7 * set.leastAmplitude, 0.5 * (set.leastAmplitude + set.mostAmplitude));
        for (ForcedMotion& motion : motionsOfAmplitude(set, larger)) {
            REQUIRE(motion.amplitude == Approx(larger).epsilon(1e-12));
            some.push_back(std::move(motion));
        }
        REQUIRE(some.size() <= 3);
        for (const ForcedMotion& motion : some) {
            INFO(describe(one.schedule) << " zeta " << one.damping.ratio);
            REQUIRE(motion.residual <= forcedTolerance);
            const std::int64_t cells = one.schedule.cells;
            const double size = amplitude(motion.state);
            const Waves start = wavesOf(motion.state);
            BarSimulation simulation(start, motion.damping, motion.excitation, {.mergeBelow = 0.0});
            const auto n = static_cast<double>(motion.excitation.steps());
            simulation.advance(10.0 * n);
            const double apart = (stretching(simulation.waves(), cells) - stretching(start, cells))
                                     .cwiseAbs()
                                     .maxCoeff();
            // Where the motion repels, rounding grows from period to period.
            const StabilityResult stability =
                stabilityOf(motion, {.periods = 10, .sizes = {1e-6}, .draws = 2});
            double growth = 1.0;
            for (const StabilityTrial& trial : stability.trials) {
                growth = std::max(growth, trial.end / trial.start);
            }
            REQUIRE(apart <= 1e-9 * std::max(1.0, size) * growth);
            REQUIRE(
                simulation.impulse() ==
                Approx(10.0 * motion.extremes.impulse).margin(1e-8 * std::max(1.0, size) * growth));
            ++motions;
        }
    }
    CHECK(motions > 200);
}

TEST_CASE("forced motions: the field of one is what the bar does event by event")
{
    std::mt19937_64 generator(21);
    int motions = 0;
    while (motions < 60) {
        const test::ForcedExample one = test::randomForced(generator);
        const ForcedSet set = forcedMotions(one.schedule, one.damping, one.forcing);
        if (set.status != Status::found) {
            continue;
        }
        const ForcedMotion motion = leastAmplitudeMotion(set);
        const std::int64_t cells = one.schedule.cells;
        INFO(describe(one.schedule));
        for (const std::int64_t factor : {1, 3}) {
            Schedule fine = one.schedule;
            fine.cells *= factor;
            for (Phase& phase : fine.phases) {
                phase.contact *= factor;
                phase.free *= factor;
            }
            const std::vector<Segment> segments{{.cells = fine.cells}};
            const Excitation excitation = refined(motion.excitation, factor);
            const Motion field(refined(motion.state, factor), fine, segments, motion.damping,
                               excitation);
            BarSimulation simulation(wavesOf(motion.state), motion.damping, motion.excitation,
                                     {.mergeBelow = 0.0});
            const double size = std::max(1.0, amplitude(motion.state));
            double impulse = 0.0;
            double peak = 0.0;
            for (std::int64_t m = 0; m < field.steps(); ++m) {
                const Eigen::VectorXd u = stretching(simulation.waves(), cells);
                const double base = excitation.baseDisplacement(m);
                REQUIRE(field.displacement(0, m) == Approx(base).margin(1e-12 * size));
                for (std::int64_t node = 0; m % factor == 0 && node <= cells; ++node) {
                    REQUIRE(field.displacement(node * factor, m) ==
                            Approx(base + u[node]).margin(1e-9 * size));
                }
                impulse += field.wallForce(m) / static_cast<double>(fine.cells);
                peak = std::max(peak, field.wallForce(m));
                simulation.advance(1.0 / static_cast<double>(factor));
            }
            CHECK(impulse == Approx(motion.extremes.impulse).margin(1e-8 * size));
            CHECK(peak == Approx(motion.extremes.peakForce).margin(1e-8 * size));
        }
        ++motions;
    }
}

TEST_CASE("forced motions: every absence is certain, and a tampered proof is not")
{
    std::mt19937_64 generator(8);
    int none = 0;
    int unmoved = 0;
    int undecided = 0;
    for (int k = 0; k < 3000; ++k) {
        const test::ForcedExample one = test::randomForced(generator);
        ForcedSet set = forcedMotions(one.schedule, one.damping, one.forcing);
        undecided += set.status == Status::undecided ? 1 : 0;
        if (set.status != Status::none) {
            REQUIRE_FALSE(isCertain(set));
            continue;
        }
        INFO(describe(one.schedule) << " zeta " << one.damping.ratio);
        REQUIRE(set.reason);
        REQUIRE(isCertain(set));
        if (set.conflict.empty()) {  // by the gap row alone, which no force moves
            REQUIRE(set.reason == Reason::gap);
            ++unmoved;
            continue;
        }
        REQUIRE(set.conflict.size() == 2);
        ++none;
        const ForcedSet whole = set;
        set.conflict.pop_back();
        REQUIRE_FALSE(isCertain(set));
        set.conflict = {whole.conflict.front(), whole.conflict.front()};
        REQUIRE_FALSE(isCertain(set));
        set.conflict = {whole.conflict.front(), {ForcedRule::penetration, steps(one.schedule)}};
        REQUIRE_FALSE(isCertain(set));
    }
    CHECK(none > 1500);
    CHECK(unmoved > 0);
    CHECK(undecided < 150);
}

TEST_CASE("forced motions: no conflict holds where there are motions, whatever rows are named")
{
    std::mt19937_64 generator(12);
    int tried = 0;
    for (int k = 0; k < 400; ++k) {
        const test::ForcedExample one = test::randomForced(generator);
        ForcedSet set = forcedMotions(one.schedule, one.damping, one.forcing);
        if (set.status != Status::found) {
            continue;
        }
        const std::int64_t n = steps(one.schedule);
        const std::int64_t contact = one.schedule.phases.front().contact;
        set.status = Status::none;  // what a liar would say
        for (std::int64_t i = 0; i < n; ++i) {
            for (std::int64_t j = 0; j < i; ++j) {
                const auto at = [contact](std::int64_t m) {
                    return ForcedCondition{
                        m < contact ? ForcedRule::pressure : ForcedRule::penetration, m};
                };
                set.conflict = {at(i), at(j)};
                REQUIRE_FALSE(isCertain(set));
                ++tried;
            }
        }
    }
    CHECK(tried > 10'000);
}

TEST_CASE("forced motions: as damping fades they tend to free motions")
{
    int met = 0;
    for (const Schedule& schedule :
         {onePhase(30, 15, 90), onePhase(12, 6, 36), onePhase(30, 12, 96), onePhase(30, 16, 88),
          onePhase(20, 10, 60)}) {
        const OnePhaseSet free = onePhaseSet(schedule);
        REQUIRE_FALSE(free.reason);
        REQUIRE(free.contact == Contact::pressing);
        double last = 0.0;
        for (const double ratio : {1e-3, 1e-5, 1e-7}) {
            const ForcedSet set = forcedMotions(schedule, {ratio}, {});
            INFO(describe(schedule) << " zeta " << ratio << " " << set.detail);
            if (set.status != Status::found) {
                continue;
            }
            const ForcedMotion motion = leastAmplitudeMotion(set);
            const std::vector<double> amplitudes = amplitudesOf(free, motion.state);
            CHECK(distanceOutside(free.set, amplitudes) <= 1e3 * ratio);
            CHECK(motion.residual <= forcedTolerance);
            // Hardly any force is needed to keep a bar going that loses hardly anything.
            CHECK(motion.amplitude < 1e3 * ratio);
            last = ratio;
            const State nearest = motionOf(free, nearestAmplitudes(free.set, amplitudes));
            CHECK((nearest.a - motion.state.a).cwiseAbs().maxCoeff() <
                  1e4 * ratio * amplitude(nearest));
        }
        met += last == 1e-7 ? 1 : 0;
    }
    CHECK(met >= 3);
}

TEST_CASE("forced motions: an excitation of any shape fixes its own size")
{
    std::mt19937_64 generator(9);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    int found = 0;
    for (int k = 0; k < 4000; ++k) {
        const Schedule schedule = onePhase(4, 1 + k % 4, 12 + k % 5);
        Forcing forcing{k % 2 == 0 ? Excited::tip : Excited::base, 1, {}};
        for (std::int64_t m = 0; m < steps(schedule); ++m) {
            forcing.shape.push_back(value(generator));
        }
        const Damping damping{0.1};
        const ForcedSet set = forcedMotions(schedule, damping, forcing);
        INFO(describe(schedule) << " " << k << " " << set.detail);
        const test::Dense dense(schedule, damping.rho());
        const auto amplitude = dense.amplitude({forcing.place, forcing.shape, 4.0}, 1e-9);
        REQUIRE(set.status != Status::undecided);
        REQUIRE((set.status == Status::found) == amplitude.has_value());
        if (!amplitude) {
            REQUIRE(isCertain(set));
            continue;
        }
        ++found;
        CHECK(set.kind == ForcedKind::point);
        CHECK(set.foot[0] == Approx(*amplitude).epsilon(1e-9));
        CHECK(leastAmplitudeMotion(set).residual <= forcedTolerance);
        CHECK(motionsOfAmplitude(set, std::abs(*amplitude) * 1.5).empty());
    }
    CHECK(found > 5);
}

TEST_CASE("forced motions: a walk sees what is wrong with a state")
{
    const ForcedSet set = forcedMotions(onePhase(30, 12, 96), dampingOfRho(0.9), {});
    const ForcedMotion motion = motionsOfAmplitude(set, 0.25).front();
    const auto worst = [&](const State& state, std::int64_t contact, const Excitation& excitation) {
        return verifyBar(state, onePhase(30, contact, 108 - contact), {}, 1e-9, motion.damping,
                         excitation)
            .seen.residuals.worst();
    };
    CHECK(worst(motion.state, 12, motion.excitation) < 1e-12);
    State wrong = motion.state;
    wrong.a[3] += 1e-6;
    CHECK(worst(wrong, 12, motion.excitation) > 1e-8);
    CHECK(worst(motion.state, 13, motion.excitation) > 1e-6);
    CHECK(worst(motion.state, 11, motion.excitation) > 1e-6);
    Excitation other = motion.excitation;
    other.values[50] += 1e-6;
    CHECK(worst(motion.state, 12, other) > 1e-9);
    wrong.a[3] = NAN;
    CHECK(std::isinf(worst(wrong, 12, motion.excitation)));
}

TEST_CASE("forced motions: wrong use is refused by name")
{
    const Schedule schedule = onePhase(30, 12, 96);
    const Damping damping{0.03};
    CHECK_THROWS_WITH(forcedMotions(schedule, {-0.1}, {}), containsText("damping ratio"));
    CHECK_THROWS_WITH(forcedMotions(schedule, damping, {}, {0.0}), containsText("strain limit"));
    CHECK_THROWS_WITH(forcedMotions(schedule, damping, {Excited::tip, 55, {}}),
                      containsText("cycles"));
    CHECK_THROWS_WITH(forcedMotions(schedule, damping, {Excited::tip, 0, {}}),
                      containsText("cycles"));
    CHECK_THROWS_WITH(
        forcedMotions(schedule, damping, {Excited::tip, 1, {1.0, 2.0, 3.0, 4.0, 5.0}}),
        containsText("divisors"));
    CHECK_THROWS_WITH(forcedMotions(schedule, damping, {Excited::tip, 1, {1.0, NAN}}),
                      containsText("finite"));
    CHECK_THROWS_WITH(forcedMotions(schedule, damping, {Excited::tip, 1, {0.0, 0.0}}),
                      containsText("other than 0"));
    CHECK_THROWS_WITH(forcedMotions(onePhase(30, 12, maxForcedSteps), damping, {}),
                      containsText("steps"));
    const ForcedSet set = forcedMotions(schedule, damping, {});
    CHECK_THROWS_WITH(motionsOfAmplitude(set, 0.0), containsText("amplitude"));
    CHECK_THROWS_WITH(motionsOfAmplitude(set, NAN), containsText("amplitude"));
    CHECK_THROWS_WITH(motionAt(set, set.high + 1.0), containsText("t ="));
    const ForcedSet none = forcedMotions(onePhase(30, 50, 58), damping, {});
    REQUIRE(none.status == Status::none);
    CHECK_THROWS_AS(leastAmplitudeMotion(none), std::invalid_argument);
}

TEST_CASE("forced motions: a walk finds no motion in a bar without waves, work that nothing takes")
{
    const Schedule schedule = onePhase(4, 2, 14);
    const Excitation push{Excited::tip, std::vector<double>(16, 5.0), 4.0};
    State state{Eigen::VectorXd::Zero(4), Eigen::VectorXd::Zero(4)};
    const Excitation none{Excited::tip, std::vector<double>(16, 0.0), 4.0};
    const auto seen = [&](const Excitation& excitation) {
        return verifyBar(state, schedule, {}, 1e-9, {}, excitation).seen.residuals;
    };
    CHECK(std::isinf(seen(none).worst()));
    // Hardly a wave: all the energy comes from the force, and nothing damps. For 8 steps of the
    // flight it works, for 6, with waves that are back, as much is taken in each.
    state.a[1] = 1e-3;
    const Network bar = networkOf(schedule.stops, {}, 4, {});
    CHECK(walk(bar, claimOf(bar, state, schedule, push)).balance == Approx(1.0 / 7).epsilon(1e-3));
    CHECK(seen(push).periodicity > 0.1);
}

TEST_CASE("forced motions: on the second stop a walk sees what it sees on the wall, mirrored")
{
    const Stops stops{1, Fraction{1, 1}};
    int met = 0;
    for (std::int64_t n = 40; n < 60; ++n) {
        for (std::int64_t contact = 1; contact < 12; ++contact) {
            const ForcedSet right =
                forcedMotions({10, {{contact, n - contact, Stop::right}}, stops}, {0.05}, {});
            const ForcedSet left =
                forcedMotions({10, {{contact, n - contact, Stop::left}}, stops}, {0.05}, {});
            REQUIRE(right.status == left.status);
            if (right.status != Status::found) {
                continue;
            }
            const Extremes one = leastAmplitudeMotion(right).extremes;
            const Extremes other = leastAmplitudeMotion(left).extremes;
            CHECK(other.approachSpeed == Approx(one.approachSpeed));
            CHECK(other.impulse == Approx(one.impulse));
            CHECK(other.contactTime == Approx(one.contactTime));
            CHECK(other.peakForce == Approx(one.peakForce));
            CHECK(other.peakTension == Approx(one.peakCompression));
            met += one.approachSpeed > 0.1 ? 1 : 0;
        }
    }
    CHECK(met > 5);
}
