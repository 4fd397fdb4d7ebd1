#include "signorini/modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "catch.hpp"
#include "modes_support.hpp"
#include "signorini/motion.hpp"
#include "signorini/verification.hpp"
#include "support.hpp"

using namespace signorini;
using test::coprimeSteps;
using test::find;
using test::onePhase;
using test::periodAt;
using test::upTo;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Q/P, if jumps meet at the lowest period, which is 2Q/P; Q is odd.
ExactPeriod meeting(const Mode& mode)
{
    const auto [p, q] = mode.lowest;
    return p % 2 == 0 ? ExactPeriod{p / 2, q} : ExactPeriod{p, 2 * q};
}

/// The mode from which this one branches off where jumps meet: a' = a - lQ, |b'| = |b| - 2lP,
/// l = floor(a/Q).
const Mode& stemOf(const std::vector<Mode>& modes, const Mode& mode)
{
    const ExactPeriod end = meeting(mode);
    const std::int64_t l = mode.a / end.numerator;
    return find(modes, mode.a - l * end.numerator, mode.b + 2 * l * end.denominator);
}

/// E/E_1 = 1/(kappa n/N - mu)^2 from integers.
double gridEnergy(const Mode& mode, std::int64_t cells, std::int64_t n)
{
    const double root =
        static_cast<double>(cells) / static_cast<double>(mode.kappa * n - mode.mu * cells);
    return root * root;
}

}  // namespace

TEST_CASE("modes: the closed families have exactly the known intervals and energies")
{
    struct Known {
        std::int64_t a, b;
        ExactPeriod lowest, highest;
        std::int64_t kappa, mu;
        std::string family;
    };
    std::vector<Known> known{{1, -1, {3, 1}, {4, 1}, 1, 3, "main"},
                             {6, -7, {10, 3}, {24, 7}, -2, -7, ""}};
    for (std::int64_t p = 2; p <= 20; ++p) {
        known.push_back({p,
                         1 - 2 * p,
                         {2 * p + 1, p},
                         {4 * p, 2 * p - 1},
                         p,
                         2 * p + 1,
                         "subharmonic " + std::to_string(p)});
    }
    for (std::int64_t m = 1; m <= 19; ++m) {
        known.push_back({1,
                         -2 * m - 1,
                         {2 * m + 3, (m + 1) * (m + 1)},
                         {4, 2 * m + 1},
                         (m + 1) * (m + 1),
                         2 * m + 3,
                         "higher " + std::to_string(m)});
    }
    for (std::int64_t k = 1; k <= 9; ++k) {
        known.push_back({1 + 3 * k,
                         -1 - 4 * k,
                         {3, 1},
                         {4 + 12 * k, 1 + 4 * k},
                         1,
                         3,
                         "twin " + std::to_string(k)});
    }
    const std::vector<Mode> modes = findModes(upTo(41));
    for (const Known& expected : known) {
        INFO(expected.a << " " << expected.b);
        const Mode& mode = find(modes, expected.a, expected.b);
        CHECK(mode.lowest == expected.lowest);
        CHECK(mode.highest == expected.highest);
        CHECK(mode.kappa == expected.kappa);
        CHECK(mode.mu == expected.mu);
        CHECK(familyName(mode) == expected.family);
        CHECK(mode.highestEnd == ModeEnd::contactVanishes);
        CHECK(mode.lowestEnd ==
              (expected.kappa > 0 ? ModeEnd::energyInfinite : ModeEnd::jumpsMeet));
    }
    // No other mode has a name.
    std::set<std::string> names;
    for (const Mode& mode : modes) {
        if (const std::string family = familyName(mode); - mode.b < 41 && !family.empty()) {
            CHECK(names.insert(family).second);
        }
    }
    CHECK(names.size() == known.size() - 1);  // one of them has none
}

TEST_CASE("modes: 29 within the default bounds, 73 of order 25 whatever the energy")
{
    CHECK(findModes().size() == 29);
    const std::vector<Mode> all = findModes(upTo(25));
    CHECK(all.size() == 73);
    // A sample on one grid sees those with enough points on it.
    const auto seen = std::count_if(all.begin(), all.end(), [](const Mode& mode) {
        return coprimeSteps(mode, 1009).size() >= 5;
    });
    CHECK(seen == 38);
}

