// What a bar settles on while a number is varied, against the exact motions and the linear
// response.

#include "signorini/sweep.hpp"

#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "network_find.hpp"
#include "network_sweep.hpp"
#include "signorini/assembly.hpp"
#include "signorini/response.hpp"
#include "support.hpp"
#include "sweep_point.hpp"

using namespace signorini;

namespace {

const std::vector both{SweepDirection::up, SweepDirection::down};

SweepRange section15()
{
    return {.least = 0.9,
            .most = 1.2,
            .points = 7,
            .cells = 30,
            .amplitude = 0.25,
            .damping = dampingOfRho(0.9)};
}

/// Serves the last first.
void backward(std::size_t count, const std::function<bool(std::size_t)>& serve)
{
    for (std::size_t k = count; k > 0 && serve(k - 1); --k) {
    }
}

/// All motions with one contact on the grid of the sweep: its frequency is 4N/n.
FrequencyResponse exactAt(const SweepRange& range, const SweepPoint& point)
{
    for (double cells = range.cells; cells <= 4.0 * range.cells; cells += 1.0) {
        const double steps = 4.0 * cells / point.frequencyRatio;
        if (std::abs(steps - std::round(steps)) < 1e-7) {
            return responseAt({.cells = static_cast<std::int64_t>(cells),
                               .damping = range.damping,
                               .place = range.place,
                               .amplitude = range.amplitude,
                               .stops = range.stops},
                              static_cast<std::int64_t>(std::round(steps)))
                .value();
        }
    }
    throw std::logic_error("the frequency is on no grid");
}

}  // namespace

TEST_CASE("sweep: what repeats with one contact is one of the exact motions")
{
    SweepRange range = section15();
    range.cells = 110.0;
    int seen = 0;
    for (const SweepPoint& point : sweep(range, both)) {
        const auto& settled = point.settling.settled;
        if (!settled || settled->periods != 1 || settled->contacts != 1) {
            continue;
        }
        INFO(point.value);
        ++seen;
        CHECK(point.contacts == std::array<std::int64_t, 2>{1, 1});
        CHECK(point.meanImpulse == Approx(settled->impulse).epsilon(1e-6));
        const FrequencyResponse exact = exactAt(range, point);
        // The grid of the excitation is the same, the contact times are not bound to it.
        double nearest = 1.0;
        for (const ForcedMotion& motion : exact.motions) {
            const Extremes& extremes = motion.extremes;
            nearest = std::min(nearest,
                               std::max({std::abs(point.meanImpulse / extremes.impulse - 1.0),
                                         std::abs(point.tip[0] / extremes.lowestTip - 1.0),
                                         std::abs(point.strain / std::max(extremes.peakCompression,
                                                                          extremes.peakTension) -
                                                  1.0)}));
        }
        CHECK(nearest < 0.02);
    }
    CHECK(seen >= 4);
}

TEST_CASE("sweep: without a wall in reach it is the linear response, from rest and carried over")
{
    for (const Excited place : {Excited::tip, Excited::base}) {
        for (const bool isCarried : {true, false}) {
            SweepRange range = section15();
            range.place = place;
            range.amplitude = 0.01;
            range.isCarried = isCarried;
            for (const SweepPoint& point : sweep(range, both, {.share = backward})) {
                REQUIRE(point.settling.settled);
                CHECK(point.settling.settled->contacts == 0);
                CHECK(point.tip[1] == Approx(exactAt(range, point).linearPeak).epsilon(5e-3));
                CHECK(point.impulses.empty());
            }
        }
    }
}

TEST_CASE("sweep: up and down keep different motions where two attract")
{
    SweepRange range = section15();
    range.least = 1.05;
    range.most = 1.3;
    range.points = 6;
    const std::vector<SweepPoint> points = sweep(range, both);
    REQUIRE(points.size() == 12);
    int apart = 0;
    for (std::size_t k = 0; k < 6; ++k) {
        const SweepPoint& down = points[11 - k];
        CHECK(points[k].value == down.value);
        apart += points[k].meanImpulse > 0.1 && down.meanImpulse == 0.0 ? 1 : 0;
    }
    CHECK(apart >= 1);
}

