// Forced motions with gaps of any sign and a second stop.

#include <cmath>
#include <random>

#include "catch.hpp"
#include "forced_case.hpp"
#include "forced_oracle.hpp"
#include "has_solver.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/response.hpp"

using namespace signorini;

namespace {

bool rests(const Schedule& schedule)
{
    return schedule.stops.right == 0 &&
           std::all_of(schedule.phases.begin(), schedule.phases.end(),
                       [](const Phase& phase) { return phase.stop == Stop::right; });
}

/// The motion of least amplitude, or where there is none one of the least that all have.
ForcedMotion someMotion(const ForcedSet& set)
{
    if (!rests(set.schedule)) {
        return leastAmplitudeMotion(set);
    }
    const auto motions = motionsOfAmplitude(set, std::min(0.1, 0.3 * set.mostAmplitude));
    REQUIRE_FALSE(motions.empty());
    return motions.back();
}

struct Count {
    int found = 0;
    int none = 0;
    int undecided = 0;
    int near = 0;  ///< too near to the edge for a solver with tolerances
};

/// Holds the verdict against the oracle, and a motion against the simulation.
void compare(const test::ForcedExample& one, Count& count)
{
    const ForcedSet set = forcedMotions(one.schedule, one.damping, one.forcing);
    INFO(
        describe(one.schedule) << " stops " << one.schedule.stops.right << " "
                               << (one.schedule.stops.left ? one.schedule.stops.left->value() : 0.0)
                               << " zeta " << one.damping.ratio << " cycles " << one.forcing.cycles
                               << " " << name(one.forcing.place) << " " << set.detail);
    if (set.status == Status::undecided) {
        ++count.undecided;
        return;
    }
    const auto shapes = shapesOf(one.forcing, one.schedule.cells, steps(one.schedule));
    const test::ForcedOracle oracle(one.schedule, one.damping.rho(), shapes);
    constexpr double edge = 1e-6;
    if (set.status == Status::none) {
        REQUIRE(isCertain(set));
        if (!set.conflict.empty()) {
            ForcedSet tampered = set;
            tampered.conflict.clear();
            REQUIRE_FALSE(isCertain(tampered));
        }
        if (rests(one.schedule)) {
            REQUIRE_FALSE(oracle.reach() > edge);
        } else if (const double missed = oracle.leastMissed(); missed < edge) {
            ++count.near;
        } else {
            REQUIRE((std::isnan(missed) || missed > 0.0));
        }
        ++count.none;
        return;
    }
    ++count.found;
    const ForcedMotion motion = someMotion(set);
    REQUIRE(motion.residual <= forcedTolerance);
    REQUIRE(test::driftInTenPeriods(motion) <=
            1e-9 * std::max(1.0, amplitude(motion.state)) * test::growth(motion));
    if (rests(one.schedule)) {
        REQUIRE(oracle.reach() > 0.0);
    } else if (const double missed = oracle.leastMissed(); !(missed < edge)) {
        ++count.near;
    }
}

}  // namespace

TEST_CASE("forced scenes, one contact: an independent program agrees, motions return")
{
    if (!test::hasSimplex()) {
        return;
    }
    std::mt19937_64 generator(31);
    for (const Stops& stops : test::forcedStops()) {
        Count count;
        for (int k = 0; k < 400; ++k) {
            test::ForcedExample one = test::randomForced(generator);
            one.schedule.cells = std::min<std::int64_t>(one.schedule.cells, 6);
            one.schedule.stops = stops;
            if (stops.left && k % 2 == 1) {
                one.schedule.phases.front().stop = Stop::left;
            }
            compare(one, count);
        }
        INFO("stops " << stops.right << " " << (stops.left ? stops.left->value() : 0.0));
        INFO(count.found << " found, " << count.none << " none, " << count.undecided
                         << " undecided, " << count.near << " near");
        CHECK(count.found > (stops.left ? 5 : 20));
        CHECK(count.none > 100);
        CHECK(count.undecided < 40);
        CHECK(count.near < 4);
    }
}

