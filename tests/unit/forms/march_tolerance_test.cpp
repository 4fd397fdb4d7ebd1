// Pushes and rooms that are exactly as large as the tolerance allows, on waves that are whole
// numbers: every check of a state has to decide there as the rule says, and no motion may get lost
// by it.

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "bar_check.hpp"
#include "catch.hpp"
#include "contact_spans.hpp"
#include "infinity.hpp"
#include "march_support.hpp"
#include "network_walk.hpp"
#include "signorini/verification.hpp"
#include "stepped_bar.hpp"
#include "stepped_waves.hpp"
#include "support.hpp"

using namespace signorini;
using namespace signorini::test;

namespace {

/// Two stops half of the time, whole places of the tip, and tolerances that pushes and rooms meet
/// exactly: N is a power of two, so that nothing is rounded.
struct Coarse {
    State state;
    Schedule schedule;
    Places places;
    double tolerance = 0.0;
};

Coarse drawCoarse(std::mt19937_64& draw, int mostPower)
{
    const auto upTo = [&](std::int64_t most) {
        return static_cast<std::int64_t>(1 + draw() % static_cast<std::uint64_t>(most));
    };
    const std::int64_t cells = std::int64_t{1} << (upTo(mostPower + 1) - 1);
    Coarse drawn{stretches(draw, cells), {cells, {{upTo(5 * cells), upTo(9 * cells)}}}, {}};
    Stops& stops = drawn.schedule.stops;
    stops.right = static_cast<int>(upTo(3)) - 2;
    drawn.places.wall = stops.right;
    if (draw() % 2 == 0) {
        stops.left = Fraction{1 + upTo(3), 1};
        drawn.schedule.phases.push_back({upTo(cells), upTo(2 * cells), Stop::left});
        drawn.places.second =
            0.5 * static_cast<double>(cells * (stops.right + stops.left->numerator));
    } else if (draw() % 2 == 0) {
        drawn.schedule.phases.push_back(drawn.schedule.phases.front());
    }
    if (draw() % 4 != 0) {
        const double start = drawn.places.second && draw() % 3 == 0 ? *drawn.places.second : 0.0;
        place(drawn.state, stops.right, start + 0.5 * static_cast<double>(upTo(5) - 3));
    }
    const std::uint64_t power = draw() % 5;
    drawn.tolerance = power == 0 ? 0.0 : std::ldexp(1.0, -static_cast<int>(power));
    return drawn;
}

/// The largest wave that arrives along a schedule, all of it walked.
double highestWave(State state, const Schedule& schedule)
{
    double highest = -INFINITY;
    for (const Phase& phase : schedule.phases) {
        for (std::int64_t step = 0; step < phase.contact + phase.free; ++step) {
            highest = std::max(highest, state.a[state.a.size() - 1]);
            takeStep(state, step < phase.contact);
        }
    }
    return highest;
}

std::vector<Phase> repeated(const std::vector<Phase>& phases, std::int64_t times)
{
    std::vector<Phase> all;
    for (std::int64_t k = 0; k < times; ++k) {
        all.insert(all.end(), phases.begin(), phases.end());
    }
    return all;
}

/// Calls action(drawn, steps) for many of them.
template <typename Action>
void forManyCoarse(unsigned seed, int mostPower, Action action)
{
    std::mt19937_64 draw(seed);
    for (int trial = 0; trial < 20000; ++trial) {
        const Coarse drawn = drawCoarse(draw, mostPower);
        INFO("trial " << trial << ": " << describe(drawn.schedule) << ", " << drawn.tolerance);
        action(drawn, steps(drawn.schedule));
    }
}

}  // namespace

TEST_CASE("march: what is near a stop, and what presses, is as exact as the tolerance")
{
    int faults = 0;
    int pressed = 0;
    forManyCoarse(22, 6, [&](const Coarse& drawn, std::int64_t count) {
        const March expected =
            marchBySteps(drawn.state, count, drawn.places, drawn.tolerance).march;
        const March seen = march(drawn.state, count, drawn.tolerance, drawn.schedule.stops);
        REQUIRE(seen.firstFault == expected.firstFault);
        REQUIRE(seen.residual == Approx(expected.residual).epsilon(1e-12));
        REQUIRE(seen.phases == expected.phases);
        faults += seen.firstFault >= 0 ? 1 : 0;
        pressed += seen.phases.empty() ? 0 : 1;
    });
    CHECK(faults > 500);
    CHECK(pressed > 500);
}

TEST_CASE("march: beside any schedule it decides step by step, and the shortest period repeats")
{
    int unpressed = 0;
    int twice = 0;
    forManyCoarse(23, 3, [&](const Coarse& drawn, std::int64_t count) {
        const March expected =
            marchBySteps(drawn.state, count, drawn.places, drawn.tolerance).march;
        const Verification seen = verify(drawn.state, drawn.schedule, drawn.tolerance);
        REQUIRE(seen.residuals.march == Approx(expected.residual).epsilon(1e-12));
        REQUIRE(repeated(seen.canonical, expected.phases.empty() ? 1 : seen.repetitions) ==
                expected.phases);
        REQUIRE(count % seen.repetitions == 0);
        if (seen.repetitions > 1) {
            const March once =
                marchBySteps(drawn.state, count / seen.repetitions, drawn.places, drawn.tolerance)
                    .march;
            REQUIRE(once.firstFault == -1);
            REQUIRE(once.residual <= drawn.tolerance);
        }
        REQUIRE(seen.peakStrain == 2.0 * highestWave(drawn.state, drawn.schedule));
        unpressed += expected.phases.empty() ? 1 : 0;
        twice += seen.repetitions > 1 ? 1 : 0;
    });
    CHECK(unpressed > 500);
    CHECK(twice > 100);
}

