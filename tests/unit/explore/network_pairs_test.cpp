// Two contacts in a period of any network, against the bar's own recursion and the engine of single
// schedules.

#include <fmt/format.h>

#include <algorithm>

#include "../mechanics/random_network.hpp"
#include "catch.hpp"
#include "has_solver.hpp"
#include "network_find.hpp"
#include "network_forced.hpp"
#include "network_sweep.hpp"
#include "sanitized.hpp"
#include "scene_words.hpp"
#include "two_contacts.hpp"

using namespace signorini;

namespace {

const TwoContactBranch* branchOf(const FrequencyResponse& response,
                                 const std::array<Phase, 2>& phases)
{
    const auto found =
        std::find_if(response.twoContacts.begin(), response.twoContacts.end(),
                     [&phases](const TwoContactBranch& one) { return one.phases == phases; });
    return found == response.twoContacts.end() ? nullptr : &*found;
}

/// All schedules of n steps, in the order in which a sweep has them.
std::vector<std::array<Phase, 2>> allSchedules(std::int64_t steps, std::size_t contacts)
{
    std::vector<std::array<Phase, 2>> all;
    for (std::size_t first = 0; first < contacts; ++first) {
        for (std::size_t second = first; second < contacts; ++second) {
            const std::int64_t shortest = first == second ? 2 : 1;
            for (std::int64_t one = 1; one < steps; ++one) {
                for (std::int64_t free = shortest; one + free < steps; ++free) {
                    for (std::int64_t other = 1; one + free + other + shortest <= steps; ++other) {
                        const Phase before{one, free, static_cast<Stop>(first)};
                        const Phase after{other, steps - one - free - other,
                                          static_cast<Stop>(second)};
                        if (first != second || before > after) {
                            all.push_back({before, after});
                        }
                    }
                }
            }
        }
    }
    return all;
}

struct PairCount {
    int found = 0;
    int none = 0;
    int motions = 0;
};

/// Every schedule of a network against its own programs, and what is listed against time stepping.
void compareWithSchedules(const HarmonicNetwork& given, PairCount& count)
{
    const auto response = pairResponse(given, 0.5, {});
    REQUIRE(response);
    const auto all = allSchedules(given.steps, given.network.contacts.size());
    CHECK(twoContactSchedules(given.steps, given.network.contacts.size()) ==
          static_cast<double>(all.size()));
    for (const std::array<Phase, 2>& phases : all) {
        const std::vector<ContactSpan> spans =
            spansOf(Schedule{1, {phases.begin(), phases.end()}, {}});
        INFO("schedule " << textOf(spans));
        const ForcedSet set =
            forcedScene(given.network, spans, {given.place, given.cycles, {}}, 10.0);
        const TwoContactBranch* branch = branchOf(*response, phases);
        if (set.status == Status::undecided ||
            (set.status == Status::found && (set.freeWaves > 0 || set.mostAmplitude < 1e-9))) {
            continue;  // rounding decides, or it rests
        }
        if (branch == nullptr && set.status == Status::found && given.cycles % 2 == 0 &&
            march(given.network, claimOf(set, leastAmplitudeMotion(set))).repeats < given.steps) {
            continue;  // gone through twice
        }
        CHECK((branch != nullptr) == (set.status == Status::found));
        branch != nullptr ? ++count.found : ++count.none;
        if (branch != nullptr) {
            CHECK(branch->least == Approx(set.leastAmplitude).epsilon(1e-6));
        }
    }
    if (response->twoContacts.empty()) {
        return;
    }
    HarmonicNetwork nearer = given;
    nearer.amplitude = response->twoContacts[response->twoContacts.size() / 2].least;
    if (nearer.amplitude == 0.0) {
        return;  // motions of a network that nothing damps
    }
    const auto listed = pairResponse(nearer, 0.01, {});
    REQUIRE(listed);
    CHECK(!listed->motions.empty());
    for (const ForcedMotion& motion : listed->motions) {
        ++count.motions;
        INFO("motion " << describe(motion.schedule));
        CHECK(std::abs(motion.amplitude - nearer.amplitude) <= 0.0101 * nearer.amplitude);
        const NetworkMarch seen = march(given.network, claimOf(spansOf(motion.schedule), motion));
        CHECK(seen.firstFault == -1);
        CHECK(seen.residual < 1e-8);
        CHECK(seen.repeats > 0);
    }
}

}  // namespace

