#include "signorini/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "catch.hpp"
#include "modes_support.hpp"
#include "signorini/modes.hpp"
#include "signorini/one_phase_set.hpp"
#include "signorini/settling.hpp"
#include "support.hpp"

using namespace signorini;
using test::onePhase;

namespace {

/// Waves whose pieces last whole steps, cell by cell.
State onCells(const Waves& waves, std::int64_t cells)
{
    std::vector<double> values[2];
    for (const bool isLeft : {false, true}) {
        for (const Piece& piece : isLeft ? waves.b : waves.a) {
            REQUIRE(piece.duration == std::floor(piece.duration));
            values[isLeft].insert(values[isLeft].end(), static_cast<std::size_t>(piece.duration),
                                  piece.value);
        }
        REQUIRE(static_cast<std::int64_t>(values[isLeft].size()) == cells);
    }
    State state{Eigen::VectorXd(cells), Eigen::VectorXd(cells)};
    for (std::int64_t i = 0; i < cells; ++i) {
        state.a[cells - 1 - i] = values[0][static_cast<std::size_t>(i)];
        state.b[i] = values[1][static_cast<std::size_t>(i)];
    }
    return state;
}

}  // namespace

TEST_CASE("damping: rho, eta and the dashpot are one thing")
{
    const Bar steel = barOfMaterial(2.0, 210e9, 7800.0, 1e-4, 1e-3);
    for (const double ratio : {0.0, 1e-9, 0.02, 0.3, 2.0}) {
        const Damping damping{ratio};
        CHECK(damping.rho() == Approx(std::exp(-std::numbers::pi * ratio)).epsilon(1e-15));
        CHECK(damping.eta() * (1.0 + damping.rho()) == Approx(1.0 - damping.rho()).margin(1e-15));
        CHECK(dampingOfRho(damping.rho()).ratio == Approx(ratio).margin(1e-15));
    }
    // eta = 1 swallows every wave: EA/c = area sqrt(E density).
    CHECK(dashpot({20.0}, steel) == Approx(1e-4 * std::sqrt(210e9 * 7800.0)).epsilon(1e-12));
    CHECK_THROWS_AS(validate(Damping{-0.1}), std::invalid_argument);
    CHECK_THROWS_AS(validate(Damping{NAN}), std::invalid_argument);
    CHECK_THROWS_AS(dampingOfRho(0.0), std::invalid_argument);
    CHECK_THROWS_AS(dampingOfRho(1.1), std::invalid_argument);
}

TEST_CASE("excitation: K cycles in n steps, base velocities are differences of places")
{
    const Excitation tip = excitationOf({Excited::tip, 2.0, 0.3, 3, 14, 5.0});
    const Excitation base = excitationOf({Excited::base, 2.0, 0.3, 3, 14, 5.0});
    for (std::int64_t m = 0; m < 30; ++m) {
        const double angle = 2.0 * std::numbers::pi * 3.0 / 14.0;
        CHECK(tip.force(m) == Approx(2.0 * std::cos(angle * (static_cast<double>(m) + 0.5) - 0.3)));
        CHECK(tip.baseVelocity(m) == 0.0);
        CHECK(base.baseDisplacement(m) ==
              Approx(2.0 * std::cos(angle * static_cast<double>(m) - 0.3)));
        CHECK(base.baseVelocity(m) ==
              5.0 * (base.baseDisplacement(m + 1) - base.baseDisplacement(m)));
    }
    CHECK_THROWS_AS(excitationOf({Excited::tip, 1.0, 0.0, 8, 14, 1.0}), std::invalid_argument);
    CHECK_THROWS_AS(excitationOf({Excited::tip, 1.0, 0.0, 0, 14, 1.0}), std::invalid_argument);
    CHECK_THROWS_AS(excitationOf({Excited::tip, NAN, 0.0, 1, 14, 1.0}), std::invalid_argument);
    CHECK_THROWS_AS(excitationOf({Excited::tip, 1.0, 0.0, 1, 0, 1.0}), std::invalid_argument);
}