TEST_CASE("march: cell by cell it sees what the tip does, as exactly as the tolerance")
{
    int pressed = 0;
    int landed = 0;
    int twice = 0;
    forManyCoarse(24, 3, [&](const Coarse& drawn, std::int64_t count) {
        const Seen expected = marchBySteps(drawn.state, count, drawn.places, drawn.tolerance);
        const std::vector<Segment> whole{{drawn.schedule.cells}};
        const auto [seen, extremes] =
            verifyBar(drawn.state, drawn.schedule, whole, drawn.tolerance);
        REQUIRE(seen.residuals.march == Approx(expected.march.residual).epsilon(1e-12));
        if (expected.march.firstFault >= 0) {
            return;
        }
        const std::int64_t times = expected.returns > 0 ? count / expected.returns : 1;
        REQUIRE(seen.repetitions == times);
        if (times == 1) {
            REQUIRE(seen.canonical == expected.march.phases);
        }
        Extremes truth = expected.extremes;
        truth.period = period(drawn.schedule) / static_cast<double>(times);
        truth.contactTime /= static_cast<double>(times);
        truth.impulse /= static_cast<double>(times);
        truth.peakCompression = extremes.peakCompression;  // strains have a test of their own
        truth.peakTension = extremes.peakTension;
        checkEqual(extremes, truth);
        pressed += seen.canonical.empty() ? 0 : 1;
        landed += extremes.approachSpeed > 0.0 ? 1 : 0;
        twice += times > 1 ? 1 : 0;
    });
    CHECK(pressed > 500);
    CHECK(landed > 500);
    CHECK(twice > 100);
}

TEST_CASE("march: strains of segments are those in every cell of a bar cut twice as fine")
{
    // Without contact a bar of one impedance repeats after 4N steps, whatever its state and speeds.
    std::mt19937_64 draw(25);
    for (int trial = 0; trial < 300; ++trial) {
        std::vector<Segment> segments;
        std::vector<Segment> halved;
        for (std::uint64_t count = 1 + draw() % 3; count > 0; --count) {
            const auto cells = static_cast<std::int64_t>(1 + draw() % 4);
            const auto speed = std::ldexp(1.0, static_cast<int>(draw() % 3) - 1);
            segments.push_back({.cells = cells, .speed = speed});
            halved.push_back({.cells = 2 * cells, .speed = speed});
        }
        const SteppedBar bar = steppedBar(halved);
        const std::int64_t half = bar.cells / 2;
        const State state = randomState(half, static_cast<unsigned>(trial));
        State fine{Eigen::VectorXd(bar.cells), Eigen::VectorXd(bar.cells)};
        for (Eigen::Index k = 0; k < bar.cells; ++k) {
            fine.a[k] = state.a[k / 2];
            fine.b[k] = state.b[k / 2];
        }
        // Held or free all the time: N or 2N times longer than any wave needs to be back.
        const bool isHeld = draw() % 2 == 0;
        const std::int64_t steps = isHeld ? 2 * half : 4 * half;
        SteppedWaves waves(bar, fine);
        double lowest = infinity;
        double highest = -infinity;
        for (std::int64_t m = 0; m < 2 * steps; ++m) {
            const State now = waves.state();
            Eigen::Index cell = 0;
            for (const Segment& segment : halved) {
                for (std::int64_t k = 0; k < segment.cells; ++k, ++cell) {
                    const double strain =
                        (now.b[cell] - now.a[cell]) / (segment.speed / halved.front().speed);
                    lowest = std::min(lowest, strain);
                    highest = std::max(highest, strain);
                }
            }
            waves.step({.reflected = isHeld ? -1.0 : 1.0});
        }
        Scene scene;
        scene.segments = segments;
        Network network = networkOf(scene, half);
        network.contacts.front().gap = isHeld ? 0.0 : 1e9;
        const NetworkClaim claim{.waves = wavesOf(network, state),
                                 .displacements = std::vector<double>(network.nodes.size(), 0.0),
                                 .schedule = {{isHeld ? 1U : 0U, steps}}};
        const NetworkResiduals seen = walk(network, claim);
        CHECK(seen.periodicity < 1e-12);
        CHECK(seen.extremes.leastStrain == Approx(lowest).epsilon(1e-12));
        CHECK(seen.extremes.mostStrain == Approx(highest).epsilon(1e-12));
    }
}

TEST_CASE("march: a state of other cells than the bar is refused, whichever wave is too long")
{
    const Schedule schedule = onePhase(2, 1, 3);
    const std::vector<Segment> segments{{1}, {1}};
    const Eigen::VectorXd two = Eigen::VectorXd::Zero(2);
    const Eigen::VectorXd three = Eigen::VectorXd::Zero(3);
    CHECK_NOTHROW(verifyBar({two, two}, schedule, segments));
    for (const State& state : {State{two, three}, State{three, two}, State{three, three}}) {
        CHECK_THROWS_AS(verifyBar(state, schedule, segments), std::invalid_argument);
    }
}

TEST_CASE("march: a tip that is held all the time is lowest where it is")
{
    // Waves of 1/2 press a bar on a wall at -g, and come back as they are.
    const Eigen::VectorXd half = Eigen::VectorXd::Constant(2, 0.5);
    Schedule schedule = onePhase(2, 7, 1);
    schedule.stops.right = -1;
    const Extremes seen =
        verifyBar({half, -half}, schedule, std::vector<Segment>{{1}, {1}}).extremes;
    CHECK(seen.lowestTip == -1.0);
    CHECK(seen.contactTime == seen.period);
}
