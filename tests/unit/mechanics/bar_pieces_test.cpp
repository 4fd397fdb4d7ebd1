// A bar as a drawing has it, on cells that a wave crosses in one time each.

#include "signorini/bar_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "catch.hpp"
#include "network.hpp"

using namespace signorini;

namespace {

double travelTime(const BarPiece& piece)
{
    return piece.length * std::sqrt(piece.density / piece.young);
}

double impedanceOf(const BarPiece& piece)
{
    return piece.area * std::sqrt(piece.density * piece.young);
}

/// tan(w t_1) tan(w t_2) = Z_1/Z_2: the first frequency [Hz] of two pieces, clamped and free.
double firstFrequency(const BarPiece& one, const BarPiece& two)
{
    const double ratio = impedanceOf(one) / impedanceOf(two);
    double low = 0.0;
    double high = 0.5 * std::numbers::pi / std::max(travelTime(one), travelTime(two));
    for (int k = 0; k < 200; ++k) {
        const double w = 0.5 * (low + high);
        const bool isBelow = std::tan(w * travelTime(one)) * std::tan(w * travelTime(two)) < ratio;
        (isBelow ? low : high) = w;
    }
    return low / (2.0 * std::numbers::pi);
}

const BarPiece steel{.length = 1.2, .young = 210e9, .density = 7850.0, .area = 3.1e-4};
const BarPiece copper{.length = 0.7, .young = 120e9, .density = 8900.0, .area = 7.1e-4};

}  // namespace

TEST_CASE("bar pieces: the first frequency of steel and copper is that of their equation")
{
    const PiecedBar made = barOfPieces(std::vector{steel, copper}, 1e-4);
    CHECK(made.cells <= 300);
    CHECK(made.rounding < 1e-4);
    CHECK(made.scene.bar.gap == 1e-4);
    CHECK_FALSE(made.scene.bar.young);  // there are two
    CHECK(made.scene.bar.length == Approx(1.9).epsilon(made.rounding));
    const Network network = networkOf(made.scene, made.cells, {});
    const double frequency = referenceOf(network).frequency / (2.0 * std::numbers::pi);
    CHECK(frequency == Approx(firstFrequency(steel, copper)).epsilon(2.0 * made.rounding));
    // Its stiffness: l_1/(E_1 A_1) + l_2/(E_2 A_2), as the energy of the least deflection has it.
    const double compliance =
        steel.length / (steel.young * steel.area) + copper.length / (copper.young * copper.area);
    CHECK(staticForce(barOfPieces(std::vector{steel, copper}, -1e-4).scene) ==
          Approx(1e-4 / compliance).epsilon(2.0 * made.rounding));
}

TEST_CASE("bar pieces: whole ratios are met exactly on the finest grid, one piece is uniform")
{
    BarPiece longer = steel;
    longer.length = 1.8;
    longer.area = 2.0 * steel.area;
    const PiecedBar made = barOfPieces(std::vector{steel, longer}, 1e-3, 299);
    CHECK(made.cells == 295);
    CHECK(made.rounding < 1e-12);
    CHECK(made.scene.segments == std::vector<Segment>{{118, 1.0, 1.0}, {177, 2.0, 1.0}});
    CHECK(made.scene.bar.length == Approx(3.0));
    CHECK(made.scene.bar.young == 210e9);
    const PiecedBar one = barOfPieces(std::vector{steel});
    CHECK(one.scene == Scene(barOfMaterial(1.2, 210e9, 7850.0, 3.1e-4, 1e-3)));
    CHECK(one.cells == 300);
}

TEST_CASE("bar pieces: no other cells of two pieces round less")
{
    std::mt19937_64 generator(20261124);
    std::uniform_real_distribution<double> power(-1.0, 1.0);
    for (int trial = 0; trial < 200; ++trial) {
        BarPiece other = copper;
        other.length *= std::pow(10.0, power(generator));
        const std::int64_t most = 2 + trial % 60;
        const PiecedBar made = barOfPieces(std::vector{steel, other}, 1e-3, most);
        const double share = travelTime(steel) / (travelTime(steel) + travelTime(other));
        double least = 1e300;
        for (std::int64_t n = 1; n < most; ++n) {
            for (std::int64_t m = 1; n + m <= most; ++m) {
                const double part = static_cast<double>(n) / static_cast<double>(n + m);
                least = std::min(least, std::max(std::abs(part / share - 1.0),
                                                 std::abs((1.0 - part) / (1.0 - share) - 1.0)));
            }
        }
        INFO(trial);
        CHECK(made.rounding == Approx(least).margin(1e-11));
        CHECK(made.cells <= most);
        const Segment& first = made.scene.segments.front();
        CHECK(std::max(std::abs(static_cast<double>(first.cells) / static_cast<double>(made.cells) /
                                    share -
                                1.0),
                       0.0) <= made.rounding + 1e-12);
        CHECK(made.scene.segments.back().impedance ==
              Approx(impedanceOf(other) / impedanceOf(steel)));
    }
}

TEST_CASE("bar pieces: what is no bar is refused by piece and value")
{
    CHECK_THROWS_WITH(barOfPieces({}), containsText("pieces = 0"));
    BarPiece bad = steel;
    bad.density = -1.0;
    CHECK_THROWS_WITH(barOfPieces(std::vector{steel, bad}),
                      containsText("density of piece 2 = -1") && containsText("[kg/m^3]"));
    CHECK_THROWS_WITH(barOfPieces(std::vector{steel, copper}, 1e-3, 1),
                      containsText("cells = 1") && containsText("2.."));
    CHECK_THROWS_WITH(barOfPieces(std::vector{steel}, NAN), containsText("gap"));
}
