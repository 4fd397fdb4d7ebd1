#include "network_simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "catch.hpp"
#include "random_network.hpp"
#include "statics.hpp"

using namespace signorini;
using signorini::test::NetworkGenerator;

namespace {

Network network(const std::string& text)
{
    return networkOf(Assembly{.parts = partsOf(text)});
}

double largest(const std::vector<double>& values)
{
    double most = 0.0;
    for (const double value : values) {
        most = std::max(most, std::abs(value));
    }
    return most;
}

double difference(const std::vector<double>& one, const std::vector<double>& other)
{
    double most = 0.0;
    for (std::size_t k = 0; k < one.size(); ++k) {
        most = std::max(most, std::abs(one[k] - other[k]));
    }
    return most;
}

}  // namespace

TEST_CASE("network simulation: a striker sends a staircase into a rod")
{
    // The end of the rod moves at V rho gamma^k in the k-th interval of 2 L_s/c.
    const double speed = 1.0;
    {
        NetworkSimulation simulation(
            network("50:3 gap=0 200:1"),
            startWithSpeeds(network("50:3 gap=0 200:1"), std::vector{speed, 0.0}));
        double expected = 0.75 * speed;
        simulation.advance(50.0);
        for (int k = 0; k < 4; ++k) {
            CHECK(simulation.velocity(2) == expected);
            CHECK(simulation.velocity(1) == expected);
            expected *= 0.5;
            simulation.advance(100.0);
        }
    }
    {  // gamma < 0: they part after the first
        const Network scene = network("50:1 gap=0 200:3");
        NetworkSimulation simulation(scene, startWithSpeeds(scene, std::vector{speed, 0.0}));
        simulation.advance(300.0);
        REQUIRE(simulation.contacts().size() == 1);
        CHECK(simulation.contacts().front() ==
              NetworkContactEvent{0, 0.0, 100.0, 0.75 * 100.0, 0.75, 1.0});
        CHECK(simulation.closed() == 0);
        CHECK(simulation.velocity(2) == 0.0);
    }
    {  // equal impedances: one pulse of V/2 lasting 2 L_s/c, and the striker stops
        const Network scene = network("50 gap=0 200");
        NetworkSimulation simulation(scene, startWithSpeeds(scene, std::vector{speed, 0.0}));
        simulation.advance(300.0);
        REQUIRE(simulation.contacts().size() == 1);
        CHECK(simulation.contacts().front().end == 100.0);
        CHECK(simulation.contacts().front().impulse == 0.5 * 100.0);
        CHECK(simulation.contacts().front().peakForce == 0.5);
        CHECK(simulation.velocity(0) == 0.0);
        CHECK(simulation.velocity(1) == 0.0);
    }
}

TEST_CASE("network simulation: two equal bars that meet exchange their speeds in 2 L/c")
{
    const Network scene = network("64 gap=1e-3 64");
    NetworkSimulation simulation(scene, startWithSpeeds(scene, std::vector{1.0, -1.0}));
    simulation.advance(1000.0);
    const std::vector<NetworkContactEvent> events = simulation.contacts();
    REQUIRE(events.size() == 1);
    CHECK(events.front().start == 64.0);  // 128 delta at relative speed 2
    CHECK(events.front().end == 64.0 + 2.0 * 64.0);
    const std::vector<double> after = simulation.state().waves;
    for (std::size_t k = 0; k < after.size(); ++k) {
        CHECK(after[k] == (k < 128 ? -0.5 : 0.5));
    }
    CHECK(simulation.balance().error == 0.0);
    CHECK(simulation.momentumBalance().error == 0.0);
    CHECK(simulation.merged() == 0.0);
}

