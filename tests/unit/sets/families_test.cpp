#include "signorini/modes.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <vector>

#include "catch.hpp"
#include "families_truth.hpp"
#include "signorini/one_phase_set.hpp"
#include "support.hpp"

using namespace signorini;
using namespace signorini::test;

TEST_CASE("families: those of one period are those of the list")
{
    const std::vector<Family> all = findFamilies(24);
    for (std::int64_t order = 1; order <= 24; ++order) {
        for (std::int64_t blocks = 1; blocks <= 3 * order; ++blocks) {
            if (std::gcd(order, blocks) != 1) {
                CHECK_THROWS_AS(familiesAt(order, blocks), std::invalid_argument);
                continue;
            }
            std::vector<Family> expected;
            std::copy_if(all.begin(), all.end(), std::back_inserter(expected),
                         [&](const Family& f) { return f.order == order && f.blocks == blocks; });
            CHECK(familiesAt(order, blocks) == expected);
        }
    }
    CHECK_THROWS_AS(familiesAt(0, 1), std::invalid_argument);
}

TEST_CASE("families: Euclid's algorithm finds the triples of the definition, exhaustively")
{
    const std::vector<Family> families = findFamilies(45);
    CHECK(families == allByDefinition(45));
    CHECK(families.size() == 838);
    for (const Family& family : families) {
        REQUIRE(findFamily(family.order, family.blocks, family.contactBlocks) == family);
    }
    for (std::int64_t w = 1; w <= 20; ++w) {
        for (std::int64_t nu = 1; nu <= 2 * w + 3; ++nu) {
            for (std::int64_t k = 1; k <= nu + 1; ++k) {
                const bool isCoprime = std::gcd(w, nu) == 1 && k < nu;
                REQUIRE(findFamily(w, nu, k) ==
                        (isCoprime ? byDefinition(w, nu, k) : std::optional<Family>()));
            }
        }
    }
}

TEST_CASE("families: contacts are even lower semiconvergents, a third of them")
{
    std::int64_t records = 0;
    std::int64_t matches = 0;
    for (std::int64_t w = 1; w <= 45; ++w) {
        for (std::int64_t nu = 1; nu < 2 * w; ++nu) {
            if (std::gcd(w, nu) == 1) {
                for (const std::int64_t k : evenRecords(w, nu)) {
                    ++records;
                    matches += findFamily(w, nu, k) ? 1 : 0;
                }
            }
        }
    }
    CHECK(matches == 838);
    CHECK(records == 2554);
}

TEST_CASE("families: the lowest ones, their periods and energies")
{
    const std::vector<Family> expected{
        {3, 5, 1, -1}, {4, 7, 1, -2},  {5, 8, 2, -1},  {5, 9, 1, -3},  {6, 11, 1, -4},
        {7, 9, 1, -1}, {7, 11, 1, -1}, {7, 11, 3, -1}, {7, 12, 2, -3}, {7, 13, 1, -5}};
    CHECK(findFamilies(7) == expected);
    CHECK(findFamilies(12).size() == 33);
    CHECK(findFamilies(60).size() == 1651);
    CHECK(exactPeriod(expected[0]) == ExactPeriod{10, 3});
    CHECK(leastEnergy(expected[0]) == ExactEnergy{9, 1});
    CHECK(exactPeriod(expected[1]) == ExactPeriod{7, 2});
    CHECK(longestContact(expected[1]) == ExactPeriod{1, 2});
    CHECK(leastEnergy(expected[1]) == ExactEnergy{4, 1});
    CHECK(leastEnergy({7, 12, 2, -3}) == ExactEnergy{49, 9});
    CHECK(leastEnergy({7, 12, 2, -3}).value() == 49.0 / 9.0);
}

TEST_CASE("families: bounds select exactly, ends included")
{
    const std::vector<Family> all = findFamilies(40);
    for (const double period : {0.5, 1.2, 3.0, 10.0 / 3.0, 3.5, 3.75, 4.0, 9.0}) {
        for (const double energy : {1.5, 4.0, 9.0, 49.0 / 9.0, 50.0, 1600.0}) {
            std::vector<Family> expected;
            for (const Family& family : all) {
                // All products are exact in long double.
                const auto w = static_cast<long double>(family.order);
                const auto win = static_cast<long double>(family.windowSum);
                if (2.0L * static_cast<long double>(family.blocks) <=
                        static_cast<long double>(period) * w &&
                    w * w <= static_cast<long double>(energy) * win * win) {
                    expected.push_back(family);
                }
            }
            INFO(period << " " << energy);
            CHECK(findFamilies(40, {period, energy}) == expected);
        }
    }
    CHECK(findFamilies(4, {3.5, 4.0}) == std::vector<Family>{{4, 7, 1, -2}});
    CHECK(findFamilies(4, {3.5, 3.999}).empty());
    CHECK(findFamilies(4, {3.499, 4.0}).empty());
}

