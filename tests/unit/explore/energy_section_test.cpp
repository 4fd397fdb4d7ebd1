#include "energy_section.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "catch.hpp"
#include "signorini/continuum.hpp"
#include "signorini/lumped_set.hpp"
#include "support.hpp"

using namespace signorini;
using signorini::test::onePhase;

namespace {

/// Points of a grid of partial sums in [0, 1]^(d-1), with Q = sum of squared differences, and which
/// of those with Q >= rho hang together through neighbours along one axis. The level set has as
/// many components as the points above it.
class GridAbove {
public:
    GridAbove(std::size_t places, int steps, double rho) : steps_(steps), axes_(places - 1)
    {
        std::size_t points = 1;
        for (std::size_t k = 0; k < axes_; ++k) {
            points *= size();
        }
        labels_.assign(points, -1);
        for (std::size_t start = 0; start < points; ++start) {
            if (labels_[start] < 0 && squaresAt(start) >= rho - 1e-12) {
                fill(start, rho);
            }
        }
    }

    [[nodiscard]] int components() const { return components_; }

    /// The component of a corner, of partial sums 0 or 1 by the bits; -1 below.
    [[nodiscard]] int labelAt(unsigned corner) const
    {
        std::size_t index = 0;
        std::size_t stride = 1;
        for (std::size_t k = 0; k < axes_; ++k) {
            index += (corner >> k & 1U) != 0 ? stride * (size() - 1) : 0;
            stride *= size();
        }
        return labels_[index];
    }

    [[nodiscard]] double squaresAt(std::size_t index) const
    {
        double previous = 0.0;
        double squares = 0.0;
        for (std::size_t k = 0; k < axes_; ++k) {
            const double value = static_cast<double>(index % size()) / steps_;
            squares += (value - previous) * (value - previous);
            previous = value;
            index /= size();
        }
        return squares + (1.0 - previous) * (1.0 - previous);
    }

private:
    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(steps_ + 1); }

    void fill(std::size_t start, double rho)
    {
        std::vector<std::size_t> open{start};
        labels_[start] = components_;
        while (!open.empty()) {
            const std::size_t index = open.back();
            open.pop_back();
            std::size_t stride = 1;
            for (std::size_t k = 0; k < axes_; ++k) {
                const auto digit = static_cast<int>(index / stride % size());
                if (digit > 0) {
                    visit(index - stride, rho, open);
                }
                if (digit < steps_) {
                    visit(index + stride, rho, open);
                }
                stride *= size();
            }
        }
        ++components_;
    }

    void visit(std::size_t index, double rho, std::vector<std::size_t>& open)
    {
        if (labels_[index] < 0 && squaresAt(index) >= rho - 1e-12) {
            labels_[index] = components_;
            open.push_back(index);
        }
    }

    int steps_;
    std::size_t axes_;
    int components_ = 0;
    std::vector<int> labels_;
};

/// The first schedule found whose motions are a box of d amplitudes.
Schedule boxOf(std::int64_t places)
{
    for (std::int64_t cells = places; cells <= 4 * places; ++cells) {
        for (std::int64_t contact = 1; contact <= cells; ++contact) {
            for (std::int64_t free = 1; free <= 8 * cells; ++free) {
                const OnePhaseSet whole = onePhaseSet(onePhase(cells, contact, free));
                if (!whole.reason && whole.contact == Contact::grazing &&
                    whole.set.count == places) {
                    return onePhase(cells, contact, free);
                }
            }
        }
    }
    throw std::logic_error("no such box");
}

}  // namespace

