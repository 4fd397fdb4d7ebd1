// Continua of networks: of one uniform bar the sets and their members are those of the geometry,
// which knows nothing of networks; of others every member is walked, and marched without its
// schedule.

#include <algorithm>
#include <cmath>
#include <limits>

#include "bar_check.hpp"
#include "catch.hpp"
#include "contact_spans.hpp"
#include "continuum_support.hpp"
#include "curve_march.hpp"
#include "network_continuum.hpp"
#include "network_section.hpp"
#include "scene_words.hpp"

using namespace signorini;
using test::onePhase;

namespace {

const std::vector<ContactSpan> ofTwoBars{{1, 6}, {0, 40}};

Network twoBars(double strainLimit = std::numeric_limits<double>::infinity())
{
    Network network = sceneOf("clamp 12 gap=1e-3 16 clamp");
    network.strainLimit = strainLimit;
    return network;
}

void requireMotions(const Network& network, const NetworkContinuum& curve)
{
    INFO(curve.detail);
    REQUIRE(curve.status == Status::found);
    for (const NetworkCurvePoint& point : curve.points) {
        CHECK(walk(network, point.motion).worst() <= 1e-7);
        CHECK(std::abs(point.energy / curve.energy - 1.0) <= 1e-7);
        const NetworkMarch seen = march(network, point.motion, 1e-7);
        CHECK(seen.firstFault == -1);
        CHECK(seen.residual <= 1e-6);
        CHECK(point.residuals.extremes.leastStrain >= -network.strainLimit * (1.0 + 1e-6));
    }
}

/// The mean over a sample of the largest share that one of the classes has of all squares.
double meanLargest(const std::vector<State>& motions)
{
    double sum = 0.0;
    for (const State& motion : motions) {
        sum += std::max(motion.a.cwiseAbs().maxCoeff(), motion.b.cwiseAbs().maxCoeff());
    }
    return sum / static_cast<double>(motions.size());
}

}  // namespace

TEST_CASE("continuum of networks: one bar has the sets of the geometry", "[glpk]")
{
    int compared = 0;
    for (const std::int64_t cells : {2, 3, 4, 6}) {
        const Network network = networkOf(Scene{}, cells, {});
        for (std::int64_t contact = 1; contact <= 4; ++contact) {
            for (std::int64_t free = 1; free <= 8 * cells; ++free) {
                const Schedule schedule = onePhase(cells, contact, free);
                const OnePhaseSet set = onePhaseSet(schedule);
                if (set.reason || energyRange(set).most < 1.1 * energyRange(set).least) {
                    continue;
                }
                CAPTURE(cells, contact, free);
                const double energy = 1.05 * energyRange(set).least;
                const Continuum known =
                    traceContinuum(schedule, energy, {.points = 2, .trace = trace::Sample{}});
                const NetworkContinuum curve =
                    traceContinuum(network, spansOf(schedule), energy * *firstEnergy(network),
                                   {.points = 3, .isSample = true});
                requireMotions(network, curve);
                CHECK(curve.dimension == known.dimension);
                for (const NetworkCurvePoint& point : curve.points) {
                    const State state = stateOf(network, point.motion.waves);
                    CHECK(verify(state, schedule).residuals.worst() <= 1e-7);
                    CHECK(std::abs(energyRatio(state) / energy - 1.0) <= 1e-7);
                }
                ++compared;
            }
        }
    }
    CHECK(compared > 20);
}

TEST_CASE("continuum of networks: great circles draw as evenly as the geometry does", "[glpk]")
{
    // (5, 30) on 10 cells: members of the simplex of five shares at 1.6 times the least energy.
    const Schedule schedule = onePhase(10, 5, 30);
    const double energy = 1.6 * energyRange(onePhaseSet(schedule)).least;
    constexpr std::int64_t count = 4000;
    const Network network = networkOf(Scene{}, 10, {});
    const NetworkContinuum drawn =
        traceContinuum(network, spansOf(schedule), energy * *firstEnergy(network),
                       {.points = count, .isSample = true, .seed = 7});
    REQUIRE(drawn.status == Status::found);
    std::vector<State> motions;
    for (const NetworkCurvePoint& point : drawn.points) {
        motions.push_back(stateOf(network, point.motion.waves));
    }
    const std::vector<State> others = sampleMotions(schedule, energy, count, 3);
    // Spread of one is 0.1 at most, so that of a mean is below 0.002.
    CHECK(std::abs(meanLargest(motions) - meanLargest(others)) < 0.01);
    const double first = motions.front().a[0];
    CHECK(std::any_of(motions.begin(), motions.end(),
                      [first](const State& one) { return one.a[0] != first; }));
}