TEST_CASE("families: a continued fraction decides a mode as the walk over its jumps does")
{
    std::size_t count = 0;
    for (std::int64_t order = 1; order <= 151; ++order) {
        for (std::int64_t a = 1; a <= 2 * order; ++a) {
            const auto mode = findMode(a, -order);
            INFO(a << " " << order);
            REQUIRE(mode == walkedMode(a, order));
            count += mode ? 1 : 0;
        }
    }
    CHECK(count == findModes(everyMode(151)).size());
}

TEST_CASE("families: each stands on exactly one mode, with its energy; each rational point is one")
{
    const std::vector<Mode> modes = findModes(everyMode(81));
    const std::vector<Family> families = findFamilies(40);
    for (const Family& family : families) {
        std::vector<Mode> through;
        std::copy_if(modes.begin(), modes.end(), std::back_inserter(through),
                     [&family](const Mode& mode) { return isOn(family, mode); });
        REQUIRE(through == std::vector<Mode>{modeThrough(family)});
        const Mode& mode = through.front();
        CHECK(-family.windowSum == 2 * mode.kappa * family.blocks - mode.mu * family.order);
    }
    std::size_t points = 0;
    for (const Mode& mode : modes) {
        for (const Family& family : familiesOf(mode, 40)) {
            ++points;
            REQUIRE(std::find(families.begin(), families.end(), family) != families.end());
            REQUIRE(modeThrough(family) == mode);
        }
    }
    CHECK(points == families.size());
}

TEST_CASE("families: large numbers stay exact")
{
    // The main mode at T = 4 - 2/w: k = 1, win = 2 - w.
    const std::int64_t w = maxFamilyOrder;
    const auto family = findFamily(w, 2 * w - 1, 1);
    REQUIRE(family);
    CHECK(family->windowSum == 2 - w);
    CHECK(familyName(modeThrough(*family)) == "main");
    // A higher mode far up: t_c = 4 - (2m+1)T, E = 1/((m+1)^2 T - (2m+3))^2.
    const std::int64_t m = 10'000;
    const auto mode = findMode(1, -2 * m - 1);
    REQUIRE(mode);
    CHECK(mode->kappa == (m + 1) * (m + 1));
    CHECK(mode->mu == 2 * m + 3);
}

TEST_CASE("families: on a grid each is one whole simplex, of the energies it says")
{
    for (const std::int64_t cells : {6, 15, 60}) {
        for (const Family& family : findFamilies(2 * cells)) {
            if (2 * cells % family.order != 0) {
                continue;
            }
            const OnePhaseSet whole = onePhaseSet(scheduleOf(family, cells));
            REQUIRE(!whole.reason);
            CHECK(whole.kernelDimension == 2 * cells / family.order);
            const EnergyRange energy = energyRange(whole);
            CHECK(energy.least == Approx(leastEnergy(family).value()));
            CHECK(energy.most == Approx(energy.least * 2.0 * static_cast<double>(cells) /
                                        static_cast<double>(family.order)));
        }
    }
}

TEST_CASE("families: a schedule presses exactly if it lies in a tent")
{
    std::vector<std::int8_t> signs;
    test::forAllSchedules(12, 0, [&signs](const Schedule& schedule) {
        const Verdict verdict = decide(schedule.cells, schedule.phases.front(), signs);
        const auto place = familyOf(schedule);
        const bool presses = !verdict.reason && verdict.contact == Contact::pressing;
        INFO(describe(schedule));
        REQUIRE(place.has_value() == presses);
        if (!presses) {
            return;
        }
        const Family expected{verdict.window, verdict.members, verdict.contactMembers,
                              verdict.windowSum};
        REQUIRE(place->family == expected);
        REQUIRE(place->classes == verdict.classes);
        REQUIRE(place->amplitudes == verdict.kernelDimension);
        REQUIRE(place->offset ==
                schedule.phases.front().contact - verdict.contactMembers * verdict.classes);
        REQUIRE(std::max<std::int64_t>(0, place->offset) == verdict.firstLive);
    });
}

TEST_CASE("families: motions press only between an odd and the next even multiple of omega_1")
{
    std::vector<std::int8_t> signs;
    std::map<std::int64_t, int> bands;
    test::forAllSchedules(20, 0, [&](const Schedule& schedule) {
        const Verdict verdict = decide(schedule.cells, schedule.phases.front(), signs);
        if (!verdict.reason && verdict.contact == Contact::pressing) {
            const std::int64_t n = steps(schedule);
            const std::int64_t band = 4 * schedule.cells / n;  // floor(omega/omega_1)
            REQUIRE(4 * schedule.cells % n != 0);
            REQUIRE(band % 2 == 1);
            ++bands[band];
        }
    });
    CHECK(bands.size() >= 3);
}

