// The response with two contacts in a period: every schedule, and what it is compared with.

#include "two_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "catch.hpp"
#include "signorini/response.hpp"
#include "support.hpp"

using namespace signorini;

namespace {

/// The motions of a range with two contacts.
ResponseRange pairsOn(std::int64_t cells, const Damping& damping, double amplitude)
{
    ResponseRange range;
    range.cells = cells;
    range.damping = damping;
    range.amplitude = amplitude;
    range.contacts = 2;
    return range;
}

using PhasePair = std::array<Phase, 2>;

/// All schedules of n steps with two contacts, each in one of its two orders. A flight of one step
/// that closes is none.
std::vector<PhasePair> allPairs(std::int64_t steps)
{
    std::vector<PhasePair> all;
    for (std::int64_t a = 1; a < steps; ++a) {
        for (std::int64_t b = 2; a + b < steps; ++b) {
            for (std::int64_t c = 1; a + b + c + 2 <= steps; ++c) {
                const Phase first{a, b};
                const Phase second{c, steps - a - b - c};
                if (first > second) {
                    all.push_back({first, second});
                }
            }
        }
    }
    return all;
}

/// The first contact on the wall, the second on the other stop: any four lengths.
std::vector<PhasePair> allBetween(std::int64_t steps)
{
    std::vector<PhasePair> all;
    for (std::int64_t a = 1; a < steps; ++a) {
        for (std::int64_t b = 1; a + b < steps; ++b) {
            for (std::int64_t c = 1; a + b + c < steps; ++c) {
                all.push_back({Phase{a, b}, Phase{c, steps - a - b - c, Stop::left}});
            }
        }
    }
    return all;
}

}  // namespace

TEST_CASE("response, two contacts: every schedule is looked at once")
{
    for (std::int64_t n = 4; n < 30; ++n) {
        CHECK(twoContactSchedules(n) == static_cast<double>(allPairs(n).size()));
    }
}

TEST_CASE("response, two contacts: it lists what find has of the schedules one by one")
{
    std::size_t motions = 0;
    std::size_t branches = 0;
    for (const Excited place : {Excited::tip, Excited::base}) {
        for (const std::int64_t cycles : {1, 2, 3}) {
            for (const std::int64_t n : {17, 20, 23, 24, 27}) {
                ResponseRange range = pairsOn(6, {0.03}, 0.8);
                range.place = place;
                range.cycles = cycles;
                range.band = 0.5;
                const auto response = responseAt(range, n);
                REQUIRE(response);
                std::size_t next = 0;
                std::int64_t undecided = 0;
                for (const PhasePair& pair : allPairs(n)) {
                    const Schedule schedule{6, {pair.begin(), pair.end()}};
                    const ForcedSet set =
                        forcedMotions(schedule, range.damping, {place, cycles, {}});
                    undecided += set.status == Status::undecided ? 1 : 0;
                    INFO("K = " << cycles << ", " << describe(schedule) << " " << set.detail);
                    const bool isListed = next < response->twoContacts.size() &&
                                          response->twoContacts[next].phases == pair;
                    if (set.status == Status::found && !isListed) {
                        // Only a motion of n/2 steps, gone through twice, is left out.
                        REQUIRE(cycles % 2 == 0);
                        REQUIRE(n % 2 == 0);
                        const ForcedMotion motion = leastAmplitudeMotion(set);
                        BarSimulation bar(wavesOf(motion.state), motion.damping, motion.excitation);
                        const Eigen::VectorXd start = stretching(bar.waves(), 6);
                        bar.advance(0.5 * static_cast<double>(n));
                        CHECK((stretching(bar.waves(), 6) - start).cwiseAbs().maxCoeff() < 1e-9);
                        continue;
                    }
                    REQUIRE(isListed == (set.status == Status::found));
                    if (isListed) {
                        CHECK(response->twoContacts[next].least ==
                              Approx(set.leastAmplitude).epsilon(1e-9));
                        ++next;
                    }
                }
                CHECK(next == response->twoContacts.size());
                CHECK(response->undecided <= undecided);
                branches += next;
                for (const ForcedMotion& motion : response->motions) {
                    motions += motion.schedule.phases.size() == 2 ? 1 : 0;
                }
            }
        }
    }
    CHECK(branches > 50);
    CHECK(motions > 10);
}