TEST_CASE("energy section: boxes have as many components as a grid shows")
{
    for (const std::size_t places : {2, 3, 4, 5}) {
        const Schedule schedule = boxOf(static_cast<std::int64_t>(places));
        const OnePhaseSet whole = onePhaseSet(schedule);
        const EnergyRange range = energyRange(whole);
        const auto count = static_cast<double>(places);
        const int steps = places == 5 ? 24 : 40;
        int several = 0;
        for (const double rho : {0.3, 0.45, 0.55, 0.75, 0.95, 1.3, 2.2, 2.45, 2.6, 2.9, 4.4, 4.7}) {
            if (rho * count <= 1.02 || rho * range.least * count >= range.most) {
                continue;
            }
            INFO("d = " << places << ", rho = " << rho);
            const int counted = GridAbove(places, steps, rho).components();
            CHECK(componentsAt(whole, rho * count * range.least) == counted);
            several += counted > 1 ? 1 : 0;
        }
        CHECK(several > 0);
    }
}

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
    CHECK(several >= 15);
    CHECK(varying >= 8);
}

TEST_CASE("energy section: corners of a box are joined where the grid joins them")
{
    for (const std::size_t places : {3, 4, 5}) {
        const Schedule schedule = boxOf(static_cast<std::int64_t>(places));
        const OnePhaseSet whole = onePhaseSet(schedule);
        const auto count = static_cast<double>(places);
        const double unit = energyRange(whole).most / (places == 5 ? 5.0 : 3.0);
        const int steps = places == 5 ? 24 : 40;
        for (const double rho : {0.45, 0.75, 1.0, 2.25, 2.5, 2.75, 3.0, 4.5, 4.75}) {
            if (rho * count <= 1.02 || rho * unit >= energyRange(whole).most) {
                continue;
            }
            INFO("d = " << places << ", rho = " << rho);
            const GridAbove grid(places, steps, rho);
            const auto section = sectionOfOnePhase(schedule, rho * unit);
            REQUIRE(section);
            CHECK(section->facts().components == grid.components());
            CHECK(section->facts().isConnected == (grid.components() == 1));
            std::vector<State> motions;
            std::vector<int> labels;
            std::mt19937_64 generator(3);
            std::uniform_real_distribution<double> noise(-0.05, 0.05);
            double previousNoise = 0.0;
            for (unsigned corner = 0; corner < 1U << (places - 1); ++corner) {
                if (grid.labelAt(corner) < 0) {
                    continue;
                }
                std::vector<double> shares;
                int previous = 0;
                int jumps = 0;
                for (std::size_t k = 0; k < places; ++k) {
                    const int sum = k + 1 < places ? static_cast<int>(corner >> k & 1U) : 1;
                    shares.push_back(sum - previous);
                    jumps += sum != previous ? 1 : 0;
                    previous = sum;
                }
                // On the way from the corner to a point near equal shares, where Q is convex.
                for (int turn = 0; turn < 3; ++turn) {
                    std::vector<double> ends;
                    previousNoise = 0.0;
                    for (std::size_t k = 0; k < places; ++k) {
                        const double next = k + 1 < places ? noise(generator) : 0.0;
                        ends.push_back(1.0 / count + next - previousNoise);
                        previousNoise = next;
                    }
                    double above = 0.0;
                    double below = 1.0;
                    std::vector<double> point(places);
                    while (below - above > 1e-15) {
                        const double part = 0.5 * (above + below);
                        double squares = 0.0;
                        for (std::size_t k = 0; k < places; ++k) {
                            point[k] = std::lerp(shares[k], ends[k], part);
                            squares += point[k] * point[k];
                        }
                        (squares >= rho ? above : below) = part;
                    }
                    for (double& share : point) {
                        share *= whole.set.sum;
                    }
                    motions.push_back(motionOf(whole, point));
                    REQUIRE(verify(motions.back(), schedule).residuals.worst() < 1e-12);
                    labels.push_back(grid.labelAt(corner));
                }
            }
            int wrong = 0;
            for (std::size_t i = 0; i < motions.size(); ++i) {
                for (std::size_t k = 0; k < motions.size(); ++k) {
                    wrong +=
                        section->joins(motions[i], motions[k]) == (labels[i] == labels[k]) ? 0 : 1;
                }
            }
            CHECK(wrong == 0);
        }
    }
}

