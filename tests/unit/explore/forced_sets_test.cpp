// Forced motions beyond a line: several contact phases, waves that nothing damps, limits.

#include <algorithm>
#include <cmath>
#include <random>

#include "catch.hpp"
#include "forced_case.hpp"
#include "forced_polytope.hpp"
#include "forced_rows.hpp"
#include "forced_support.hpp"
#include "has_solver.hpp"
#include "signorini/one_phase_set.hpp"
#include "signorini/response.hpp"
#include "support.hpp"

using namespace signorini;
using test::onePhase;

TEST_CASE("forced motions, two contacts: isolated points that a dense solver confirms, or proofs")
{
    std::mt19937_64 generator(21);
    int found = 0;
    int none = 0;
    int undecided = 0;
    for (int k = 0; k < 6000; ++k) {
        test::ForcedExample one = test::randomForced(generator, 2);
        one.schedule.cells = std::min<std::int64_t>(one.schedule.cells, 5);
        const ForcedSet set = forcedMotions(one.schedule, one.damping, one.forcing);
        INFO(describe(one.schedule) << " zeta " << one.damping.ratio << " " << set.detail);
        undecided += set.status == Status::undecided ? 1 : 0;
        if (set.status == Status::none) {
            REQUIRE(isCertain(set));
            if (!set.conflict.empty()) {
                ForcedSet tampered = set;
                tampered.conflict.pop_back();
                REQUIRE_FALSE(isCertain(tampered));
            }
            ++none;
        }
        if (set.status != Status::found) {
            continue;
        }
        const ForcedMotion motion = leastAmplitudeMotion(set);
        REQUIRE(motion.residual <= forcedTolerance);
        const test::Dense dense(one.schedule, one.damping.rho());
        if (dense.isRegular()) {
            const auto broken = dense.broken(motion.excitation);
            REQUIRE(std::abs(broken.gap) < 1e-8);
            REQUIRE(broken.closure < 1e-8);
            REQUIRE(broken.rows < 1e-8);
        }
        REQUIRE(test::driftInTenPeriods(motion) <=
                1e-9 * std::max(1.0, amplitude(motion.state)) * test::growth(motion));
        ++found;
    }
    CHECK(found > 20);
    CHECK(none > 5000);
    CHECK(undecided < 20);
}

TEST_CASE(
    "forced motions, two contacts: a motion of one contact in two periods, and one of its own")
{
    // (12, 96) twice, with two cycles: the line of the half, point by point.
    const Damping damping = dampingOfRho(0.9);
    const ForcedSet half = forcedMotions(onePhase(30, 12, 96), damping, {});
    const ForcedSet twice =
        forcedMotions({30, {{12, 96}, {12, 96}}}, damping, {Excited::tip, 2, {}});
    REQUIRE(half.status == Status::found);
    REQUIRE(twice.status == Status::found);
    CHECK(twice.kind == ForcedKind::segment);
    CHECK(twice.leastAmplitude == Approx(half.leastAmplitude).epsilon(1e-9));
    CHECK(twice.mostAmplitude == Approx(half.mostAmplitude).epsilon(1e-9));
    const auto one = motionsOfAmplitude(half, 0.25);
    const auto two = motionsOfAmplitude(twice, 0.25);
    REQUIRE(one.size() == two.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
        CHECK(two[k].extremes.impulse == Approx(2.0 * one[k].extremes.impulse));
    }
}

TEST_CASE("forced motions: closed form and linear programs leave the same of a line")
{
    if (!test::hasSimplex()) {
        return;
    }
    std::mt19937_64 generator(22);
    int compared = 0;
    for (int k = 0; k < 600; ++k) {
        const test::ForcedExample one = test::randomForced(generator);
        const ForcedSet set = forcedMotions(one.schedule, one.damping, one.forcing);
        if (set.freeWaves > 0 || set.status == Status::undecided) {
            continue;
        }
        INFO(describe(one.schedule) << " zeta " << one.damping.ratio);
        const auto shapes = shapesOf(one.forcing, one.schedule.cells, steps(one.schedule));
        ForcedWaves waves(one.schedule.cells, one.damping.rho(), shapes);
        waves.setPhases(one.schedule.phases);
        const ForcedPolytope polytope =
            forcedPolytope(waves.rows(std::numeric_limits<double>::infinity()), {true, 0});
        INFO(polytope.detail);
        if (set.status == Status::none) {
            CHECK(polytope.corners.empty());
            CHECK((polytope.conflict || set.conflict.empty()));  // which nothing moves has no rows
            continue;
        }
        REQUIRE_FALSE(polytope.conflict);
        REQUIRE(polytope.isBounded == (set.kind != ForcedKind::ray));
        if (polytope.isBounded && set.mostAmplitude < 100.0) {
            const auto [least, most] = amplitudesOf(polytope);
            CHECK(least == Approx(set.leastAmplitude).epsilon(1e-6));
            CHECK(most == Approx(set.mostAmplitude).epsilon(1e-6));
            ++compared;
        }
    }
    CHECK(compared > 20);
}