TEST_CASE("response, two contacts: with other stops it lists what find has, and no tip that rests")
{
    const std::vector<Stops> scenes{
        {-1, {}}, {0, {}}, {1, Fraction{1, 1}}, {1, Fraction{2, 3}}, {-1, Fraction{3, 2}}};
    std::size_t branches = 0;
    std::size_t both = 0;
    for (const Stops& stops : scenes) {
        for (const Excited place : {Excited::tip, Excited::base}) {
            for (const std::int64_t n : {9, 10, 12, 13, 15}) {
                ResponseRange range = pairsOn(4, {0.03}, 0.8);
                range.stops = stops;
                range.place = place;
                const auto response = responseAt(range, n);
                REQUIRE(response);
                std::vector<PhasePair> all;
                for (const Stop stop : {Stop::right, Stop::left}) {
                    for (PhasePair pair : stop == Stop::right || stops.left
                                              ? allPairs(n)
                                              : std::vector<PhasePair>{}) {
                        pair[0].stop = pair[1].stop = stop;
                        all.push_back(pair);
                    }
                }
                for (const PhasePair& pair :
                     stops.left ? allBetween(n) : std::vector<PhasePair>{}) {
                    all.push_back(pair);
                }
                CHECK(twoContactSchedules(n, stops.left ? 2 : 1) ==
                      static_cast<double>(all.size()));
                for (const PhasePair& pair : all) {
                    const Schedule schedule{4, {pair.begin(), pair.end()}, stops};
                    const ForcedSet set = forcedMotions(schedule, range.damping, {place, 1, {}});
                    const bool isListed =
                        std::any_of(response->twoContacts.begin(), response->twoContacts.end(),
                                    [&pair](const auto& one) { return one.phases == pair; });
                    const bool isMirrored =
                        pair[0].stop != pair[1].stop && stops.left == Fraction{stops.right, 1} &&
                        pair[0].contact == pair[1].contact && pair[0].free == pair[1].free;
                    INFO(describe(schedule) << " stops " << stops.right << " " << name(place) << " "
                                            << set.detail << " least " << set.leastAmplitude);
                    branches += isListed ? 1 : 0;
                    both += isListed && pair[0].stop != pair[1].stop ? 1 : 0;
                    if (isListed || set.status != Status::found || isMirrored) {
                        CHECK((!isListed || set.status == Status::found));
                        continue;
                    }
                    // What is not listed has a tip that rests.
                    CHECK(set.freeWaves > 0);
                    const double some = std::clamp(0.8, set.leastAmplitude, set.mostAmplitude);
                    for (const ForcedMotion& motion :
                         some > 0.0 ? motionsOfAmplitude(set, some) : std::vector<ForcedMotion>{}) {
                        CHECK(motion.extremes.approachSpeed < 1e-8);
                    }
                }
                for (const ForcedMotion& motion : response->motions) {
                    CHECK(motion.residual <= forcedTolerance);
                    CHECK(std::abs(motion.amplitude - 0.8) <= 0.8 * range.band * (1.0 + 1e-9));
                }
            }
        }
    }
    CHECK(branches > 50);
    CHECK(both > 10);
}

TEST_CASE("response, two contacts: every motion simulated for ten periods returns to itself")
{
    std::size_t simulated = 0;
    for (const std::int64_t n : {104, 111, 113, 116, 118, 126}) {
        ResponseRange range = pairsOn(30, {0.02}, 1.0);
        range.band = 0.9;
        const auto response = responseAt(range, n);
        REQUIRE(response);
        for (const ForcedMotion& motion : response->motions) {
            if (motion.schedule.phases.size() < 2) {
                continue;
            }
            INFO(describe(motion.schedule));
            CHECK(motion.amplitude >= 0.1);
            CHECK(motion.amplitude <= 1.9);
            BarSimulation bar(wavesOf(motion.state), motion.damping, motion.excitation,
                              {.mergeBelow = 0.0});
            const Eigen::VectorXd start = stretching(bar.waves(), 30);
            bar.advance(10.0 * static_cast<double>(n));
            CHECK((stretching(bar.waves(), 30) - start).cwiseAbs().maxCoeff() <=
                  1e-9 * std::max(1.0, amplitude(motion.state)));
            CHECK(bar.contacts().size() >= 19);  // the last one may not have ended
            ++simulated;
        }
    }
    CHECK(simulated > 20);
}

