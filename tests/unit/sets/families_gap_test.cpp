// Families and modes with a gap of any sign.

#include <algorithm>
#include <numeric>
#include <vector>

#include "catch.hpp"
#include "families_truth.hpp"
#include "signorini/modes.hpp"
#include "signorini/one_phase_set.hpp"
#include "support.hpp"

using namespace signorini;
using namespace signorini::test;

TEST_CASE("families: with a gap of any sign the triples of the definition, and those alone")
{
    const int gapSign = GENERATE(1, 0, -1);
    constexpr std::int64_t maxOrder = 25;
    std::vector<Family> expected;
    for (std::int64_t w = 1; w <= maxOrder; ++w) {
        for (std::int64_t nu = 1; nu <= 2 * w + 3; ++nu) {
            std::vector<Family> here;
            for (std::int64_t k = 1; k <= nu; ++k) {
                // All blocks in contact repeat (w, 1, 1).
                const bool isOne = std::gcd(w, nu) == 1 && (k < nu || nu == 1);
                const auto family = isOne ? byDefinition(w, nu, k, gapSign) : std::nullopt;
                INFO(w << " " << nu << " " << k);
                REQUIRE(findFamily(w, nu, k, gapSign) == family);
                if (family) {
                    here.push_back(*family);
                }
            }
            if (std::gcd(w, nu) == 1) {
                REQUIRE(familiesAt(w, nu, gapSign) == here);
            }
            expected.insert(expected.end(), here.begin(), here.end());
        }
    }
    CHECK(findFamilies(maxOrder, {.gapSign = gapSign}) == expected);
    CHECK(expected.size() > 15);
    for (const double period : {0.125, 0.5, 1.0, 1.2, 2.0, 3.5, 4.0}) {
        for (const double energy : {0.5, 1.0, 1.5, 4.0, 9.0, 1e6}) {
            std::vector<Family> within;
            std::copy_if(
                expected.begin(), expected.end(), std::back_inserter(within), [&](const Family& f) {
                    const auto w = static_cast<long double>(f.order);
                    const auto win = static_cast<long double>(f.windowSum);
                    // All products are exact.
                    return 2.0L * static_cast<long double>(f.blocks) <=
                               static_cast<long double>(period) * w &&
                           (gapSign == 0 || w * w <= static_cast<long double>(energy) * win * win);
                });
            INFO(period << " " << energy);
            CHECK(findFamilies(maxOrder, {period, energy, gapSign}) == within);
        }
    }
}

TEST_CASE("families: those whose tip never leaves the wall are on every grid but the coarsest")
{
    for (const std::int64_t w : {1, 2, 3, 10}) {
        const Family held{w, 1, 1, w};
        CHECK(findFamily(w, 1, 1, -1) == held);
        CHECK_FALSE(findFamily(w, 1, 1));
        CHECK(lowestTip(held, -1) == Fraction{-1, 1});
        CHECK_THROWS_AS(modeThrough(held), std::invalid_argument);
        for (const std::int64_t cells : {5, 15, 30}) {
            if (2 * cells % w != 0 || 2 * cells == w) {
                CHECK_THROWS_WITH(scheduleOf(held, cells), containsText("cells = "));
                continue;
            }
            const std::int64_t classes = 2 * cells / w;
            CHECK(scheduleOf(held, cells) == Schedule{cells, {{classes - 1, 1}}, {.right = -1}});
        }
    }
    int visits = 0;
    CHECK_FALSE(forEachFamily(5, {.gapSign = -1}, [&visits](const Family& family) {
        ++visits;
        CHECK(family == Family{1, 1, 1, 1});
        return false;
    }));
    CHECK(visits == 1);
}

TEST_CASE("families: the stop of a schedule is on the side of the gap")
{
    for (const int gapSign : {1, 0, -1}) {
        const auto visitor = [&](const Family& family) {
            CHECK(scheduleOf(family, family.order).stops.right == gapSign);
            return true;
        };
        CHECK(forEachFamily(12, {.gapSign = gapSign}, visitor));
    }
}

TEST_CASE("families: without a gap no place of the tip is the lowest")
{
    CHECK_THROWS_AS(lowestTip({3, 5, 1, -1}, 0), std::invalid_argument);
    const std::vector<Family> without = findFamilies(12, {.gapSign = 0});
    REQUIRE(!without.empty());
    CHECK(without.front().windowSum == 0);
    CHECK_THROWS_AS(lowestTip(without.front(), 1), std::invalid_argument);
}

TEST_CASE("families: where the gap is negative modes end where jumps meet and at infinite energy")
{
    int found = 0;
    for (std::int64_t order = 1; order <= 61; ++order) {
        for (std::int64_t a = 1; a <= 2 * order; ++a) {
            const auto walked = walkedMode(a, order);
            const auto mode = findMode(a, -order, -1);
            INFO(a << " " << order);
            REQUIRE((walked || !mode));
            if (!walked) {
                continue;
            }
            std::int64_t q = 1;
            while ((1 + q * order) % (2 * a) != 0) {
                ++q;
            }
            const std::int64_t p = (1 + q * order) / (2 * a);
            // mu - kappa T > 0 just above T = 2q/p, where jumps meet?
            REQUIRE(mode.has_value() == (walked->mu * p - walked->kappa * 2 * q > 0));
            if (mode) {
                ++found;
                REQUIRE(mode->lowest == exactPeriod(2 * q, p));
                REQUIRE(mode->highest == exactPeriod(walked->mu, walked->kappa));
                REQUIRE(mode->lowest.value() < mode->highest.value());
            }
        }
    }
    CHECK(found > 50);
}
