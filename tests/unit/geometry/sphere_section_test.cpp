#include "sphere_section.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

#include "catch.hpp"
#include "points.hpp"

using namespace signorini;
using test::distance;
using test::squaresOf;
using test::sumOf;

namespace {

/// How far z lies from the section.
double outside(const std::vector<double>& z, double rho)
{
    double worst = std::max(std::abs(sumOf(z) - 1.0), std::abs(squaresOf(z) - rho) / rho);
    for (const double value : z) {
        worst = std::max(worst, -value);
    }
    return worst;
}

/// Components of the points k/n of the simplex with |sum z^2 - rho| <= band, neighbours being
/// those that differ by 1/n in two amplitudes.
std::size_t countComponents(std::size_t count, int n, double rho, double band)
{
    using Point = std::vector<int>;
    std::map<Point, std::size_t> index;
    Point point(count, 0);
    const auto visit = [&](auto&& self, std::size_t j, int rest) -> void {
        if (j + 1 == count) {
            point[j] = rest;
            double squares = 0.0;
            for (const int value : point) {
                squares += static_cast<double>(value) * value / (static_cast<double>(n) * n);
            }
            if (std::abs(squares - rho) <= band) {
                index.emplace(point, index.size());
            }
            return;
        }
        for (int value = 0; value <= rest; ++value) {
            point[j] = value;
            self(self, j + 1, rest - value);
        }
    };
    visit(visit, 0, n);
    std::vector<std::size_t> parent(index.size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto root = [&parent](std::size_t k) {
        while (parent[k] != k) {
            k = parent[k] = parent[parent[k]];
        }
        return k;
    };
    std::size_t components = index.size();
    for (const auto& [at, number] : index) {
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t j = 0; j < count; ++j) {
                Point next = at;
                ++next[i];
                --next[j];
                const auto found = index.find(next);
                if (i != j && found != index.end() && root(found->second) != root(number)) {
                    parent[root(found->second)] = root(number);
                    --components;
                }
            }
        }
    }
    return components;
}

AmplitudeSet simplexOf(std::int64_t count)
{
    return {SetKind::simplex, count, 1.0, 0.0, 0.0};
}

}  // namespace

TEST_CASE("sphere section: brute force counts one component up to 1/2, and d above")
{
    for (const double rho : {0.55, 0.6, 0.8, 0.95}) {
        CHECK(countComponents(2, 400, rho, 0.004) == 2);
        CHECK(countComponents(3, 150, rho, 0.01) == 3);
        CHECK(countComponents(4, 60, rho, 0.025) == 4);
    }
    for (const double rho : {0.36, 0.42, 0.47}) {
        CHECK(countComponents(3, 150, rho, 0.01) == 1);
        CHECK(countComponents(4, 60, rho, 0.025) == 1);
    }
    CHECK(countComponents(4, 60, 0.3, 0.025) == 1);
}

TEST_CASE("sphere section: paths join any two random members, inside all the way")
{
    for (const std::int64_t count : {3, 4, 7, 30}) {
        const double least = 1.0 / static_cast<double>(count);
        for (const double share : {0.0, 1e-9, 0.1, 0.5, 0.9, 1.0}) {
            const double rho = least + share * (0.5 - least);
            SectionSampler sampler(simplexOf(count), rho, 7);
            for (int k = 0; k < 20; ++k) {
                const std::vector<double> from = sampler.next();
                const std::vector<double> to = sampler.next();
                REQUIRE(outside(from, rho) < 1e-13);
                const SectionPath path({count, rho}, from, to);
                CHECK(distance(path.at(0.0), from) < 1e-7);
                CHECK(distance(path.at(1.0), to) < 1e-7);
                const Spacing spacing = equalSpacing(path, 101);
                std::vector<double> previous = path.at(0.0);
                for (const double s : spacing.parameters) {
                    std::vector<double> next = path.at(s);
                    CHECK(outside(next, rho) < 1e-13);
                    CHECK(distance(previous, next) <= 1.2 * spacing.lengths.back() / 100.0 + 1e-9);
                    previous = std::move(next);
                }
            }
        }
    }
}

