// Motions of one energy with several phases, against random motions and sums.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "catch.hpp"
#include "energy_section.hpp"
#include "sanitized.hpp"
#include "signorini/continuum.hpp"
#include "signorini/lumped_set.hpp"
#include "support.hpp"

using namespace signorini;
using signorini::test::onePhase;

namespace {

State between(const State& from, const State& to, double part)
{
    return {from.a + part * (to.a - from.a), from.b + part * (to.b - from.b)};
}

/// The motion of this energy on the way from the least one to one above.
State lowered(const State& least, const State& above, double energy)
{
    double inside = 0.0;
    double outside = 1.0;
    for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (inside + outside);
        (energyRatio(between(least, above, middle)) < energy ? inside : outside) = middle;
    }
    return between(least, above, outside);
}

/// Motions of at least some energy, and the group of each.
struct Above {
    std::vector<State> motions;
    std::vector<std::size_t> groups;
    int count = 0;  ///< of groups
};

/// Motions of random directions from the one of least energy as far out as the set goes, those of
/// at least this energy, and the groups that remain when all are joined whose segment keeps it.
Above groupsAbove(const Schedule& schedule, double energy, int draws)
{
    const LumpedSet set = lumpedSet(schedule);
    const LumpedShape shape = shapeOf(set);
    const State least = equalMotion(set, set.leastSums);
    std::mt19937_64 generator(5);
    std::normal_distribution<double> normal;
    std::vector<State> above;
    for (int k = 0; k < draws; ++k) {
        // Random mixtures of draws reach every direction; draws alone keep to one side.
        State beside = least;
        for (int part = 0; part < 4; ++part) {
            const State drawn = drawMotion(set, shape, generator);
            const double weight = normal(generator);
            beside.a += weight * (drawn.a - least.a);
            beside.b += weight * (drawn.b - least.b);
        }
        double inside = 0.0;
        double outside = 64.0;
        while (outside - inside > 1e-6) {
            const double middle = 0.5 * (inside + outside);
            const double worst = verify(between(least, beside, middle), schedule).residuals.worst();
            (worst < 1e-9 ? inside : outside) = middle;
        }
        const State end = between(least, beside, inside);
        if (energyRatio(end) >= energy) {
            above.push_back(end);
        }
    }
    std::vector<std::size_t> groups(above.size());
    std::iota(groups.begin(), groups.end(), std::size_t{0});
    int count = static_cast<int>(above.size());
    for (std::size_t i = 0; i < above.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            double lowest = energy;
            for (int part = 1; part < 16 && groups[i] != groups[k]; ++part) {
                lowest = std::min(lowest, energyRatio(between(above[i], above[k], part / 16.0)));
            }
            if (groups[i] != groups[k] && lowest >= energy) {
                std::replace(groups.begin(), groups.end(), std::size_t{groups[i]},
                             std::size_t{groups[k]});
                --count;
            }
        }
    }
    return {above, groups, count};
}

int countedAbove(const Schedule& schedule, double energy, int draws)
{
    return groupsAbove(schedule, energy, draws).count;
}

double largestAmplitude(const LumpedSet& set, const State& state)
{
    double largest = 0.0;
    for (const double z : amplitudesOf(set.classes, state)) {
        largest = std::max(largest, std::abs(z));
    }
    return largest;
}

}  // namespace

