#include "network_walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "catch.hpp"
#include "network_simulation.hpp"
#include "unit/mechanics/random_network.hpp"

using namespace signorini;
using signorini::test::NetworkGenerator;

namespace {

Network network(const std::string& text)
{
    return networkOf(Assembly{.parts = partsOf(text)});
}

double relative(double difference, double size)
{
    return std::abs(difference) / (size > 0.0 ? size : 1.0);
}

/// What waves of size 1 can press with.
double bearing(const Network& scene, std::size_t contact)
{
    const NetworkContact& at = scene.contacts[contact];
    double most = 0.0;
    for (std::size_t node = at.node; node <= at.node + (at.kind == ContactKind::gap ? 1 : 0);
         ++node) {
        double sum = 0.0;
        for (std::size_t k = 0; k < scene.channels(); ++k) {
            sum += scene.nodeOf(k) == node ? 2.0 * scene.impedanceOf(k) : 0.0;
        }
        most = std::max(most, sum);
    }
    return most;
}

}  // namespace

TEST_CASE("network walk: the bouncing bar of Doyen, Ern and Piperno satisfies all rows")
{
    for (const std::int64_t cells : {1, 2, 4, 10, 50}) {
        // In units W/Z: its weight is a force 1 at the foot, 2N steps on the ground, 6N in flight.
        Network bar = network(std::to_string(cells) + " stop=0");
        bar.nodes[1].force = 1.0;
        NetworkClaim claim{
            .schedule = {{1, 2 * cells}, {0, 6 * cells}, {1, 2 * cells}, {0, 6 * cells}}};
        std::vector<double> strains;
        for (std::int64_t i = 1; i <= cells; ++i) {
            strains.push_back((static_cast<double>(i) - 0.5) / static_cast<double>(cells));
        }
        double stretched = 0.0;
        for (const double strain : strains) {
            claim.waves.push_back(0.5 * (3.0 - strain));
            stretched += strain;
        }
        for (const double strain : strains) {
            claim.waves.push_back(0.5 * (3.0 + strain));
        }
        claim.displacements = {-stretched, 0.0};
        const NetworkResiduals seen = walk(bar, claim);
        CHECK(seen.worst() < 1e-13);
        // The mean of the pushes is the weight.
        CHECK(seen.extremes.contacts[0].impulse == Approx(16.0 * static_cast<double>(cells)));
        claim.waves[0] += 0.1;
        CHECK(walk(bar, claim).worst() > 1e-3);
    }
}

TEST_CASE("network walk: a bar flies between two walls with any flight")
{
    for (const std::int64_t flight : {1, 5, 12, 31}) {
        const Network bar = network("stop=-1e-3 6 stop=1e-3");
        const double way = bar.contacts[0].gap + bar.contacts[1].gap;
        const double half = 0.5 * way / static_cast<double>(flight);
        const NetworkClaim claim{.waves = std::vector<double>(12, half),
                                 .displacements = {bar.contacts[1].gap, bar.contacts[1].gap},
                                 .schedule = {{2, 12}, {0, flight}, {1, 12}, {0, flight}}};
        const NetworkResiduals seen = walk(bar, claim);
        CHECK(seen.worst() < 1e-13);
        CHECK(seen.extremes.contacts[0].impulse == Approx(seen.extremes.contacts[1].impulse));
    }
}

TEST_CASE("network walk: every kind of violation is seen")
{
    const Network bar = network("stop=-1e-3 6 stop=1e-3");
    const double half = 0.5 * 12.0 / 4.0;
    const NetworkClaim good{.waves = std::vector<double>(12, half),
                            .displacements = {6.0, 6.0},
                            .schedule = {{2, 12}, {0, 4}, {1, 12}, {0, 4}}};
    REQUIRE(walk(bar, good).worst() < 1e-13);
    NetworkClaim claim = good;
    claim.displacements = {5.0, 5.0};
    CHECK(walk(bar, claim).gap == Approx(1.0 / 9.0));
    claim = good;
    claim.displacements = {6.0, 5.0};
    CHECK(walk(bar, claim).tie > 0.1);
    claim = good;
    claim.schedule = {{2, 12}, {0, 5}, {1, 12}, {0, 5}};
    CHECK(walk(bar, claim).penetration > 0.1);
    claim = good;
    claim.schedule = {{2, 14}, {0, 4}, {1, 14}, {0, 4}};
    CHECK(walk(bar, claim).pressure > 0.1);
    claim = good;
    claim.schedule = {{2, 12}, {0, 4}};
    CHECK(walk(bar, claim).periodicity > 0.1);
    claim = good;
    claim.waves[3] = std::numeric_limits<double>::quiet_NaN();
    CHECK(std::isinf(walk(bar, claim).worst()));
    claim = good;
    claim.schedule = {{4, 12}};
    CHECK_THROWS_WITH(walk(bar, claim), Catch::Contains("sets of contacts 1..2"));
    claim.schedule = {};
    CHECK_THROWS_WITH(walk(bar, claim), Catch::Contains("schedule"));
    claim.schedule = {{0, 0}};
    CHECK_THROWS_WITH(walk(bar, claim), Catch::Contains("steps = 0"));
}

TEST_CASE("network walk: it does what the law of the network says, pushes included")
{
    NetworkGenerator draw(6);
    for (int sample = 0; sample < 400; ++sample) {
        const Network scene = draw.network({.hasDashpots = true, .hasForces = true});
        NetworkClaim claim;
        for (std::size_t k = 0; k < scene.waves(); ++k) {
            claim.waves.push_back(draw.fraction() - draw.fraction());
        }
        claim.displacements = displacementsOf(scene, claim.waves, {});
        NetworkWaves<double> waves(scene, claim.waves);
        double size = 0.0;
        for (const double wave : claim.waves) {
            size = std::max(size, std::abs(wave));
        }
        double pull = 0.0;
        std::vector<double> impulses(scene.contacts.size(), 0.0);
        for (int part = 0; part < 5; ++part) {
            const ContactSpan steps{draw.closedSet(scene), draw.whole(1, 6)};
            claim.schedule.push_back(steps);
            const NetworkLaw<double> law(scene, steps.closed);
            for (std::int64_t k = 0; k < steps.steps; ++k) {
                const double force = draw.fraction();
                const double base = -draw.fraction();
                claim.forces.push_back(force);
                claim.velocities.push_back(base);
                for (std::size_t j = 0; j < scene.contacts.size(); ++j) {
                    if ((steps.closed >> j & 1U) != 0) {
                        const double push = law.push(j).at(waves.arriving(), force, base);
                        pull = std::max(pull, -push / bearing(scene, j));
                        impulses[j] += push;
                    }
                }
                waves.step(law, force, base);
            }
        }
        const NetworkResiduals seen = walk(scene, claim);
        const std::vector<double> after = waves.waves();
        double change = 0.0;
        for (std::size_t k = 0; k < after.size(); ++k) {
            change = std::max(change, relative(after[k] - claim.waves[k], size));
        }
        CHECK(seen.periodicity >= change * (1.0 - 1e-12));
        CHECK(seen.pressure == Approx(relative(pull, size)).margin(1e-12));
        for (std::size_t j = 0; j < impulses.size(); ++j) {
            CHECK(seen.extremes.contacts[j].impulse == Approx(impulses[j]).margin(1e-9));
        }
    }
}