TEST_CASE("network simulation: a contact is met with the speed before waves that arrive with it")
{
    // A free bar pushed with F = Z c moves its end with c, and from 2 L/c, when the wave is back
    // from the other end, with 3 c.
    const std::int64_t crossing = 4;
    for (const double gap : {1.0, 2.0, 3.5}) {
        const Network scene = network(fmt::format("{} force=1 stop={}", crossing, gap));
        NetworkSimulation simulation(scene, startWithSpeeds(scene, std::vector{0.0}));
        simulation.advance(4.0 * static_cast<double>(crossing));
        const std::vector<NetworkContactEvent> events = simulation.contacts();
        REQUIRE(!events.empty());
        const double begin = gap <= 2.0 ? gap : 2.0 + (gap - 2.0) / 3.0;  // L/c
        CHECK(events.front().start == Approx(begin * static_cast<double>(crossing)));
        CHECK(events.front().speed * scene.scales.velocity() == Approx(gap <= 2.0 ? 1.0 : 3.0));
    }
}

TEST_CASE("network simulation: the bouncing bar of Doyen, Ern and Piperno repeats after 16/3")
{
    // L = 10, E = 900, rho = 1, g = 10, dropped from 5; the wave speed is 30, a crossing takes 1/3.
    for (const int cells : {1, 2, 5}) {
        const Assembly bar{.parts = partsOf(std::to_string(cells) + " stop=5"),
                           .length = 10.0,
                           .waveSpeed = 30.0,
                           .axialStiffness = 900.0,
                           .gravity = 10.0};
        const Network scene = networkOf(bar);
        NetworkSimulation simulation(scene, startWithSpeeds(scene, std::vector{0.0}));
        const double second = 3.0 * cells;
        simulation.advance(second);  // it falls 5 in 1 s
        const double speed = scene.scales.velocity();
        CHECK(simulation.velocity(1) * speed == Approx(10.0).epsilon(1e-2 + 0.5 / cells));
        simulation.advance(0.5 * second);
        const std::vector<double> start = simulation.state().waves;
        const int bounces = cells == 2 ? 1'000'000 : 1000;
        for (int bounce = 0; bounce < bounces; bounce += 2) {
            simulation.advance(16.0 * cells);
        }
        const std::vector<double> after = simulation.state().waves;
        CHECK(difference(after, start) < 1e-6 * largest(start));
        const std::vector<NetworkContactEvent> events = simulation.contacts();
        REQUIRE(events.size() == static_cast<std::size_t>(bounces) + 1);
        for (std::size_t k = 0; k < events.size(); k += 1 + events.size() / 50) {
            CHECK(events[k].end - events[k].start == Approx(2.0 * cells).epsilon(1e-6));
        }
        CHECK(std::abs(simulation.balance().error) < 1e-9 * simulation.balance().size);
        CHECK(std::abs(simulation.momentumBalance().error) <
              1e-9 * simulation.momentumBalance().size);
    }
}

