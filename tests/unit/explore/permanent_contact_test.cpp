// The tip that never leaves the wall: it is said once, at every frequency where it holds, and it is
// what schedules with hardly any flight have, whatever they are called.

#include <cmath>
#include <numeric>

#include "catch.hpp"
#include "forced_case.hpp"
#include "forced_oracle.hpp"
#include "resting_tip.hpp"
#include "signorini/response.hpp"

using namespace signorini;

namespace {

ResponseRange pressedRange(Excited place, double amplitude)
{
    ResponseRange range;
    range.cells = 20;
    range.place = place;
    range.amplitude = amplitude;
    range.leastFrequencyRatio = 0.9;
    range.mostFrequencyRatio = 1.2;
    range.stops = {-1, {}};
    return range;
}

}  // namespace

TEST_CASE("permanent contact: under a force it is listed once at every frequency")
{
    for (const double amplitude : {0.3, 0.999, 1.001}) {
        const ResponseRange range = pressedRange(Excited::tip, amplitude);
        for (const FrequencyResponse& response : frequencyResponse(range)) {
            INFO("n = " << response.steps << ", " << response.detail);
            CHECK(response.undecided == 0);
            for (const ForcedMotion& motion : response.motions) {
                // It leaves the wall, unless the steps of a staircase just miss the crest of a
                // force that would lift the tip.
                CHECK((motion.extremes.lowestTip < -1.0 - 1e-6 || amplitude > 1.0));
            }
            REQUIRE(response.permanent.has_value() == (amplitude < 1.0));
            if (!response.permanent) {
                continue;
            }
            const PermanentContact& held = *response.permanent;
            CHECK(held.residual < 1e-12);
            CHECK(held.leastForce == Approx(1.0 - amplitude));
            CHECK(held.extremes.lowestTip == -1.0);
            // The bar at rest, shaken from there, does just that.
            const Excitation force = excitationOf({.place = Excited::tip,
                                                   .amplitude = amplitude,
                                                   .steps = response.steps,
                                                   .stepsPerCrossing = 20.0});
            BarSimulation bar(wavesAtRest(20.0, range.stops), range.damping, force,
                              {.stops = range.stops});
            bar.advance(10.0 * static_cast<double>(response.steps));
            CHECK(bar.contacts().size() <= 1);
            CHECK(bar.tip() == -1.0);
            CHECK(held.extremes.impulse == Approx(static_cast<double>(response.steps) / 20.0));
            CHECK(held.extremes.peakForce ==
                  Approx(1.0 + *std::max_element(force.values.begin(), force.values.end())));
        }
    }
}

TEST_CASE("permanent contact: a force on a tip that is held leaves the strain at rest")
{
    ResponseRange range = pressedRange(Excited::tip, 0.3);
    const auto strains = [&](std::vector<Segment> segments) {
        range.segments = std::move(segments);
        const auto response = responseAt(range, 77);
        REQUIRE(response->permanent);
        return response->permanent->extremes;
    };
    CHECK(strains({}).peakCompression == Approx(1.0));
    CHECK(strains({}).peakTension == Approx(-1.0));
    // The wall takes g = N (0.4/EA + 0.6/(2 EA)) from both pieces.
    const std::vector<Segment> stiffer{{.cells = 8}, {.cells = 12, .impedance = 2.0}};
    CHECK(strains(stiffer).peakCompression == Approx(1.0 / 0.7));
    CHECK(strains(stiffer).peakTension == Approx(-0.5 / 0.7));
}

TEST_CASE("permanent contact: above a moving base it ends where the clamped bar resonates")
{
    // A rod between base and wall: the strain at the wall is Y omega/sin(omega L/c) for fine grids.
    ResponseRange range = pressedRange(Excited::base, 0.05);
    range.cells = 100;
    for (const std::int64_t n : {130, 170, 199, 201, 260, 340}) {
        const double turn = 200.0 * std::acos(-1.0) / static_cast<double>(n);
        const double force = 0.05 * turn / std::abs(std::sin(turn));
        const auto response = responseAt(range, n);
        INFO("n = " << n << ", force " << force);
        REQUIRE(response->permanent.has_value() == (force < 1.0));
        if (response->permanent) {
            CHECK(1.0 - response->permanent->leastForce == Approx(force).epsilon(1e-3));
            CHECK(response->permanent->residual < 1e-11);
        }
    }
    range.cells = 10;
    CHECK_FALSE(responseAt(range, 20)->permanent);  // 2 omega_1
    range.stops = {1, {}};
    CHECK_FALSE(responseAt(range, 36)->permanent);
}

