// What becomes of disturbances of scenes: linear ones die as the dashpot says, and a bar said as a
// scene attracts and repels where its own simulation does.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "disturbed.hpp"
#include "has_solver.hpp"
#include "network_forced.hpp"
#include "network_simulation.hpp"
#include "scene_words.hpp"
#include "signorini/response.hpp"

using namespace signorini;

namespace {

/// What a harmonic force has made of a bar of 6 cells before a wall that it does not reach.
NetworkClaim withoutContact(const Network& network, std::int64_t steps)
{
    NetworkClaim claim{.schedule = {{0, steps}}};
    for (std::int64_t m = 0; m < steps; ++m) {
        const double turn = static_cast<double>(m) / static_cast<double>(steps);
        claim.forces.push_back(1e-3 * std::cos(2.0 * std::numbers::pi * turn));
    }
    NetworkSimulation simulation(network, startAtRest(network), {.forces = claim.forces});
    simulation.advance(400.0 * static_cast<double>(steps));
    REQUIRE(simulation.contactCount() == 0);
    const NetworkStart state = simulation.state();
    claim.waves = state.waves;
    claim.displacements = state.displacements;
    return claim;
}

}  // namespace

TEST_CASE("stability of scenes: without contact a dashpot takes the same part of each round trip")
{
    for (const double dash : {0.05, 0.2, 0.7}) {
        const Network network = sceneOf(fmt::format("clamp 6 dash={} driven stop=1", dash));
        for (const std::int64_t trips : {1, 2}) {
            const NetworkClaim motion = withoutContact(network, 12 * trips);
            for (const std::int64_t periods : {1, 4}) {
                StabilityOptions options{.periods = periods, .mergeBelow = 0.0};
                const StabilityResult tried = stabilityOf(network, motion, options);
                const double part =
                    std::pow((1.0 - dash) / (1.0 + dash), static_cast<double>(trips * periods));
                INFO(dash << " " << trips << " " << periods);
                CHECK(tried.drift < 1e-12);
                REQUIRE(tried.trials.size() == 4);
                for (const StabilityTrial& trial : tried.trials) {
                    CHECK(trial.start > 0.1 * trial.size);
                    CHECK(trial.end == Approx(part * trial.start).epsilon(1e-6));
                }
                CHECK((tried.stability == Stability::attracts) == (part < 0.1));
            }
        }
    }
}

TEST_CASE("stability of scenes: a bar said as one attracts and repels as its own simulation says")
{
    if (!test::hasSimplex()) {
        return;
    }
    const Damping damping{0.05};
    const Network network = sceneOf(fmt::format("clamp 6 dash={} driven stop=1e-3", damping.eta()));
    int attracting = 0;
    int repelling = 0;
    for (std::int64_t contact = 1; contact < 5; ++contact) {
        for (std::int64_t free = 17; free < 32; ++free) {
            const ForcedSet bar =
                forcedMotions({6, {{contact, free}}, {}}, damping, {Excited::tip, 1, {}});
            const ForcedSet scene =
                forcedScene(network, {{1, contact}, {0, free}}, {Excited::tip, 1, {}}, 3.0);
            if (bar.status != Status::found) {
                continue;
            }
            const double amplitude = 1.2 * bar.leastAmplitude;
            const auto own = motionsOfAmplitude(bar, amplitude);
            const auto said = motionsOfAmplitude(scene, amplitude);
            REQUIRE(own.size() == said.size());
            for (std::size_t k = 0; k < own.size(); ++k) {
                INFO(contact << " " << free << " " << own[k].phase);
                REQUIRE(said[k].phase == Approx(own[k].phase).margin(1e-6));
                const Stability one = stabilityOf(own[k]).stability;
                CHECK(stabilityOf(network, claimOf(scene, said[k])).stability == one);
                attracting += one == Stability::attracts ? 1 : 0;
                repelling += one == Stability::repels ? 1 : 0;
            }
        }
    }
    CHECK(attracting > 3);
    CHECK(repelling > 3);
}