TEST_CASE("sphere section: the legs of a path meet")
{
    // Two vertices of the section with no amplitude in common.
    const std::vector<double> from{0.4, 0.4, 0.2, 0.0, 0.0, 0.0};
    const std::vector<double> to{0.0, 0.0, 0.0, 0.2, 0.4, 0.4};
    const SectionPath path({6, squaresOf(from)}, from, to);
    CHECK(distance(path.at(0.5 - 1e-12), path.at(0.5 + 1e-12)) < 1e-9);
    CHECK(distance(path.at(0.0), from) < 1e-15);
    CHECK(distance(path.at(1.0), to) < 1e-15);
}

TEST_CASE("sphere section: the way back is the way there, and ends at equal amplitudes exactly")
{
    for (std::int64_t count = 3; count <= 12; ++count) {
        // Equal amplitudes on two faces: both at the rim of their caps, where roots cost digits.
        for (std::int64_t equal = 2; equal < count; ++equal) {
            std::vector<double> from(static_cast<std::size_t>(count), 0.0);
            std::fill_n(from.begin(), equal, 1.0 / static_cast<double>(equal));
            std::vector<double> to = from;
            std::reverse(to.begin(), to.end());
            const double rho = squaresOf(from);
            const SectionPath there({count, rho}, from, to);
            CAPTURE(count, equal);
            CHECK(distance(there.at(0.0), from) < 1e-15);
            CHECK(distance(there.at(1.0), to) < 1e-15);
            CHECK(outside(there.at(0.5), rho) < 1e-14);
        }
    }
    const std::vector<double> from{0.4, 0.1, 0.3, 0.2, 0.0};
    const std::vector<double> to{0.1, 0.4, 0.0, 0.2, 0.3};
    const SectionPath there({5, squaresOf(from)}, from, to);
    const SectionPath back({5, squaresOf(from)}, to, from);
    for (const double s : {0.0, 0.1, 0.4, 0.5, 0.8, 1.0}) {
        CHECK(distance(there.at(s), back.at(1.0 - s)) < 1e-12);
    }
    // The pair at 1/2, in both caps but for rounding.
    const std::vector<double> pair{0.5 + 0x1p-53, 0.5 - 0x1p-54, 0.0};
    const std::vector<double> swapped{0.5 - 0x1p-54, 0.5 + 0x1p-53, 0.0};
    CHECK(distance(SectionPath({3, 0.5}, pair, swapped).at(0.5), {0.5, 0.5, 0.0}) < 1e-7);
    const std::vector<double> vertex{0.0, 1.0, 0.0};
    CHECK(SectionPath({3, 1.0}, vertex, vertex).at(0.5) == vertex);
}

TEST_CASE("sphere section: equally spaced points start and end with the path")
{
    const std::vector<double> from{0.4, 0.1, 0.3, 0.2, 0.0};
    const std::vector<double> to{0.1, 0.4, 0.0, 0.2, 0.3};
    const SectionPath path({5, squaresOf(from)}, from, to);
    CHECK(equalSpacing(path, 1).parameters == std::vector{0.0});
    for (const std::int64_t n : {2, 3, 50}) {
        const Spacing spacing = equalSpacing(path, n);
        REQUIRE(spacing.parameters.size() == static_cast<std::size_t>(n));
        CHECK(spacing.parameters.front() == 0.0);
        CHECK(spacing.parameters.back() == Approx(1.0));
        // The length, by a march of many steps of its own.
        double length = 0.0;
        for (int k = 0; k < 20000; ++k) {
            length += distance(path.at(k / 20000.0), path.at((k + 1) / 20000.0));
        }
        CHECK(spacing.lengths.back() == Approx(length).epsilon(n == 50 ? 1e-4 : 0.02));
    }
}

TEST_CASE("sphere section: a zero shared by both ends stays zero")
{
    const std::vector<double> from{0.5, 0.3, 0.0, 0.2, 0.0};
    const std::vector<double> to{0.2, 0.5, 0.0, 0.3, 0.0};
    const SectionPath path({5, squaresOf(from)}, from, to);
    for (int k = 0; k <= 50; ++k) {
        const std::vector<double> z = path.at(k / 50.0);
        CHECK(z[2] == 0.0);
        CHECK(z[4] == 0.0);
    }
}

