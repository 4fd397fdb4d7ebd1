#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <random>

#include "catch.hpp"
#include "modes_support.hpp"
#include "signorini/lumped_set.hpp"
#include "signorini/modes.hpp"

using namespace signorini;
using test::anyEnergy;
using test::requireTheorems;
using test::sumOfK;

namespace {

/// -win of a pressing motion on a grid whose steps form one class, else 0: the signs go once
/// around the class, contact has to push, and flights are summed step by step.
std::int64_t pressingSum(const Schedule& schedule)
{
    const std::int64_t n = steps(schedule);
    std::vector<char> isContact;
    for (const Phase& phase : schedule.phases) {
        isContact.insert(isContact.end(), static_cast<std::size_t>(phase.contact), 1);
        isContact.insert(isContact.end(), static_cast<std::size_t>(phase.free), 0);
    }
    std::vector<int> sign(isContact.size());
    std::size_t step = 0;
    int value = 1;
    for (std::int64_t k = 0; k < n; ++k) {
        if (isContact[step] != 0 && value < 0) {
            return 0;
        }
        sign[step] = value;
        value = isContact[step] != 0 ? value : -value;
        step = static_cast<std::size_t>((static_cast<std::int64_t>(step) + 2 * schedule.cells) % n);
    }
    if (value < 0) {
        return 0;
    }
    std::size_t at = 0;
    for (const Phase& phase : schedule.phases) {
        at += static_cast<std::size_t>(phase.contact);
        std::int64_t prefix = 0;
        for (std::int64_t k = 0; k < phase.free; ++k, ++at) {
            prefix += sign[at];
            if (prefix > 0) {
                return 0;
            }
        }
        if (prefix != 0) {
            return 0;
        }
    }
    std::int64_t sum = 0;
    for (std::int64_t k = 0; k < 2 * schedule.cells; ++k) {
        sum -= sign[static_cast<std::size_t>(k % n)];
    }
    return std::max<std::int64_t>(sum, 0);
}

/// The rotation of the phases that comes first.
std::vector<Phase> leastRotation(std::vector<Phase> phases)
{
    std::vector<Phase> least = phases;
    for (std::size_t k = 0; k < phases.size(); ++k) {
        std::rotate(phases.begin(), phases.begin() + 1, phases.end());
        least = std::min(least, phases);
    }
    return least;
}

bool repeatsItself(const std::vector<Phase>& phases)
{
    std::vector<Phase> turned = phases;
    for (std::size_t k = 1; k < phases.size(); ++k) {
        std::rotate(turned.begin(), turned.begin() + 1, turned.end());
        if (turned == phases) {
            return true;
        }
    }
    return false;
}

/// Every schedule of K phases with gcd(2N, n) = 1 within the bounds that presses, each orbit once,
/// and its -win.
std::map<std::vector<Phase>, std::int64_t> pressing(std::size_t phases, std::int64_t cells,
                                                    std::int64_t contact, std::int64_t free)
{
    std::map<std::vector<Phase>, std::int64_t> found;
    Schedule schedule{cells, {}};
    const auto extend = [&](const auto& self) -> void {
        if (schedule.phases.size() == phases) {
            if (std::gcd(2 * cells, steps(schedule)) == 1 &&
                leastRotation(schedule.phases) == schedule.phases &&
                !repeatsItself(schedule.phases)) {
                if (const std::int64_t sum = pressingSum(schedule)) {
                    found.emplace(schedule.phases, sum);
                }
            }
            return;
        }
        const std::int64_t first = schedule.phases.empty() ? 1 : schedule.phases[0].contact;
        for (std::int64_t c = first; c <= contact; ++c) {
            for (std::int64_t f = 1; f <= free; ++f) {
                schedule.phases.push_back({c, f});
                self(self);
                schedule.phases.pop_back();
            }
        }
    };
    extend(extend);
    return found;
}

bool isWithin(const std::vector<Phase>& phases, std::int64_t contact, std::int64_t free)
{
    return std::all_of(phases.begin(), phases.end(), [&](const Phase& phase) {
        return phase.contact <= contact && phase.free <= free;
    });
}

/// Both directions between a grid and the polytopes, the enumerated ones up to an order.
void compareWithGrid(std::size_t phases, std::int64_t cells, std::int64_t contact,
                     std::int64_t free, std::int64_t order, std::size_t expected)
{
    const auto found = pressing(phases, cells, contact, free);
    INFO(phases << " contacts on " << cells << " cells: " << found.size());
    if (expected > 0) {
        CHECK(found.size() == expected);
    }
    const auto all = findPolytopes(static_cast<std::int64_t>(phases), anyEnergy(order));
    std::map<std::int64_t, std::vector<ModePolytope>> at;  // by steps
    std::size_t points = 0;
    for (const auto& [list, sum] : found) {
        const Schedule schedule{cells, list};
        INFO(describe(schedule));
        const auto polytope = polytopeOf(schedule);
        REQUIRE(polytope);
        requireTheorems(*polytope);
        // Its energy, from -win alone.
        const double root = static_cast<double>(sum) / static_cast<double>(2 * cells);
        REQUIRE(energyRatio(*polytope, period(schedule)) * root * root ==
                Approx(1.0).epsilon(1e-9));
        if (polytope->order <= order) {
            REQUIRE(std::count(all.begin(), all.end(), *polytope) == 1);
        }
        auto& list_ = at[steps(schedule)];
        if (std::find(list_.begin(), list_.end(), *polytope) == list_.end()) {
            list_.push_back(*polytope);
        }
    }
    // The grid points of those polytopes are the schedules, each once.
    for (const auto& [n, polytopes] : at) {
        for (const ModePolytope& polytope : polytopes) {
            for (const Schedule& schedule : schedulesOf(polytope, cells, n)) {
                const auto phasesOf = leastRotation(schedule.phases);
                if (isWithin(phasesOf, contact, free) && !repeatsItself(phasesOf)) {
                    INFO(describe(schedule));
                    REQUIRE(found.count(phasesOf) == 1);
                    ++points;
                }
            }
        }
    }
    CHECK(points == found.size());
    // A polytope with a grid point inside is met.
    for (const ModePolytope& polytope : all) {
        for (std::int64_t n = polytope.lowest.numerator * cells / polytope.lowest.denominator + 1;
             n * polytope.highest.denominator < polytope.highest.numerator * cells; ++n) {
            if (std::gcd(2 * cells, n) != 1) {
                continue;
            }
            for (const Schedule& schedule : schedulesOf(polytope, cells, n)) {
                const auto phasesOf = leastRotation(schedule.phases);
                if (isWithin(phasesOf, contact, free) && !repeatsItself(phasesOf) &&
                    sumOfK(polytope) < n) {
                    INFO(describe(schedule));
                    REQUIRE(found.count(phasesOf) == 1);
                    REQUIRE(std::find(at[n].begin(), at[n].end(), polytope) != at[n].end());
                }
            }
        }
    }
}

}  // namespace

