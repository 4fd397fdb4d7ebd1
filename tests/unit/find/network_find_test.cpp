// Free motions of networks: least energies, and proofs that there are none.

#include "network_find.hpp"

#include <cmath>
#include <string>

#include "catch.hpp"
#include "energy_floor.hpp"
#include "has_solver.hpp"
#include "network_field.hpp"
#include "scene_words.hpp"
#include "signorini/find_periodic.hpp"

using namespace signorini;

namespace {

LeastMotion asked(const Network& network, std::int64_t contact, std::int64_t free)
{
    return leastMotion(network, {{1, contact}, {0, free}},
                       1e9 * static_cast<double>(network.cells()));
}

/// Schedules with n_c < contact, n_f < free that exist; all others are proved not to.
int existing(const std::string& words, std::int64_t contact, std::int64_t free)
{
    const Network network = sceneOf(words);
    int found = 0;
    for (std::int64_t c = 1; c < contact; ++c) {
        for (std::int64_t f = 1; f < free; ++f) {
            const LeastMotion answer = asked(network, c, f);
            INFO(words << ": " << c << " " << f << ": " << answer.detail);
            CHECK(answer.status != Status::undecided);
            found += answer.status == Status::found ? 1 : 0;
        }
    }
    return found;
}

}  // namespace

TEST_CASE(
    "network find: strains of a period are what is seen along the bars, at rest stretched or not")
{
    // On a grid twice as fine the field at whole steps holds all that waves do on the coarse one.
    struct Bars {
        const char* coarse;
        const char* fine;
        double gravity;
        std::int64_t contact;
        std::int64_t free;
    };
    for (const Bars& bars :
         {Bars{"clamp 4 gap=2e-3 4:2:0.5 clamp", "clamp 8 gap=2e-3 8:2:0.5 clamp", 0, 3, 11},
          Bars{"clamp 5 force=3e-3 stop=5e-3 2 clamp", "clamp 10 force=3e-3 stop=5e-3 4 clamp", 0,
               1, 12},
          Bars{"4 stop=0", "8 stop=0", 10, 8, 24},
          Bars{"clamp 6 stop=1e-3", "clamp 12 stop=1e-3", 1e-3, 3, 17}}) {
        const auto network = [&bars](const char* words) {
            return networkOf({.parts = partsOf(words), .gravity = bars.gravity});
        };
        const Network coarse = network(bars.coarse);
        const Network fine = network(bars.fine);
        INFO(bars.coarse);
        const LeastMotion found = leastMotion(coarse, {{1, bars.contact}, {0, bars.free}}, 1e12);
        INFO(found.detail);
        REQUIRE(found.motion);
        NetworkStart start;
        for (const double wave : found.motion->waves) {
            start.waves.insert(start.waves.end(), 2, wave);
        }
        // Half as long a cell, and half as wide the unit of gaps.
        for (const double place : found.motion->displacements) {
            start.displacements.push_back(2.0 * place);
        }
        double least = 0.0;
        double most = 0.0;
        const auto places = placesOfRows(fine, fine.cells());
        const std::int64_t steps = 2 * (bars.contact + bars.free);
        (void)throughPeriod(fine, start, {}, static_cast<double>(steps), steps,
                            [&](const NetworkSimulation& now) {
                                NetworkLook seen;
                                look(seen, fine, now.state(), places);
                                for (const double strain : seen.strains) {
                                    least = std::min(least, strain);
                                    most = std::max(most, strain);
                                }
                            });
        const NetworkExtremes& extremes = found.residuals.extremes;
        // Means over a cell of the fine grid miss at most what a cell and a half weigh.
        const double weight = 1.5 * coarse.gravity;
        CHECK(extremes.leastStrain <= least + 1e-9 * most);
        CHECK(extremes.leastStrain >= least - weight - 1e-9 * most);
        CHECK(extremes.mostStrain >= most - 1e-9 * most);
        CHECK(extremes.mostStrain <= most + weight + 1e-9 * most);
    }
}

