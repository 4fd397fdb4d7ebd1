#include "signorini/atlas.hpp"

#include <algorithm>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "signorini/motion.hpp"

using namespace signorini;

namespace {

AtlasRange rangeOf(std::int64_t cells, std::int64_t contact, std::int64_t free)
{
    AtlasRange range;
    range.cells = cells;
    range.maxContact = contact;
    range.maxFree = free;
    return range;
}

using Found = std::pair<Phase, Verdict>;

std::vector<Found> visitAll(const AtlasRange& range)
{
    std::vector<Found> found;
    CHECK(forEachSchedule(range, [&found](const Phase& phase, const Verdict& verdict) {
        found.emplace_back(phase, verdict);
        return true;
    }));
    return found;
}

/// The same by deciding every schedule.
std::vector<Found> decideAll(const AtlasRange& range)
{
    std::vector<Found> found;
    std::vector<std::int8_t> signs;
    for (std::int64_t n = 2; n <= range.maxContact + range.maxFree; ++n) {
        for (std::int64_t contact = std::max<std::int64_t>(1, n - range.maxFree);
             contact <= std::min(range.maxContact, n - 1); ++contact) {
            const Phase phase{contact, n - contact};
            const Verdict verdict = decide(range.cells, phase, signs);
            if (!verdict.reason && energyRange(verdict).least <= range.maxEnergyRatio) {
                found.emplace_back(phase, verdict);
            }
        }
    }
    return found;
}

bool isSame(const Verdict& a, const Verdict& b)
{
    const EnergyRange energyA = energyRange(a);
    const EnergyRange energyB = energyRange(b);
    return a.cells == b.cells && a.classes == b.classes && a.members == b.members &&
           a.window == b.window && a.contactMembers == b.contactMembers &&
           a.firstLive == b.firstLive && a.kernelDimension == b.kernelDimension &&
           a.windowSum == b.windowSum && a.reason == b.reason && a.contact == b.contact &&
           a.set.kind == b.set.kind && a.set.count == b.set.count && a.set.sum == b.set.sum &&
           a.set.lower == b.set.lower && a.set.upper == b.set.upper &&
           a.isCanonical() == b.isCanonical() && energyA.least == energyB.least &&
           energyA.most == energyB.most;
}

void compare(const AtlasRange& range)
{
    const std::vector<Found> visited = visitAll(range);
    const std::vector<Found> decided = decideAll(range);
    INFO(range.cells << " " << range.maxContact << " " << range.maxFree);
    REQUIRE(visited.size() == decided.size());
    for (std::size_t i = 0; i < visited.size(); ++i) {
        REQUIRE(visited[i].first == decided[i].first);
        REQUIRE(isSame(visited[i].second, decided[i].second));
    }
}

std::pair<int, int> countOf(const AtlasRange& range)
{
    int pressing = 0;
    int grazing = 0;
    forEachSchedule(range, [&](const Phase&, const Verdict& verdict) {
        ++(verdict.contact == Contact::pressing ? pressing : grazing);
        return true;
    });
    return {pressing, grazing};
}

}  // namespace

TEST_CASE("family atlas: the verdicts of the exhaustive search, to the last bit")
{
    for (std::int64_t cells = 1; cells <= 32; ++cells) {
        compare(rangeOf(cells, 2 * cells, 8 * cells));
    }
}

TEST_CASE("family atlas: any bounds on contact, flight and energy")
{
    std::mt19937_64 generator(11);
    for (int i = 0; i < 200; ++i) {
        const auto draw = [&generator](std::int64_t most) {
            return std::uniform_int_distribution<std::int64_t>(1, most)(generator);
        };
        const std::int64_t cells = draw(24);
        AtlasRange range = rangeOf(cells, draw(5 * cells), draw(13 * cells));
        range.maxEnergyRatio = i % 3 == 0 ? 4.0 : i % 3 == 1 ? 9.0 : 31.7;
        compare(range);
    }
    compare(rangeOf(1, 3, 2000));
    compare(rangeOf(2, 500, 300));
}

