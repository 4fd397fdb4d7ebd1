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

/// Motions of random directions from the one of least energy as far out as the set goes, those of
/// at least this energy, and how many groups remain when all are joined whose segment keeps it.
int countedAbove(const Schedule& schedule, double energy, int draws)
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
    return count;
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
            CHECK(section->facts().components == countedAbove(schedule, energy, 900));
            several += section->facts().components > 1 ? 1 : 0;
        }
    }
    CHECK(several >= 15);
    CHECK(varying >= 8);
}
