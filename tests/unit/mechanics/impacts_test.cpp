#include "catch.hpp"
#include "force_history.hpp"
#include "signorini/simulation.hpp"
#include "spread.hpp"

using namespace signorini;

TEST_CASE("impacts: speed of approach and energy turned over of a block that hits the wall")
{
    // p = 0.8 reaches the tip for L/c: it moves with 1.6 and meets the wall after 0.625, which
    // pushes with 2 p until the block has passed.
    const Waves start{.crossing = 1.0, .a = {{1.0, 0.8}}, .b = {{1.0, 0.8}}};
    BarSimulation simulation(start, {});
    simulation.advance(1.5);
    REQUIRE(simulation.contacts().size() == 1);
    const ContactEvent& contact = simulation.contacts().front();
    CHECK(contact.start == Approx(0.625));
    CHECK(contact.end == Approx(1.0));
    CHECK(contact.speed == Approx(1.6));
    CHECK(contact.impulse == Approx(0.6));
    CHECK(contact.energy ==
          Approx(2.0 * 0.64 * 0.375));  // E/E_1 = 2 int p^2 dx of what is sent back
}

TEST_CASE("impacts: a bar that is pressed at the start came with no speed")
{
    const Stops pressed{.right = -1};
    BarSimulation simulation(wavesAtRest(1.0, pressed), {}, {}, {.stops = pressed});
    simulation.advance(3.0);
    CHECK(simulation.isHeld());
    CHECK(simulation.contacts().empty());
    CHECK(simulation.impulse() == Approx(3.0));
}

TEST_CASE("force history: means over steps keep the impulse of what is straight between points")
{
    const std::vector<ForcePoint> points{{0.25, 0.0}, {0.75, 2.0}, {2.0, 2.0}, {2.5, -1.0}};
    // Areas under the trapezes: 0 .. 0.5, 0.5 .. 1, ... by hand.
    const std::vector<double> means = meanForces(points, 0.5, 6);
    REQUIRE(means.size() == 6);
    CHECK(means[0] == Approx((0.25 * 0.5 * 1.0) / 0.5));
    CHECK(means[1] == Approx((0.25 * 1.5 + 0.25 * 2.0) / 0.5));
    CHECK(means[2] == Approx(2.0));
    CHECK(means[3] == Approx(2.0));
    CHECK(means[4] == Approx(0.5));
    CHECK(means[5] == 0.0);
    // Many points in one step: the impulse of all of them.
    double impulse = 0.0;
    for (const double mean : meanForces(points, 3.0, 2)) {
        impulse += 3.0 * mean;
    }
    CHECK(impulse == Approx(0.5 * 0.5 * 2.0 + 1.25 * 2.0 + 0.5 * 0.5));
    CHECK(meanForces({}, 1.0, 3) == std::vector<double>(3, 0.0));
}

TEST_CASE("spread: mean, ends, sum, and a histogram that counts each number once")
{
    const Spread spread = spreadOf(std::vector<double>{0.0, 1.0, 2.5, 4.0}, 4);
    CHECK(spread.count == 4);
    CHECK(spread.mean == Approx(1.875));
    CHECK(spread.least == 0.0);
    CHECK(spread.most == 4.0);
    CHECK(spread.total == Approx(7.5));
    CHECK(spread.histogram == std::vector<std::int64_t>{1, 1, 1, 1});
    CHECK(spreadOf(std::vector<double>{0.0, 0.0}, 3).histogram ==
          std::vector<std::int64_t>{2, 0, 0});
    CHECK(spreadOf({}).histogram.empty());
}
