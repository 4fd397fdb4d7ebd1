// Amplitudes of a given sum of squares: the flattest, and those nearest to a target.

#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

#include "catch.hpp"
#include "points.hpp"
#include "signorini/amplitude_set.hpp"

using namespace signorini;
using test::squaresOf;

namespace {

double largest(const std::vector<double>& z)
{
    double most = 0.0;
    for (const double value : z) {
        most = std::max(most, std::abs(value));
    }
    return most;
}

/// Calls visit for many points with sum S and sum z^2 = q, in the set or not: an even net on the
/// circle (d = 3) or sphere (d = 4) about equal amplitudes.
void forNet(std::size_t count, double sum, double squares,
            const std::function<void(const std::vector<double>&)>& visit)
{
    const double mean = sum / static_cast<double>(count);
    const double radius = std::sqrt(squares - sum * mean);
    const int turns = count == 3 ? 60000 : 600;
    const int rises = count == 3 ? 1 : 300;
    for (int r = 0; r < rises; ++r) {
        const double polar =
            count == 3 ? 0.5 * std::numbers::pi : std::acos(1.0 - 2.0 * (r + 0.5) / rises);
        for (int k = 0; k < turns; ++k) {
            const double turn = 2.0 * std::numbers::pi * k / turns;
            const double x = radius * std::sin(polar) * std::cos(turn);
            const double y = radius * std::sin(polar) * std::sin(turn);
            const double h = radius * std::cos(polar);
            // An orthonormal basis at right angles to (1, ..., 1).
            std::vector<double> z(count, mean);
            z[0] += x / std::sqrt(2.0) + y / std::sqrt(6.0);
            z[1] += -x / std::sqrt(2.0) + y / std::sqrt(6.0);
            z[2] += -2.0 * y / std::sqrt(6.0);
            if (count == 4) {
                for (std::size_t i = 0; i < 3; ++i) {
                    z[i] += h / std::sqrt(12.0);
                }
                z[3] -= 3.0 * h / std::sqrt(12.0);
            }
            visit(z);
        }
    }
}

AmplitudeSet simplex(std::int64_t count, double sum)
{
    return {.kind = SetKind::simplex, .count = count, .sum = sum};
}

AmplitudeSet box(std::int64_t count, double sum)
{
    return {.kind = SetKind::box,
            .count = count,
            .sum = sum,
            .lower = std::min(0.0, sum),
            .upper = std::max(0.0, sum)};
}

}  // namespace

TEST_CASE("flattest: no point of the set with the same squares has a lower peak, on a net")
{
    const std::int64_t count = GENERATE(3, 4);
    const bool isBox = GENERATE(false, true);
    const AmplitudeSet set = isBox ? box(count, -2.0) : simplex(count, 2.0);
    for (int step = 1; step < 24; ++step) {
        const double least = leastSquares(set);
        const double squares = least + (mostSquares(set) - least) * step / 24.0;
        const std::vector<double> z = flattestAmplitudes(set, squares);
        CAPTURE(count, isBox, squares, z);
        REQUIRE(distanceOutside(set, z) <= 1e-12);
        CHECK(squaresOf(z) == Approx(squares).epsilon(1e-12));
        double best = std::numeric_limits<double>::infinity();
        forNet(static_cast<std::size_t>(count), set.sum, squares,
               [&](const std::vector<double>& y) {
                   if (distanceOutside(set, y) <= 1e-12) {
                       best = std::min(best, largest(y));
                   }
               });
        CHECK(largest(z) <= best * (1.0 + 1e-9));
        // The net finds a point as flat, up to its meshes: the claim is no lower than the truth.
        if (std::isfinite(best)) {
            CHECK(largest(z) >= best * (count == 3 ? 0.999 : 0.93));
        }
    }
}