TEST_CASE("modes: every mode leaves a linear motion at its highest period, with E = b^2")
{
    for (const Mode& mode : findModes(upTo(101))) {
        INFO(mode.a << " " << mode.b);
        REQUIRE(mode.highest == ExactPeriod{4 * mode.a, -mode.b});
        REQUIRE(mode.highest.value() <= 4.0);
        REQUIRE(std::gcd(mode.lowest.numerator, mode.lowest.denominator) == 1);
        const EnergyRange range = energyRange(mode);
        const auto square = static_cast<double>(mode.b * mode.b);
        REQUIRE((range.least == square || range.most == square));
        const bool isInfinite = mode.lowestEnd == ModeEnd::energyInfinite;
        REQUIRE((range.most == infinity) == isInfinite);
        // Near the ends the energy of members is near the limits.
        const double nearLowest = energyRatio(mode, periodAt(mode, 1e-6));
        const double nearHighest = energyRatio(mode, periodAt(mode, 1.0 - 1e-6));
        REQUIRE(nearHighest == Approx(square).epsilon(1e-3));
        if (isInfinite) {
            REQUIRE(nearLowest > 1e6 * square);
        } else {
            REQUIRE(nearLowest == Approx(range.least).epsilon(1e-3));
        }
        REQUIRE(contactTime(mode, periodAt(mode, 1.0 - 1e-6)) < 1e-5);
    }
}

TEST_CASE("modes: where jumps meet a mode branches off just one other, given by a formula")
{
    const std::vector<Mode> all = findModes(upTo(101));
    int branches = 0;
    for (const Mode& mode : all) {
        if (mode.lowestEnd != ModeEnd::jumpsMeet) {
            continue;
        }
        ++branches;
        // Contact time and 1/sqrt(E/E_1) at the end p/q, times q: whole numbers.
        const auto [p, q] = mode.lowest;
        const auto contact = [p = p, q = q](const Mode& m) { return 4 * m.a * q + m.b * p; };
        const auto root = [p = p, q = q](const Mode& m) { return m.kappa * p - m.mu * q; };
        const auto holds = [p = p, q = q](const Mode& m) {
            return m.lowest.numerator * q < p * m.lowest.denominator &&
                   p * m.highest.denominator < m.highest.numerator * q;
        };
        INFO(mode.a << " " << mode.b);
        const auto isMet = [&](const Mode& other) {
            return holds(other) && contact(other) == contact(mode);
        };
        const Mode& stem = stemOf(all, mode);
        REQUIRE(stem.b > mode.b);
        REQUIRE(isMet(stem));
        REQUIRE(root(stem) == root(mode));
        REQUIRE(std::count_if(all.begin(), all.end(), isMet) == 1);
    }
    CHECK(branches == 337);
}

TEST_CASE("modes: at a branch both modes have one sequence of signs")
{
    const std::vector<Mode> all = findModes(upTo(101));
    for (const Mode& mode : all) {
        if (mode.lowestEnd != ModeEnd::jumpsMeet) {
            continue;
        }
        const ModeMotion at(stemOf(all, mode), mode.lowest.value());
        const ModeMotion beside(mode, periodAt(mode, 1e-9));
        INFO(mode.a << " " << mode.b);
        // Signs are constant on the Q units of 2/P; the middles are far from all jumps.
        const std::int64_t units = meeting(mode).numerator;
        const double unit = mode.lowest.value() / static_cast<double>(units);
        for (std::int64_t k = 0; k < units; ++k) {
            const double t = unit * (static_cast<double>(k) + 0.5);
            REQUIRE(beside.incoming(t) == Approx(at.incoming(t)).epsilon(1e-4));
        }
    }
}

TEST_CASE("modes: on grids each is the one motion of its schedules, with its energy")
{
    const std::int64_t cells = GENERATE(1009, 10007);
    for (const Mode& mode : findModes(upTo(25))) {
        const std::vector<std::int64_t> all = coprimeSteps(mode, cells);
        const std::size_t stride = std::max<std::size_t>(1, all.size() / 7);
        for (std::size_t k = 0; k < all.size(); k += stride) {
            const Schedule schedule = scheduleOf(mode, cells, all[k]);
            const OnePhaseSet r = onePhaseSet(schedule);
            INFO(mode.a << " " << mode.b << ": " << describe(schedule));
            REQUIRE_FALSE(r.reason);
            REQUIRE(r.contact == Contact::pressing);
            REQUIRE(r.set.kind == SetKind::point);
            REQUIRE(energyRange(r).least == Approx(gridEnergy(mode, cells, all[k])).epsilon(1e-12));
            REQUIRE(std::sqrt(energyRatio(mode, period(schedule)) / energyRange(r).least) ==
                    Approx(1.0).epsilon(1e-15 * static_cast<double>(std::abs(mode.mu) * cells)));
        }
    }
}

