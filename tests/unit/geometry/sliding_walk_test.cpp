// Walks through a sphere section against great circles, which have a closed form.

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "catch.hpp"
#include "points.hpp"
#include "sphere_section.hpp"

using namespace signorini;
using test::distance;
using test::squaresOf;

namespace {

/// The point at an angle on the great circle from z along a direction, on the sphere about equal
/// amplitudes of those that `moves` names; the others stay.
std::vector<double> onCircle(const std::vector<double>& z, std::vector<double> direction,
                             const std::vector<bool>& moves, double angle)
{
    const auto members = static_cast<double>(std::count(moves.begin(), moves.end(), true));
    double mean = 0.0;
    double sum = 0.0;
    for (std::size_t j = 0; j < z.size(); ++j) {
        mean += moves[j] ? z[j] / members : 0.0;
        sum += moves[j] ? direction[j] : 0.0;
    }
    double along = 0.0;
    double squares = 0.0;
    for (std::size_t j = 0; j < z.size(); ++j) {
        direction[j] = moves[j] ? direction[j] - sum / members : 0.0;
        along += moves[j] ? direction[j] * (z[j] - mean) : 0.0;
        squares += moves[j] ? (z[j] - mean) * (z[j] - mean) : 0.0;
    }
    double length = 0.0;
    for (std::size_t j = 0; j < z.size(); ++j) {
        direction[j] -= moves[j] ? along / squares * (z[j] - mean) : 0.0;
        length += direction[j] * direction[j];
    }
    std::vector<double> result = z;
    for (std::size_t j = 0; j < z.size(); ++j) {
        if (moves[j]) {
            result[j] = mean + std::cos(angle) * (z[j] - mean) +
                        std::sqrt(squares / length) * std::sin(angle) * direction[j];
        }
    }
    return result;
}

}  // namespace

TEST_CASE("sliding walk: whole turns and long strides come out where the circle does")
{
    const std::vector<double> start{0.5, 0.3, 0.2};
    const std::vector<double> direction{0.3, -1.0, 2.0};
    const double rho = squaresOf(start);
    const double radius = std::sqrt(rho - 1.0 / 3.0);
    for (const double angle : {0.2, 1.0, 2.0, 4.0, 13.0}) {
        SlidingWalk walk({3, rho}, start, direction);
        for (int stride = 1; stride <= 3; ++stride) {
            const std::vector<double>& z = walk.advance(angle * radius);
            CAPTURE(angle, stride);
            CHECK(distance(z, onCircle(start, direction, {true, true, true}, stride * angle)) <
                  1e-13);
        }
    }
}

TEST_CASE("sliding walk: a zero that is pushed down stays, one that is pushed up grows")
{
    for (std::size_t zero = 0; zero < 4; ++zero) {
        std::vector<double> start{0.4, 0.35, 0.25};
        start.insert(start.begin() + static_cast<std::ptrdiff_t>(zero), 0.0);
        const double rho = squaresOf(start);
        for (const double push : {-3.0, 3.0}) {
            std::vector<double> direction{0.2, 0.1, -0.4, 0.3};
            direction[zero] = push;
            std::vector<bool> moves(4, true);
            moves[zero] = push > 0.0;
            const double radius = std::sqrt(rho - (push > 0.0 ? 1.0 / 4.0 : 1.0 / 3.0));
            SlidingWalk walk({4, rho}, start, direction);
            for (int k = 1; k <= 4; ++k) {
                CAPTURE(zero, push, k);
                CHECK(distance(walk.advance(0.1 * radius),
                               onCircle(start, direction, moves, 0.1 * k)) < 1e-13);
            }
        }
    }
}

TEST_CASE("sliding walk: from equal amplitudes on a face it curves into the set")
{
    for (const std::vector<double>& start :
         {std::vector{0.5, 0.5, 0.0, 0.0}, std::vector{0.0, 0.0, 0.5, 0.5}}) {
        const std::vector<double> direction{1.0, -2.0, 4.0, 1.5};
        std::vector<double> along = direction;  // what the amplitudes that are not zero are told
        for (std::size_t j = 0; j < 4; ++j) {
            const double mean = start[0] > 0.0 ? -0.5 : 2.75;
            along[j] = start[j] > 0.0 ? direction[j] - mean : 0.0;
        }
        SlidingWalk walk({4, 0.5}, start, direction);
        for (int k = 1; k <= 4; ++k) {
            CAPTURE(start, k);
            CHECK(distance(walk.advance(0.05),
                           onCircle(start, along, std::vector<bool>(4, true), 0.1 * k)) < 1e-13);
        }
    }
}

TEST_CASE("sliding walk: it leaves equal amplitudes on a face whatever the direction is rounded to")
{
    std::mt19937_64 generator(4);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 1000; ++trial) {
        const std::size_t count = 3 + generator() % 6;
        const std::size_t members = 2 + generator() % (count - 2);
        std::vector<double> start(count, 0.0);
        std::fill_n(start.begin(), members, 1.0 / static_cast<double>(members));
        std::vector<double> direction(count);
        std::generate(direction.begin(), direction.end(), [&] { return normal(generator); });
        const double rho = 1.0 / static_cast<double>(members);
        SlidingWalk walk({static_cast<std::int64_t>(count), rho}, start, direction);
        CAPTURE(trial);
        REQUIRE(walk.canMove());
        const std::vector<double> z = walk.advance(1e-3);
        CHECK(std::abs(test::sumOf(z) - 1.0) < 1e-14);
        CHECK(std::abs(squaresOf(z) - rho) < 1e-14);
        CHECK(distance(z, start) > 1e-4);
    }
}

TEST_CASE("sliding walk: a start that misses the set by little is moved onto it")
{
    const std::vector<double> exact{0.4, 0.3, 0.2, 0.1};
    const double rho = squaresOf(exact);
    std::vector<double> start = exact;
    start[0] += 1e-8;
    start[2] += 2e-8;
    const std::vector<double> direction{1.0, 2.0, -1.0, 0.5};
    SlidingWalk walk({4, rho}, start, direction);
    const std::vector<double> z = walk.advance(0.0);
    CHECK(std::abs(test::sumOf(z) - 1.0) < 1e-15);
    CHECK(std::abs(squaresOf(z) - rho) < 1e-15);
    CHECK(distance(z, exact) < 1e-7);
}

TEST_CASE("sliding walk: it stands where the set is a point, or the direction says nothing")
{
    const std::vector<double> direction{1.0, -2.0, 0.5};
    CHECK_FALSE(SlidingWalk({3, 1.0}, std::vector{0.0, 1.0, 0.0}, direction).canMove());
    CHECK_FALSE(SlidingWalk({3, 1.0 / 3.0}, std::vector(3, 1.0 / 3.0), direction).canMove());
    const std::vector<double> start{0.5, 0.3, 0.2};
    CHECK_FALSE(SlidingWalk({3, 0.38}, start, std::vector(3, 2.0)).canMove());
    CHECK_THROWS_AS(SlidingWalk({4, 0.38}, start, direction), std::invalid_argument);
    CHECK_THROWS_AS(SlidingWalk({3, 0.38}, start, std::vector(4, 1.0)), std::invalid_argument);
}
