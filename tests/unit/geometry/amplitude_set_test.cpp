#include "signorini/amplitude_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "catch.hpp"

using namespace signorini;

namespace {

const AmplitudeSet aSimplex{SetKind::simplex, 4, 2.0, 0.0, 0.0};
const AmplitudeSet aBox{SetKind::box, 4, -2.0, -2.0, 0.0};

}  // namespace

TEST_CASE("amplitude set: distance is 0 inside and the largest relative violation outside")
{
    CHECK(distanceOutside(aSimplex, std::vector{0.5, 0.5, 1.0, 0.0}) == 0.0);
    CHECK(distanceOutside(aSimplex, std::vector{-0.5, 1.5, 1.0, 0.0}) == 0.25);
    CHECK(distanceOutside(aSimplex, std::vector{0.5, 0.5, 1.0, 1.0}) == 0.5);
    CHECK(distanceOutside(aBox, std::vector{-2.0, 2.0, -2.0, 0.0}) == 0.0);
    CHECK(distanceOutside(aBox, std::vector{1.0, -1.0, -2.0, 0.0}) == 0.5);
    CHECK(std::isinf(distanceOutside(aBox, std::vector{std::nan(""), 0.0, 0.0, 0.0})));
}

TEST_CASE("amplitude set: the distance is the worst of all bounds, each looked at alone")
{
    std::mt19937_64 generator(3);
    std::uniform_int_distribution<int> eighths(-40, 40);
    for (int trial = 0; trial < 500; ++trial) {
        // Eighths add up without rounding.
        const auto count = static_cast<std::size_t>(1 + trial % 5);
        std::vector<double> z(count);
        for (double& value : z) {
            value = eighths(generator) / 8.0;
        }
        const AmplitudeSet wide{SetKind::box, trial % 5 + 1, -2.0, -3.0, 1.5};
        std::vector<double> partial(count);
        std::partial_sum(z.begin(), z.end(), partial.begin());
        double worst = std::abs(partial.back() + 2.0);
        for (std::size_t j = 0; j + 1 < count; ++j) {
            worst = std::max({worst, -3.0 - partial[j], partial[j] - 1.5});
        }
        CAPTURE(z);
        REQUIRE(distanceOutside(wide, z) == worst / 2.0);
        const AmplitudeSet positive{SetKind::simplex, trial % 5 + 1, 2.0, 0.0, 0.0};
        worst = std::max(std::abs(partial.back() - 2.0), -*std::min_element(z.begin(), z.end()));
        REQUIRE(distanceOutside(positive, z) == worst / 2.0);
    }
}

TEST_CASE("amplitude set: partial sums drawn from a box are even between its bounds")
{
    const AmplitudeSet wide{SetKind::box, 3, 2.0, -1.0, 5.0};
    std::mt19937_64 generator(9);
    std::vector<int> hits(6, 0);
    for (int k = 0; k < 3000; ++k) {
        const std::vector<double> z = drawAmplitudes(wide, generator);
        REQUIRE(distanceOutside(wide, z) < 1e-15);
        for (const double partial : {z[0], z[0] + z[1]}) {
            ++hits.at(static_cast<std::size_t>(partial + 1.0));
        }
    }
    for (const int count : hits) {
        CHECK(std::abs(count - 1000) < 150);  // 5 standard deviations
    }
}

TEST_CASE("amplitude set: a wrong number of amplitudes is refused")
{
    CHECK_THROWS_AS(distanceOutside(aSimplex, std::vector{2.0}), std::invalid_argument);
    CHECK_THROWS_AS(distanceOutside(AmplitudeSet{}, std::vector<double>{}), std::invalid_argument);
}

TEST_CASE("amplitude set: draws are members, differ, and repeat with the seed")
{
    for (const AmplitudeSet& set : {aSimplex, aBox}) {
        std::mt19937_64 first(5);
        std::mt19937_64 second(5);
        const std::vector<double> z = drawAmplitudes(set, first);
        CHECK(z == drawAmplitudes(set, second));
        CHECK(z != drawAmplitudes(set, first));
        for (int k = 0; k < 100; ++k) {
            CHECK(distanceOutside(set, drawAmplitudes(set, first)) < 1e-15);
        }
    }
    std::mt19937_64 generator(1);
    CHECK_THROWS_AS(drawAmplitudes(AmplitudeSet{}, generator), std::invalid_argument);
}