TEST_CASE("energy section: several phases have as many components as random motions show")
{
    // Sets of up to three dimensions; in all but the first two the sums vary as well.
    const std::vector<Schedule> schedules{
        {4, {{1, 12}, {3, 12}}},         {4, {{2, 11}, {2, 11}, {4, 10}}},
        {8, {{2, 26}, {2, 1}, {1, 24}}}, {8, {{1, 2}, {1, 24}, {1, 2}, {1, 24}}},
        {8, {{2, 24}, {2, 3}, {2, 23}}}, {8, {{1, 24}, {2, 1}}},
        {8, {{1, 2}, {1, 24}, {2, 26}}}, {6, {{2, 16}, {2, 17}, {2, 1}, {2, 18}}},
        {6, {{1, 16}, {1, 2}}},          {5, {{1, 15}, {1, 16}, {1, 1}}}};
    int several = 0;
    int varying = 0;
    for (const Schedule& schedule : schedules) {
        const LumpedShape shape = shapeOf(lumpedSet(schedule));
        varying += shape.spanning.size() > 1 ? 1 : 0;
        for (const double part : {0.1, 0.35, 0.6}) {
            if (test::drawsFew() && part != 0.6) {
                continue;
            }
            const double energy = std::lerp(shape.energy.least, shape.energy.most, part);
            const auto section = sectionOfPhases(schedule, energy);
            REQUIRE(section);
            INFO(describe(schedule) << ", E = " << energy);
            const LumpedSet set = lumpedSet(schedule);
            const State least = equalMotion(set, set.leastSums);
            const Above above = groupsAbove(schedule, energy, 900);
            CHECK(section->facts().components == above.count);
            several += section->facts().components > 1 ? 1 : 0;
            // Those that the segments join are joined, the others are not.
            std::vector<std::size_t> some;
            for (std::size_t i = 0; i < above.motions.size(); ++i) {
                const bool isFirst =
                    std::find(
                        above.groups.begin(), above.groups.begin() + static_cast<std::ptrdiff_t>(i),
                        above.groups[i]) == above.groups.begin() + static_cast<std::ptrdiff_t>(i);
                if (i < 12 || isFirst) {
                    some.push_back(i);
                }
            }
            int wrong = 0;
            for (const std::size_t i : some) {
                const State from = lowered(least, above.motions[i], energy);
                CHECK(largestAmplitude(set, from) <= section->facts().largestWave * (1.0 + 1e-9));
                for (const std::size_t k : some) {
                    const State to = lowered(least, above.motions[k], energy);
                    wrong +=
                        section->joins(from, to) == (above.groups[i] == above.groups[k]) ? 0 : 1;
                }
            }
            CHECK(wrong == 0);
            // Spikes of this energy, as many as asked for.
            CHECK(section->isolated(1).size() == 1);
            CHECK(section->facts().dimension == shape.dimension - 1);
            for (const State& spike : section->isolated(100)) {
                CHECK(energyRatio(spike) == Approx(energy).epsilon(1e-12));
                CHECK(verify(spike, schedule).residuals.worst() < 1e-12);
            }
            if (shape.spanning.size() > 1) {
                CHECK_FALSE(section->facts().simplex);  // no sum is the same for all motions
            }
        }
    }
    CHECK(several >= test::drawn(15));
    CHECK(varying >= 8);
}

namespace {

/// The energy of the least sums with each type that spreads over so many classes in one of them.
double mostOfShared(const LumpedSet& set, std::int64_t count)
{
    std::vector<double> z(static_cast<std::size_t>(set.classes.classes), 0.0);
    for (std::size_t t = 0; t < set.live.size(); ++t) {
        const ClassType& type = set.classes.types[set.live[t]];
        const std::int64_t used = type.count == count ? 1 : type.count;
        for (std::int64_t j = 0; j < used; ++j) {
            z[static_cast<std::size_t>(type.first + j)] =
                set.leastSums[t] / static_cast<double>(used);
        }
    }
    return energyRatio(motionOf(set.classes, z));
}

/// Shares >= 0 of sum 1 with this sum of squares: x on the first, the rest evenly, or on two.
std::vector<double> sharesOfRatio(const SphereSection& simplex)
{
    const auto count = static_cast<double>(simplex.count);
    const double top =
        (1.0 + std::sqrt(std::max(0.0, (count - 1.0) * (count * simplex.ratio - 1.0)))) / count;
    std::vector<double> shares(static_cast<std::size_t>(simplex.count),
                               (1.0 - top) / (count - 1.0));
    shares[0] = top;
    return shares;
}

}  // namespace

