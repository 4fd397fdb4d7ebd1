// Forced motions of bars of several segments.

#include "network_forced.hpp"

#include <cmath>

#include "catch.hpp"
#include "signorini/response.hpp"
#include "stepped_forced_oracle.hpp"

using namespace signorini;
using signorini::test::SteppedForcedOracle;

namespace {

/// By the engine of networks, also of equal segments.
ForcedSet setOf(const Schedule& schedule, const Damping& damping, Excited place,
                const std::vector<Segment>& segments, const ForcedLimits& limits = {})
{
    ForcedSet set;
    set.limits = limits;
    set.schedule = schedule;
    set.damping = damping;
    set.forcing = {place, 1};
    set.segments = segments;
    set.waves = std::make_shared<const NetworkForced>(set);
    set.waves->decide(set);
    return set;
}

/// One contact, or where there are two stops mostly one on each.
Schedule scheduleOf(std::int64_t cells, std::int64_t contact, std::int64_t free, const Stops& stops)
{
    Schedule schedule{cells, {{contact, free}}, stops};
    if (stops.left && free % 3 != 0) {
        schedule.phases.push_back({contact, free, Stop::left});
    }
    return schedule;
}

}  // namespace

TEST_CASE("stepped forced: equal segments have the sets, motions and proofs of one bar", "[glpk]")
{
    const double ratio = GENERATE(0.05, 0.0);
    const Stops stops = GENERATE(Stops{1, std::nullopt}, Stops{-1, std::nullopt},
                                 Stops{0, std::nullopt}, Stops{1, Fraction{3, 2}});
    const Excited place = GENERATE(Excited::tip, Excited::base);
    const std::vector<Segment> equal{{.cells = 2}, {.cells = 4}};
    int found = 0;
    int none = 0;
    int undecided = 0;
    for (std::int64_t contact = 1; contact < 12; contact += 2) {
        for (std::int64_t free = 5; free < 24; ++free) {
            const Schedule schedule = scheduleOf(6, contact, free, stops);
            const ForcedSet one = forcedMotions(schedule, {ratio}, {place, 1});
            const ForcedSet parts = setOf(schedule, {ratio}, place, equal);
            INFO(describe(schedule) << ", " << name(place) << ", " << ratio << ", " << stops.right
                                    << ": " << parts.detail << "; " << one.detail);
            if (parts.status == Status::undecided || one.status == Status::undecided) {
                undecided += one.status == Status::undecided ? 0 : 1;
                continue;
            }
            CHECK(parts.status == one.status);
            CHECK(parts.freeWaves == one.freeWaves);
            if (one.status == Status::none) {
                ++none;
                CHECK(isCertain(parts));
                CHECK(parts.reason.has_value());
                continue;
            }
            ++found;
            CHECK(parts.kind == one.kind);
            CHECK(parts.leastAmplitude == Approx(one.leastAmplitude).epsilon(1e-6).margin(1e-9));
            CHECK((std::isinf(one.mostAmplitude)
                       ? parts.mostAmplitude > 1e5
                       : parts.mostAmplitude == Approx(one.mostAmplitude).epsilon(1e-6)));
            if (one.kind == ForcedKind::polytope || stops.right == 0) {
                continue;
            }
            const ForcedMotion motion = leastAmplitudeMotion(parts);
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
    INFO(ratio << ", " << stops.right << ", " << (stops.left ? 1 : 0) << ", " << name(place) << ": "
               << found << " found, " << none << " none, " << undecided << " undecided");
    CHECK(none > 5);
    CHECK(undecided < 6);
}

TEST_CASE("stepped forced: equal segments keep limits on strain as one bar does", "[glpk]")
{
    const double ratio = GENERATE(0.05, 0.0);
    const Stops stops =
        GENERATE(Stops{1, std::nullopt}, Stops{-1, std::nullopt}, Stops{1, Fraction{3, 2}});
    const std::vector<Segment> equal{{.cells = 2}, {.cells = 3}};
    int cut = 0;
    int none = 0;
    for (std::int64_t contact = 1; contact < 9; contact += 2) {
        for (std::int64_t free = 4; free < 20; ++free) {
            const Schedule schedule = scheduleOf(5, contact, free, stops);
            const ForcedSet whole = forcedMotions(schedule, {ratio}, {});
            if (whole.status != Status::found) {
                continue;
            }
            const double seen = leastAmplitudeMotion(whole).extremes.peakCompression;
            for (const double factor : {1.5, 1.01, 0.9, 0.5, 0.1}) {
                const ForcedLimits limits{factor * seen};
                const ForcedSet one = forcedMotions(schedule, {ratio}, {}, limits);
                const ForcedSet parts = setOf(schedule, {ratio}, Excited::tip, equal, limits);
                INFO(describe(schedule)
                     << ", " << ratio << ", " << stops.right << ", limit " << limits.strain << ": "
                     << parts.detail << "; " << one.detail);
                if (one.status == Status::undecided) {
                    continue;
                }
                REQUIRE(parts.status == one.status);
                if (one.status == Status::none) {
                    ++none;
                    CHECK(isCertain(parts));
                    CHECK(parts.reason == Reason::constraints);
                    continue;
                }
                CHECK(parts.leastAmplitude ==
                      Approx(one.leastAmplitude).epsilon(1e-6).margin(1e-9));
                CHECK((std::isinf(one.mostAmplitude)
                           ? parts.mostAmplitude > 1e5
                           : parts.mostAmplitude == Approx(one.mostAmplitude).epsilon(1e-6)));
                cut += one.mostAmplitude < whole.mostAmplitude ? 1 : 0;
            }
        }
    }
    INFO(ratio << ", " << stops.right << ": " << cut << " cut, " << none << " none");
    CHECK(cut > 3);
    CHECK(none > 3);
}

TEST_CASE("stepped forced: none where a linear program of its own finds none, and proved", "[glpk]")
{
    const auto segments =
        GENERATE(std::vector<Segment>{{.cells = 2}, {.cells = 3, .impedance = 1.3}},
                 std::vector<Segment>{{.cells = 1},
                                      {.cells = 3, .impedance = 30.0, .dashpot = 0.1},
                                      {.cells = 1, .impedance = 0.7}});
    const Excited place = GENERATE(Excited::tip, Excited::base);
    const Damping damping{0.08};
    int found = 0;
    int none = 0;
    for (std::int64_t contact = 1; contact < 16; ++contact) {
        for (std::int64_t free = 6; free < 22; ++free) {
            const Schedule schedule{5, {{contact, free}}};
            const double missed =
                SteppedForcedOracle(schedule, segments, damping.eta(), place).leastMissed();
            if (missed > 1e-11 && missed < 1e-7) {
                continue;  // rounding decides
            }
            ForcedSet set = forcedMotions(schedule, damping, {place, 1}, {}, segments);
            INFO(describe(schedule) << ", " << name(place) << ": " << set.detail);
            CHECK(set.status == (missed <= 1e-11 ? Status::found : Status::none));
            if (set.status != Status::none) {
                ++found;
                continue;
            }
            ++none;
            CHECK(isCertain(set));
            // What is spoilt proves nothing, and neither does nothing.
            const std::vector<EnergyFloor> cuts = set.cuts;
            set.cuts.front().periodicity[3] += 1e-3;
            CHECK_FALSE(isCertain(set));
            set.cuts = cuts;
            for (ContactMultiplier& push : set.cuts.front().pushes) {
                push.value = -push.value;
            }
            CHECK(isCertain(set) == cuts.front().pushes.empty());
            set.cuts.clear();
            CHECK_FALSE(isCertain(set));
        }
    }
    CHECK(found > 5);
    CHECK(none > 50);
}

TEST_CASE("stepped forced: none, and proved, where it was undecided; and no such amplitude")
{
    const std::vector<Segment> segments{{.cells = 4}, {.cells = 4, .impedance = 1.3}};
    const ForcedSet none = forcedMotions({8, {{5, 24}}}, {0.05}, {Excited::tip, 1}, {}, segments);
    CHECK(none.status == Status::none);
    CHECK(isCertain(none));
    CHECK(none.conflict.size() <= 2);
    const ForcedSet set = forcedMotions({8, {{6, 26}}}, {0.1}, {Excited::tip, 1}, {}, segments);
    CHECK(set.status == Status::found);
    for (const double amplitude : {0.5 * set.leastAmplitude, 0.999999 * set.leastAmplitude,
                                   1.000001 * set.mostAmplitude, 3.0 * set.mostAmplitude}) {
        if (std::isfinite(amplitude)) {
            CHECK(motionsOfAmplitude(set, amplitude).empty());
            CHECK(exclusionOf(set, amplitude).isCertain);
        }
    }
    // What motions have is not excluded.
    CHECK_FALSE(exclusionOf(set, 1.000001 * set.leastAmplitude).isCertain);
}

TEST_CASE("stepped forced: what is found returns by itself for ten periods, what is not does not")
{
    const std::vector<Segment> segments{{.cells = 3},
                                        {.cells = 2, .impedance = 0.4, .dashpot = 0.02},
                                        {.cells = 3, .impedance = 1.7}};
    int found = 0;
    int wide = 0;
    for (std::int64_t contact = 2; contact < 12; ++contact) {
        for (std::int64_t free = 18; free < 36; ++free) {
            const Schedule schedule{8, {{contact, free}}};
            const ForcedSet set = forcedMotions(schedule, {0.05}, {Excited::tip, 1}, {}, segments);
            INFO(describe(schedule) << ": " << set.detail);
            if (set.status != Status::found) {
                CHECK(set.status == Status::none);
                continue;
            }
            ++found;
            const ForcedMotion motion = leastAmplitudeMotion(set);
            CHECK(motion.residual < 1e-9);
            CHECK(motion.amplitude == Approx(set.leastAmplitude).epsilon(1e-9));
            BarSimulation own(wavesOf(motion.state), motion.damping, motion.excitation,
                              {.segments = segments});
            own.advance(10.0 * static_cast<double>(steps(schedule)));
            CHECK(own.tip() == Approx(1.0).margin(1e-6));
            CHECK(own.impulse() == Approx(10.0 * motion.extremes.impulse).epsilon(1e-5));
            const EnergyBalance balance = own.balance();
            CHECK(std::abs(balance.error) < 1e-9 * balance.size);
            CHECK(balance.work == Approx(balance.dissipated).epsilon(1e-4));
            if (!std::isfinite(set.high - set.low) || !(set.high - set.low > 1e-3)) {
                continue;
            }
            ++wide;
            // Beyond its end the same waves push into the wall, or pull at it.
            const double beyond = set.high + 0.02 * (set.high - set.low);
            const Plane place{set.foot[0] + beyond * set.direction[0],
                              set.foot[1] + beyond * set.direction[1]};
            CHECK(set.waves->motionAt()(place, {}).residual > 1e-6);
            const double middle =
                std::hypot(std::hypot(set.foot[0], set.foot[1]), 0.5 * (set.low + set.high));
            const auto there = motionsOfAmplitude(set, middle);
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
    const std::vector<Segment> segments{{.cells = 2}, {.cells = 2, .impedance = 1.3}};
    int found = 0;
    for (std::int64_t one = 1; one < 5; ++one) {
        for (std::int64_t first = 6; first < 14; ++first) {
            for (std::int64_t second = 6; second < 14; ++second) {
                const Schedule schedule{4, {{one, first}, {one + 1, second}}};
                const ForcedSet set =
                    forcedMotions(schedule, {0.1}, {Excited::tip, 1}, {}, segments);
                if (set.status == Status::found) {
                    ++found;
                    INFO(describe(schedule));
                    CHECK(set.kind == ForcedKind::point);
                    CHECK(leastAmplitudeMotion(set).residual < 1e-8);
                }
            }
        }
    }
    CHECK(found > 0);
}

TEST_CASE("stepped forced: what is not known is refused")
{
    const std::vector<Segment> segments{{.cells = 2}, {.cells = 2, .impedance = 1.3}};
    const Schedule schedule{4, {{3, 12}}};
    const auto ask = [&](const Schedule& of, const Forcing& forcing, const ForcedLimits& limits) {
        return forcedMotions(of, {0.1}, forcing, limits, segments);
    };
    CHECK_THROWS_WITH(ask(schedule, {}, {0.0}), containsText("strain limit"));
    CHECK_THROWS_WITH(ask(schedule, {Excited::tip, 8}, {}), containsText("cycles = 8"));
    CHECK_THROWS_WITH(ask({5, {{3, 12}}}, {}, {}), containsText("cells of all segments = 4"));
    CHECK_THROWS_WITH(ask(schedule, {Excited::tip, 1, {1.0}}, {}), containsText("shape"));
}
