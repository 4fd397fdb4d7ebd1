// Simulations of bars of several segments.

#include <cmath>
#include <random>

#include "catch.hpp"
#include "signorini/motion.hpp"
#include "signorini/simulation.hpp"
#include "stepped_bar.hpp"
#include "stepped_waves.hpp"
#include "support.hpp"
#include "sweep_point.hpp"

using namespace signorini;

namespace {

/// 2..4 segments of 1..4 cells with impedances over two decades, sometimes a dashpot.
std::vector<Segment> randomSegments(std::mt19937_64& generator)
{
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    std::vector<Segment> segments;
    for (std::size_t k = 0, count = 2 + generator() % 3; k < count; ++k) {
        segments.push_back({.cells = 1 + static_cast<std::int64_t>(generator() % 4),
                            .impedance = std::pow(10.0, part(generator)),
                            .dashpot = k + 1 < count && generator() % 3 == 0 ? 0.3 : 0.0});
    }
    return segments;
}

Excitation forceOf(Excited place, double amplitude, std::int64_t steps, double perCrossing)
{
    return excitationOf({place, amplitude, 0.4, 1, steps, perCrossing});
}

}  // namespace

TEST_CASE("simulation of segments: equal ones move as one bar does")
{
    std::mt19937_64 generator(31);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    const std::vector<Segment> equal{{.cells = 3}, {.cells = 1}, {.cells = 5}};
    std::size_t contacts = 0;
    for (int k = 0; k < 24; ++k) {
        // Landings off the grid, and steps of the excitation that are no steps of the cells.
        const Damping damping{k % 3 == 0 ? 0.0 : 0.05 * part(generator)};
        const Excitation excitation =
            forceOf(k % 2 == 0 ? Excited::tip : Excited::base, 0.4 + 0.6 * part(generator), 20 + k,
                    9.0 + part(generator));
        const Stops stops = k % 4 == 3 ? Stops{1, Fraction{3, 2}} : Stops{};
        SimulationOptions options{.mergeBelow = {}, .recordsTip = false, .stops = stops};
        BarSimulation one(wavesAtRest(9.0), damping, excitation, options);
        options.segments = equal;
        BarSimulation parts(wavesAtRest(9.0), damping, excitation, options);
        for (int look = 0; look < 20; ++look) {
            one.advance(13.7);
            parts.advance(13.7);
            INFO("case " << k << ", " << one.time());
            CHECK(parts.time() == Approx(one.time()).epsilon(1e-13));
            CHECK(parts.tip() == Approx(one.tip()).margin(1e-9));
            CHECK(parts.energyRatio() == Approx(one.energyRatio()).epsilon(1e-8).margin(1e-9));
            CHECK(parts.impulse() == Approx(one.impulse()).epsilon(1e-8).margin(1e-9));
        }
        REQUIRE(parts.contacts().size() == one.contacts().size());
        for (std::size_t m = 0; m < one.contacts().size(); ++m) {
            CHECK(parts.contacts()[m].start == Approx(one.contacts()[m].start).margin(1e-8));
            CHECK(parts.contacts()[m].stop == one.contacts()[m].stop);
        }
        contacts += one.contacts().size();
    }
    CHECK(contacts > 100);
}

TEST_CASE("simulation of segments: without contact it is the step of the waves, on the grid")
{
    std::mt19937_64 generator(32);
    for (unsigned k = 0; k < 30; ++k) {
        const std::vector<Segment> segments = randomSegments(generator);
        const SteppedBar bar = steppedBar(segments);
        State start = test::randomState(bar.cells, k);
        start.a *= 1e-3;  // far from the wall
        start.b *= 1e-3;
        const Damping damping{0.1 * static_cast<double>(k % 4)};
        const Excitation excitation = forceOf(k % 2 == 0 ? Excited::tip : Excited::base, 1e-3, 11,
                                              static_cast<double>(bar.cells));
        BarSimulation simulation(wavesOf(start), damping, excitation, {.segments = segments});
        test::SteppedWaves waves(bar, start);
        const double z = bar.segments.back().impedance;
        const double eta = damping.eta();
        for (std::int64_t m = 0; m < 50; ++m) {
            simulation.advance(1.0);
            waves.step({.reflected = (z - eta) / (z + eta),
                        .pulled = excitation.force(m) / (z + eta),
                        .baseVelocity = excitation.baseVelocity(m)});
        }
        REQUIRE(simulation.contacts().empty());
        BarSimulation there(wavesOf(waves.state()), {}, {}, {.segments = segments});
        CHECK(simulation.energyRatio() ==
              Approx(energyRatio(waves.state(), segments)).epsilon(1e-9));
        CHECK((stretching(simulation.waves(), bar.cells) - stretching(there.waves(), bar.cells))
                  .lpNorm<Eigen::Infinity>() < 1e-12);
    }
}

TEST_CASE("simulation of segments: what the force does is kept, or goes into dashpots")
{
    std::mt19937_64 generator(33);
    int contacts = 0;
    for (int k = 0; k < 30; ++k) {
        const std::vector<Segment> segments = randomSegments(generator);
        const auto cells = static_cast<double>(steppedBar(segments).cells);
        BarSimulation simulation(wavesAtRest(segments, {}), {k % 2 == 0 ? 0.0 : 0.05},
                                 forceOf(k % 3 == 0 ? Excited::base : Excited::tip, 0.8, 30, cells),
                                 {.segments = segments});
        simulation.advance(400.0);
        const EnergyBalance balance = simulation.balance();
        INFO("case " << k);
        CHECK(balance.size > 0.0);
        CHECK(std::abs(balance.error) < 1e-9 * balance.size);
        CHECK(balance.dissipated >= 0.0);
        CHECK(simulation.tip() <= 1.0 + 1e-9);
        contacts += static_cast<int>(simulation.contacts().size());
    }
    CHECK(contacts > 50);
}