TEST_CASE("forced motions without damping: what is free needs no force, the others some")
{
    if (!test::hasSimplex()) {
        return;
    }
    int free = 0;
    int forced = 0;
    int none = 0;
    int undecided = 0;
    for (const Excited place : {Excited::tip, Excited::base}) {
        for (const std::int64_t cells : {3, 5, 6}) {
            for (std::int64_t n = 2 * cells + 1; n < 5 * cells; ++n) {
                for (std::int64_t contact = 1; contact < std::min(n, 2 * cells); ++contact) {
                    const Schedule schedule = onePhase(cells, contact, n - contact);
                    const ForcedSet set = forcedMotions(schedule, {}, {place, 1, {}});
                    INFO(describe(schedule) << " " << set.detail);
                    const OnePhaseSet autonomous = onePhaseSet(schedule);
                    if (set.status == Status::undecided) {
                        ++undecided;
                    } else if (set.status == Status::none) {
                        REQUIRE(autonomous.reason);
                        REQUIRE(isCertain(set));
                        ++none;
                    } else {
                        const ForcedMotion motion = leastAmplitudeMotion(set);
                        REQUIRE(motion.residual <= forcedTolerance);
                        REQUIRE(test::driftInTenPeriods(motion) <= 1e-9 * test::growth(motion));
                        REQUIRE((set.leastAmplitude < 1e-9) == !autonomous.reason);
                        if (!autonomous.reason) {
                            CHECK(distanceOutside(autonomous.set,
                                                  amplitudesOf(autonomous, motion.state)) < 1e-9);
                        }
                        ++(autonomous.reason ? forced : free);
                    }
                }
            }
        }
    }
    CHECK(free > 80);
    CHECK(forced > 40);
    CHECK(none > 250);
    CHECK(undecided == 0);
}

TEST_CASE("forced motions without damping: a wall that need not push, whatever the excitation")
{
    // N = 6, n = 16, a contact of 4 steps: F + 2p is 0 in contact for every C and S, so it moves
    // as without a wall, with a tip that rests at g for those steps.
    const ForcedSet set = forcedMotions(onePhase(6, 4, 12), {}, {});
    REQUIRE(set.status == Status::found);
    const ForcedMotion motion = leastAmplitudeMotion(set);
    CHECK(motion.residual < 1e-12);
    CHECK(motion.extremes.impulse == Approx(0.0).margin(1e-12));
    const test::Dense dense(set.schedule, 1.0);
    REQUIRE(dense.isRegular());
    const auto broken = dense.broken(motion.excitation);
    CHECK(std::abs(broken.gap) < 1e-12);
    CHECK(broken.rows < 1e-12);
    CHECK(test::driftInTenPeriods(motion) < 1e-9);
    for (const Excited place : {Excited::tip, Excited::base}) {
        for (const std::int64_t contact : {4, 5, 6}) {
            if (contact == 4 || test::hasSimplex()) {
                INFO("n_c = " << contact);
                CHECK(
                    forcedMotions(onePhase(6, contact, 16 - contact), {}, {place, 1, {}}).status !=
                    Status::undecided);
            }
        }
    }
}

TEST_CASE("forced motions without damping: the paper's case bears no force at all")
{
    if (!test::hasSimplex()) {
        return;
    }
    const ForcedSet set = forcedMotions(onePhase(12, 6, 36), {}, {});
    REQUIRE(set.status == Status::found);
    CHECK(set.kind == ForcedKind::polytope);
    CHECK(set.freeWaves == 6);
    CHECK(set.mostAmplitude < 1e-9);
    CHECK(leastAmplitudeMotion(set).residual < 1e-12);
    // Resonance: whatever the force, it does work on some wave.
    CHECK(motionsOfAmplitude(set, 0.1).empty());
    const AmplitudeExclusion exclusion = exclusionOf(set, 0.1);
    CHECK(exclusion.isCertain);
    REQUIRE(exclusion.conflict.size() == 2);
    CHECK(exclusion.conflict.front().rule == ForcedRule::work);
}