TEST_CASE("network find: an energy is held without asking for the least again, which is known")
{
    if (!test::hasSimplex()) {
        return;
    }
    // In resonance, where nothing presses: an interior point has no inside to stay in.
    const Network network = sceneOf("clamp 6 gap=1e-3 6 clamp");
    const double energy = *heldEnergy(network, {}, 9.0);
    FindOptions options;
    options.timeLimit = 5.0;
    const LeastMotion held =
        wishedMotion(network, {{1, 6}, {0, 42}}, 1e9, {Objective::automatic, energy, {}}, options);
    INFO(held.detail);
    REQUIRE(held.status == Status::found);
    CHECK(held.energy == Approx(energy).epsilon(1e-9));
    CHECK(held.residuals.worst() < 1e-9);
}

TEST_CASE("network find: held energies, most impulses and the nearest motions of the paper's bar")
{
    if (!test::hasSimplex()) {
        return;  // both searches need one
    }
    const Network network = sceneOf("clamp 4 stop=1e-3");
    constexpr double firstEnergy = 2.0;  // E_1, of 4 cells
    const auto wished = [&network](std::int64_t contact, std::int64_t free,
                                   const NetworkWish& wish) {
        return wishedMotion(network, {{1, contact}, {0, free}}, 1e9, wish, {});
    };
    int found = 0;
    int mostReached = 0;
    for (std::int64_t contact = 1; contact < 10; ++contact) {
        for (std::int64_t free = 1; free < 22; ++free) {
            const Schedule schedule{4, {{contact, free}}};
            const PeriodicResult least = findPeriodic(schedule);
            if (least.status != Status::found) {
                continue;
            }
            ++found;
            FindOptions options;
            const LeastMotion pressed = wished(contact, free, {Objective::maxImpulse, {}, {}});
            INFO(contact << " " << free << ": " << pressed.detail);
            REQUIRE(pressed.status == Status::found);
            options.objective = Objective::maxImpulse;
            const PeriodicResult most = findPeriodic(schedule, options);
            const auto other =
                walk(network,
                     {wavesOf(network, most.motion->state), {0.0, 0.0}, {{1, contact}, {0, free}}});
            CHECK(pressed.residuals.impulses.front() ==
                  Approx(other.impulses.front()).epsilon(1e-7).margin(1e-9));
            options.objective = Objective::maxEnergy;
            const PeriodicResult highest = findPeriodic(schedule, options);
            const LeastMotion climbed = wished(contact, free, {Objective::maxEnergy, {}, {}});
            REQUIRE(climbed.status == Status::found);
            const double energy = highest.motion->energyRatio * firstEnergy;
            CHECK(climbed.energy <= energy * (1.0 + 1e-8));
            CHECK(climbed.residuals.worst() < 1e-8);
            mostReached += climbed.energy >= energy * (1.0 - 1e-8) ? 1 : 0;
            const LeastMotion near =
                wished(contact, free, {Objective::nearest, {}, pressed.motion->waves});
            REQUIRE(near.status == Status::found);
            CHECK(near.energy == Approx(pressed.energy).epsilon(1e-7));
            for (const double factor : {0.5, 0.9, 1.0, 1.3, 2.5, 6.0}) {
                const double ratio = factor * least.motion->energyRatio;
                options = {};
                options.energyRatio = ratio;
                const PeriodicResult one = findPeriodic(schedule, options);
                const LeastMotion held = wished(contact, free, {{}, ratio * firstEnergy, {}});
                INFO(factor << ": " << held.detail);
                CHECK((held.status == one.status ||
                       (held.status == Status::undecided && factor >= 1.0)));
                CHECK((held.status == Status::none) == (factor < 1.0));
                if (held.status == Status::found) {
                    CHECK(held.energy == Approx(ratio * firstEnergy).epsilon(1e-8));
                }
                if (one.status == Status::found) {
                    CHECK(held.status == Status::found);
                }
            }
        }
    }
    CHECK(found > 10);
    CHECK(10 * mostReached > 9 * found);  // climbing may end on a lower summit
    // Two bars of one length swing together, as far as one likes, and stay apart as they are.
    const LeastMotion together =
        wishedMotion(sceneOf("clamp 6 gap=1e-3 6 clamp"), {{1, 6}, {0, 42}}, 1e9,
                     {Objective::maxEnergy, {}, {}}, {});
    CHECK(together.status == Status::undecided);
    CHECK_THAT(together.detail, containsText("no motion the most"));
    CHECK_THROWS_WITH(wished(2, 14, {Objective::minEnergy, 1.0, {}}), containsText("is held"));
}