TEST_CASE("network pairs: a uniform bar has the schedules that its recursion finds", "[glpk]")
{
    if (!test::hasSimplex()) {
        return;
    }
    const std::vector<Stops> scenes{
        {1, {}}, {-1, {}}, {0, {}}, {1, Fraction{1, 1}}, {1, Fraction{2, 3}}, {-1, Fraction{3, 2}}};
    test::NetworkGenerator draw(11);
    std::size_t listed = 0;
    for (const Stops& stops : scenes) {
        for (int k = 0; k < test::drawn(12); ++k) {
            ResponseRange range;
            range.cells = draw.whole(2, 7);
            range.damping = {draw.isOneOf(2) ? 0.03 : 0.15};
            range.place = draw.isOneOf(2) ? Excited::tip : Excited::base;
            range.cycles = draw.isOneOf(3) ? 2 : 1;
            range.stops = stops;
            range.contacts = 2;
            const std::int64_t n = draw.whole(6, 20);
            range.amplitude = 0.8;
            range.band = 0.5;
            const auto own = responseAt(range, n);
            ResponseRange segments = range;
            segments.segments = {{.cells = range.cells}};
            const auto all = steppedResponseAt(segments, n, {});
            REQUIRE(own);
            REQUIRE(all);
            INFO("N = " << range.cells << ", n = " << n << ", K = " << range.cycles << ", "
                        << name(range.place) << ", stops " << stops.right << ", undecided "
                        << all->undecided << " for " << own->undecided << " " << all->detail);
            for (const TwoContactBranch& branch : own->twoContacts) {
                INFO(describe(Schedule{range.cells, {branch.phases[0], branch.phases[1]}, stops}));
                const TwoContactBranch* other = branchOf(*all, branch.phases);
                CHECK(other != nullptr);
                if (other != nullptr) {
                    CHECK(other->least == Approx(branch.least).epsilon(1e-6));
                }
                ++listed;
            }
            for (const TwoContactBranch& branch : all->twoContacts) {
                INFO(describe(Schedule{range.cells, {branch.phases[0], branch.phases[1]}, stops}));
                const auto& [first, second] = branch.phases;
                const bool isMirrored = first.stop != second.stop &&
                                        first.contact == second.contact &&
                                        first.free == second.free;
                CHECK((isMirrored || branchOf(*own, branch.phases) != nullptr));
            }
        }
    }
    INFO(listed << " schedules");
    CHECK(listed > static_cast<std::size_t>(test::drawn(12)) * 4);
}

TEST_CASE("network pairs: segments have the schedules that find has one by one", "[glpk]")
{
    if (!test::hasSimplex()) {
        return;
    }
    const std::vector<Stops> scenes{
        {1, {}}, {-1, {}}, {0, {}}, {1, Fraction{1, 1}}, {1, Fraction{2, 3}}, {-1, Fraction{3, 2}}};
    test::NetworkGenerator draw(5);
    int found = 0;
    int none = 0;
    for (const Stops& stops : scenes) {
        for (int k = 0; k < test::drawn(5); ++k) {
            ResponseRange range;
            range.segments = {{.cells = draw.whole(1, 3)},
                              {.cells = draw.whole(1, 3), .impedance = draw.fraction()}};
            range.cells = range.segments[0].cells + range.segments[1].cells;
            range.damping = {draw.isOneOf(2) ? 0.03 : 0.1};
            range.place = draw.isOneOf(2) ? Excited::tip : Excited::base;
            range.stops = stops;
            range.contacts = 2;
            const std::int64_t n = draw.whole(8, 14);
            const auto response = responseAt(range, n);
            REQUIRE(response);
            for (const auto& phases : allSchedules(n, stops.left ? 2 : 1)) {
                const Schedule schedule{range.cells, {phases.begin(), phases.end()}, stops};
                const ForcedSet set = forcedMotions(schedule, range.damping, {range.place, 1, {}},
                                                    {}, range.segments);
                const TwoContactBranch* branch = branchOf(*response, phases);
                if (set.status == Status::undecided ||
                    (branch == nullptr && set.status == Status::found && set.freeWaves > 0)) {
                    continue;  // rounding decides, or the tip rests
                }
                INFO(describe(schedule) << ", " << name(range.place));
                CHECK((branch != nullptr) == (set.status == Status::found));
                branch != nullptr ? ++found : ++none;
            }
        }
    }
    INFO(found << " found, " << none << " none");
    CHECK(found > test::drawn(30));
    CHECK(none > test::drawn(1000));
}

TEST_CASE("network pairs: every schedule of scenes is what its own programs say", "[glpk]")
{
    if (!test::hasSimplex()) {
        return;
    }
    test::NetworkGenerator draw(7);
    PairCount count;
    for (const char* words :
         {"clamp 3 driven dash=0.03 stop=1e-3 2:1.5 dash=0.02 stop=1e-3",
          "clamp 3 dash=0.02 driven gap=1e-3 2:1.3 dash=0.05 2 clamp",
          "clamp 4 dash=0.05 mass=0.2 2 driven stop=1e-3", "clamp 4 driven gap=1e-3 4 clamp",
          "stop=1e-3 4 driven dash=0.1 stop=1e-3"}) {
        INFO(words);
        const std::int64_t n = draw.whole(11, 15);
        compareWithSchedules({sceneOf(words), Excited::tip, 40.0, n, 1 + n % 3}, count);
    }
    int networks = 0;
    while (networks < test::drawn(25)) {
        const Network network =
            draw.network({.mostCells = 3, .mostBars = 2, .hasDashpots = true, .hasForces = true});
        const Excited place = draw.isOneOf(3) ? Excited::base : Excited::tip;
        const std::int64_t n = draw.whole(7, 11);
        if (!isExcitable(network, place) || network.contacts.size() > 3) {
            continue;
        }
        INFO("network " << networks << ", " << name(place));
        try {
            compareWithSchedules({network, place, 10.0, n, draw.whole(1, 2)}, count);
            ++networks;
        } catch (const std::invalid_argument&) {
            continue;  // a bar that forces pull away, or that is shaken and held elsewhere
        }
    }
    INFO(count.found << " found, " << count.none << " none, " << count.motions << " motions");
    CHECK(count.none > test::drawn(1000));
    CHECK(count.found + count.motions > test::drawn(8));
}
