// Forced motions of bars of several segments.

#include "stepped_forced.hpp"

#include <cmath>

#include "catch.hpp"
#include "signorini/response.hpp"

using namespace signorini;

namespace {

Scene sceneOf(std::vector<Segment> segments)
{
    return {Bar{}, std::nullopt, std::move(segments)};
}

}  // namespace

TEST_CASE("stepped forced: equal segments have the sets and motions of one bar")
{
    const Scene equal = sceneOf({{.cells = 2}, {.cells = 4}});
    int found = 0;
    for (const Excited place : {Excited::tip, Excited::base}) {
        for (std::int64_t contact = 1; contact < 12; ++contact) {
            for (std::int64_t free = 8; free < 30; ++free) {
                const Schedule schedule{6, {{contact, free}}};
                const ForcedSet one = forcedMotions(schedule, {0.05}, {place, 1});
                const SteppedForced parts(schedule, equal, {0.05}, {place, 1});
                INFO(describe(schedule) << ", " << name(place) << ": " << parts.set().detail);
                if (one.freeWaves > 0) {
                    CHECK(parts.set().status == Status::undecided);
                    continue;
                }
                CHECK((parts.set().status == Status::found) == (one.status == Status::found));
                if (one.status != Status::found) {
                    CHECK(parts.set().status == Status::undecided);
                    continue;
                }
                ++found;
                CHECK(parts.set().kind == one.kind);
                CHECK(parts.set().leastAmplitude == Approx(one.leastAmplitude).epsilon(1e-8));
                CHECK((std::isinf(one.mostAmplitude)
                           ? std::isinf(parts.set().mostAmplitude)
                           : parts.set().mostAmplitude == Approx(one.mostAmplitude).epsilon(1e-8)));
                const ForcedMotion motion = parts.leastAmplitude();
                const ForcedMotion known = leastAmplitudeMotion(one);
                CHECK(motion.residual < 1e-9);
                CHECK((motion.state.a - known.state.a).lpNorm<Eigen::Infinity>() < 1e-8);
                CHECK((motion.state.b - known.state.b).lpNorm<Eigen::Infinity>() < 1e-8);
                CHECK(motion.extremes.impulse == Approx(known.extremes.impulse).margin(1e-8));
                CHECK(motion.extremes.peakForce == Approx(known.extremes.peakForce).margin(1e-8));
                CHECK(motion.extremes.lowestTip == Approx(known.extremes.lowestTip).margin(1e-8));
                CHECK(motion.extremes.approachSpeed ==
                      Approx(known.extremes.approachSpeed).margin(1e-8));
            }
        }
    }
    CHECK(found > 20);
}

TEST_CASE("stepped forced: what is found returns by itself for ten periods, what is not does not")
{
    const Scene scene = sceneOf({{.cells = 3},
                                 {.cells = 2, .impedance = 0.4, .dashpot = 0.02},
                                 {.cells = 3, .impedance = 1.7}});
    int found = 0;
    int wide = 0;
    for (std::int64_t contact = 2; contact < 12; ++contact) {
        for (std::int64_t free = 18; free < 36; ++free) {
            const Schedule schedule{8, {{contact, free}}};
            const SteppedForced forced(schedule, scene, {0.05}, {Excited::tip, 1});
            const ForcedSet& set = forced.set();
            INFO(describe(schedule) << ": " << set.detail);
            if (set.status != Status::found) {
                CHECK(set.status == Status::undecided);
                continue;
            }
            ++found;
            const ForcedMotion motion = forced.leastAmplitude();
            CHECK(motion.residual < 1e-9);
            CHECK(motion.amplitude == Approx(set.leastAmplitude).epsilon(1e-9));
            BarSimulation own(wavesOf(motion.state), motion.damping, motion.excitation,
                              {.segments = scene.segments});
            own.advance(10.0 * static_cast<double>(steps(schedule)));
            CHECK(own.tip() == Approx(1.0).margin(1e-6));
            CHECK(own.impulse() == Approx(10.0 * motion.extremes.impulse).epsilon(1e-5));
            const EnergyBalance balance = own.balance();
            CHECK(std::abs(balance.error) < 1e-9 * balance.size);
            CHECK(balance.work == Approx(balance.dissipated).epsilon(1e-4));
            if (!std::isfinite(set.high) || !(set.high - set.low > 1e-3)) {
                continue;
            }
            ++wide;
            // Beyond its end the same waves push into the wall, or pull at it.
            CHECK(forced.at(set.high + 0.02 * (set.high - set.low)).residual > 1e-6);
            const double middle =
                std::hypot(std::hypot(set.foot[0], set.foot[1]), 0.5 * (set.low + set.high));
            const auto there = forced.ofAmplitude(middle);
            CHECK((there.size() == 1 || there.size() == 2));
            for (const ForcedMotion& one : there) {
                CHECK(one.residual < 1e-9);
                CHECK(one.amplitude == Approx(middle).epsilon(1e-12));
            }
        }
    }
    CHECK(found > 5);
    CHECK(wide > 2);
}

TEST_CASE("stepped forced: two contacts in a period leave a point, or nothing")
{
    const Scene scene = sceneOf({{.cells = 2}, {.cells = 2, .impedance = 1.3}});
    int found = 0;
    for (std::int64_t one = 1; one < 5; ++one) {
        for (std::int64_t first = 6; first < 14; ++first) {
            for (std::int64_t second = 6; second < 14; ++second) {
                const Schedule schedule{4, {{one, first}, {one + 1, second}}};
                const SteppedForced forced(schedule, scene, {0.1}, {Excited::tip, 1});
                if (forced.set().status == Status::found) {
                    ++found;
                    INFO(describe(schedule));
                    CHECK(forced.set().kind == ForcedKind::point);
                    CHECK(forced.leastAmplitude().residual < 1e-8);
                }
            }
        }
    }
    CHECK(found > 0);
}

TEST_CASE("stepped forced: what is not known is refused, and what nothing damps is undecided")
{
    const Scene scene = sceneOf({{.cells = 2}, {.cells = 2, .impedance = 1.3}});
    const Schedule schedule{4, {{3, 12}}};
    CHECK(SteppedForced(schedule, scene, {0.0}, {Excited::tip, 1}).set().status ==
          Status::undecided);
    Scene other = scene;
    other.secondStop = 1e-3;
    CHECK_THROWS_WITH(SteppedForced(schedule, other, {0.1}, {}), containsText("second stop"));
    other = scene;
    other.bar.gap = -1e-3;
    CHECK_THROWS_WITH(SteppedForced(schedule, other, {0.1}, {}), containsText("gap"));
    CHECK_THROWS_WITH(SteppedForced(schedule, scene, {0.1}, {Excited::tip, 8}),
                      containsText("cycles = 8"));
    CHECK_THROWS_WITH(SteppedForced({5, {{3, 12}}}, scene, {0.1}, {}),
                      containsText("cells of all segments = 4"));
    CHECK_THROWS_WITH(SteppedForced(schedule, scene, {0.1}, {Excited::tip, 1, {1.0}}),
                      containsText("shape"));
}