TEST_CASE("families: the sets of a tent are faces of one simplex, state by state")
{
    std::mt19937_64 generator(5);
    for (const Family& family : {Family{4, 7, 1, -2}, Family{5, 8, 2, -1}, Family{7, 11, 3, -1}}) {
        const std::int64_t cells = 3 * family.order;  // G = 6
        const Schedule top = scheduleOf(family, cells);
        const OnePhaseSet whole = onePhaseSet(top);
        const std::int64_t n = steps(top);
        for (std::int64_t offset = -5; offset <= 5; ++offset) {
            const std::int64_t contact = top.phases.front().contact + offset;
            const OnePhaseSet face = onePhaseSet(onePhase(cells, contact, n - contact));
            REQUIRE(!face.reason);
            const std::vector<double> z = drawAmplitudes(face.set, generator);
            std::vector<double> padded(6, 0.0);
            std::copy(z.begin(), z.end(), padded.begin() + std::max<std::int64_t>(0, offset));
            CHECK(motionOf(face, z) == motionOf(whole, padded));
        }
    }
}

TEST_CASE("families: all grazing motions of a grid lie in one box, and repeat after 2G steps")
{
    std::mt19937_64 generator(7);
    constexpr std::int64_t cells = 15;
    const OnePhaseSet largest = onePhaseSet(onePhase(cells, 1, 4 * cells - 1));  // G = 2N
    REQUIRE(largest.contact == Contact::grazing);
    std::vector<std::int8_t> signs;
    std::size_t motions = 0;
    for (std::int64_t contact = 1; contact <= 2 * cells; ++contact) {
        for (std::int64_t free = 1; free <= 4 * cells; ++free) {
            const Verdict verdict = decide(cells, {contact, free}, signs);
            if (verdict.reason || verdict.contact == Contact::pressing) {
                continue;
            }
            const OnePhaseSet set = onePhaseSet(onePhase(cells, contact, free));
            const State state = motionOf(set, drawAmplitudes(set.set, generator));
            const std::vector<double> z = amplitudesOf(largest, state);
            REQUIRE(distanceOutside(largest.set, z) < 1e-14);
            REQUIRE((test::stacked(motionOf(largest, z)) - test::stacked(state)).norm() <
                    1e-13 * test::stacked(state).norm());
            // p_{m+G} = -p_m on the window that is the state.
            const auto p = [&state](std::int64_t m) {
                return m < cells ? state.a[cells - 1 - m] : -state.b[m - cells];
            };
            for (std::int64_t m = 0; m + set.classes < 2 * cells; ++m) {
                REQUIRE(p(m + set.classes) == -p(m));
            }
            ++motions;
        }
    }
    CHECK(motions > 50);
}

TEST_CASE("families: a visitor that says no ends the search")
{
    int visits = 0;
    const FamilyVisitor third = [&visits](const Family&) { return ++visits < 3; };
    CHECK_FALSE(forEachFamily(maxFamilyOrder, {}, third));
    CHECK(visits == 3);

    // Where nothing is visited a stop request ends it.
    CHECK_FALSE(forEachFamily(maxFamilyOrder,
                              {.maxEnergyRatio = 1.5, .cancel = [] { return true; }}, third));
    CHECK(visits == 3);
}

TEST_CASE("families: what is out of range is refused by name")
{
    const auto nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH(findFamilies(0), containsText("maxOrder = 0"));
    CHECK_THROWS_WITH(findFamilies(5, {0.0, nan}),
                      containsText("maxPeriod = 0") && containsText("maxEnergyRatio = nan"));
    CHECK_THROWS_WITH(findFamilies(5, {4.0, 0.0}), containsText("maxEnergyRatio = 0"));
    CHECK_THROWS_WITH(findFamily(4, 0, -1),
                      containsText("blocks = 0") && containsText("contactBlocks = -1"));
    CHECK_THROWS_WITH(findMode(0, 1), containsText("a = 0") && containsText("b = 1"));
    CHECK_THROWS_WITH(scheduleOf(Family{4, 7, 1, -2}, 5), containsText("cells = 5"));
    CHECK_THROWS_WITH(modeThrough({4, 7, 3, -2}), containsText("k = 3"));
    CHECK_THROWS_WITH(familiesOf(Mode{}, 5), containsText("a = 0"));
    CHECK_THROWS_WITH(familyOf({4, {{1, 12}, {3, 12}}}), containsText("phases: 2"));
}
