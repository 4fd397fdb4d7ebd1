// Forced motions of any network: those of a bar are known, all others are walked.

#include "network_forced.hpp"

#include <fmt/format.h>

#include <string>

#include "catch.hpp"
#include "has_solver.hpp"
#include "scene_words.hpp"

using namespace signorini;

TEST_CASE("scene forced: a bar with a stop at its tip has the motions of the forced bar")
{
    if (!test::hasSimplex()) {
        return;
    }
    const Damping damping{0.05};
    const Network network =
        sceneOf(fmt::format("clamp shaken 6 dash={} driven stop=1e-3", damping.eta()));
    int found = 0;
    for (std::int64_t contact = 1; contact < 9; ++contact) {
        for (std::int64_t free = 5; free < 34; free += 3) {
            for (const Excited place : {Excited::tip, Excited::base}) {
                const ForcedSet bar =
                    forcedMotions({6, {{contact, free}}, {}}, damping, {place, 1, {}});
                const ForcedSet scene =
                    forcedScene(network, {{1, contact}, {0, free}}, {place, 1, {}}, 3.0);
                INFO(contact << " " << free << ": " << bar.detail << scene.detail);
                REQUIRE(scene.status == bar.status);
                if (bar.status == Status::none) {
                    CHECK(isCertain(scene));
                    continue;
                }
                ++found;
                // Forces in Z_1 delta/h are EA g/L here, places N to g.
                const double unit = place == Excited::tip ? 1.0 : 6.0;
                CHECK(scene.leastAmplitude == Approx(unit * bar.leastAmplitude).epsilon(1e-6));
                const ForcedMotion least = leastAmplitudeMotion(scene);
                CHECK(least.residual < 1e-9);
                CHECK(walk(network, claimOf(scene, least)).worst() < 1e-9);
                if (bar.leastAmplitude > 0.0 && scene.kind != ForcedKind::polytope) {
                    const double less = 0.5 * scene.leastAmplitude;
                    CHECK(motionsOfAmplitude(scene, less).empty());
                    CHECK(exclusionOf(scene, less).isCertain);
                }
            }
        }
    }
    CHECK(found > 20);
}

TEST_CASE("scene forced: bars that meet, fly and bounce under a force, or proofs that they do not")
{
    if (!test::hasSimplex()) {
        return;
    }
    int found = 0;
    int none = 0;
    for (const char* words :
         {"clamp 3 dash=0.1 driven gap=1e-3 4:1.3 dash=0.05 2 clamp",
          "clamp 3 dash=0.1 stop=1e-3 2 driven 2 clamp", "spring=4 5 dash=0.1 driven stop=1e-3",
          "driven stop=-1e-3 3 dash=0.1 stop=1e-3",
          "clamp 3 dash=0.2 gap=1e-3 2 driven gap=1e-3 3 dash=0.1 2 clamp"}) {
        const Network network = sceneOf(words);
        for (std::int64_t contact = 1; contact < 7; ++contact) {
            for (std::int64_t free = 3; free < 20; free += 2) {
                std::vector<ContactSpan> schedule{{1, contact}, {0, free}};
                if (network.contacts.size() > 1) {
                    schedule.insert(schedule.end(), {{2, contact}, {0, free}});
                }
                const ForcedSet set = forcedScene(network, schedule, {}, 10.0);
                INFO(words << ": " << contact << " " << free << ": " << set.detail);
                CHECK(set.status != Status::undecided);
                if (set.status == Status::none) {
                    ++none;
                    CHECK(isCertain(set));
                } else if (set.status == Status::found) {
                    ++found;
                    const ForcedMotion least = leastAmplitudeMotion(set);
                    CHECK(walk(network, claimOf(set, least)).worst() < 1e-9);
                    CHECK(least.amplitude == Approx(set.leastAmplitude));
                }
            }
        }
    }
    CHECK(found > 10);
    CHECK(none > 50);
}