TEST_CASE("sweep: a gap twice as wide is half the amplitude; amplitude and damping as simulated")
{
    SweepRange range = section15();
    range.over = Swept::gap;
    range.least = 1.0;
    range.most = 2.0;
    range.points = 2;
    range.frequencyRatio = 30.0 / 29.0;
    range.isCarried = false;
    const SweepPoint wide = sweep(range, {SweepDirection::up}).back();
    range.over = Swept::amplitude;
    range.least = 0.125;
    range.most = 0.25;
    const std::vector<SweepPoint> half = sweep(range, both);
    REQUIRE(half.size() == 4);
    CHECK(half[0].meanImpulse * 2.0 == Approx(wide.meanImpulse));
    CHECK(half[0].tip[0] * 2.0 == Approx(wide.tip[0]));
    CHECK(half[1].meanImpulse > half[0].meanImpulse);
    range.over = Swept::damping;
    range.amplitude = 0.25;
    range.least = range.most = range.damping.ratio;
    range.points = 1;
    CHECK(sweep(range, {SweepDirection::up})[0].meanImpulse == Approx(half[1].meanImpulse));
}

TEST_CASE("sweep: contacts and impulses are those of a simulation from rest")
{
    SweepRange range = section15();
    range.least = range.most = 120.0 / 111.0;
    range.points = 1;
    const SweepPoint point = sweep(range, {SweepDirection::up}).at(0);
    REQUIRE(point.settling.settled);
    const Excitation driving =
        excitationAt({.amplitude = 0.25, .phase = std::acos(0.0), .stepsPerCrossing = 30.0},
                     point.frequencyRatio);
    BarSimulation simulation(wavesAtRest(30.0), range.damping, driving);
    const double period = stretchOf(driving, 30.0);
    simulation.advance(static_cast<double>(point.watched + 1) * period);
    const double before = simulation.impulse();
    const auto contacts = static_cast<std::int64_t>(simulation.contacts().size());
    const auto repeats = static_cast<double>(point.settling.settled->periods);
    simulation.advance(repeats * period);
    CHECK((simulation.impulse() - before) / repeats == Approx(point.meanImpulse).epsilon(1e-6));
    CHECK(static_cast<std::int64_t>(simulation.contacts().size()) - contacts ==
          point.settling.settled->contacts);
}

TEST_CASE("sweep: segments, second stops, gaps of any sign; alike segments are the uniform bar")
{
    SweepRange range = section15();
    range.points = 3;
    range.periods = 100;
    const std::vector<SweepPoint> plain = sweep(range, both);
    range.segments = {{12, 1.0, 1.0, 0.0}, {18, 1.0, 1.0, 0.0}};
    const std::vector<SweepPoint> alike = sweep(range, both);
    range.segments = {{12, 1.0, 1.0, 0.0}, {18, 1.3, 1.0, 0.0}};
    REQUIRE(alike.size() == plain.size());
    for (std::size_t k = 0; k < plain.size(); ++k) {
        CHECK(alike[k].meanImpulse == plain[k].meanImpulse);
    }
    CHECK(sweep(range, both).size() == 6);
    range.segments.clear();
    range.stops.left = Fraction{1, 2};
    for (const SweepPoint& point : sweep(range, both)) {
        CHECK(point.tip[0] >= -0.5 - 1e-9);
    }
    for (const int right : {0, -1}) {
        range.stops = {right, std::nullopt};
        for (const SweepPoint& point : sweep(range, both)) {
            CHECK(point.tip[1] <= right + 1e-9);
        }
    }
}

TEST_CASE("sweep: what was done stays where it is cancelled, and no range is refused")
{
    SweepRange range = section15();
    int looks = 0;
    const auto points = sweep(range, both, {.cancel = [&looks] { return ++looks > 1050; }});
    CHECK(!points.empty());
    CHECK(points.size() < 14);
    const auto refused = [&](auto change) {
        SweepRange spoilt = section15();
        change(spoilt);
        CHECK_THROWS_AS(sweep(spoilt, both), std::invalid_argument);
    };
    refused([](SweepRange& r) { r.points = 0; });
    refused([](SweepRange& r) { r.periods = 0; });
    refused([](SweepRange& r) { r.least = -1.0; });
    refused([](SweepRange& r) { r.most = 0.5; });
    refused([](SweepRange& r) { r.amplitude = NAN; });
    refused([](SweepRange& r) { r.cells = 0.0; });
    refused([](SweepRange& r) { r.most = 1e9; });
    refused([](SweepRange& r) {
        r.over = Swept::gap;
        r.stops.right = 0;
    });
}