TEST_CASE("polytopes: two contacts on small grids, each schedule in one, each grid point a motion")
{
    compareWithGrid(2, 13, 26, 52, 9, 6);
    compareWithGrid(2, 17, 34, 68, 9, 53);
    compareWithGrid(2, 19, 20, 60, 9, 0);
}

TEST_CASE(
    "polytopes: three contacts on small grids, each schedule in one, each grid point a motion")
{
    compareWithGrid(3, 7, 8, 28, 5, 0);
    compareWithGrid(3, 11, 3, 44, 3, 0);
}

TEST_CASE("polytopes: the same on all grids of docs/theory.md", "[.]")
{
    for (const std::int64_t cells : {13, 17, 19, 23, 29}) {
        compareWithGrid(2, cells, 2 * cells, 4 * cells, 25, 0);
    }
    for (const std::int64_t cells : {15, 21, 25, 31, 37}) {  // grids that suggested nothing
        compareWithGrid(2, cells, cells, 4 * cells, 15, 0);
    }
    compareWithGrid(3, 7, 14, 28, 7, 0);
    compareWithGrid(3, 11, 8, 44, 7, 34);
    compareWithGrid(3, 13, 5, 52, 5, 0);
    compareWithGrid(4, 5, 5, 20, 5, 0);
    compareWithGrid(4, 7, 3, 28, 5, 0);
}