TEST_CASE("permanent contact: schedules without room for a flight have what a program says")
{
    std::mt19937_64 generator(5);
    const auto draw = [&generator](std::int64_t low, std::int64_t high) {
        return std::uniform_int_distribution<std::int64_t>(low, high)(generator);
    };
    int polygons = 0;
    for (int k = 0; k < 400 && polygons < 60; ++k) {
        const std::int64_t cells = draw(1, 6);
        const std::int64_t n = draw(3, 8 * cells);
        const std::int64_t common = std::gcd(2 * cells, n);
        if (common < 2) {
            continue;
        }
        const std::int64_t free = draw(1, std::min(common - 1, n - 1));
        Schedule schedule{cells, {{n - free, free}}, {-1, {}}};
        if (draw(0, 1) == 0) {
            schedule.stops.left = Fraction{41, 20};
        }
        const Forcing forcing{draw(0, 1) == 0 ? Excited::tip : Excited::base,
                              draw(1, std::min<std::int64_t>(3, (n - 1) / 2)),
                              {}};
        const Damping damping{0.01 * static_cast<double>(draw(1, 40))};
        const auto shapes = shapesOf(forcing, cells, n);
        ForcedWaves waves(cells, damping.rho(), shapes, schedule.stops);
        waves.setPhases(schedule.phases);
        // With whole cycles in 2N steps a force and waves cancel, whatever their size.
        if (!tipRests(schedule, forcing, waves) || 2 * cells * forcing.cycles % n == 0) {
            continue;
        }
        INFO(describe(schedule) << " " << name(forcing.place) << " cycles " << forcing.cycles);
        const ForcedSet set = forcedMotions(schedule, damping, forcing);
        INFO(set.detail);
        REQUIRE(set.status == Status::found);
        CHECK(set.leastAmplitude == 0.0);
        const test::ForcedOracle oracle(schedule, damping.rho(), shapes);
        CHECK(oracle.leastMissed() < 1e-7);
        for (int way = 0; way < 8; ++way) {
            const double angle = 0.1 + 0.7853981633974483 * way;
            const double c = std::cos(angle);
            const double s = std::sin(angle);
            double farthest = -1e300;
            for (const ForcedCorner& corner : set.corners) {
                farthest = std::max(farthest, c * corner.place[0] + s * corner.place[1]);
            }
            CHECK(farthest == Approx(oracle.farthest(c, s, 1e4)).margin(1e-6).epsilon(1e-6));
        }
        for (const double part : {0.3, 1.0}) {
            if (set.mostAmplitude > 1e-9) {
                const auto motions = motionsOfAmplitude(set, part * set.mostAmplitude);
                REQUIRE(motions.size() == 1);
                CHECK(motions.front().residual <= forcedTolerance);
                CHECK(motions.front().extremes.approachSpeed < 1e-9);
            }
        }
        ++polygons;
    }
    CHECK(polygons == 60);
}

TEST_CASE("permanent contact: found at any start of the period, also where that has no waves")
{
    // Once undecided: residuals were relative to a state that is 0.
    const ForcedSet first =
        forcedMotions({10, {{110, 10}}, {-1, {}}}, {0.1522}, {Excited::base, 2, {}});
    CHECK(first.status == Status::found);
    const ForcedSet second = forcedMotions({12, {{65, 1}}, {-1, Fraction{41, 20}}}, {0.0446}, {});
    CHECK(second.status == Status::found);
}

TEST_CASE("permanent contact: without a gap no excitation keeps the tip at the wall")
{
    const Forcing force;
    const ForcedSet none = forcedMotions({6, {{13, 3}}, {0, {}}}, {0.0033}, force);
    REQUIRE(none.status == Status::none);
    REQUIRE(none.conflict.size() == 1);
    CHECK(none.conflict.front().rule == ForcedRule::rest);
    CHECK(isCertain(none));
    // The rule proves nothing elsewhere: a flight as long as the classes are many, a gap, a force
    // that has whole cycles in 2N steps.
    for (const Schedule& other : {Schedule{6, {{12, 4}}, {0, {}}}, Schedule{6, {{13, 3}}, {1, {}}},
                                  Schedule{6, {{10, 2}}, {0, {}}}}) {
        ForcedSet forged = none;
        forged.schedule = other;
        CHECK_FALSE(isCertain(forged));
    }
    for (std::int64_t n = 8; n < 30; ++n) {
        for (std::int64_t free = 1; free < std::gcd<std::int64_t>(12, n) && free < n; ++free) {
            for (const Excited place : {Excited::tip, Excited::base}) {
                INFO("n = " << n << ", n_f = " << free);
                const ForcedSet set =
                    forcedMotions({6, {{n - free, free}}, {0, {}}}, {0.05}, {place, 1, {}});
                CHECK((set.status == Status::none || 12 % n == 0));
            }
        }
    }
}

TEST_CASE("response: where a base moves with the clamped bar nothing is left undecided", "[glpk]")
{
    ResponseRange range;
    range.cells = 60;
    range.damping = {0.05};
    range.place = Excited::base;
    range.amplitude = 0.02;
    const auto response = responseAt(range, 120);
    CHECK(response->undecided == 0);
    CHECK(response->motions.empty());
    for (const std::int64_t contact : {63, 66, 67, 80, 88}) {
        const ForcedSet set =
            forcedMotions({60, {{contact, 120 - contact}}}, {0.05}, {Excited::base, 1, {}});
        CHECK(set.status == Status::none);
        CHECK(isCertain(set));
    }
}