TEST_CASE("forced scenes: waves that are always held bear any amplitude where the bar is pressed")
{
    if (!test::hasSimplex()) {
        return;
    }
    // A corner that stands for infinity once made rows look met that were not.
    Count count;
    for (const std::int64_t contact : {8, 10, 12, 13, 19}) {
        const Schedule schedule{10, {{contact, 20 - contact}}, {.right = -1}};
        compare({.schedule = schedule, .damping = {0.02}, .forcing = {}}, count);
        const ForcedSet set = forcedMotions(schedule, {0.02}, {});
        REQUIRE(set.status == Status::found);
        for (const double amplitude : {0.1, 2.0}) {
            const auto motions = motionsOfAmplitude(set, amplitude);
            REQUIRE_FALSE(motions.empty());
            CHECK(motions.front().residual <= forcedTolerance);
            CHECK(test::driftInTenPeriods(motions.front()) < 1e-9);
        }
    }
    CHECK(count.found == 5);
    CHECK(count.near == 0);
}

TEST_CASE("forced scenes, two contacts, each on its stop: an independent program agrees")
{
    if (!test::hasSimplex()) {
        return;
    }
    std::mt19937_64 generator(32);
    for (const Stops& stops : test::forcedStops()) {
        if (!stops.left) {
            continue;
        }
        Count count;
        for (int k = 0; k < 600; ++k) {
            test::ForcedExample one = test::randomForced(generator, 2);
            one.schedule.cells = std::min<std::int64_t>(one.schedule.cells, 4);
            one.schedule.stops = stops;
            one.schedule.phases.back().stop = Stop::left;
            if (k % 2 == 0) {
                one.schedule.phases.back() = one.schedule.phases.front();
                one.schedule.phases.back().stop = Stop::left;
                one.forcing.cycles = 1;
            }
            compare(one, count);
        }
        INFO("stops " << stops.right << " " << stops.left->value());
        INFO(count.found << " found, " << count.none << " none, " << count.undecided
                         << " undecided, " << count.near << " near");
        CHECK(count.none > 200);
        CHECK(count.undecided < 40);
        CHECK(count.near < 6);
        if (stops == Stops{1, Fraction{1, 1}}) {
            CHECK(count.found > 20);
        }
    }
}

TEST_CASE("forced scenes without damping: what is free needs no force")
{
    if (!test::hasSimplex()) {
        return;
    }
    for (const Stops& stops : {Stops{-1, {}}, Stops{1, Fraction{1, 1}}, Stops{1, Fraction{2, 3}}}) {
        int free = 0;
        Count count;
        for (const std::int64_t cells : {3, 4}) {
            for (std::int64_t n = 2 * cells + 1; n < 5 * cells; ++n) {
                for (std::int64_t contact = 1; contact < std::min(n, 2 * cells); ++contact) {
                    const test::ForcedExample one{
                        {cells, {{contact, n - contact}}, stops}, {}, {Excited::tip, 1, {}}};
                    compare(one, count);
                    FindOptions options;
                    options.scene.bar.gap = stops.right;
                    if (stops.left) {
                        options.scene.secondStop = stops.left->value();
                    }
                    const PeriodicResult autonomous = findPeriodic(one.schedule, options);
                    const ForcedSet set = forcedMotions(one.schedule, {}, one.forcing);
                    if (set.status == Status::found) {
                        REQUIRE((set.leastAmplitude < 1e-8) ==
                                (autonomous.status == Status::found));
                        free += autonomous.status == Status::found ? 1 : 0;
                    } else if (set.status == Status::none) {
                        REQUIRE(autonomous.status == Status::none);
                    }
                }
            }
        }
        INFO("stops " << stops.right << " " << (stops.left ? stops.left->value() : 0.0));
        INFO(count.found << " found, " << count.none << " none, " << count.undecided
                         << " undecided, " << count.near << " near");
        CHECK(free >= (stops.left == Fraction{2, 3} ? 0 : 5));
        CHECK(count.none > 20);
        CHECK(count.undecided < 20);
    }
}