TEST_CASE("continuum of networks: what a curve cannot join is not said to be joined", "[glpk]")
{
    if (preferred(continuumNeeds) == nullptr) {
        return;  // no back end that holds an energy
    }
    // At 22 E_1 one of six shares exceeds a half, so there are six components.
    const Schedule schedule = onePhase(12, 6, 36);
    const double energy = 22.0;
    const Continuum known =
        traceContinuum(schedule, energy, {.points = 40, .trace = trace::Sample{3}});
    REQUIRE(known.components == 6);
    const Network network = networkOf(Scene{}, 12, {});
    const double held = energy * *firstEnergy(network);
    const auto largest = [](const State& state) {
        Eigen::Index at = 0;
        state.a.maxCoeff(&at);
        return at;
    };
    int joined = 0;
    int apart = 0;
    const State& from = known.points.front().state;
    for (std::size_t k = 1; k < 12; ++k) {
        const State& to = known.points[k].state;
        const Continuum path =
            traceContinuum(schedule, energy, {.points = 11, .trace = trace::Path{from, to}});
        const NetworkContinuum curve = traceContinuum(
            network, spansOf(schedule), held,
            {.points = 11, .from = wavesOf(network, from), .to = wavesOf(network, to)});
        CAPTURE(k, curve.detail, largest(from), largest(to));
        if (path.connected == true) {
            requireMotions(network, curve);
            CHECK(curve.connected == true);
            CHECK(curve.points.back().lambda >=
                  0.99 * std::sqrt(energyRatio({from.a - to.a, from.b - to.b})));
            ++joined;
        } else {
            CHECK(curve.status != Status::found);
            CHECK(curve.connected != true);
            ++apart;
        }
    }
    CHECK(joined > 0);
    CHECK(apart > 0);
}

TEST_CASE("continuum of networks: paths, walks and samples of two bars", "[glpk]")
{
    if (preferred(continuumNeeds) == nullptr) {
        return;  // no back end that holds an energy
    }
    const Network network = twoBars();
    const double energy = 8.0 * *firstEnergy(network);
    const NetworkContinuum sample =
        traceContinuum(network, ofTwoBars, energy, {.points = 12, .isSample = true});
    requireMotions(network, sample);
    CHECK(sample.parameter == Parameter::number);
    CHECK(sample.connected == std::nullopt);
    CHECK(sample.points.size() == 12);
    const auto wavesAt = [&sample](std::size_t k) { return sample.points[k].motion.waves; };

    SECTION("between two motions")
    {
        const NetworkContinuum path = traceContinuum(
            network, ofTwoBars, energy, {.points = 21, .from = wavesAt(0), .to = wavesAt(1)});
        requireMotions(network, path);
        CHECK(path.connected == true);
        CHECK(path.points.size() >= 21);
        CHECK(path.resolution <= 0.05);
        CHECK(path.points.front().lambda == 0.0);
        CHECK(pointAt(path, path.points[4].lambda) == 4);
        CHECK_THROWS_WITH(pointAt(path, -1.0), containsText("allowed"));
        for (std::size_t k = 0; k < network.waves(); ++k) {
            CHECK(std::abs(path.points.back().motion.waves[k] - wavesAt(1)[k]) < 1e-5);
        }
    }
    SECTION("from a motion towards another")
    {
        const NetworkContinuum way =
            traceContinuum(network, ofTwoBars, energy,
                           {.points = 31, .from = wavesAt(0), .direction = wavesAt(1)});
        requireMotions(network, way);
        CHECK(way.family == "walk in a given direction");
        CHECK(way.points.back().lambda > 0.5);
    }
    SECTION("of the solver's choice")
    {
        requireMotions(network, traceContinuum(network, ofTwoBars, energy, {.points = 11}));
    }
    SECTION("a limit on strain")
    {
        const NetworkContinuum whole =
            traceContinuum(network, ofTwoBars, energy, {.points = 30, .isSample = true, .seed = 5});
        std::vector<double> strains;
        for (const NetworkCurvePoint& point : whole.points) {
            strains.push_back(-point.residuals.extremes.leastStrain);
        }
        std::sort(strains.begin(), strains.end());
        const Network limited = twoBars(strains[15]);  // about half of them break it
        for (const bool isSample : {true, false}) {
            const NetworkContinuum curve =
                traceContinuum(limited, ofTwoBars, energy, {.points = 11, .isSample = isSample});
            requireMotions(limited, curve);
        }
    }
}

