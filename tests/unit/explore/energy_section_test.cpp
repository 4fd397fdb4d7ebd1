#include "energy_section.hpp"

#include <algorithm>
#include <cmath>
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
    for (const std::size_t places : {2U, 3U, 4U, 5U}) {
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
            CHECK(connectivityOf(whole, rho * count * range.least).components == counted);
            several += counted > 1 ? 1 : 0;
        }
        CHECK(several > 0);
    }
}

TEST_CASE("energy section: corners of a box are joined where the grid joins them")
{
    for (const std::size_t places : {3U, 4U, 5U}) {
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
                for (std::size_t k = 0; k < places; ++k) {
                    const int sum = k + 1 < places ? static_cast<int>(corner >> k & 1U) : 1;
                    shares.push_back(sum - previous);
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
        return connectivityOf(whole,
                              rho * energyRange(whole).most / static_cast<double>(2 * cells - 1))
            .components;
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
        CHECK(connectivityOf(whole, range.least).components == 1);
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