TEST_CASE("forced scenes: stops at equal distances leave a segment of mirrored motions")
{
    const Stops both{1, Fraction{1, 1}};
    int segments = 0;
    for (std::int64_t half = 20; half < 60; ++half) {
        for (std::int64_t contact = 1; contact < 10; ++contact) {
            const Schedule schedule{
                10,
                {{contact, half - contact, Stop::right}, {contact, half - contact, Stop::left}},
                both};
            const ForcedSet set = forcedMotions(schedule, {0.05}, {});
            if (set.status != Status::found || set.kind != ForcedKind::segment) {
                continue;
            }
            ++segments;
            const double amplitude = 0.5 * (set.leastAmplitude + set.mostAmplitude);
            for (const ForcedMotion& motion : motionsOfAmplitude(set, amplitude)) {
                CHECK(motion.residual <= forcedTolerance);
                CHECK(motion.extremes.lowestTip == Approx(-1.0));
                CHECK(motion.state.a.size() == 10);
            }
        }
    }
    CHECK(segments > 20);
}

TEST_CASE("forced scenes: without a gap motions scale with the amplitude, and rest is none")
{
    int cones = 0;
    for (std::int64_t n = 30; n < 60; ++n) {
        for (std::int64_t contact = 1; contact < n; ++contact) {
            const ForcedSet set =
                forcedMotions({10, {{contact, n - contact}}, {.right = 0}}, {0.05}, {});
            if (set.status != Status::found || set.kind != ForcedKind::ray) {
                continue;
            }
            ++cones;
            CHECK(set.leastAmplitude == 0.0);
            CHECK_THROWS_AS(leastAmplitudeMotion(set), std::invalid_argument);
            const auto one = motionsOfAmplitude(set, 1e-6);
            const auto other = motionsOfAmplitude(set, 1e3);
            REQUIRE(one.size() == other.size());
            REQUIRE_FALSE(one.empty());
            CHECK(other[0].extremes.impulse == Approx(1e9 * one[0].extremes.impulse));
            CHECK(other[0].phase == Approx(one[0].phase));
        }
    }
    CHECK(cones > 5);
}

TEST_CASE(
    "response with two stops: motions on either stop are mirror images, and there are "
    "symmetric ones",
    "[glpk]")
{
    ResponseRange range;
    range.cells = 10;
    range.damping = {0.05};
    range.amplitude = 0.3;
    range.leastFrequencyRatio = 0.8;
    range.mostFrequencyRatio = 1.6;
    range.stops = {1, Fraction{1, 1}};
    std::size_t onWall = 0;
    std::size_t onSecond = 0;
    std::size_t both = 0;
    std::int64_t undecided = 0;
    for (const FrequencyResponse& response : frequencyResponse(range)) {
        undecided += response.undecided;
        std::vector<double> impulses[2];
        for (const ForcedMotion& motion : response.motions) {
            CHECK(motion.residual <= forcedTolerance);
            CHECK(motion.amplitude == Approx(0.3));
            REQUIRE(test::driftInTenPeriods(motion) <= 1e-9 * test::growth(motion));
            const bool isLeft = motion.schedule.phases.front().stop == Stop::left;
            if (motion.schedule.phases.size() == 2) {
                ++both;
            } else {
                ++(isLeft ? onSecond : onWall);
                impulses[isLeft ? 1 : 0].push_back(motion.extremes.impulse);
            }
        }
        REQUIRE(impulses[0].size() == impulses[1].size());
        for (std::size_t k = 0; k < impulses[0].size(); ++k) {
            CHECK(impulses[0][k] == Approx(impulses[1][k]));
        }
    }
    CHECK(onWall == onSecond);
    CHECK(both > 5);
    CHECK(undecided < 5);
}