TEST_CASE("response, two contacts: where the simulation settles on two contacts a period")
{
    // Section 15: n = 118, no motion with one contact; from rest it settles on an impulse of
    // 0.4265. On the grid neighbours have amplitudes on both sides of 0.25, and impulses, too.
    ResponseRange range = pairsOn(30, dampingOfRho(0.9), 0.25);
    range.band = 0.15;
    const auto response = responseAt(range, 118);
    REQUIRE(response);
    REQUIRE(response->motions.size() == 2);
    const ForcedMotion& below = response->motions.front();
    const ForcedMotion& above = response->motions.back();
    CHECK(below.schedule == Schedule{30, {{2, 100}, {2, 14}}});
    CHECK(above.schedule == Schedule{30, {{2, 101}, {2, 13}}});
    REQUIRE(below.amplitude < 0.25);
    REQUIRE(above.amplitude > 0.25);
    const double share = (0.25 - below.amplitude) / (above.amplitude - below.amplitude);
    CHECK(std::lerp(below.extremes.impulse, above.extremes.impulse, share) ==
          Approx(0.4265).epsilon(0.01));
}

TEST_CASE("response, two contacts: damping and excitation pick the splits of a polygon")
{
    // Section 18: amplitudes 154.1, 256.4, 768.4 times zeta for contacts 6 + 1, 5 + 2, 4 + 3, all
    // with the energy of the polygon, 58.78 E_1.
    for (const double zeta : {1e-4, 1e-5}) {
        ResponseRange range = pairsOn(23, {zeta}, 460.0 * zeta);
        range.band = 0.7;
        const auto response = responseAt(range, 59);
        REQUIRE(response);
        std::vector<ForcedMotion> motions;
        std::copy_if(response->motions.begin(), response->motions.end(),
                     std::back_inserter(motions),
                     [](const ForcedMotion& motion) { return motion.schedule.phases.size() == 2; });
        const std::pair<std::int64_t, double> known[] = {{4, 768.4}, {5, 256.4}, {6, 154.1}};
        REQUIRE(motions.size() == 3);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& [contact, slope] = known[k];
            const ForcedMotion& motion = motions[k];
            CHECK(motion.schedule == Schedule{23, {{contact, 26}, {7 - contact, 26}}});
            CHECK(motion.amplitude == Approx(slope * zeta).epsilon(1e-3));
            CHECK(energyRatio(motion.state) == Approx(58.78).epsilon(1e-3));
        }
    }
}

TEST_CASE("response, two contacts: a longer excitation of twice as many cells is the same")
{
    const auto coarse = responseAt(pairsOn(15, dampingOfRho(0.9), 0.25), 59);
    const auto fine = responseAt(pairsOn(30, dampingOfRho(0.9), 0.25), 118);
    REQUIRE(coarse);
    REQUIRE(fine);
    std::size_t compared = 0;
    for (const TwoContactBranch& branch : coarse->twoContacts) {
        for (const TwoContactBranch& other : fine->twoContacts) {
            const auto isTwice = [](const Phase& x, const Phase& y) {
                return 2 * x.contact == y.contact && 2 * x.free == y.free;
            };
            if (isTwice(branch.phases[0], other.phases[0]) &&
                isTwice(branch.phases[1], other.phases[1])) {
                CHECK(other.least == Approx(branch.least).epsilon(1e-2));
                ++compared;
            }
        }
    }
    CHECK(compared > 2);
}

TEST_CASE("response, two contacts: what is asked is refused or cancelled as everywhere")
{
    ResponseRange range = pairsOn(300, {0.02}, 0.2);
    CHECK_THROWS_WITH(stepsOf(range), containsText("contacts: 2") && containsText("at most 1"));
    range.contacts = 3;
    CHECK_THROWS_WITH(stepsOf(range), containsText("contacts = 3") && containsText("1 or 2"));
    range.contacts = 1;
    CHECK(stepsOf(range).size() > 600);
    for (const double band : {0.0, 1.0, -1.0, std::nan("")}) {
        range.band = band;
        CHECK_THROWS_WITH(stepsOf(range), containsText("band"));
    }
    int asked = 0;
    CHECK_FALSE(responseAt(pairsOn(30, {0.02}, 0.2), 108, [&asked] { return ++asked > 200; }));
}