TEST_CASE("energy section: the motions of most energy of a box are all there, and apart")
{
    for (const std::int64_t places : {2, 4, 6}) {
        const Schedule schedule = boxOf(places);
        const double most = energyRange(onePhaseSet(schedule)).most;
        const auto section = sectionOfOnePhase(schedule, most);
        REQUIRE(section->facts().isFinite);
        CHECK(section->facts().isWhole == (places == 2));
        const std::vector<State> motions = section->isolated(100);
        REQUIRE(static_cast<std::int64_t>(motions.size()) == places);
        CHECK(section->facts().components == places);
        for (std::size_t i = 0; i < motions.size(); ++i) {
            CHECK(energyRatio(motions[i]) == Approx(most).epsilon(1e-12));
            CHECK(verify(motions[i], schedule).residuals.worst() < 1e-12);
            for (std::size_t k = 0; k < motions.size(); ++k) {
                CHECK(section->joins(motions[i], motions[k]) == (i == k));
            }
        }
    }
}

TEST_CASE("energy section: components of wide boxes are counted where the number fits")
{
    // One step of contact and 4N - 1 of flight: a box of 2N - 1. Below the most jumps m, each of
    // m + 1 gaps may hold one of the holes; the rest hang together.
    const auto at = [](std::int64_t cells, double rho) {
        const OnePhaseSet whole = onePhaseSet(onePhase(cells, 1, 4 * cells - 1));
        REQUIRE(whole.set.kind == SetKind::box);
        REQUIRE(whole.set.count == 2 * cells - 1);
        return componentsAt(whole,
                            rho * energyRange(whole).most / static_cast<double>(2 * cells - 1));
    };
    CHECK(at(42, 81.0) == 82 * 81 / 2 + 1);
    CHECK(at(42, 83.0) == 1);
    CHECK(at(79, 79.0) == 80 * 79 / 2 + 1);
    CHECK(at(80, 79.0) == 1 + 1);
    CHECK(at(81, 79.0) == 1);
    CHECK_FALSE(at(60, 79.0));  // C(80, 40)
}

TEST_CASE("energy section: one simplex has the largest wave of its spikes, and one least motion")
{
    int spikes = 0;
    int pairs = 0;
    test::forAllSchedules(12, 0, [&](const Schedule& schedule) {
        const OnePhaseSet whole = onePhaseSet(schedule);
        if (whole.reason) {
            return;
        }
        INFO(describe(schedule));
        const EnergyRange range = energyRange(whole);
        CHECK(componentsAt(whole, range.least) == 1);
        CHECK(sectionOfOnePhase(schedule, range.least)->facts().isConnected == true);
        if (whole.set.kind != SetKind::simplex) {
            return;
        }
        const auto count = static_cast<double>(whole.set.count);
        const double energy = std::lerp(range.least, range.most, 0.7);
        // x on one class, the rest evenly on the others: x^2 + (1 - x)^2/(d - 1) grows.
        double low = 1.0 / count;
        double high = 1.0;
        for (int k = 0; k < 60; ++k) {
            const double x = 0.5 * (low + high);
            const double squares = x * x + (1.0 - x) * (1.0 - x) / (count - 1.0);
            (squares * count * range.least < energy ? low : high) = x;
        }
        const auto section = sectionOfOnePhase(schedule, energy);
        CHECK(section->facts().largestWave == Approx(high * std::abs(whole.set.sum)));
        CHECK(section->facts().isWhole);
        ++spikes;
        const auto ends = sectionOfOnePhase(schedule, whole.set.count == 2 ? energy : range.most);
        const std::vector<State> motions = ends->isolated(100);
        REQUIRE(static_cast<std::int64_t>(motions.size()) == whole.set.count);
        for (std::size_t j = 0; j < motions.size(); ++j) {
            const std::vector<double> shares = ends->sharesOf(motions[j]);
            CHECK(std::max_element(shares.begin(), shares.end()) - shares.begin() ==
                  static_cast<std::ptrdiff_t>(j));
        }
        pairs += whole.set.count == 2 ? 1 : 0;
    });
    CHECK(spikes > 20);
    CHECK(pairs > 5);
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
    CHECK(known == 6);  // all of the first two: their grazing types are of one class
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
