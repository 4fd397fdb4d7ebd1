// What any force between two bounds can do: against closed forms and against forces that are tried.

#include <algorithm>
#include <cmath>
#include <random>

#include "catch.hpp"
#include "force_range.hpp"
#include "signorini/assembly.hpp"

using namespace signorini;

namespace {

Network networkOfText(const char* text)
{
    return networkOf({.parts = partsOf(text)});
}

}  // namespace

TEST_CASE("force range: of a clamped bar the velocity is a sum of echoes of both signs")
{
    // v(x, t) = (F(t - d_1) - F(t - d_2) - F(t - d_3) + F(t - d_4) + ...)/Z, d = (L -+ x)/c, + 2
    // L/c.
    const Network network = networkOfText("clamp 7 stop=9 3 driven");
    const double unit = network.scales.force();
    const double low = 0.8 / unit;
    const double high = 1.3 / unit;
    for (const double duration : {2.5, 3.5, 17.5, 40.5, 101.36}) {
        double most = 0.0;
        double least = 0.0;
        double up = 0.0;
        double down = 0.0;
        for (int echo = 0; echo < 20; ++echo) {
            for (const double arrival : {3.0 + 20.0 * echo, 17.0 + 20.0 * echo}) {
                const bool isPlus = (arrival == 3.0 + 20.0 * echo) == (echo % 2 == 0);
                if (arrival < duration) {
                    up += isPlus ? high : -low;
                    down += isPlus ? low : -high;
                }
                most = std::max(most, up);
                least = std::min(least, down);
            }
        }
        const ForceReach reach = reachUnder(network, low, high, duration);
        REQUIRE(!reach.closes);
        const ContactReach& one = reach.contacts.front();
        CHECK(one.mostVelocity.bound == Approx(most).epsilon(1e-12).margin(1e-15));
        CHECK(one.mostVelocity.reached == Approx(most).epsilon(1e-12).margin(1e-15));
        CHECK(one.leastVelocity.bound == Approx(least).epsilon(1e-12).margin(1e-15));
        CHECK(one.leastVelocity.reached == Approx(least).epsilon(1e-12).margin(1e-15));
    }
}

TEST_CASE("force range: forces that are tried stay within the bounds, and one reaches each")
{
    std::mt19937 random(5);
    for (const char* text : {"clamp 5 driven stop=9 4:1.7 stop=left:8",
                             "clamp 3 stop=right:4 spring=0.3 6:0.4 dash=0.2 driven",
                             "clamp 4 gap=5 6:2 driven dash=0.3 3 clamp",
                             "clamp 6 driven force=0.01 2:3 stop=right:3"}) {
        const Network network = networkOfText(text);
        constexpr int steps = 37;
        const double part = 0.4;
        const ForceReach reach = reachUnder(network, -0.02, 0.05, steps + part);
        INFO(text);
        REQUIRE(!reach.closes);
        CHECK(reach.duration == steps + part);
        const NetworkStart start = startAtRest(network);
        for (int trial = 0; trial < 60; ++trial) {
            NetworkDrive drive;
            for (int m = 0; m <= steps; ++m) {
                const double share = std::uniform_real_distribution(0.0, 1.0)(random);
                drive.forces.push_back(trial % 2 == 0 ? std::lerp(-0.02, 0.05, share)
                                       : share < 0.5  ? -0.02
                                                      : 0.05);
            }
            NetworkSimulation simulation(network, start, drive);
            for (int m = 0; m < steps; ++m) {
                simulation.advance(m == 0 ? 0.5 : 1.0);
                for (std::size_t j = 0; j < network.contacts.size(); ++j) {
                    const NetworkContact& contact = network.contacts[j];
                    const bool isGap = contact.kind == ContactKind::gap;
                    const double u = simulation.displacement(contact.node) -
                                     (isGap ? simulation.displacement(contact.node + 1) : 0.0);
                    const double v = simulation.velocity(contact.node) -
                                     (isGap ? simulation.velocity(contact.node + 1) : 0.0);
                    const ContactReach& one = reach.contacts[j];
                    CHECK(u <= one.mostDisplacement.bound);
                    CHECK(u >= one.leastDisplacement.bound);
                    CHECK(v <= one.mostVelocity.bound);
                    CHECK(v >= one.leastVelocity.bound);
                }
            }
        }
        for (const ContactReach& one : reach.contacts) {
            for (const ForcePeak& peak : {one.leastVelocity, one.mostVelocity,
                                          one.leastDisplacement, one.mostDisplacement}) {
                CHECK(peak.reached == Approx(peak.bound).epsilon(1e-10).margin(1e-13));
            }
            CHECK(one.mostVelocity.bound > one.leastVelocity.bound);
        }
    }
}

TEST_CASE("force range: it ends where a contact can first close")
{
    const Network network = networkOfText("clamp 7 stop=1 3 driven");
    const double force = 0.5 / network.scales.force();
    const ForceReach reach = reachUnder(network, -force, force, 300.0);
    REQUIRE(reach.closes == std::optional<std::size_t>(0));
    CHECK(reach.contacts.front().mostDisplacement.reached ==
          Approx(network.contacts.front().gap).epsilon(1e-12));
    // A force of that size closes it neither by itself nor sooner.
    NetworkSimulation steady(network, startAtRest(network), {.forces = {force}});
    steady.advance(300.0);
    CHECK(steady.contactCount() == 0);
    CHECK(!reachUnder(network, -force, force, reach.duration - 1e-6).closes);
}

TEST_CASE("force range: what it refuses")
{
    CHECK_THROWS_AS(reachUnder(networkOfText("clamp 4 stop=1"), 0.0, 1.0, 5.0),
                    std::invalid_argument);
    CHECK_THROWS_AS(reachUnder(networkOfText("clamp 4 driven stop=right:-1"), 0.0, 1.0, 5.0),
                    std::invalid_argument);
}