TEST_CASE("simulation: every motion of the library returns to itself, bit for bit")
{
    std::mt19937_64 generator(7);
    int motions = 0;
    test::forAllSchedules(9, 0, [&](const Schedule& schedule) {
        const OnePhaseSet set = onePhaseSet(schedule);
        if (set.reason) {
            return;
        }
        const State state = motionOf(set, drawAmplitudes(set.set, generator));
        INFO(describe(schedule));
        BarSimulation simulation(wavesOf(state), {});
        for (int k = 0; k < 3; ++k) {
            simulation.advance(static_cast<double>(steps(schedule)));
            REQUIRE(onCells(simulation.waves(), schedule.cells) == state);
        }
        REQUIRE(simulation.balance().error == 0.0);
        ++motions;
    });
    CHECK(motions > 300);
}

TEST_CASE("simulation: the paper's case for 10,000 periods, nothing lost, nothing gained")
{
    const OnePhaseSet set = onePhaseSet(onePhase(300, 150, 900));
    const State least = leastEnergyMotion(set);
    std::mt19937_64 generator(3);
    const State drawn = motionOf(set, drawAmplitudes(set.set, generator));
    for (const State& state : {least, drawn}) {
        BarSimulation simulation(wavesOf(state), {});
        simulation.advance(1050.0 * 10'000.0);
        CHECK(std::abs(simulation.balance().error) <= 1e-12 * simulation.balance().size);
        CHECK(onCells(simulation.waves(), 300) == state);
        CHECK(simulation.contacts().size() == 10'000);
        const ContactEvent& last = simulation.contacts().back();
        CHECK(last.start == Approx(9'999.0 * 3.5).epsilon(1e-12));
        CHECK(last.end - last.start == Approx(0.5).epsilon(1e-9));
    }
}

TEST_CASE("simulation: forced and damped for 10,000 periods, the energy accounts hold")
{
    // N = 300, rho = 0.9, a force of 0.25 EA g/L, n = 1080: section 15's bar, from rest.
    const double steps = 1080.0;
    BarSimulation bar(wavesAtRest(300.0), dampingOfRho(0.9),
                      excitationOf({.amplitude = 0.25, .steps = 1080, .stepsPerCrossing = 300.0}));
    const auto advance = [&](int periods) {
        for (int k = 0; k < periods; ++k) {
            bar.advance(steps);
        }
    };
    advance(5'000);
    const double tip = bar.tip();
    const double impulse = bar.impulse();
    const std::size_t contacts = bar.contacts().size();
    advance(5'000);
    const EnergyBalance balance = bar.balance();
    CHECK(std::abs(balance.error) <= 1e-12 * balance.size);
    CHECK(balance.size >= 1e4);  // much came and went
    CHECK(bar.tip() == Approx(tip).margin(1e-9));
    CHECK(bar.contacts().size() == contacts + 5'000);
    CHECK((bar.impulse() - impulse) / 5'000.0 == Approx(1.0708).margin(5e-4));
    CHECK(bar.time() == Approx(36'000.0).epsilon(1e-14));
    CHECK(bar.merged() < 1e-6);
}

TEST_CASE("simulation: modes at irrational periods, off every grid")
{
    for (const Mode& mode : findModes()) {
        const double period =
            mode.lowest.value() + (mode.highest.value() - mode.lowest.value()) / std::numbers::e;
        const ModeMotion motion(mode, period);
        INFO(mode.a << " " << mode.b);
        BarSimulation simulation(test::wavesOf(motion), {});
        for (int k = 1; k <= 40; ++k) {
            simulation.advance(0.5 * period);
            REQUIRE(simulation.tip() ==
                    Approx(motion.displacement(1.0, 0.5 * k * period)).margin(1e-9));
        }
        REQUIRE(simulation.contacts().size() == 20);
        for (const ContactEvent& contact : simulation.contacts()) {
            REQUIRE(contact.end - contact.start == Approx(motion.contactTime()).margin(1e-9));
            REQUIRE(contact.peakForce == Approx(2.0 * motion.amplitude()).epsilon(1e-12));
        }
        REQUIRE(energyRatio(simulation.waves()) ==
                Approx(energyRatio(mode, period)).epsilon(1e-12));
    }
}

TEST_CASE("simulation: free vibration loses a factor rho^2 of its energy in 2 L/c")
{
    const State state = test::randomState(20, 4);
    State small{0.01 * state.a, 0.01 * state.b};
    for (const double ratio : {0.0, 0.05, 0.4}) {
        const Damping damping{ratio};
        BarSimulation simulation(wavesOf(small), damping, {}, {.mergeBelow = 0.0});
        for (int k = 1; k <= 6; ++k) {
            simulation.advance(40.0);
            CHECK(energyRatio(simulation.waves()) ==
                  Approx(energyRatio(small) * std::pow(damping.rho(), 2 * k)).epsilon(1e-13));
        }
        CHECK(simulation.contacts().empty());
        CHECK(std::abs(simulation.balance().error) <= 1e-14 * simulation.balance().size);
    }
}

TEST_CASE("simulation: a steady force stretches the bar, or presses it on the wall")
{
    for (const double force : {-2.0, 0.4, 0.999, 3.0}) {
        BarSimulation simulation(wavesAtRest(), {0.3}, {Excited::tip, {force}, 1.0});
        simulation.advance(400.0);
        CHECK(simulation.tip() == Approx(std::min(force, 1.0)).margin(1e-9));
        CHECK(simulation.isHeld() == (force > 1.0));
        const double before = simulation.impulse();
        simulation.advance(10.0);
        // R = F - u(L) EA/L once all is still.
        CHECK(simulation.impulse() - before ==
              Approx(10.0 * std::max(force - 1.0, 0.0)).margin(1e-9));
    }
}

TEST_CASE("simulation: a base that moves and stops takes the bar with it, or against the wall")
{
    // In 50 steps of 1/5 L/c to its place, where it stays for a long time.
    for (const double place : {-3.0, 0.5, 1.5}) {
        Excitation base{Excited::base, std::vector<double>(5000, place), 5.0};
        for (std::size_t m = 0; m < 50; ++m) {
            base.values[m] = place * static_cast<double>(m) / 50.0;
        }
        BarSimulation simulation(wavesAtRest(5.0), {0.3}, base);
        simulation.advance(4000.0);
        CHECK(simulation.base() == Approx(place));
        CHECK(simulation.tip() == Approx(std::min(place, 1.0)).margin(1e-9));
        CHECK(stretching(simulation.waves(), 5)[5] ==
              Approx(std::min(1.0 - place, 0.0)).margin(1e-9));
        const EnergyBalance balance = simulation.balance();
        CHECK(std::abs(balance.error) <= 1e-13 * balance.size);
        // E_1 is the energy of a bar stretched or pressed by g; what still runs to and fro between
        // a wall that is not left and the base comes on top.
        const double still = std::pow(std::max(place - 1.0, 0.0), 2);
        CHECK(energyRatio(simulation.waves()) >= still * (1.0 - 1e-12));
        CHECK(energyRatio(simulation.waves()) <= still * 1.1 + 1e-9);
    }
}

TEST_CASE("simulation: waves and tip agree about where the tip is, whatever happened")
{
    std::mt19937_64 generator(11);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    for (int k = 0; k < 60; ++k) {
        const bool isTip = k % 2 == 0;
        const auto n = static_cast<std::int64_t>(40 + 60 * part(generator));
        const Excitation excitation =
            excitationOf({isTip ? Excited::tip : Excited::base, part(generator),
                          7.0 * part(generator), 1, n, 20.0 * (0.5 + part(generator))});
        BarSimulation simulation(wavesAtRest(std::numbers::pi), {0.1 * part(generator)}, excitation,
                                 {.mergeBelow = 1e-9, .recordsTip = true});
        for (int period = 0; period < 20; ++period) {
            simulation.advance(10.0 * part(generator));
            REQUIRE(simulation.tip() <= 1.0 + 1e-12);
            REQUIRE(simulation.base() + stretching(simulation.waves(), 7)[7] ==
                    Approx(simulation.tip()).margin(1e-9 + simulation.merged()));
            const EnergyBalance balance = simulation.balance();
            REQUIRE(std::abs(balance.error) <= 1e-7 * std::max(1.0, balance.size));
        }
        for (const TipPoint& point : simulation.tipPath()) {
            REQUIRE(point.displacement <= 1.0 + 1e-12);
        }
    }
}

TEST_CASE("simulation: merging saves pieces, and its bound holds")
{
    const Excitation force = excitationOf({Excited::tip, 0.25, 0.0, 1, 111, 30.0});
    const Damping damping = dampingOfRho(0.9);
    BarSimulation exact(wavesAtRest(30.0), damping, force, {.mergeBelow = 0.0});
    BarSimulation merging(wavesAtRest(30.0), damping, force, {.mergeBelow = 1e-5});
    exact.advance(111.0 * 150.0);
    merging.advance(111.0 * 150.0);
    CHECK(exact.merged() == 0.0);
    CHECK(merging.merged() > 0.0);
    CHECK(merging.pieces() < exact.pieces());
    CHECK(std::abs(exact.tip() - merging.tip()) < merging.merged() + 1e-3);
}

TEST_CASE("simulation: forced from rest it settles where section 15 says")
{
    struct Known {
        std::int64_t steps;
        std::int64_t contacts;
        double impulse;
    };
    for (const Known& known : {Known{108, 1, 1.0710}, Known{111, 1, 0.8258}, Known{122, 1, 0.3588},
                               Known{104, 0, 0.0}, Known{118, 2, 0.4265}}) {
        const Excitation force = excitationOf({Excited::tip, 0.25, 0.0, 1, known.steps, 30.0});
        BarSimulation simulation(wavesAtRest(30.0), dampingOfRho(0.9), force);
        SettlingWatch watch(1500);
        for (int period = 0; period < 1500; ++period) {
            simulation.advance(static_cast<double>(known.steps));
            watch.see(simulation);
        }
        const auto [settled, why] = watch.settling(simulation, static_cast<double>(known.steps));
        INFO(known.steps << ": " << why);
        REQUIRE(settled);
        CHECK(settled->periods == 1);
        CHECK(settled->contacts == known.contacts);
        // The motion may begin contact between grid points: a neighbour of the grid's.
        CHECK(settled->impulse == Approx(known.impulse).margin(3e-4));
    }
}

TEST_CASE("simulation: at n = 104 the bar, pulled back by g and let go, finds the upper motion")
{
    const Excitation force = excitationOf({Excited::tip, 0.25, std::numbers::pi, 1, 104, 30.0});
    const State pulled{Eigen::VectorXd::Constant(30, 0.5), Eigen::VectorXd::Constant(30, -0.5)};
    REQUIRE(displacement(pulled)[29] == Approx(-1.0));
    BarSimulation simulation(wavesOf(pulled), dampingOfRho(0.9), force);
    SettlingWatch watch(600);
    for (int period = 0; period < 600; ++period) {
        simulation.advance(104.0);
        watch.see(simulation);
    }
    const auto settled = watch.settling(simulation, 104.0).settled;
    REQUIRE(settled);
    CHECK(settled->contacts == 1);
    CHECK(settled->impulse == Approx(1.5609).margin(3e-4));
}

TEST_CASE("simulation: wrong use is refused by name")
{
    const Waves rest = wavesAtRest();
    CHECK_THROWS_WITH(BarSimulation(rest, {-1.0}), containsText("damping ratio"));
    CHECK_THROWS_WITH(BarSimulation(rest, {}, {Excited::tip, {NAN}, 1.0}), containsText("values"));
    CHECK_THROWS_WITH(BarSimulation(rest, {}, {}, {.mergeBelow = -1.0}),
                      containsText("mergeBelow"));
    CHECK_THROWS_WITH(BarSimulation({1.0, {{0.5, 0.0}}, {{1.0, 0.0}}}, {}), containsText("add up"));
    CHECK_THROWS_WITH(BarSimulation({1.0, {{1.0, NAN}}, {{1.0, 0.0}}}, {}), containsText("finite"));
    CHECK_THROWS_WITH(BarSimulation({1.0, {{1.0, -2.0}}, {{1.0, 0.0}}}, {}), containsText("wall"));
    CHECK_THROWS_WITH(BarSimulation({0.0, {}, {}}, {}), containsText("crossing"));
    BarSimulation simulation(rest, {});
    CHECK_THROWS_WITH(simulation.advance(-1.0), containsText("duration"));
}