TEST_CASE("network simulation: energy and momentum of any network balance")
{
    NetworkGenerator draw(5);
    int contacts = 0;
    for (int sample = 0; sample < 300; ++sample) {
        const Network scene = draw.network(
            {.mostCells = 6, .hasDashpots = draw.isOneOf(2), .hasForces = draw.isOneOf(2)});
        std::vector<double> speeds;
        for (std::size_t k = 0; k < scene.bars.size(); ++k) {
            speeds.push_back(draw.fraction() * (draw.isOneOf(2) ? 0.1 : -0.1));
        }
        NetworkDrive drive;
        if (draw.isOneOf(2)) {
            drive.forces = {0.1 * draw.fraction(), -0.2 * draw.fraction(), 0.0};
            drive.velocities = {0.1 * draw.fraction(), 0.0, -0.1 * draw.fraction()};
            drive.step = draw.fraction();
        }
        NetworkSimulation simulation(scene, startWithSpeeds(scene, speeds), drive,
                                     {.mergeBelow = 1e-9});
        for (int stretch = 0; stretch < 5; ++stretch) {
            simulation.advance(7.0 + draw.fraction());
            for (std::size_t j = 0; j < scene.contacts.size(); ++j) {
                const NetworkContact& contact = scene.contacts[j];
                const double here = simulation.displacement(contact.node);
                const double distance =
                    contact.kind == ContactKind::stopRight ? contact.gap - here
                    : contact.kind == ContactKind::stopLeft
                        ? contact.gap + here
                        : contact.gap - here + simulation.displacement(contact.node + 1);
                CHECK(distance > -1e-7);
            }
        }
        const NetworkBalance energy = simulation.balance();
        CHECK(std::abs(energy.error) <= 1e-6 * energy.size);
        const MomentumBalance momentum = simulation.momentumBalance();
        CHECK(std::abs(momentum.error) <= 1e-6 * momentum.size);
        // Displacements are those that the waves say, in bars that hang on something.
        const NetworkStart state = simulation.state();
        const std::vector<double> said = displacementsOf(scene, state.waves, {});
        for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
            const NetworkBar& bar = scene.bars[scene.nodes[node].bar];
            const double first = bar.drifts() ? state.displacements[bar.firstNode] : 0.0;
            if (bar.clamps <= 1 && bar.springs == 0 &&
                !(bar.clamps == 1 &&
                  (scene.nodes[bar.firstNode].isShaken || scene.nodes[bar.lastNode].isShaken))) {
                CHECK(state.displacements[node] == Approx(said[node] + first).margin(1e-6));
            }
        }
        contacts += static_cast<int>(simulation.contacts().size());
    }
    CHECK(contacts > 500);
}

TEST_CASE("network simulation: today's scenes do what the simulation of one bar says")
{
    const auto compare = [](const Scene& scene, std::int64_t cells, const Damping& damping) {
        const Stops stops = stopsOf(scene);
        const Excitation excitation =
            excitationOf({.place = Excited::tip,
                          .amplitude = 0.9,
                          .phase = 0.4,
                          .cycles = 1,
                          .steps = 4 * cells - 3,
                          .stepsPerCrossing = static_cast<double>(cells)});
        BarSimulation bar(scene.segments.empty() ? wavesAtRest(static_cast<double>(cells), stops)
                                                 : wavesAtRest(scene.segments, stops),
                          damping, excitation,
                          {.mergeBelow = 1e-12, .stops = stops, .segments = scene.segments});
        const Network network = networkOf(scene, cells, damping);
        // A force of EA g/L is Z_1 c g/L; velocities are in c g/L in both.
        NetworkSimulation nodes(network, startAtRest(network), {.forces = excitation.values},
                                {.mergeBelow = 1e-12});
        for (int period = 0; period < 120; ++period) {
            bar.advance(static_cast<double>(cells));
            nodes.advance(static_cast<double>(cells));
            CHECK(nodes.displacement(network.nodes.size() - 1) / static_cast<double>(cells) ==
                  Approx(bar.tip()).margin(1e-8));
        }
        double impulse = 0.0;
        for (const NetworkContactEvent& event : nodes.contacts()) {
            impulse += event.impulse;
        }
        CHECK(impulse / static_cast<double>(cells) == Approx(bar.impulse()).epsilon(1e-7));
        CHECK(nodes.contacts().size() >= bar.contacts().size());
        CHECK(impulse > 0.0);
    };
    compare(Scene{}, 30, Damping{0.02});
    compare(Scene(Bar{.gap = -1e-3}), 20, Damping{0.05});
    compare(Scene(Bar{}, 1.1e-3), 25, Damping{0.01});
    compare(Scene(Bar{}, std::nullopt,
                  {{.cells = 12}, {.cells = 9, .impedance = 1.7, .dashpot = 0.1}, {.cells = 7}}),
            28, Damping{0.03});
}

