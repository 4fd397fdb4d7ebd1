#include "signorini/response.hpp"

#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "signorini/one_phase_set.hpp"
#include "support.hpp"

using namespace signorini;
using test::onePhase;

namespace {

/// The bar of section 15: N = 30, rho = 0.9, a force of amplitude 0.25 on the tip.
ResponseRange section15()
{
    ResponseRange range;
    range.cells = 30;
    range.damping = dampingOfRho(0.9);
    range.amplitude = 0.25;
    return range;
}

struct Known {
    std::int64_t contact;
    double impulse;
};

}  // namespace

TEST_CASE("response: the motions of section 15, and no others")
{
    const auto check = [](std::int64_t n, const std::vector<Known>& known) {
        INFO("n = " << n);
        const auto response = responseAt(section15(), n);
        REQUIRE(response);
        CHECK(response->undecided == 0);
        CHECK(response->frequencyRatio == Approx(120.0 / static_cast<double>(n)));
        REQUIRE(response->motions.size() == known.size());
        for (std::size_t k = 0; k < known.size(); ++k) {
            const ForcedMotion& motion = response->motions[k];
            CHECK(motion.schedule == onePhase(30, known[k].contact, n - known[k].contact));
            CHECK(motion.extremes.impulse == Approx(known[k].impulse).margin(5e-5));
            CHECK(motion.amplitude == Approx(0.25).epsilon(1e-12));
            CHECK(motion.residual < 1e-12);
        }
    };
    check(104, {{16, 0.6285}, {16, 1.5609}});
    check(108, {{8, 0.1907}, {12, 1.0710}});
    check(111, {{9, 0.8258}});
    check(113, {{7, 0.6826}});
    check(118, {});
    check(122, {{26, 0.3588}});
}

TEST_CASE("response: the least amplitude at n = 108 is 0.1254, all other n_c are proved absent")
{
    double least = std::numeric_limits<double>::infinity();
    for (std::int64_t contact = 1; contact < 108; ++contact) {
        const ForcedSet set =
            forcedMotions(onePhase(30, contact, 108 - contact), dampingOfRho(0.9), {});
        INFO("n_c = " << contact << " " << set.detail);
        REQUIRE(set.status != Status::undecided);
        if (set.status == Status::found) {
            least = std::min(least, set.leastAmplitude);
            CHECK(leastAmplitudeMotion(set).amplitude == Approx(set.leastAmplitude));
        } else {
            CHECK(isCertain(set));
        }
    }
    CHECK(least == Approx(0.1254).margin(5e-5));
}

TEST_CASE("response: it lists what the schedules have one by one, for a force and for the base")
{
    for (const Excited place : {Excited::tip, Excited::base}) {
        for (const std::int64_t cycles : {1, 2, 3}) {
            for (std::int64_t n = 22; n < 60; n += 3) {
                ResponseRange range;
                range.cells = 10;
                range.damping = {0.04};
                range.place = place;
                range.cycles = cycles;
                range.amplitude = 0.6;
                const auto response = responseAt(range, n);
                REQUIRE(response);
                std::size_t next = 0;
                std::int64_t undecided = 0;
                for (std::int64_t contact = 1; contact < n; ++contact) {
                    const ForcedSet set = forcedMotions(onePhase(10, contact, n - contact),
                                                        range.damping, {place, cycles, {}});
                    undecided += set.status == Status::undecided ? 1 : 0;
                    for (const ForcedMotion& motion : motionsOfAmplitude(set, 0.6)) {
                        INFO("K = " << cycles << ", " << describe(motion.schedule));
                        REQUIRE(next < response->motions.size());
                        const ForcedMotion& listed = response->motions[next++];
                        CHECK(listed.schedule == motion.schedule);
                        CHECK(listed.extremes.impulse ==
                              Approx(motion.extremes.impulse).epsilon(1e-9));
                    }
                }
                CHECK(next == response->motions.size());
                CHECK(response->undecided <= undecided);
            }
        }
    }
}