TEST_CASE("modes: at a common divisor a mode is the motion of least energy of a simplex")
{
    const std::vector<Mode> modes = findModes();
    const OnePhaseSet paper = onePhaseSet(scheduleOf(find(modes, 1, -1), 300, 1050));
    CHECK(paper.schedule == onePhase(300, 150, 900));
    CHECK(paper.set.dimension() == 149);
    for (const Mode& mode : modes) {
        for (const std::int64_t cells : {720, 5040}) {
            std::int64_t n = mode.lowest.numerator * cells / mode.lowest.denominator + 1;
            for (; n * mode.highest.denominator < mode.highest.numerator * cells; ++n) {
                const OnePhaseSet r = onePhaseSet(scheduleOf(mode, cells, n));
                INFO(mode.a << " " << mode.b << ": " << n << " steps on " << cells);
                REQUIRE_FALSE(r.reason);
                REQUIRE(r.contact == Contact::pressing);
                REQUIRE(r.kernelDimension == std::gcd(2 * cells, n));
                REQUIRE(energyRange(r).least == Approx(gridEnergy(mode, cells, n)).epsilon(1e-12));
            }
        }
    }
}

TEST_CASE("modes: just outside the interval the same contact time has no motion")
{
    const std::int64_t cells = 10007;
    int below = 0;
    int above = 0;
    for (const Mode& mode : findModes(upTo(25))) {
        const std::int64_t first = mode.lowest.numerator * cells / mode.lowest.denominator;
        const std::int64_t last = (mode.highest.numerator * cells + mode.highest.denominator - 1) /
                                  mode.highest.denominator;
        for (std::int64_t k = 0; k < 5; ++k) {
            for (const std::int64_t n : {first - k, last + k}) {
                const std::int64_t contact = 4 * mode.a * cells + mode.b * n;
                INFO(mode.a << " " << mode.b << ": " << contact << " of " << n);
                REQUIRE_THROWS_AS(scheduleOf(mode, cells, n), std::invalid_argument);
                if (n >= last) {
                    REQUIRE(contact <= 0);
                    ++above;
                } else if (std::gcd(2 * cells, n) == 1) {
                    const OnePhaseSet r = onePhaseSet(onePhase(cells, contact, n - contact));
                    REQUIRE((r.reason || r.contact == Contact::grazing));
                    ++below;
                }
            }
        }
    }
    CHECK(below > 150);
    CHECK(above == 5 * 73);
}

TEST_CASE("modes: complete: the pressing schedules with gcd(2N, n) = 1 are those of the modes")
{
    // Prime and composite: powers, products of small primes.
    const std::int64_t cells = GENERATE(31, 101, 211, 12, 30, 64, 81, 105);
    std::set<std::pair<std::int64_t, std::int64_t>> found;
    OnePhaseSet r;
    for (std::int64_t n = 2; n <= 8 * cells; ++n) {
        if (std::gcd(2 * cells, n) != 1) {
            continue;
        }
        for (std::int64_t contact = 1; contact < n; ++contact) {
            onePhaseSet(onePhase(cells, contact, n - contact), r);
            if (!r.reason && r.contact == Contact::pressing) {
                found.emplace(contact, n);
            }
        }
    }
    // 0 < n_c = 4aN - |b| n with 2a < n allows no |b| above 2N.
    std::set<std::pair<std::int64_t, std::int64_t>> predicted;
    std::size_t members = 0;
    for (const Mode& mode : findModes(upTo(2 * cells - 1))) {
        for (const std::int64_t n : coprimeSteps(mode, cells)) {
            if (2 * mode.a < n) {
                predicted.emplace(scheduleOf(mode, cells, n).phases.front().contact, n);
                ++members;
            }
        }
    }
    INFO(cells << " cells: " << found.size() << " schedules");
    CHECK(found == predicted);
    CHECK(members == predicted.size());  // each belongs to one mode
    CHECK(found.size() > static_cast<std::size_t>(cells / 2));
}

TEST_CASE("modes: the bounds select modes and leave their intervals alone")
{
    const std::vector<Mode> all = findModes(upTo(25));
    const auto listed = [](const ModeBounds& bounds, std::int64_t a, std::int64_t b) {
        const std::vector<Mode> modes = findModes(bounds);
        return std::any_of(modes.begin(), modes.end(),
                           [a, b](const Mode& mode) { return mode.a == a && mode.b == b; });
    };
    ModeBounds bounds;
    for (const auto& [energy, order, period, count] :
         {std::tuple{1.0, 25, 8.0, 0}, std::tuple{1.01, 25, 8.0, 1}, std::tuple{4.0, 25, 3.4, 0},
          std::tuple{4.0, 25, 3.5, 1}, std::tuple{9.1, 3, 8.0, 3}, std::tuple{9.1, 3, 3.0, 2},
          std::tuple{9.1, 3, 2.0, 1}, std::tuple{1e300, 1, 8.0, 1}, std::tuple{1e300, 3, 1.25, 0},
          std::tuple{49.0, 7, 8.0, 7}, std::tuple{49.1, 7, 8.0, 10}}) {
        bounds.maxEnergyRatio = energy;
        bounds.maxOrder = order;
        bounds.maxPeriod = period;
        INFO(energy << " " << order << " " << period);
        const std::vector<Mode> modes = findModes(bounds);
        CHECK(modes.size() == static_cast<std::size_t>(count));
        for (const Mode& mode : modes) {
            CHECK(mode == find(all, mode.a, mode.b));
        }
    }
    // 24 - 7T has its energies in ]9, 49[, the least at its shortest period 10/3.
    bounds = {};
    bounds.maxEnergyRatio = 9.0;
    CHECK_FALSE(listed(bounds, 6, -7));
    bounds.maxEnergyRatio = std::nextafter(9.0, 10.0);
    CHECK(listed(bounds, 6, -7));
    bounds.maxPeriod = 10.0 / 3.0;  // rounded up
    CHECK(listed(bounds, 6, -7));
    bounds.maxPeriod = std::nextafter(bounds.maxPeriod, 0.0);
    CHECK_FALSE(listed(bounds, 6, -7));
    bounds.cancel = [] { return true; };
    CHECK(findModes(bounds).empty());
}