TEST_CASE("polytopes: on 23 cells contact is shared freely, at one energy")
{
    const auto found = pressing(2, 23, 30, 95);
    CHECK(found.size() == 169);
    // T = 59/23: flights 2T - 4 twice, contacts tau and 8 - 3T - tau.
    for (const std::int64_t contact : {1, 2, 3}) {
        const Schedule schedule{23, {{contact, 26}, {7 - contact, 26}}};
        REQUIRE(found.count(schedule.phases) == 1);
        CHECK(lumpedSet(schedule).leastEnergy == Approx(58.777778).epsilon(1e-7));
        const ModePolytope polytope = polytopeOf(schedule).value();
        CHECK(polytope.chains == std::vector<ModeChain>{{1, 2, 1}, {0, 2, 2}});
        CHECK(schedulesOf(polytope, 23, 59).size() == 3);
        CHECK(polytope.lowest == ExactPeriod{5, 2});
        CHECK(polytope.highest == ExactPeriod{8, 3});
        CHECK(energyRatio(polytope, 59.0 / 23.0) == Approx(529.0 / 9.0).epsilon(1e-12));
    }
    // All splits: with the flights of one schedule every other split of its contact.
    for (const auto& [phases, sum] : found) {
        const std::int64_t contact = phases[0].contact + phases[1].contact;
        for (std::int64_t c = std::max<std::int64_t>(1, contact - 30);
             c < std::min<std::int64_t>(31, contact); ++c) {
            const std::vector<Phase> split{{c, phases[0].free}, {contact - c, phases[1].free}};
            const auto other = found.find(leastRotation(split));
            INFO(describe({23, split}));
            REQUIRE((other != found.end() || repeatsItself(split)));
            REQUIRE((repeatsItself(split) || other->second == sum));
        }
    }
}

TEST_CASE("polytopes: on 11 cells three equal contacts are isolated motions, many of one energy")
{
    const auto found = pressing(3, 11, 3, 44);
    for (const auto& [phases, sum] : found) {
        const Schedule schedule{11, phases};
        if (steps(schedule) != 111 || phases[0].contact != 3) {
            continue;
        }
        const ModePolytope polytope = polytopeOf(schedule).value();
        INFO(describe(schedule));
        CHECK(phases[1].contact == 3);
        CHECK(phases[2].contact == 3);
        CHECK(sum == 4);
        CHECK(polytope.dimension == 0);
        CHECK(schedulesOf(polytope, 11, 111).size() == 1);
    }
    CHECK(found.count({{3, 26}, {3, 38}, {3, 38}}) == 1);
    CHECK(found.count({{3, 28}, {3, 36}, {3, 38}}) == 1);
    CHECK(found.count({{3, 30}, {3, 34}, {3, 38}}) == 1);
    CHECK(found.count({{3, 30}, {3, 36}, {3, 36}}) == 1);
}

TEST_CASE("polytopes: a schedule is in one exactly if it presses and repeats none")
{
    std::mt19937_64 generator(21);
    int inside = 0;
    int outside = 0;
    const auto compare = [&](const Schedule& schedule) {
        if (std::gcd(2 * schedule.cells, steps(schedule)) != 1) {
            return;
        }
        INFO(describe(schedule));
        const bool isMotion = pressingSum(schedule) > 0 && !repeatsItself(schedule.phases);
        REQUIRE(polytopeOf(schedule).has_value() == isMotion);
        ++(isMotion ? inside : outside);
    };
    for (std::int64_t contact = 1; contact <= 10; ++contact) {
        for (std::int64_t free = 1; free <= 20; ++free) {
            compare({5, {{contact, free}}});
            for (std::int64_t c = 1; c <= 3; ++c) {
                for (std::int64_t f = 1; f <= 12; ++f) {
                    compare({3, {{contact, free}, {c, f}}});
                }
            }
        }
    }
    // Those that press, and all that differ from them by a step.
    for (const auto& [phases, sum] : pressing(2, 13, 26, 52)) {
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::int64_t d = -2; d <= 2; ++d) {
                for (std::int64_t e = -2; e <= 2; ++e) {
                    Schedule schedule{13, phases};
                    schedule.phases[i].contact += d;
                    schedule.phases[1 - i].free += e;
                    if (schedule.phases[i].contact > 0 && schedule.phases[1 - i].free > 0) {
                        compare(schedule);
                    }
                }
            }
        }
    }
    const auto length = [&generator](std::int64_t most) {
        return std::uniform_int_distribution<std::int64_t>(1, most)(generator);
    };
    for (int k = 0; k < 3000; ++k) {
        Schedule schedule{length(9), {}};
        for (std::int64_t l = 1 + length(3); l > 0; --l) {
            schedule.phases.push_back({length(3), length(4 * schedule.cells)});
        }
        compare(schedule);
    }
    CHECK(inside > 10);
    CHECK(outside > 1000);
}