TEST_CASE("forced motions without damping: every amplitude of the range has a motion")
{
    if (!test::hasSimplex()) {
        return;
    }
    int motions = 0;
    for (std::int64_t contact = 1; contact < 9; ++contact) {
        for (std::int64_t n = 11; n < 25; ++n) {
            const ForcedSet set = forcedMotions(onePhase(5, contact, n - contact), {}, {});
            if (set.status != Status::found || !(set.mostAmplitude > set.leastAmplitude + 1e-6)) {
                continue;
            }
            const double most = std::min(set.mostAmplitude, 1.0 + 2.0 * set.leastAmplitude);
            for (const double part : {0.1, 0.5, 0.9}) {
                const double wanted = std::lerp(set.leastAmplitude, most, part);
                const auto some = motionsOfAmplitude(set, wanted);
                INFO(describe(set.schedule) << " " << name(set.kind) << " " << wanted);
                if (set.kind == ForcedKind::polytope) {
                    REQUIRE(some.size() == 1);
                }
                for (const ForcedMotion& motion : some) {
                    CHECK(motion.amplitude == Approx(wanted).epsilon(1e-8));
                    CHECK(motion.residual <= forcedTolerance);
                    ++motions;
                }
            }
        }
    }
    CHECK(motions > 40);
}

TEST_CASE(
    "forced motions: an amplitude outside the range is excluded for certain, one inside never")
{
    std::mt19937_64 generator(23);
    int excluded = 0;
    for (int k = 0; k < 1500; ++k) {
        const test::ForcedExample one = test::randomForced(generator, k % 5 == 0 ? 2 : 1);
        const ForcedSet set = forcedMotions(one.schedule, one.damping, one.forcing);
        if (set.status != Status::found || set.freeWaves > 0) {
            continue;
        }
        INFO(describe(one.schedule) << " zeta " << one.damping.ratio);
        for (const double beyond :
             {0.5 * set.leastAmplitude, 0.999 * set.leastAmplitude, 1.001 * set.mostAmplitude}) {
            if (std::isfinite(beyond)) {
                CHECK(motionsOfAmplitude(set, beyond).empty());
                CHECK(exclusionOf(set, beyond).isCertain);
                ++excluded;
            }
        }
        for (const double part : {0.0, 0.3, 1.0}) {
            const double inside = std::lerp(
                set.leastAmplitude, std::min(set.mostAmplitude, 9.0 * set.leastAmplitude), part);
            if (!motionsOfAmplitude(set, inside).empty()) {
                CHECK_FALSE(exclusionOf(set, inside).isCertain);
            }
        }
    }
    CHECK(excluded > 300);
}

TEST_CASE("forced motions: a limit on compression cuts the line where -min s = 2 max p reaches it")
{
    const Damping damping = dampingOfRho(0.9);
    const Schedule schedule = onePhase(30, 12, 96);
    const ForcedSet all = forcedMotions(schedule, damping, {});
    const ForcedMotion least = leastAmplitudeMotion(all);
    const double strain = 1.2 * least.extremes.peakCompression;
    const ForcedSet cut = forcedMotions(schedule, damping, {}, {strain});
    REQUIRE(cut.status == Status::found);
    CHECK(cut.mostAmplitude < all.mostAmplitude);
    for (const double t : {cut.low, 0.5 * (cut.low + cut.high), cut.high}) {
        CHECK(motionAt(cut, t).extremes.peakCompression <= strain * (1.0 + 1e-12));
    }
    const double atEnds = std::max(motionAt(cut, cut.low).extremes.peakCompression,
                                   motionAt(cut, cut.high).extremes.peakCompression);
    CHECK(atEnds == Approx(strain));
    // Too little for any.
    const ForcedSet none = forcedMotions(schedule, damping, {}, {0.3 * strain});
    REQUIRE(none.status == Status::none);
    CHECK(none.reason == Reason::constraints);
    CHECK(isCertain(none));
    if (test::hasSimplex()) {
        const ForcedSet held = forcedMotions(onePhase(12, 6, 36), {}, {}, {1.9});
        CHECK(held.status == Status::none);  // the flattest has 2, energy 4 E_1
        CHECK(isCertain(held));
        CHECK(forcedMotions(onePhase(12, 6, 36), {}, {}, {2.1}).status == Status::found);
    }
}

