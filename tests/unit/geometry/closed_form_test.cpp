#include "signorini/amplitude_set.hpp"

#include <random>

#include "catch.hpp"

using namespace signorini;

namespace {

double squares(const std::vector<double>& z)
{
    double sum = 0.0;
    for (const double value : z) {
        sum += value * value;
    }
    return sum;
}

/// The largest sum of squares over all corners of a box, one by one.
double mostOverCorners(const AmplitudeSet& box)
{
    double most = 0.0;
    const auto inner = static_cast<unsigned>(box.count - 1);
    for (unsigned corner = 0; corner < (1U << inner); ++corner) {
        double previous = 0.0;
        double sum = 0.0;
        for (unsigned j = 0; j <= inner; ++j) {
            const double next = j == inner                  ? box.sum
                                : ((corner >> j) & 1U) != 0 ? box.upper
                                                            : box.lower;
            sum += (next - previous) * (next - previous);
            previous = next;
        }
        most = std::max(most, sum);
    }
    return most;
}

}  // namespace

TEST_CASE("closed form: on a simplex least is S^2/d at the centre, most S^2 at a vertex")
{
    const AmplitudeSet set{SetKind::simplex, 5, 10.0, 0.0, 0.0};
    CHECK(leastSquares(set) == 20.0);
    CHECK(mostSquares(set) == 100.0);
    CHECK(squares(leastAmplitudes(set)) == Approx(20.0));
    CHECK(squares(mostAmplitudes(set)) == 100.0);
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
            CHECK(squares(mostAmplitudes(box)) == Approx(mostSquares(box)).epsilon(1e-13));
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
            const double drawn = squares(drawAmplitudes(set, generator));
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