TEST_CASE("response: where the bar without a wall would reach the wall, by simulation")
{
    ResponseRange range = section15();
    for (const Excited place : {Excited::tip, Excited::base}) {
        range.place = place;
        for (const std::int64_t n : {70, 104, 108, 111, 122, 150, 200}) {
            const auto response = responseAt(range, n);
            REQUIRE(response);
            // Smaller by so much that the tip stays away from the wall.
            const double small = 0.1 / std::max(1.0, response->linearPeak);
            BarSimulation simulation(
                wavesAtRest(30.0), range.damping,
                excitationOf({place, small * range.amplitude, 0.2, 1, n, 30.0}),
                {.mergeBelow = {}, .recordsTip = true});
            const auto settled = static_cast<double>(200 * n);
            simulation.advance(settled + static_cast<double>(n));
            double peak = -1.0;
            for (const TipPoint& point : simulation.tipPath()) {
                peak = point.time * 30.0 > settled ? std::max(peak, point.displacement) : peak;
            }
            INFO("n = " << n);
            REQUIRE(simulation.contacts().empty());
            CHECK(peak / small == Approx(response->linearPeak).epsilon(2e-3));
            CHECK(response->touches == (response->linearPeak >= 1.0));
        }
    }
}

TEST_CASE("response: a subharmonic motion repeats after K cycles and not before")
{
    ResponseRange range = section15();
    range.cycles = 2;
    range.amplitude = 2.0;
    range.leastFrequencyRatio = 1.6;
    range.mostFrequencyRatio = 3.0;
    std::size_t motions = 0;
    for (const FrequencyResponse& response : frequencyResponse(range)) {
        CHECK(response.frequencyRatio ==
              Approx(240.0 / static_cast<double>(response.steps)).epsilon(1e-15));
        for (const ForcedMotion& motion : response.motions) {
            ++motions;
            BarSimulation simulation(wavesOf(motion.state), motion.damping, motion.excitation);
            const Eigen::VectorXd start = stretching(wavesOf(motion.state), 30);
            const auto n = static_cast<double>(response.steps);
            simulation.advance(0.5 * n);
            CHECK((stretching(simulation.waves(), 30) - start).cwiseAbs().maxCoeff() > 1e-3);
            simulation.advance(0.5 * n);
            CHECK((stretching(simulation.waves(), 30) - start).cwiseAbs().maxCoeff() < 1e-9);
        }
    }
    CHECK(motions > 5);
}

TEST_CASE("response: ranges, cancelling, progress")
{
    ResponseRange range = section15();
    range.leastFrequencyRatio = 120.0 / 112.0;
    range.mostFrequencyRatio = 120.0 / 108.0;
    CHECK(stepsOf(range) == std::vector<std::int64_t>{108, 109, 110, 111, 112});
    double last = 0.0;
    CHECK(frequencyResponse(range, {.cancel = {},
                                    .progress =
                                        [&last](double done, double total) {
                                            CHECK(done == last + 1.0);
                                            CHECK(total == 5.0);
                                            last = done;
                                        }})
              .size() == 5);
    CHECK(last == 5.0);
    int asked = 0;
    const auto some =
        frequencyResponse(range, {.cancel = [&asked] { return ++asked > 8; }, .progress = {}});
    CHECK(some.size() < 5);
    CHECK_FALSE(responseAt(range, 108, [] { return true; }));

    const auto refuses = [](auto change, const char* word) {
        ResponseRange wrong = section15();
        change(wrong);
        CHECK_THROWS_WITH(stepsOf(wrong), containsText(word));
    };
    refuses([](ResponseRange& r) { r.amplitude = 0.0; }, "amplitude");
    refuses([](ResponseRange& r) { r.damping.ratio = 0.0; }, "damping ratio");
    refuses([](ResponseRange& r) { r.damping.ratio = -1.0; }, "damping ratio");
    refuses([](ResponseRange& r) { r.damping.ratio = 1e-30; }, "damping ratio");
    refuses([](ResponseRange& r) { r.cycles = 0; }, "cycles");
    refuses([](ResponseRange& r) { r.cells = 0; }, "cells");
    refuses([](ResponseRange& r) { r.leastFrequencyRatio = 3.0; }, "leastFrequencyRatio");
    refuses([](ResponseRange& r) { r.mostFrequencyRatio = NAN; }, "mostFrequencyRatio");
    refuses([](ResponseRange& r) { r.leastFrequencyRatio = r.mostFrequencyRatio = 1.0001; },
            "frequency ratios");
}