TEST_CASE("continuum of networks: energies below the least are none, with a proof")
{
    const Network network = twoBars();
    const double unit = *firstEnergy(network);
    const NetworkContinuum low = traceContinuum(network, ofTwoBars, 5.0 * unit, {});
    CHECK(low.status == Status::none);
    CHECK(low.points.empty());
    CHECK(low.known.provedEnergy > 5.0 * unit);
    CHECK(low.known.provedEnergy < 5.25 * unit);  // (6, 40) of two bars: 5.25 E_1
    // The least itself, of one motion alone.
    const NetworkContinuum least = traceContinuum(network, ofTwoBars, 5.25 * unit, {});
    requireMotions(network, least);
    CHECK(least.points.size() == 1);
    CHECK(least.family == "the motion of least energy");
    CHECK_THAT(least.detail, containsText("√E apart"));
    CHECK(least.connected == std::nullopt);
    const NetworkContinuum never = traceContinuum(network, {{1, 6}, {0, 36}}, 50.0 * unit, {});
    CHECK(never.status == Status::none);
    CHECK(never.known.isEmpty);
}

TEST_CASE("continuum of networks: motions that are isolated are listed, and nothing is claimed",
          "[glpk]")
{
    // Three cells before a stop and one beyond it, (1, 3): one unknown is left.
    const Network network = sceneOf("clamp 3 stop=1e-3 1 clamp");
    const std::vector<ContactSpan> schedule{{1, 1}, {0, 3}};
    const LeastMotion least = leastMotion(network, schedule, 1e9);
    REQUIRE(least.status == Status::found);
    const NetworkContinuum pair = traceContinuum(network, schedule, 1.3 * least.energy, {});
    requireMotions(network, pair);
    REQUIRE(pair.points.size() == 2);
    CHECK(pair.dimension == 0);
    CHECK(pair.connected == std::nullopt);
    CHECK_THAT(pair.detail, containsText("as far as rounding tells"));
    const NetworkContinuum apart =
        traceContinuum(network, schedule, 1.3 * least.energy,
                       {.from = pair.points[0].motion.waves, .to = pair.points[1].motion.waves});
    CHECK(apart.status == Status::undecided);
    CHECK(apart.connected == std::nullopt);
}

TEST_CASE("continuum of networks: wrong use is named", "[glpk]")
{
    const Network network = twoBars();
    const double energy = 8.0 * *firstEnergy(network);
    const auto refuses = [&](const NetworkCurveOptions& options, const char* text,
                             double of = -1.0) {
        CHECK_THROWS_WITH(traceContinuum(network, ofTwoBars, of < 0.0 ? energy : of, options),
                          containsText(text));
    };
    refuses({}, "energy = 0", 0.0);
    refuses({.points = 1}, "points = 1 ");
    refuses({.resolution = 0.0}, "resolution = 0 ");
    refuses({.tolerance = 1.0}, "tolerance = 1 ");
    refuses({.solver = "closed-form"}, "solver = closed-form");
    refuses({.isSample = true, .solver = "ipopt"}, "solver = ipopt");
    refuses({.solver = "oracle"}, "oracle");
    const std::vector<double> none(network.waves(), 0.0);
    refuses({.from = none, .to = none}, "from = a state of 0 times the energy");
    // Of another network.
    refuses({.from = std::vector<double>(3, 0.0), .to = none}, "from = a state of 3 waves");
    refuses({.from = none, .direction = std::vector<double>(99, 0.0)},
            "direction = a state of 99 waves");
}