TEST_CASE("sweep: a bar as a network does what the bar does, whole or in parts")
{
    SweepRange range = section15();
    range.least = 1.1;
    range.points = 4;
    const Bar bar;
    const Network network = networkOf(Scene(bar), 30, range.damping);
    const NetworkSweep several{network, bar, range};
    const SweepBody body = several.body();
    std::vector<SweepStep> kept;
    const std::vector<SweepPoint> alike = sweep(
        range, body, both, {.keep = [&kept](const SweepStep& step) { kept.push_back(step); }});
    const std::vector<SweepPoint> own = sweep(range, both);
    REQUIRE(alike.size() == own.size());
    int touching = 0;
    for (std::size_t k = 0; k < own.size(); ++k) {
        // Steps of the excitation are others, and contacts that are apart by less than one are one.
        INFO(own[k].value);
        REQUIRE(alike[k].settling.settled);
        CHECK(alike[k].settling.settled->periods == own[k].settling.settled->periods);
        CHECK(alike[k].contacts == own[k].contacts);
        CHECK(alike[k].meanImpulse == Approx(own[k].meanImpulse).epsilon(0.03).margin(1e-9));
        CHECK(alike[k].tip[0] == Approx(own[k].tip[0]).epsilon(0.03));
        CHECK(alike[k].meanForce == Approx(own[k].meanForce).epsilon(0.1).margin(1e-9));
        CHECK(alike[k].strain == Approx(own[k].strain).epsilon(0.05));
        if (own[k].value == range.most) {  // there the steps are the same
            CHECK(alike[k].strain == Approx(own[k].strain).epsilon(1e-9));
        }
        touching += own[k].meanImpulse > 0.0 ? 1 : 0;
    }
    CHECK(touching > 2);
    kept.resize(3);
    const std::vector<SweepPoint> resumed = sweep(range, body, both, {.known = kept});
    for (std::size_t k = 0; k < resumed.size(); ++k) {
        CHECK(resumed[k].meanImpulse == alike[k].meanImpulse);
        CHECK(resumed[k].settling.settled->residual == alike[k].settling.settled->residual);
    }
}

TEST_CASE("sweep: the largest strain of bars is that which the walk along their motion sees")
{
    int count = 0;
    for (const double gravity : {0.0, 2e-3}) {
        for (const char* words :
             {"clamp 6 gap=1e-3 4:1.3 clamp", "spring=2 7:0.8 3:1:1.5 stop=1e-3",
              "clamp 3 stop=5e-4 5:2 spring=1", "clamp 9 mass=0.5 2 stop=1e-3"}) {
            Assembly assembly;
            assembly.parts = partsOf(words);
            assembly.gravity = gravity;
            const Network network = networkOf(assembly);
            for (const std::int64_t closed : {1, 2, 3, 4}) {
                for (const std::int64_t free : {11, 13, 19, 23, 25, 29, 33}) {
                    const LeastMotion found = leastMotion(network, {{1, closed}, {0, free}}, 1e9);
                    if (!found.motion) {
                        continue;
                    }
                    ++count;
                    const NetworkExtremes seen = walk(network, *found.motion).extremes;
                    NetworkSimulation simulation(
                        network, {found.motion->waves, found.motion->displacements});
                    const double strain =
                        largestStrain(simulation, static_cast<double>(closed + free));
                    INFO(words << ", " << closed << " " << free << ", " << gravity);
                    CHECK(strain == Approx(std::max(-seen.leastStrain, seen.mostStrain))
                                        .epsilon(1e-9)
                                        .margin(1.01 * network.gravity));
                }
            }
        }
    }
    CHECK(count > 12);
}

TEST_CASE("sweep: the largest strain of several segments is that of the uniform bar they are")
{
    SweepRange range = section15();
    range.least = 0.8;
    range.most = 0.9;
    range.points = 3;
    const std::vector<SweepPoint> one = sweep(range, {SweepDirection::up});
    range.segments = {{.cells = 11}, {.cells = 12, .dashpot = 1e-12}, {.cells = 7}};
    const std::vector<SweepPoint> parts = sweep(range, {SweepDirection::up});
    for (std::size_t k = 0; k < one.size(); ++k) {
        CHECK(parts[k].strain == Approx(one[k].strain).epsilon(0.02));
    }
}