TEST_CASE("stability: of two motions the one of larger impulse attracts, the other repels")
{
    for (const std::int64_t n : {100, 103, 104, 106, 108, 109}) {
        const auto response = responseAt(section15(), n);
        REQUIRE(response);
        REQUIRE(response->motions.size() == 2);
        INFO("n = " << n);
        const StabilityResult lower = stabilityOf(response->motions.front());
        const StabilityResult upper = stabilityOf(response->motions.back());
        CHECK(lower.stability == Stability::repels);
        CHECK(upper.stability == Stability::attracts);
        REQUIRE(upper.trials.size() == 4);
        for (const StabilityTrial& trial : upper.trials) {
            CHECK(trial.start > 0.0);
            CHECK(trial.start < 1e-2);
            CHECK(trial.end < 1e-8);
        }
    }
}

TEST_CASE("stability: slow ways away, too little time, and no disturbance at all")
{
    const auto slow = responseAt(section15(), 113);
    REQUIRE(slow);
    const ForcedMotion& motion = slow->motions.front();
    CHECK(stabilityOf(motion).stability == Stability::repels);
    StabilityOptions brief;
    brief.periods = 3;
    CHECK(stabilityOf(motion, brief).stability == Stability::unclear);
    brief.cancel = [] { return true; };
    CHECK(stabilityOf(motion, brief).stability == Stability::unclear);
    CHECK_THROWS_WITH(stabilityOf(motion, {.periods = 0}), containsText("periods"));
    CHECK_THROWS_WITH(stabilityOf(motion, {.sizes = {0.0}}), containsText("sizes"));
    CHECK_THROWS_WITH(stabilityOf(motion, {.sizes = {}}), containsText("sizes"));
    CHECK_THROWS_WITH(stabilityOf(motion, {.draws = 0}), containsText("draws"));
}

TEST_CASE("stability: a free motion stays near its neighbours; with damping all fade alike")
{
    const Schedule schedule = onePhase(30, 15, 90);
    const OnePhaseSet set = onePhaseSet(schedule);
    REQUIRE_FALSE(set.reason);
    const State state = leastEnergyMotion(set);
    const StabilityResult free = stabilityOf(state, schedule);
    CHECK(free.stability != Stability::attracts);  // nothing is lost
    CHECK(free.drift == 0.0);
    CHECK(free.contacts == 300);
    REQUIRE(free.trials.size() == 4);
    for (const StabilityTrial& trial : free.trials) {
        CHECK(trial.start > 0.0);
        CHECK(trial.end > 0.01 * trial.start);
    }
    // With 0.1 % of damping the motion leaves itself.
    const StabilityResult damped = stabilityOf(state, schedule, {0.001});
    CHECK(damped.drift > 0.1);
    CHECK(damped.contacts > 0);
    CHECK_THROWS_WITH(stabilityOf(state, onePhase(20, 10, 60)), containsText("cells"));
    CHECK_THROWS_WITH(stabilityOf(state, schedule, {-1.0}), containsText("damping"));
}

TEST_CASE("response: branches count the motions of every amplitude")
{
    ResponseRange range = section15();
    for (const std::int64_t n : {100, 104, 108, 113, 122}) {
        range.amplitude = 0.25;
        const auto response = responseAt(range, n);
        REQUIRE(response);
        for (const double amplitude : {0.05, 0.13, 0.2, 0.3, 0.5, 0.9}) {
            range.amplitude = amplitude;
            const auto other = responseAt(range, n);
            REQUIRE(other);
            CHECK(other->branches == response->branches);
            const auto count =
                std::count_if(response->branches.begin(), response->branches.end(),
                              [amplitude](const AmplitudeBranch& branch) {
                                  return branch.least <= amplitude && amplitude <= branch.most;
                              });
            INFO("n = " << n << ", amplitude " << amplitude);
            CHECK(static_cast<std::size_t>(count) == other->motions.size());
        }
    }
}