TEST_CASE("family atlas: the counts of the exhaustive search at N = 12, 30 and 300")
{
    const std::vector<Found> usual = visitAll(usualRange(12));
    CHECK(std::count_if(usual.begin(), usual.end(),
                        [](const Found& found) { return found.second.isCanonical(); }) == 36);
    CHECK(countOf(rangeOf(30, 60, 240)) == std::pair(359, 330));
    CHECK(countOf(rangeOf(300, 600, 2400)) == std::pair(12'962, 5'050));
}

TEST_CASE("family atlas: whole columns of a large grid agree with the verdicts")
{
    constexpr std::int64_t cells = 1'000;
    const std::vector<Found> visited = visitAll(rangeOf(cells, 2 * cells, 4 * cells));
    std::vector<std::int8_t> signs;
    for (const std::int64_t n : {2'600, 3'000, 3'250, 3'500, 3'501, 3'504, 3'725, 3'990, 4'000}) {
        std::vector<Found> decided;
        for (std::int64_t contact = 1; contact <= 2 * cells; ++contact) {
            const Verdict verdict = decide(cells, {contact, n - contact}, signs);
            if (n - contact >= 1 && !verdict.reason) {
                decided.emplace_back(Phase{contact, n - contact}, verdict);
            }
        }
        std::size_t place = 0;
        for (const Found& found : visited) {
            if (found.first.contact + found.first.free == n) {
                REQUIRE(place < decided.size());
                REQUIRE(found.first == decided[place].first);
                REQUIRE(isSame(found.second, decided[place].second));
                ++place;
            }
        }
        CHECK(place == decided.size());
    }
}

TEST_CASE("family atlas: motions of least energy repeat after their own steps, and no sooner")
{
    for (const std::int64_t cells : {6, 9, 14, 15}) {
        for (const auto& [phase, verdict] : visitAll(rangeOf(cells, 2 * cells, 6 * cells))) {
            const Schedule schedule{cells, {phase}};
            std::vector<double> p = arrivals(leastEnergyMotion(onePhaseSet(schedule)), schedule);
            const std::vector<double> start = p;
            std::int64_t count = 0;
            do {
                std::rotate(p.begin(), p.begin() + 1, p.end());
                ++count;
            } while (p != start);
            INFO(describe(schedule));
            REQUIRE(count == ownSteps(phase, verdict));
        }
    }
    // A grazing member that repeats sooner: p is antiperiodic after 6 steps, G = 18.
    const Schedule schedule{9, {{1, 35}}};
    const OnePhaseSet set = onePhaseSet(schedule);
    REQUIRE(set.classes == 18);
    std::vector<double> z{0, 0, 0, 0, -9, 0, 0, 0, 0, 0, 9, 0, 0, 0, 0, 0, -9};
    const std::vector<double> p = arrivals(motionOf(set, z), schedule);
    for (std::size_t m = 0; m < p.size(); ++m) {
        REQUIRE(p[m] == p[(m + 12) % p.size()]);
    }
    std::vector<std::int8_t> signs;
    const Verdict refuted = decide(9, {1, 1}, signs);
    CHECK_THROWS_AS(ownSteps({1, 1}, refuted), std::invalid_argument);
}

TEST_CASE("family atlas: a visitor that says no ends the search")
{
    int visits = 0;
    CHECK_FALSE(forEachSchedule(rangeOf(maxCells, maxCells, maxCells * 4),
                                [&visits](const Phase&, const Verdict&) { return ++visits < 5; }));
    CHECK(visits == 5);
    CHECK_FALSE(forEachSchedule(
        rangeOf(300, 600, 1200), [](const Phase&, const Verdict&) { return true; },
        [] { return true; }));
}

TEST_CASE("family atlas: several phases and bad ranges are refused")
{
    AtlasRange range = rangeOf(4, 8, 16);
    range.maxPhases = 2;
    const ScheduleVisitor all = [](const Phase&, const Verdict&) { return true; };
    CHECK_THROWS_WITH(forEachSchedule(range, all), containsText("phases = 2"));
    CHECK_THROWS_WITH(forEachSchedule(rangeOf(0, 1, 1), all), containsText("cells = 0"));
}