TEST_CASE("network find: two bars of one length meet as the paper's bar does, with its energies")
{
    const double ratio = GENERATE(1.0, 2.0, 10.0);
    const Network network = sceneOf("clamp 4 gap=1e-3 4:" + std::to_string(ratio) + " clamp");
    const double impedance = ratio / (1.0 + ratio);
    int found = 0;
    for (std::int64_t contact = 1; contact < 16; ++contact) {
        for (std::int64_t free = 1; free < 32; ++free) {
            const LeastMotion two = asked(network, contact, free);
            const PeriodicResult one = findPeriodic({4, {{contact, free}}});
            INFO(contact << " " << free << ", " << ratio << ": " << two.detail);
            CHECK(two.status == one.status);
            if (two.status != Status::found) {
                CHECK(two.provedEnergy >= 1e9);
                continue;
            }
            ++found;
            // The gap is 8 delta here; that of 4 cells has 4, and E_1 is 2 there.
            CHECK(two.energy ==
                  Approx(impedance * 4.0 * 2.0 * one.motion->energyRatio).epsilon(1e-9));
            CHECK(two.provedEnergy == Approx(two.energy).epsilon(1e-7));
            CHECK(two.provedEnergy <= two.energy * (1.0 + 1e-12));
            CHECK(two.residuals.worst() < 1e-12);
        }
    }
    CHECK(found == 19);
}

TEST_CASE("network find: as many schedules exist as another program counted")
{
    CHECK(existing("clamp 4 gap=1e-3 3 clamp", 14, 28) == 38);
    CHECK(existing("clamp 3 gap=1e-3 5:0.5 clamp", 16, 32) == 34);
    CHECK(existing("clamp 3 stop=1e-3 3 clamp", 12, 18) == 12);
}

TEST_CASE("network find: a point obstacle, and roots that are springs")
{
    const Network obstacle = sceneOf("clamp 3 stop=1e-3 3 clamp");
    const LeastMotion least = asked(obstacle, 1, 10);
    REQUIRE(least.status == Status::found);
    CHECK(least.energy == Approx(0.75 * 36.0).epsilon(1e-12));  // the gap is 6 delta
    CHECK(least.provedEnergy == Approx(least.energy).epsilon(1e-7));
    // Stiff springs are clamps: the least energy comes near that of the clamped bar.
    const PeriodicResult clamped = findPeriodic({4, {{2, 12}}});
    REQUIRE(clamped.status == Status::found);
    const double known = 2.0 * clamped.motion->energyRatio;
    double before = 1.0;
    for (const char* words : {"spring=4e2 4 stop=1e-3", "spring=4e5 4 stop=1e-3"}) {
        const LeastMotion soft = asked(sceneOf(words), 2, 12);
        INFO(words << ": " << soft.detail);
        if (soft.status == Status::found) {
            CHECK(std::abs(soft.energy / known - 1.0) < before);
            before = std::abs(soft.energy / known - 1.0);
        }
        CHECK(soft.status != Status::undecided);
    }
}