TEST_CASE("network simulation: fronts that were rounded apart become one, and nothing is lost")
{
    // A bar of 10 m falls 5 m: 1 s down, 2 L/c = 2/3 s at the stop, 1 s up. After some 400 bounces
    // fronts miss each other by more than instants are told apart.
    Assembly assembly{.parts = partsOf("4 stop=5"),
                      .length = 10.0,
                      .waveSpeed = 30.0,
                      .axialStiffness = 900.0,
                      .gravity = 10.0};
    const Network scene = networkOf(assembly);
    NetworkSimulation simulation(scene, startWithSpeeds(scene, std::vector{0.0}), {},
                                 {.mergeBelow = 1e-12});
    simulation.advance(32000.0 / scene.scales.time);
    CHECK(simulation.fronts() < 40);
    CHECK(simulation.contacts().size() == 12000);
    const NetworkBalance energy = simulation.balance();
    CHECK(std::abs(energy.error) <= 1e-8 * energy.size);
    const MomentumBalance momentum = simulation.momentumBalance();
    CHECK(std::abs(momentum.error) <= 1e-13 * momentum.size);
}

TEST_CASE("network simulation: a state off the grid goes on as if nothing had been")
{
    const Network scene = network("clamp 7 dash=0.1 gap=0.5 5:1.3 spring=0.2 stop=0.7 6 free");
    const NetworkStart start = startWithSpeeds(scene, std::vector{6.0, -4.0});
    NetworkSimulation whole(scene, start);
    whole.advance(1000.0 / 7.0);
    NetworkSimulation first(scene, start);
    first.advance(300.0 / 7.0);
    const NetworkStart between = first.state();
    NetworkSimulation second(scene, between);
    CHECK(second.energy() == Approx(first.energy()).epsilon(1e-13));
    second.advance(700.0 / 7.0);
    CHECK(second.energy() == Approx(whole.energy()).epsilon(1e-9));
    for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
        CHECK(second.displacement(node) == Approx(whole.displacement(node)).margin(1e-9));
    }
    CHECK(whole.contactCount() > 5);
    NetworkStart wrong = between;
    wrong.pieces.front().front().duration += 1.0;
    CHECK_THROWS_WITH(NetworkSimulation(scene, wrong), Catch::Contains("wave 1 of the start"));
    wrong.pieces.pop_back();
    CHECK_THROWS_WITH(NetworkSimulation(scene, wrong), Catch::Contains("waves of the start"));
}

TEST_CASE("network simulation: what cannot be is refused")
{
    const Network scene = network("clamp 5 gap=-1e-3 5 clamp");
    CHECK_THROWS_WITH(NetworkSimulation(scene, startWithSpeeds(scene, std::vector{0.0, 0.0})),
                      Catch::Contains("distance of contact 1 at the start"));
    CHECK_THROWS_WITH(startWithSpeeds(scene, std::vector{0.0}),
                      Catch::Contains("velocity = 1 is out of range: allowed 2"));
    CHECK_THROWS_WITH(startWithSpeeds(scene, std::vector{0.0, std::nan("")}),
                      Catch::Contains("velocity = nan"));
    NetworkStart start = startAtRest(scene);
    start.waves.pop_back();
    CHECK_THROWS_WITH(NetworkSimulation(scene, start), Catch::Contains("waves of the start"));
}

TEST_CASE("network simulation: events per second", "[.benchmark]")
{
    const Network scene =
        network("clamp 60 gap=1e-3 50:1.3 gap=1e-3 70:0.7 gap=1e-3 40:2 gap=1e-3 30 clamp");
    NetworkSimulation simulation(scene,
                                 startWithSpeeds(scene, std::vector{0.3, -0.5, 0.4, -0.2, 0.1}), {},
                                 {.mergeBelow = 1e-12});
    for (int k = 0; k < 20; ++k) {
        simulation.advance(10000.0);
        WARN(simulation.events() << " events, " << simulation.fronts() << " fronts, "
                                 << simulation.contacts().size() << " contacts");
    }
}