TEST_CASE("flattest: many amplitudes against random members of one sum of squares")
{
    std::mt19937_64 generator(11);
    for (const std::int64_t count : {5, 8, 13, 40}) {
        for (const bool isBox : {false, true}) {
            const AmplitudeSet set = isBox ? box(count, -1.0) : simplex(count, 1.0);
            for (int k = 0; k < 400; ++k) {
                // From equal amplitudes part of the way to a member drawn from the set.
                std::vector<double> y = drawAmplitudes(set, generator);
                const double share = std::uniform_real_distribution<double>(0.05, 1.0)(generator);
                for (double& value : y) {
                    value = set.sum / static_cast<double>(count) * (1.0 - share) + share * value;
                }
                const std::vector<double> z = flattestAmplitudes(set, squaresOf(y));
                CAPTURE(count, isBox, y);
                REQUIRE(distanceOutside(set, z) <= 1e-11);
                REQUIRE(squaresOf(z) == Approx(squaresOf(y)).epsilon(1e-11));
                REQUIRE(largest(z) <= largest(y) * (1.0 + 1e-9));
            }
            for (const double squares : {leastSquares(set), mostSquares(set)}) {
                const std::vector<double> z = flattestAmplitudes(set, squares);
                CHECK(distanceOutside(set, z) <= 1e-12);
                CHECK(squaresOf(z) == Approx(squares).epsilon(1e-11));
            }
            CHECK_THROWS_AS(flattestAmplitudes(set, 0.5 * leastSquares(set)),
                            std::invalid_argument);
            CHECK_THROWS_AS(flattestAmplitudes(set, 2.0 * mostSquares(set)), std::invalid_argument);
        }
    }
}

TEST_CASE("flattest: whole numbers of equal amplitudes, and the strokes of a box")
{
    CHECK(flattestAmplitudes(simplex(6, 12.0), 144.0 / 3.0) ==
          std::vector<double>{4.0, 4.0, 4.0, 0.0, 0.0, 0.0});
    const std::vector<double> strokes = flattestAmplitudes(box(9, -1.0), 1.0);
    // 9 steps of 1/3: up to the end, back, and up again.
    REQUIRE(strokes.size() == 9);
    for (std::size_t j = 0; j < strokes.size(); ++j) {
        CHECK(strokes[j] == Approx(j / 3 == 1 ? 1.0 / 3.0 : -1.0 / 3.0));
    }
    CHECK_THROWS_AS(
        flattestAmplitudes(
            {.kind = SetKind::box, .count = 3, .sum = 1.0, .lower = -1.0, .upper = 1.0}, 1.0),
        std::invalid_argument);
}

TEST_CASE("nearest of a sum of squares: no member is nearer, on a net")
{
    std::mt19937_64 generator(5);
    std::normal_distribution<double> normal;
    for (const std::int64_t count : {3, 4}) {
        const AmplitudeSet set = simplex(count, 1.0);
        for (int k = 0; k < 20; ++k) {
            std::vector<double> target(static_cast<std::size_t>(count));
            for (double& value : target) {
                value = k < 16 ? normal(generator) : std::round(normal(generator));
            }
            const double squares =
                std::uniform_real_distribution<double>(leastSquares(set), 1.0)(generator);
            const std::vector<double> z = nearestWithSquares(set, target, squares);
            REQUIRE(distanceOutside(set, z) <= 1e-12);
            REQUIRE(squaresOf(z) == Approx(squares).epsilon(1e-12));
            const auto work = [&target](const std::vector<double>& y) {
                return std::inner_product(y.begin(), y.end(), target.begin(), 0.0);
            };
            double best = -std::numeric_limits<double>::infinity();
            forNet(static_cast<std::size_t>(count), 1.0, squares,
                   [&](const std::vector<double>& y) {
                       if (distanceOutside(set, y) <= 1e-12) {
                           best = std::max(best, work(y));
                       }
                   });
            CAPTURE(target, squares, z);
            CHECK(work(z) >= best - 1e-9);
        }
    }
}

TEST_CASE(
    "nearest of a sum of squares: refuses boxes and other lengths, but for a single amplitude")
{
    const std::vector<double> target{0.3, 0.2, 0.9};
    CHECK_THROWS_AS(nearestWithSquares(box(3, 1.0), target, 0.5), std::invalid_argument);
    CHECK_THROWS_AS(nearestWithSquares(simplex(4, 1.0), target, 0.5), std::invalid_argument);
    CHECK(nearestWithSquares(box(1, 2.0), std::vector{0.3}, 4.0) == std::vector{2.0});
    CHECK(flattestAmplitudes(box(1, 2.0), 4.0) == std::vector{2.0});
}