TEST_CASE("network find: contacts in turn, and both at once")
{
    const Network network = sceneOf("clamp 3 stop=1e-3 3 gap=1e-3 4 clamp");
    int found = 0;
    int none = 0;
    for (std::int64_t one = 1; one < 6; ++one) {
        for (std::int64_t free = 2; free < 14; ++free) {
            for (const ContactSet second : {2U, 3U}) {
                const LeastMotion answer = leastMotion(
                    network, {{1, one}, {0, free}, {second, one}, {0, free}}, 1e9 * 10.0);
                INFO(one << " " << free << " " << second << ": " << answer.detail);
                CHECK(answer.status != Status::undecided);
                found += answer.status == Status::found ? 1 : 0;
                none += answer.status == Status::none ? 1 : 0;
            }
        }
    }
    INFO(found << " found");
    CHECK(none > 50);
}

namespace {

/// A bar on the ground under its weight, as Doyen, Ern and Piperno (2011) have it: units of theirs.
Network bouncing(std::int64_t cells)
{
    return networkOf(Assembly{.parts = partsOf(std::to_string(cells) + " stop=0"),
                              .length = 10.0,
                              .waveSpeed = 30.0,
                              .axialStiffness = 900.0,
                              .gravity = 10.0});
}

}  // namespace

TEST_CASE("network find: a bar bounces under its weight, and no motion has less energy")
{
    for (const std::int64_t n : {2, 4, 10}) {
        const Network network = bouncing(n);
        const std::vector<ContactSpan> twice{{1, 2 * n}, {0, 6 * n}, {1, 2 * n}, {0, 6 * n}};
        const LeastMotion answer = leastMotion(network, twice, 1e12);
        INFO(n << ": " << answer.detail);
        REQUIRE(answer.status == Status::found);
        CHECK(answer.residuals.worst() < 1e-12);
        CHECK(answer.provedEnergy == Approx(answer.energy).epsilon(1e-7));
        CHECK(answer.provedEnergy <= answer.energy * (1.0 + 1e-12));
        // The benchmark's: velocities 3 W/Z, l - r = (i - 1/2)/N from the head, contact 2 N steps.
        NetworkClaim known{.schedule = {{1, 2 * n}, {0, 6 * n}, {1, 2 * n}, {0, 6 * n}}};
        const double weight = network.nodes.back().force;
        for (const double turn : {1.0, -1.0}) {
            for (std::int64_t i = 1; i <= n; ++i) {
                const double stretch = (static_cast<double>(i) - 0.5) / static_cast<double>(n);
                known.waves.push_back(0.5 * weight * (3.0 - turn * stretch));
            }
        }
        known.displacements = {-0.5 * weight * static_cast<double>(n), 0.0};
        CHECK(walk(network, known).worst() < 1e-12);
        // With one bounce in a period there is one: it is undeformed all the time.
        const LeastMotion once = leastMotion(network, {{1, 2 * n}, {0, 6 * n}}, 1e12);
        REQUIRE(once.status == Status::found);
        const double energy = 2.0 * static_cast<double>(n) * 2.25 * weight * weight;
        CHECK(once.energy == Approx(energy).epsilon(1e-10));
        CHECK(once.provedEnergy == Approx(energy).epsilon(1e-7));
        CHECK(answer.energy == Approx(energy).epsilon(1e-10));
        CHECK(leastMotion(network, {{1, 2 * n}, {0, 6 * n + 1}}, 1e12).status != Status::undecided);
    }
}

TEST_CASE("network find: under constant forces the least energy found is the one that is proved")
{
    int found = 0;
    for (const char* words :
         {"clamp 5 force=1e-3 gap=1e-3 5 clamp", "clamp 2 force=1e-3 3 gap=1e-3 5 clamp",
          "clamp 5 gap=1e-3 force=1e-3 4:2 clamp", "clamp 5 force=1e-3 stop=1e-3 5 clamp",
          "clamp 3 force=2e-3 3:0.5 stop=1e-3"}) {
        for (std::int64_t contact = 1; contact < 6; ++contact) {
            for (const std::int64_t steps : {12, 18, 20, 24}) {
                const LeastMotion least = asked(sceneOf(words), contact, steps - contact);
                INFO(words << ": " << contact << " of " << steps << ": " << least.detail);
                CHECK(least.status != Status::undecided);
                if (least.status == Status::found) {
                    ++found;
                    CHECK(least.provedEnergy == Approx(least.energy).epsilon(1e-7));
                }
            }
        }
    }
    CHECK(found > 20);
}

