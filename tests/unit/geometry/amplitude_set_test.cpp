#include "signorini/amplitude_set.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include "catch.hpp"

using namespace signorini;

namespace {

const AmplitudeSet simplex{SetKind::simplex, 4, 2.0, 0.0, 0.0};
const AmplitudeSet box{SetKind::box, 4, -2.0, -2.0, 0.0};

}  // namespace

TEST_CASE("amplitude set: distance is 0 inside and the largest relative violation outside")
{
    CHECK(distanceOutside(simplex, std::vector{0.5, 0.5, 1.0, 0.0}) == 0.0);
    CHECK(distanceOutside(simplex, std::vector{-0.5, 1.5, 1.0, 0.0}) == 0.25);
    CHECK(distanceOutside(simplex, std::vector{0.5, 0.5, 1.0, 1.0}) == 0.5);
    CHECK(distanceOutside(box, std::vector{-2.0, 2.0, -2.0, 0.0}) == 0.0);
    CHECK(distanceOutside(box, std::vector{1.0, -1.0, -2.0, 0.0}) == 0.5);
    CHECK(std::isinf(distanceOutside(box, std::vector{std::nan(""), 0.0, 0.0, 0.0})));
}

TEST_CASE("amplitude set: a wrong number of amplitudes is refused")
{
    CHECK_THROWS_AS(distanceOutside(simplex, std::vector{2.0}), std::invalid_argument);
    CHECK_THROWS_AS(distanceOutside(AmplitudeSet{}, std::vector<double>{}), std::invalid_argument);
}

TEST_CASE("amplitude set: draws are members, differ, and repeat with the seed")
{
    for (const AmplitudeSet& set : {simplex, box}) {
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