TEST_CASE("modes: wrong bounds, periods and grids are refused by name")
{
    const auto message = [](const ModeBounds& bounds) {
        try {
            (void)findModes(bounds);
        } catch (const std::invalid_argument& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK_THAT(message({0, 8.0, 50.0, {}}), containsText("maxOrder = 0"));
    CHECK_THAT(message({10002, 8.0, 50.0, {}}), containsText("1..10001"));
    CHECK_THAT(message({25, -1.0, 50.0, {}}), containsText("maxPeriod = -1"));
    CHECK_THAT(message({25, 8.0, infinity, {}}), containsText("maxEnergyRatio = inf"));
    CHECK_THAT(message({-1, 0.0, std::nan(""), {}}), containsText("maxOrder") &&
                                                         containsText("maxPeriod") &&
                                                         containsText("maxEnergyRatio"));
    const Mode mode = findModes().front();
    for (const double period : {3.0, 4.0, 2.0, 5.0, infinity, std::nan("")}) {
        CHECK_THROWS_AS(ModeMotion(mode, period), std::invalid_argument);
        CHECK_THROWS_AS(energyRatio(mode, period), std::invalid_argument);
        CHECK_THROWS_AS(contactTime(mode, period), std::invalid_argument);
    }
    CHECK_THROWS_WITH(energyRatio(mode, 4.5), containsText("4.5") && containsText("]3/1, 4/1["));
    CHECK_THROWS_WITH(scheduleOf(mode, 0, 3), containsText("cells = 0"));
    CHECK_THROWS_AS(scheduleOf(mode, 10, 30), std::invalid_argument);
    CHECK_THROWS_AS(scheduleOf(mode, 10, 40), std::invalid_argument);
    CHECK_THROWS_AS(scheduleOf(mode, 10, std::numeric_limits<std::int64_t>::max()),
                    std::invalid_argument);
    CHECK(scheduleOf(mode, 10, 31) == onePhase(10, 9, 22));
    // The coarsest and the finest grid; on one cell no mode has a period.
    CHECK_THROWS_WITH(scheduleOf(mode, 1, 3), containsText("steps = 3"));
    CHECK(scheduleOf(mode, maxCells, maxCells / 2 * 7) ==
          onePhase(maxCells, maxCells / 2, 3 * maxCells));
    CHECK_FALSE(findMode(1, -maxFamilyOrder));  // even
    CHECK_THROWS_WITH(findMode(1, -maxFamilyOrder - 1), containsText("b = "));
}

TEST_CASE("modes: a longest period or a highest energy at an end of a mode does not list it")
{
    // Energies of 4 - T fall to 1 at T = 4.
    CHECK(findModes({.maxOrder = 25, .maxPeriod = 4.0, .maxEnergyRatio = 1.0}).empty());
    CHECK(findModes({.maxOrder = 25, .maxPeriod = 4.0, .maxEnergyRatio = 1.0 + 1e-15}).size() == 1);
    std::set<ModeEnd> ends;
    for (const Mode& mode : findModes(upTo(61))) {
        const std::int64_t q = mode.lowest.denominator;
        if ((q & (q - 1)) != 0) {
            continue;  // no double
        }
        ModeBounds bounds = upTo(-mode.b);
        bounds.maxPeriod = mode.lowest.value();
        INFO(mode.a << " " << mode.b << " above " << bounds.maxPeriod);
        const std::vector<Mode> at = findModes(bounds);
        REQUIRE(std::find(at.begin(), at.end(), mode) == at.end());
        bounds.maxPeriod = std::nextafter(bounds.maxPeriod, 8.0);
        const std::vector<Mode> above = findModes(bounds);
        // Where the energy becomes infinite it is beyond 1e300 nowhere that close.
        REQUIRE(std::find(above.begin(), above.end(), mode) != above.end());
        ends.insert(mode.lowestEnd);
    }
    CHECK(ends.size() == 2);
}