TEST_CASE("sphere section: above 1/2 a component is left by no path")
{
    const double rho = 0.66;
    const std::vector<double> first{0.8, 0.1, 0.1};
    const std::vector<double> same{0.8, 0.1, 0.1};
    const std::vector<double> other{0.1, 0.8, 0.1};
    CHECK(dominant(other) == 1);
    CHECK_THROWS_WITH(SectionPath({3, rho}, first, other),
                      containsText("largest are 1 and 2") && containsText("different components"));
    CHECK(outside(SectionPath({3, rho}, first, same).at(0.3), rho) < 1e-15);
    CHECK_THROWS_AS(SectionPath({4, rho}, first, same), std::invalid_argument);
    CHECK_THROWS_AS(SectionPath({3, rho}, first, std::vector{1.0}), std::invalid_argument);
}

TEST_CASE("sphere section: two pulses have their energy at every pause, and begin at the front")
{
    for (const std::int64_t count : {2, 3, 5, 150}) {
        for (const double rho : {1.0 / static_cast<double>(count), 1.0 / 30.0, 0.27, 0.4, 0.5}) {
            if (rho * static_cast<double>(count) < 1.0) {
                continue;
            }
            const PulsePair pulses({count, rho});
            CHECK(pulses.longestPause() ==
                  Approx(static_cast<double>(count) - 1.0 / rho).margin(1e-12));
            std::vector<double> previous = pulses.at(0.0);
            for (int k = 0; k <= 1000; ++k) {
                const double pause = k * pulses.longestPause() / 1000.0;
                const std::vector<double> z = pulses.at(pause);
                REQUIRE(outside(z, rho) < 1e-12);
                CHECK(z.front() > 0.0);
                // The ideal shape: height rho on [0, w] and [w + pause, 2w + pause], w = 1/(2 rho).
                double off = 0.0;
                for (std::size_t j = 0; j < z.size(); ++j) {
                    const auto left = static_cast<double>(j);
                    const auto in = [&](double low, double high) {
                        return std::max(0.0, std::min(high, left + 1.0) - std::max(low, left));
                    };
                    const double w = 0.5 / rho;
                    off += std::abs(z[j] - rho * (in(0.0, w) + in(w + pause, 2.0 * w + pause)));
                }
                CHECK(off < 2.0 * rho);  // two cells' worth
                // Like a root where a pulse begins to cover a cell.
                const double step = pulses.longestPause() / 1000.0;
                CHECK(distance(previous, z) < rho * (1.2 * std::sqrt(step) + 2.0 * step) + 1e-7);
                previous = z;
            }
            CHECK(pulses.at(pulses.longestPause()).back() > 0.0);
        }
    }
    // Whole cells are taken as they are.
    const std::vector<double> apart = PulsePair({6, 0.25}).at(1.0);
    CHECK(distance(apart, {0.25, 0.25, 0.0, 0.25, 0.25, 0.0}) < 1e-15);
}

TEST_CASE("sphere section: above 1/2 the second pulse is smaller and one cell wide")
{
    for (const std::int64_t count : {1, 2, 3, 40}) {
        for (const double rho : {0.51, 0.8, 1.0}) {
            if (count == 1 && rho < 1.0) {
                continue;
            }
            const PulsePair pulses({count, rho});
            for (int k = 0; k <= 40; ++k) {
                const std::vector<double> z = pulses.at(k * pulses.longestPause() / 40.0);
                CHECK(outside(z, rho) < 1e-14);
                CHECK(dominant(z) == 0);
            }
        }
    }
    const std::vector<double> z = PulsePair({5, 0.68}).at(2.0);
    CHECK(distance(z, {0.8, 0.0, 0.0, 0.2, 0.0}) < 1e-15);
}

TEST_CASE("sphere section: samples lie in the set, spread, and repeat with the seed")
{
    for (const double rho : {1.0 / 30.0, 0.7}) {
        SectionSampler first(simplexOf(150), rho, 3);
        SectionSampler again(simplexOf(150), rho, 3);
        SectionSampler other(simplexOf(150), rho, 4);
        std::vector<double> mean(150, 0.0);
        constexpr int samples = 400;
        for (int k = 0; k < samples; ++k) {
            const std::vector<double> z = first.next(10);
            REQUIRE(outside(z, rho) < 1e-12);
            CHECK(again.next(10) == z);
            for (std::size_t j = 0; j < z.size(); ++j) {
                mean[j] += z[j] / samples;
            }
        }
        CHECK(other.next(10) != again.next(10));
        // Independent draws would leave sqrt(rho/150/400) or so about 1/150.
        for (const double value : mean) {
            CHECK(std::abs(value - 1.0 / 150.0) < 8.0 * std::sqrt(rho / 150.0 / samples));
        }
    }
}