TEST_CASE("network find: between two walls each side is met, however long a bar flies")
{
    const Network network = sceneOf("stop=-1e-3 3 stop=1e-3");
    for (std::int64_t f = 1; f < 20; ++f) {
        const LeastMotion answer = leastMotion(network, {{2, 6}, {0, f}, {1, 6}, {0, f}}, 1e9);
        INFO(f << ": " << answer.detail);
        REQUIRE(answer.status == Status::found);
        CHECK(answer.residuals.worst() < 1e-12);
        CHECK(answer.provedEnergy == Approx(answer.energy).epsilon(1e-7));
        // With uniform speed it crosses both gaps, 6 delta, in f steps.
        const double speed = 6.0 / static_cast<double>(f);
        CHECK(answer.energy <= 6.0 * 0.25 * speed * speed * (1.0 + 1e-9));
        CHECK(answer.residuals.impulses[0] == Approx(answer.residuals.impulses[1]));
    }
}

TEST_CASE("network find: nothing presses a bar that drifts to one wall, and weight pulls it there")
{
    const Network still = sceneOf("4 stop=1e-3");
    const LeastMotion rest = leastMotion(still, {{1, 8}, {0, 24}}, 1e9);
    REQUIRE(rest.status == Status::found);
    CHECK(rest.energy == 0.0);
    CHECK(rest.motion->displacements.back() == Approx(4.0));
    // A force away from the wall: the mean push would be negative.
    const Network away = sceneOf("force=-1e-3 4 stop=1e-3");
    const LeastMotion none = leastMotion(away, {{1, 8}, {0, 24}}, 1e9);
    CHECK(none.status == Status::none);
    CHECK(none.provedEnergy >= 1e9);
    // Two bars, and only they meet.
    CHECK_THROWS_WITH(leastMotion(sceneOf("4 gap=1e-3 4"), {{1, 8}, {0, 24}}, 1e9),
                      containsText("bar"));
    // Between clamped bars, or walls, they are known.
    const LeastMotion three = leastMotion(sceneOf("clamp 4 gap=1e-3 2 gap=1e-3 4 clamp"),
                                          {{1, 4}, {0, 7}, {2, 4}, {0, 7}}, 1e9);
    CHECK(three.status != Status::undecided);
}

TEST_CASE("network find: what is spoilt proves nothing")
{
    const Network network = sceneOf("clamp 3 gap=1e-3 5:0.5 clamp");
    const std::vector<ContactSpan> schedule{{1, 3}, {0, 7}};
    const LeastMotion answer = leastMotion(network, schedule, 1e9);
    REQUIRE(answer.status == Status::none);
    EnergyFloor bad = answer.multipliers;
    bad.periodicity[5] += 1e-3;
    CHECK(provedEnergy(bad, network, schedule) < 1e9);
    bad = answer.multipliers;
    for (ContactMultiplier& place : bad.places) {
        place.value = -place.value;
    }
    CHECK(provedEnergy(bad, network, schedule) < 1e9);
}

TEST_CASE("network find: what nobody has a method for is refused by name")
{
    const auto refuses = [](const std::string& words, std::vector<ContactSpan> schedule,
                            const std::string& part) {
        CHECK_THROWS_WITH(leastMotion(sceneOf(words), schedule, 1e9), containsText(part));
    };
    refuses("clamp 4 stop=0", {{1, 2}, {0, 8}}, "at rest are a motion");
    refuses("clamp 4 stop=1e-3", {{0, 2}, {1, 8}, {0, 1}}, "schedule = -:2 1:8 -:1");
    refuses("clamp 4 stop=1e-3", {{2, 2}, {0, 8}}, "contacts 1..1");
    refuses("clamp 4 stop=1e-3", {{1, 0}, {0, 8}}, "steps");
}