TEST_CASE("energy section: shares of several phases are motions of the energy, and come back")
{
    // One type alone spreads: first, last, beside a type of the same width whose sum is 0; then
    // types of equal width, beside narrower ones and such of sum 0.
    struct Case {
        Schedule schedule;
        std::int64_t count;
        bool isShared;
    };
    const std::vector<Case> cases{{{4, {{1, 12}, {3, 12}}}, 3, false},
                                  {{4, {{3, 12}, {1, 12}}}, 3, false},
                                  {{10, {{4, 31}, {4, 33}}}, 3, false},
                                  {{10, {{4, 32}, {4, 32}}}, 4, false},
                                  {{8, {{2, 26}, {2, 26}, {4, 24}}}, 2, false},
                                  {{9, {{2, 30}, {1, 30}}}, 2, false},
                                  {{9, {{1, 30}, {3, 30}, {1, 25}}}, 3, false},
                                  {{9, {{1, 25}, {3, 28}, {3, 30}}}, 3, true},
                                  {{9, {{3, 27}, {3, 30}}}, 3, true},
                                  {{7, {{2, 19}, {3, 20}, {3, 23}}}, 3, true},
                                  {{9, {{1, 27}, {3, 30}, {3, 29}, {3, 30}}}, 3, true},
                                  {{8, {{1, 25}, {4, 26}, {2, 24}, {4, 26}}}, 4, true},
                                  {{13, {{3, 42}, {5, 37}, {1, 3}}}, 3, true},
                                  {{14, {{4, 45}, {2, 41}, {7, 42}, {7, 2}, {1, 45}}}, 4, true},
                                  {{14, {{4, 44}, {5, 42}, {1, 4}, {7, 43}, {5, 41}}}, 4, true}};
    for (const Case& one : cases) {
        const LumpedSet set = lumpedSet(one.schedule);
        const LumpedShape shape = shapeOf(set);
        REQUIRE(shape.spanning.size() == 1);
        const State least = equalMotion(set, set.leastSums);
        const auto at = [&](double energy) { return sectionOfPhases(one.schedule, energy); };
        // From 1/d of equal shares to 1 of one share.
        const auto count = static_cast<double>(one.count);
        const auto energyOfRatio = [&](double ratio) {
            return shape.energy.least + (ratio - 1.0 / count) / (1.0 - 1.0 / count) *
                                            (mostOfShared(set, one.count) - shape.energy.least);
        };
        for (const double ratio : {0.4, 0.45, 0.5, 0.6, 0.9}) {
            if (ratio * count <= 1.0) {
                continue;
            }
            INFO(describe(one.schedule) << ", ratio = " << ratio);
            const double energy = energyOfRatio(ratio);
            const auto section = at(energy);
            const SectionFacts& facts = section->facts();
            CHECK(facts.dimension == shape.dimension - 1);
            CHECK(facts.range.least == shape.energy.least);
            if (one.isShared && ratio > 0.5) {
                CHECK_FALSE(facts.simplex);
                continue;
            }
            if (!one.isShared || ratio != 0.5) {
                REQUIRE(facts.simplex);
            }
            if (!facts.simplex) {
                continue;
            }
            CHECK(facts.simplex->count == one.count);
            CHECK(facts.simplex->ratio == Approx(ratio).epsilon(1e-12));
            CHECK(facts.isShared == one.isShared);
            CHECK(facts.isWhole == !one.isShared);
            const std::vector<double> shares = sharesOfRatio(*facts.simplex);
            const State motion = section->motionOf(shares);
            CHECK(energyRatio(motion) == Approx(energy).epsilon(1e-12));
            CHECK(verify(motion, one.schedule).residuals.worst() < 1e-12);
            CHECK(largestAmplitude(set, motion) <= facts.largestWave * (1.0 + 1e-12));
            const std::vector<double> back = section->sharesOf(motion);
            REQUIRE(back.size() == shares.size());
            for (std::size_t j = 0; j < back.size(); ++j) {
                CHECK(back[j] == Approx(shares[j]).margin(1e-12));
            }
            if (!one.isShared && ratio == 0.5) {
                CHECK(facts.simplex->ratio == 0.5);
            }
        }
        const auto lowest = at(shape.energy.least);
        CHECK(lowest->facts().dimension == 0);
        CHECK(lowest->facts().isFinite);
        CHECK(lowest->facts().components == 1);
        CHECK(energyRatio(lowest->isolated(5).front()) == Approx(shape.energy.least));
        const auto highest = at(shape.energy.most);
        CHECK(highest->facts().isFinite);
        CHECK(highest->facts().dimension == 0);
        double largest = 0.0;
        for (const State& motion : highest->isolated(100)) {
            CHECK(energyRatio(motion) == Approx(shape.energy.most).epsilon(1e-12));
            largest = std::max(largest, largestAmplitude(set, motion));
        }
        CHECK(largest <= highest->facts().largestWave * (1.0 + 1e-12));
        if (!one.isShared) {
            CHECK(largest == Approx(highest->facts().largestWave));
        }
        CHECK(at(0.9 * shape.energy.least)->facts().components == 0);
        CHECK(at(1.1 * shape.energy.most)->facts().components == 0);
    }
}

TEST_CASE("energy section: grazing classes of several phases are counted right, or not at all")
{
    const std::vector<Schedule> schedules{
        {9, {{1, 26}, {3, 26}, {3, 1}}}, {9, {{2, 25}, {2, 28}, {2, 1}}},
        {6, {{2, 22}, {2, 14}}},         {3, {{1, 1}, {1, 10}, {1, 10}}},
        {4, {{2, 9}, {2, 3}}},           {6, {{1, 24}, {2, 7}, {1, 7}, {3, 3}}},
        {6, {{3, 13}, {1, 13}, {3, 15}}}};
    int known = 0;
    for (const Schedule& schedule : schedules) {
        const LumpedShape shape = shapeOf(lumpedSet(schedule));
        for (const double part : {0.15, 0.6, 0.8}) {
            const double energy = std::lerp(shape.energy.least, shape.energy.most, part);
            INFO(describe(schedule) << ", E = " << energy);
            const auto components = sectionOfPhases(schedule, energy)->facts().components;
            if (components) {
                ++known;
                CHECK(components == countedAbove(schedule, energy, 300));
            }
        }
    }
    // All of the first two, whose grazing types are of one class, and of a set of one dimension.
    CHECK(known == 9);
}