TEST_CASE("sphere section: on the circle of d = 3 the walk is even in the angle")
{
    SectionSampler sampler(simplexOf(3), 0.4, 1);
    std::vector<int> hits(12, 0);
    constexpr int samples = 12000;
    for (int k = 0; k < samples; ++k) {
        const std::vector<double>& z = sampler.next(1);
        const double angle = std::atan2(std::sqrt(3.0) * (z[1] - z[2]), 2.0 * z[0] - z[1] - z[2]);
        const int bin = static_cast<int>((angle / 3.14159265358979 + 1.0) * 6.0);
        ++hits[static_cast<std::size_t>(std::clamp(bin, 0, 11))];
    }
    for (const int count : hits) {
        CHECK(std::abs(count - samples / 12) < 200);
    }
}

TEST_CASE("sphere section: samples of a box keep to its partial sums")
{
    const AmplitudeSet box{SetKind::box, 6, -6.0, -6.0, 0.0};
    SectionSampler sampler(box, 30.0, 5);
    for (int k = 0; k < 200; ++k) {
        const std::vector<double> z = sampler.next(5);
        CHECK(distanceOutside(box, z) < 1e-13);
        CHECK(squaresOf(z) == Approx(30.0).epsilon(1e-13));
    }
}

TEST_CASE("sphere section: a walk slides along the faces it meets, and never leaves the set")
{
    std::mt19937_64 generator(21);
    std::normal_distribution<double> normal;
    int faces = 0;
    for (const std::int64_t count : {3, 5, 20, 150}) {
        for (const double excess : {1.3, 4.0}) {
            const SphereSection section{count, std::min(0.9, excess / static_cast<double>(count))};
            SectionSampler sampler({SetKind::simplex, count, 1.0, 0.0, 0.0}, section.ratio, 3);
            std::vector<double> z = sampler.next();
            std::vector<double> direction(z.size());
            for (double& value : direction) {
                value = normal(generator);
            }
            SlidingWalk walk(section, z, direction);
            constexpr double step = 0.02;
            for (int k = 0; k < 200 && walk.canMove(); ++k) {
                const std::vector<double> next = walk.advance(step);
                INFO("d = " << count << ", rho = " << section.ratio << ", step " << k);
                double sum = 0.0;
                double squares = 0.0;
                double moved = 0.0;
                for (std::size_t j = 0; j < next.size(); ++j) {
                    REQUIRE(next[j] >= 0.0);
                    sum += next[j];
                    squares += next[j] * next[j];
                    moved += (next[j] - z[j]) * (next[j] - z[j]);
                    faces += next[j] == 0.0 ? 1 : 0;
                }
                REQUIRE(sum == Approx(1.0).epsilon(1e-11));
                REQUIRE(squares == Approx(section.ratio).epsilon(1e-11));
                REQUIRE(std::sqrt(moved) <= step * (1.0 + 1e-9));
                z = next;
            }
        }
    }
    CHECK(faces > 100);
    CHECK_THROWS_AS(SlidingWalk({3, 0.5}, std::vector{0.5, 0.5, 0.0}, std::vector{1.0}),
                    std::invalid_argument);
}

TEST_CASE("sphere section: away from faces a walk is the great circle itself")
{
    // d = 3: the sphere section is a circle about (1, 1, 1)/3 of radius sqrt(rho - 1/3).
    const double rho = 0.4;
    const double radius = std::sqrt(rho - 1.0 / 3.0);
    const std::vector<double> u{2.0 / std::sqrt(6.0), -1.0 / std::sqrt(6.0), -1.0 / std::sqrt(6.0)};
    const std::vector<double> v{0.0, 1.0 / std::sqrt(2.0), -1.0 / std::sqrt(2.0)};
    std::vector<double> start(3);
    for (std::size_t j = 0; j < 3; ++j) {
        start[j] = 1.0 / 3.0 + radius * u[j];
    }
    SlidingWalk walk({3, rho}, start, std::vector{1.0, 3.0, -1.0});  // v plus what does not count
    for (int k = 1; k <= 10; ++k) {
        const std::vector<double>& z = walk.advance(0.1 * radius);
        const double angle = 0.1 * k;
        for (std::size_t j = 0; j < 3; ++j) {
            CHECK(z[j] ==
                  Approx(1.0 / 3.0 + radius * (std::cos(angle) * u[j] + std::sin(angle) * v[j])));
        }
    }
}