TEST_CASE("simulation of segments: the bar pressed at rest stays, and its force is the static one")
{
    const std::vector<Segment> segments{
        {.cells = 3}, {.cells = 2, .impedance = 0.4, .speed = 2.0}, {.cells = 4, .impedance = 5.0}};
    const Stops pressed{-1, {}};
    BarSimulation simulation(wavesAtRest(segments, pressed), {}, {},
                             {.stops = pressed, .segments = segments});
    CHECK(simulation.tip() == Approx(-1.0));
    simulation.advance(90.0);
    CHECK(simulation.tip() == Approx(-1.0));
    CHECK(simulation.isHeld());
    // Springs in a row: lengths 3 : 4 : 4 of 11, EA 1, 0.8 and 5.
    Scene scene;
    scene.bar.gap = -1e-3;
    scene.segments = segments;
    const double force = 1e-3 / ((3.0 + 4.0 / 0.8 + 4.0 / 5.0) / 11.0);
    CHECK(staticForce(scene) == Approx(force).epsilon(1e-14));
    // Its unit is EA |g|/L of a bar of the first material with the same travel time.
    const double unit = scales(firstMaterial(scene)).strain;
    CHECK(simulation.impulse() * unit == Approx(force * simulation.time()).epsilon(1e-12));
}

TEST_CASE("simulation of segments: its largest strain is that of all waves that meet in a cell")
{
    std::mt19937_64 generator(34);
    constexpr std::int64_t period = 48;  // times 1..4 cells, whole
    for (unsigned k = 0; k < 12; ++k) {
        std::vector<Segment> segments = randomSegments(generator);
        for (Segment& segment : segments) {
            segment.impedance = std::sqrt(std::sqrt(segment.impedance));
            segment.speed = generator() % 2 == 0 ? 1.0 : 2.5;
        }
        segments.front().speed = 1.0;
        const SteppedBar bar = steppedBar(segments);
        const Excitation excitation = forceOf(k % 2 == 0 ? Excited::tip : Excited::base, 1e-3,
                                              period, static_cast<double>(bar.cells));
        const Damping damping{0.3};
        BarSimulation simulation(wavesAtRest(segments, {}), damping, excitation,
                                 {.segments = segments});
        const State rest{Eigen::VectorXd::Zero(bar.cells), Eigen::VectorXd::Zero(bar.cells)};
        test::SteppedWaves waves(bar, rest);
        const double z = bar.segments.back().impedance;
        const double eta = damping.eta();
        double worst = 0.0;
        constexpr std::int64_t before = 50 * period;
        State was = rest;
        for (std::int64_t m = 0; m < before + period; ++m) {
            waves.step({.reflected = (z - eta) / (z + eta),
                        .pulled = excitation.force(m) / (z + eta),
                        .baseVelocity = excitation.baseVelocity(m)});
            // In the step before and after, and where one of the two waves has come already.
            const State now = waves.state();
            for (const State& both : {was, State{now.a, was.b}, State{was.a, now.b}}) {
                const double most = strain(both, bar.segments).lpNorm<Eigen::Infinity>();
                worst = m < before ? 0.0 : std::max(worst, most);
            }
            was = now;
        }
        simulation.advance(static_cast<double>(before));
        INFO("case " << k);
        REQUIRE(simulation.contacts().empty());
        CHECK(largestStrain(simulation, static_cast<double>(period)) ==
              Approx(worst).epsilon(1e-8));
        CHECK(simulation.time() * static_cast<double>(bar.cells) ==
              Approx(static_cast<double>(before + period)).epsilon(1e-12));
    }
}

TEST_CASE("simulation of segments: strain and energy of a state know the segments")
{
    const State state = test::randomState(3, 5);
    const std::vector<Segment> segments{{.cells = 1, .impedance = 2.0},
                                        {.cells = 2, .impedance = 6.0, .speed = 4.0}};
    const Eigen::VectorXd plain = strain(state);
    const Eigen::VectorXd known = strain(state, segments);
    CHECK(known[0] == plain[0]);
    CHECK(known[2] == plain[2] / 4.0);
    CHECK(strain(state, {}) == plain);
    CHECK(energyRatio(state, {}) == energyRatio(state));
    const double lighter = 2.0 / 3.0 * (state.a[0] * state.a[0] + state.b[0] * state.b[0]);
    CHECK(energyRatio(state, segments) ==
          Approx(lighter + 3.0 * (energyRatio(state) - lighter)).epsilon(1e-14));
    CHECK_THROWS_WITH(energyRatio(test::randomState(4, 1), segments),
                      containsText("4 and 4 cells"));
}

TEST_CASE("simulation of segments: a start of other cells is refused, a copy goes its own way")
{
    const std::vector<Segment> segments{{.cells = 2}, {.cells = 2, .impedance = 3.0}};
    CHECK_THROWS_WITH(BarSimulation(wavesAtRest(5.0), {}, {}, {.segments = segments}),
                      containsText("crossing of the start = 5"));
    CHECK_THROWS_WITH(BarSimulation(wavesAtRest(4.0), {}, {},
                                    {.segments = {{.cells = 2}, {.cells = 2, .impedance = -1.0}}}),
                      containsText("impedance of segment 2"));
    BarSimulation one(wavesAtRest(4.0), {}, forceOf(Excited::tip, 1.0, 12, 4.0),
                      {.segments = segments});
    one.advance(7.0);
    BarSimulation other = one;
    other.advance(5.0);
    one.advance(5.0);
    CHECK(other.tip() == one.tip());
    other.advance(1.0);
    CHECK(other.time() > one.time());
}
