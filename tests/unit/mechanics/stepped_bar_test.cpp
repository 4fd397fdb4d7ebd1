#include "stepped_bar.hpp"
#include "signorini/motion.hpp"
#include "stepped_waves.hpp"

#include <cmath>
#include <limits>
#include <random>

#include "catch.hpp"

using namespace signorini;

namespace {

State randomState(std::int64_t cells, std::mt19937_64& generator)
{
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    State state{Eigen::VectorXd(cells), Eigen::VectorXd(cells)};
    for (Eigen::Index k = 0; k < cells; ++k) {
        state.a[k] = value(generator);
        state.b[k] = value(generator);
    }
    return state;
}

}  // namespace

TEST_CASE("stepped bar: impedances are the fractions that were meant, without a common factor")
{
    CHECK(jointWeights(1.0, 1.3, 0.0) == JointWeights{10, 13, 23});
    CHECK(jointWeights(1.0, 1.0, 0.0) == JointWeights{1, 1, 2});
    CHECK(jointWeights(0.001, 1000.0, 0.5) == JointWeights{1, 1000000, 1000501});
    CHECK(jointWeights(1.0 / 3.0, 2.0 / 7.0, 0.0) == JointWeights{7, 6, 13});
    // No common denominator is small enough: 15 digits are kept.
    for (const double least : {1e-18, 1e-30, 1.3e-306}) {  // less than weights can say
        const JointWeights none = jointWeights(1.0, 1.3, least);
        CHECK(none.all == none.left + none.right);
    }
    const JointWeights rounded = jointWeights(std::sqrt(2.0), std::sqrt(3.0), std::sqrt(5.0));
    const auto left = static_cast<double>(rounded.left);
    CHECK(static_cast<double>(rounded.right) / left == Approx(std::sqrt(1.5)).epsilon(1e-14));
    CHECK(static_cast<double>(rounded.all - rounded.left - rounded.right) / left ==
          Approx(std::sqrt(2.5)).epsilon(1e-14));
}

TEST_CASE("stepped bar: with equal impedances a step is the echo of the uniform bar")
{
    std::mt19937_64 generator(1);
    const std::vector<Segment> parts{{.cells = 3}, {.cells = 1}, {.cells = 4}};
    const State start = randomState(8, generator);
    test::SteppedWaves waves(steppedBar(parts), start);
    test::UniformWaves line(start);
    for (int step = 0; step < 100; ++step) {
        const bool isHeld = generator() % 2 == 0;
        CHECK(waves.arriving() == Approx(line.arriving()).margin(1e-15));
        waves.step({.reflected = isHeld ? -1.0 : 1.0});
        isHeld ? line.contact() : line.free();
    }
    CHECK((waves.state().a - line.state().a).norm() < 1e-14);
    CHECK((waves.state().b - line.state().b).norm() < 1e-14);
}

TEST_CASE("stepped bar: what is lost of the energy is what the dashpots of the joints took")
{
    std::mt19937_64 generator(2);
    for (const double dashpot : {0.0, 0.7}) {
        const std::vector<Segment> parts{{.cells = 2, .impedance = 2.0, .dashpot = dashpot},
                                         {.cells = 3, .impedance = 2e3},
                                         {.cells = 1, .impedance = 0.02, .dashpot = 0.0}};
        const SteppedBar bar = steppedBar(parts);
        const State start = randomState(6, generator);
        test::SteppedWaves waves(bar, start);
        double taken = 0.0;
        for (int step = 0; step < 50; ++step) {
            taken += waves.step({.reflected = generator() % 2 == 0 ? -1.0 : 1.0});
        }
        const double before = energyRatio(start, bar.segments);
        CHECK((taken > 0.0) == (dashpot > 0.0));
        // E/E_1 = (2/N) sum Z (a^2 + b^2), each step loses d v^2.
        CHECK(energyRatio(waves.state(), bar.segments) + taken * 2.0 / 6.0 ==
              Approx(before).epsilon(1e-12));
    }
}

TEST_CASE("stepped bar: force and base do the work that the waves gain")
{
    std::mt19937_64 generator(3);
    const SteppedBar bar =
        steppedBar(std::vector<Segment>{{.cells = 2}, {.cells = 2, .impedance = 3.0}});
    const State start = randomState(4, generator);
    test::SteppedWaves waves(bar, start);
    const double force = 0.3;
    const double velocity = -0.2;
    double work = 0.0;
    for (int step = 0; step < 20; ++step) {
        const double p = waves.arriving();
        const double clamp = waves.state().b[0];
        const double v = 2.0 * p + force / 3.0;      // of the tip: p + q
        const double pull = velocity - 2.0 * clamp;  // a - b at the clamp, Z = 1
        work += force * v + pull * velocity;
        waves.step({.reflected = 1.0, .pulled = force / 3.0, .baseVelocity = velocity});
    }
    // The power of a wave of velocity a is Z a^2.
    CHECK(energyRatio(waves.state(), bar.segments) ==
          Approx(energyRatio(start, bar.segments) + 2.0 / 4.0 * work).epsilon(1e-12));
}

TEST_CASE("stepped bar: the scales are those of the first material with the same travel time")
{
    const Scene scene(Bar{.length = 3.0}, {}, {{.cells = 1}, {.cells = 1, .speed = 2.0}});
    CHECK(firstMaterial(scene).length == Approx(2.0).epsilon(1e-15));
    CHECK(firstMaterial(Scene(Bar{.length = 3.0})).length == 3.0);
    CHECK(isUniform(
        std::vector<Segment>{{.cells = 1, .impedance = 2.0}, {.cells = 5, .impedance = 2.0}}));
    CHECK_FALSE(isUniform(scene.segments));
    CHECK_FALSE(isUniform(std::vector<Segment>{{.cells = 1, .dashpot = 1.0}, {.cells = 5}}));
}

TEST_CASE("stepped bar: segments that cannot be are refused by name")
{
    CHECK_THROWS_WITH(steppedBar({}), containsText("number of segments = 0"));
    CHECK_THROWS_WITH(steppedBar(std::vector<Segment>{{.cells = 0}}),
                      containsText("cells of segment 1 = 0"));
    CHECK_THROWS_WITH(
        steppedBar(std::vector<Segment>{{.cells = 1}, {.cells = 1, .impedance = 1e10}}),
        containsText("impedance of segment 2 = 1e+10") || containsText("10000000000"));
    CHECK_THROWS_WITH(steppedBar(std::vector<Segment>{{.cells = 1, .dashpot = 1.0}}),
                      containsText("no joint follows"));
    CHECK_THROWS_WITH(test::SteppedWaves(steppedBar(std::vector<Segment>{{.cells = 2}}),
                                         State{Eigen::VectorXd::Zero(3), Eigen::VectorXd::Zero(3)}),
                      containsText("state: 3 and 3 cells"));
}
