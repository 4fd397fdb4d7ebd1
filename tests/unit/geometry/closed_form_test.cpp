#include "signorini/amplitude_set.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "catch.hpp"
#include "points.hpp"

using namespace signorini;
using test::squaresOf;

namespace {

/// Calls visit for the corners of a set, whose hull it is, one by one.
void forCorners(const AmplitudeSet& set,
                const std::function<void(const std::vector<double>&)>& visit)
{
    const auto count = static_cast<std::size_t>(set.count);
    if (set.kind != SetKind::box) {
        for (std::size_t j = 0; j < count; ++j) {
            std::vector<double> corner(count, 0.0);
            corner[j] = set.sum;
            visit(corner);
        }
        return;
    }
    const std::size_t inner = count - 1;
    for (unsigned pattern = 0; pattern < (1U << inner); ++pattern) {
        double previous = 0.0;
        std::vector<double> corner;
        for (std::size_t j = 0; j <= inner; ++j) {
            const double next = j == inner                   ? set.sum
                                : ((pattern >> j) & 1U) != 0 ? set.upper
                                                             : set.lower;
            corner.push_back(next - previous);
            previous = next;
        }
        visit(corner);
    }
}

double mostOverCorners(const AmplitudeSet& set)
{
    double most = 0.0;
    forCorners(set, [&most](const auto& corner) { most = std::max(most, squaresOf(corner)); });
    return most;
}

/// A box about 0 and S, or a simplex.
AmplitudeSet drawSet(std::mt19937_64& generator, std::int64_t count, bool isBox)
{
    std::uniform_real_distribution<double> value(0.1, 3.0);
    const double sum = isBox ? -value(generator) : value(generator);
    return {.kind = isBox ? SetKind::box : SetKind::simplex,
            .count = count,
            .sum = sum,
            .lower = isBox ? sum - value(generator) : 0.0,
            .upper = isBox ? value(generator) : 0.0};
}

}  // namespace

TEST_CASE("closed form: on a simplex least is S^2/d at the centre, most S^2 at a vertex")
{
    const AmplitudeSet set{SetKind::simplex, 5, 10.0, 0.0, 0.0};
    CHECK(leastSquares(set) == 20.0);
    CHECK(mostSquares(set) == 100.0);
    CHECK(squaresOf(leastAmplitudes(set)) == Approx(20.0));
    CHECK(squaresOf(mostAmplitudes(set)) == 100.0);
    CHECK(distanceOutside(set, leastAmplitudes(set)) < 1e-15);
    CHECK(distanceOutside(set, mostAmplitudes(set)) == 0.0);
}

TEST_CASE("closed form: on a box most agrees with every corner tried, for odd and even d")
{
    std::mt19937_64 generator(11);
    std::uniform_real_distribution<double> value(0.0, 3.0);
    for (std::int64_t count = 2; count <= 11; ++count) {
        for (int k = 0; k < 20; ++k) {
            const double sum = -value(generator);
            const AmplitudeSet box{SetKind::box, count, sum, sum - value(generator),
                                   value(generator)};
            INFO("d = " << count << ", S = " << sum);
            CHECK(mostSquares(box) == Approx(mostOverCorners(box)).epsilon(1e-13));
            CHECK(squaresOf(mostAmplitudes(box)) == Approx(mostSquares(box)).epsilon(1e-13));
            CHECK(distanceOutside(box, mostAmplitudes(box)) < 1e-12);
        }
    }
}

TEST_CASE("closed form: no draw from a set leaves [least, most]")
{
    std::mt19937_64 generator(2);
    for (const AmplitudeSet& set : {AmplitudeSet{SetKind::simplex, 6, 3.0, 0.0, 0.0},
                                    AmplitudeSet{SetKind::box, 6, -3.0, -3.0, 0.0}}) {
        for (int k = 0; k < 500; ++k) {
            const double drawn = squaresOf(drawAmplitudes(set, generator));
            CHECK(drawn >= leastSquares(set));
            CHECK(drawn <= mostSquares(set));
        }
    }
}

TEST_CASE("closed form: a single point is least and most at once")
{
    const AmplitudeSet point{SetKind::point, 1, -4.0, -4.0, 0.0};
    CHECK(leastSquares(point) == 16.0);
    CHECK(mostSquares(point) == 16.0);
    CHECK(mostAmplitudes(point) == std::vector{-4.0});
    CHECK(leastAmplitudes(point) == std::vector{-4.0});
}

TEST_CASE("closed form: the nearest member makes no sharp angle with any corner, ties or none")
{
    std::mt19937_64 generator(17);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 600; ++trial) {
        const AmplitudeSet set = drawSet(generator, 1 + trial % 7, trial % 2 == 0);
        const double width = std::array{0.3, 3.0, 50.0}[static_cast<std::size_t>(trial % 3)];
        std::vector<double> target(static_cast<std::size_t>(set.count));
        for (double& value : target) {
            value = width * normal(generator);
            value = trial % 5 == 0 ? std::round(value) : value;
        }
        const std::vector<double> z = nearestAmplitudes(set, target);
        CAPTURE(trial, set.count, set.sum, set.lower, set.upper, target, z);
        REQUIRE(distanceOutside(set, z) <= 1e-12);
        // (t - z) . (y - z) <= 0 for all members y if for the corners.
        forCorners(set, [&](const auto& corner) {
            double angle = 0.0;
            for (std::size_t j = 0; j < z.size(); ++j) {
                angle += (target[j] - z[j]) * (corner[j] - z[j]);
            }
            REQUIRE(angle <= 1e-11 * width);
        });
    }
    const AmplitudeSet set{SetKind::simplex, 3, 1.0, 0.0, 0.0};
    CHECK_THROWS_AS(nearestAmplitudes(set, std::vector{1.0}), std::invalid_argument);
    CHECK_THROWS_AS(nearestAmplitudes(AmplitudeSet{}, std::vector<double>{}),
                    std::invalid_argument);
}

TEST_CASE("closed form: members of every sum of squares from the least to the most, and no other")
{
    std::mt19937_64 generator(23);
    for (int trial = 0; trial < 200; ++trial) {
        const AmplitudeSet set = drawSet(generator, 1 + trial % 7, trial % 2 == 0);
        const double least = leastSquares(set);
        const double most = mostSquares(set);
        CAPTURE(set.count, set.sum, set.lower, set.upper);
        REQUIRE(most == Approx(mostOverCorners(set)).epsilon(1e-13));
        for (const double share : {0.0, 0.1, 0.5, 1.0}) {
            const double wanted = std::lerp(least, most, share);
            const std::vector<double> z = amplitudesWithSquares(set, wanted);
            REQUIRE(squaresOf(z) == Approx(wanted).epsilon(1e-13));
            REQUIRE(distanceOutside(set, z) <= 1e-12);
        }
        for (const double wrong : {least - 1e-12 * most, most + 1e-12 * most, std::nan("")}) {
            REQUIRE_THROWS_AS(amplitudesWithSquares(set, wrong), std::invalid_argument);
        }
    }
}