TEST_CASE("energy section: of more sums than vertices are listed for nothing is said to be joined")
{
    const Schedule many{20, std::vector<Phase>(16, Phase{4, 71})};
    const LumpedSet set = lumpedSet(many);
    const LumpedShape shape = shapeOf(set);
    REQUIRE(set.live.size() == 16);
    REQUIRE(shape.vertices.empty());
    const double energy = 1.5 * shape.energy.least;
    const auto section = sectionOfPhases(many, energy);
    REQUIRE(section);
    CHECK(section->facts().dimension == shape.dimension - 1);
    CHECK_FALSE(section->facts().components);
    CHECK_FALSE(section->facts().isConnected);
    const State least = equalMotion(set, set.leastSums);
    std::mt19937_64 generator(6);
    const State drawn = drawMotion(set, shape, generator);
    CHECK_FALSE(section->joins(least, drawn));
}

TEST_CASE("energy section: motions of a cone that share an impulse have the energy, and come back")
{
    struct Case {
        Schedule schedule;
        std::int64_t widest;
    };
    const std::vector<Case> cases{
        {{7, {{1, 20}, {3, 18}}}, 3},         {{7, {{3, 18}, {1, 20}}}, 3},
        {{7, {{2, 23}, {3, 14}}}, 3},         {{9, {{3, 29}, {2, 20}}}, 3},
        {{9, {{4, 24}, {2, 24}}}, 4},         {{8, {{4, 20}, {3, 21}}}, 4},
        {{8, {{2, 25}, {4, 17}}}, 4},         {{7, {{3, 1}, {3, 9}, {2, 6}, {3, 15}}}, 3},
        {{9, {{1, 10}, {4, 3}, {2, 7}}}, 0},  {{11, {{2, 15}, {2, 15}, {4, 3}, {4, 21}}}, 3},
        {{11, {{3, 5}, {3, 3}, {5, 14}}}, 3}, {{11, {{4, 4}, {3, 26}, {2, 9}, {4, 14}}}, 3},
        {{8, {{4, 1}, {3, 10}, {2, 4}}}, 0}};
    for (Case one : cases) {
        one.schedule.stops.right = 0;
        INFO(describe(one.schedule));
        const auto section = sectionOfCone(one.schedule, 7.0);
        REQUIRE(section);
        const auto& simplex = section->facts().simplex;
        REQUIRE(simplex.has_value() == (one.widest > 0));
        if (!simplex) {
            continue;
        }
        CHECK(simplex->count == one.widest);
        std::vector<double> shares(static_cast<std::size_t>(simplex->count), 0.25 / 2.0);
        shares[1] = 1.0 - 0.125 * static_cast<double>(simplex->count - 1);
        const State motion = section->motionOf(shares);
        CHECK(energyRatio(motion) == Approx(7.0).epsilon(1e-12));
        CHECK(verify(motion, one.schedule).residuals.worst() < 1e-12);
        const std::vector<double> back = section->sharesOf(motion);
        REQUIRE(back.size() == shares.size());
        for (std::size_t j = 0; j < back.size(); ++j) {
            CHECK(back[j] == Approx(shares[j]).margin(1e-12));
        }
    }
}

TEST_CASE("energy section: pulses are shared where sums stay, from equal shares to two of a half")
{
    // Two types of three classes, E = 6 to 18: sum of squares 1/3 to 1 of each.
    const Schedule pair{9, {{3, 27}, {3, 30}}};
    CHECK(sectionOfPhases(pair, 6.0)->facts().simplex);
    CHECK(sectionOfPhases(pair, 9.0)->facts().simplex);
    CHECK_FALSE(sectionOfPhases(pair, 9.01)->facts().simplex);
    // Here the sum of the wide type goes from 0 to all.
    const Schedule varying{9, {{2, 23}, {4, 1}}};
    const LumpedShape shape = shapeOf(lumpedSet(varying));
    REQUIRE(shape.spanning.size() == 2);
    for (const double part : {0.01, 0.05, 0.1, 0.2, 0.5}) {
        const double energy = std::lerp(shape.energy.least, shape.energy.most, part);
        CHECK_FALSE(sectionOfPhases(varying, energy)->facts().simplex);
    }
}