TEST_CASE(
    "forced motions: a limit on compression beside a moving base leaves the part that keeps it")
{
    int cutOff = 0;
    int refused = 0;
    for (const std::int64_t cells : {4, 6, 12}) {
        for (std::int64_t contact = 1; contact <= cells; ++contact) {
            const Schedule schedule = onePhase(cells, contact, 4 * cells - contact);
            const Damping damping = dampingOfRho(0.9);
            const Forcing base{Excited::base, 1, {}};
            const ForcedSet all = forcedMotions(schedule, damping, base);
            if (all.status != Status::found || all.kind != ForcedKind::segment) {
                continue;
            }
            CAPTURE(cells, contact);
            // The whole line, motion by motion, by the waves of one bar.
            constexpr int parts = 400;
            std::vector<double> strains;
            for (int k = 0; k <= parts; ++k) {
                strains.push_back(motionAt(all, all.low + (all.high - all.low) * k / parts)
                                      .extremes.peakCompression);
            }
            const auto [least, most] = std::minmax_element(strains.begin(), strains.end());
            const double limit = 0.5 * (*least + *most);
            const ForcedSet cut = forcedMotions(schedule, damping, base, {limit});
            REQUIRE(cut.status == Status::found);
            REQUIRE(cut.kind == ForcedKind::segment);
            for (const double t : {cut.low, 0.5 * (cut.low + cut.high), cut.high}) {
                CHECK(motionAt(cut, t).extremes.peakCompression <= limit * (1.0 + 1e-9));
            }
            double lowest = all.mostAmplitude;
            double highest = 0.0;
            for (int k = 0; k <= parts; ++k) {
                if (strains[static_cast<std::size_t>(k)] <= limit) {
                    const double t = all.low + (all.high - all.low) * k / parts;
                    const double amplitude = motionAt(all, t).amplitude;
                    lowest = std::min(lowest, amplitude);
                    highest = std::max(highest, amplitude);
                }
            }
            const double part = (all.mostAmplitude - all.leastAmplitude) / parts;
            CHECK(cut.leastAmplitude <= lowest * (1.0 + 1e-9));
            CHECK(cut.mostAmplitude >= highest * (1.0 - 1e-9));
            CHECK(cut.leastAmplitude >= lowest - 2.0 * part);
            CHECK(cut.mostAmplitude <= highest + 2.0 * part);
            cutOff += cut.mostAmplitude < all.mostAmplitude - part ? 1 : 0;
            const ForcedSet none = forcedMotions(schedule, damping, base, {0.9 * *least});
            REQUIRE(none.status == Status::none);
            CHECK(none.reason == Reason::constraints);
            CHECK(isCertain(none));
            ++refused;
        }
    }
    CHECK(cutOff > 0);
    CHECK(refused > 3);
}

TEST_CASE("forced motions: strains are those of the cells, step by step")
{
    std::mt19937_64 generator(24);
    int compared = 0;
    for (int k = 0; k < 300; ++k) {
        const test::ForcedExample one = test::randomForced(generator);
        const ForcedSet set = forcedMotions(one.schedule, one.damping, one.forcing);
        if (set.status != Status::found || set.freeWaves > 0) {
            continue;
        }
        const ForcedMotion motion = leastAmplitudeMotion(set);
        BarSimulation simulation(wavesOf(motion.state), motion.damping, motion.excitation,
                                 {.mergeBelow = 0.0, .recordsTip = false});
        double compression = -1e300;
        double tension = -1e300;
        // Waves of two pieces meet also inside a step: halves see every pair of neighbours.
        const std::int64_t cells = one.schedule.cells;
        for (std::int64_t m = 0; m < 2 * steps(one.schedule); ++m) {
            const Eigen::VectorXd u = stretching(simulation.waves(), 4 * cells);
            for (Eigen::Index i = 0; i < 4 * cells; ++i) {
                const double s = (u[i + 1] - u[i]) * 4.0 * static_cast<double>(cells);
                compression = std::max(compression, -s);
                tension = std::max(tension, s);
            }
            simulation.advance(0.5);
        }
        const double size = 1e-6 * std::max(1.0, amplitude(motion.state)) * test::growth(motion);
        INFO(describe(one.schedule) << " zeta " << one.damping.ratio);
        CHECK(motion.extremes.peakCompression == Approx(compression).margin(size));
        CHECK(motion.extremes.peakTension == Approx(tension).margin(size));
        ++compared;
    }
    CHECK(compared > 30);
}

TEST_CASE("response: nothing stays undecided where classes of steps are always in contact")
{
    if (!test::hasSimplex()) {
        return;
    }
    std::int64_t held = 0;
    for (const Excited place : {Excited::tip, Excited::base}) {
        for (const std::int64_t n : {80, 84, 90, 100, 102, 120, 140, 160}) {
            for (std::int64_t contact = n / 2; contact < n; ++contact) {
                const ForcedSet set =
                    forcedMotions(onePhase(30, contact, n - contact), {0.02}, {place, 1, {}});
                INFO(describe(set.schedule) << " " << set.detail);
                CHECK(set.status != Status::undecided);
                held += set.freeWaves > 0 ? 1 : 0;
            }
        }
    }
    CHECK(held > 200);
}

TEST_CASE("forced motions: a base that is displaced is no mirrored one, though its velocity is")
{
    const Schedule schedule{4, {{2, 10, Stop::right}, {2, 10, Stop::left}}, {1, Fraction{1, 1}}};
    const ForcedSet set = forcedMotions(schedule, {0.1}, {Excited::base, 1, {1.0}});
    CHECK(set.status == Status::none);
    CHECK(isCertain(set));
}
