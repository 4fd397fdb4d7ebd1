#include "bar_check.hpp"
#include "catch.hpp"
#include "network_find.hpp"
#include "scene_figures.hpp"
#include "signorini/motion.hpp"

using namespace signorini;

namespace {

/// Its series of these words, point by point.
const plot::Series& lineOf(const FigureData& figure, std::string_view words)
{
    for (const plot::Series& series : figure.panels.back().series) {
        if (series.legend == words) {
            return series;
        }
    }
    throw std::invalid_argument("no such line");
}

}  // namespace

// A string of length 1 with a stop at its middle, 1 mm away, six cells of 1/6 s: contact for one
// step. The waves are square, so the middle moves at 3 mm/s between its turns: 1 mm while in
// contact, -1.5 mm halfway through the rest of the 11/6 s.
TEST_CASE("scene figures: a motion that is found is drawn over its period, contact marked")
{
    const Network network = networkOf({.parts = partsOf("clamp 3 stop=1e-3 3 clamp")});
    const LeastMotion found = leastMotion(network, {{1, 1}, {0, 10}}, 1e9);
    REQUIRE(found.motion);
    const FigureData figure = periodFigure(network, *found.motion, 1.0);
    REQUIRE(figure.panels.size() == 2);
    CHECK(*figure.panels.back().x.high == Approx(11.0 / 6.0));
    CHECK(figure.panels.back().x.label.find("[s]") != std::string::npos);
    const plot::Series& face = lineOf(figure, "face");
    for (std::size_t k = 0; k < face.x.size(); ++k) {
        const double t = face.x[k];
        const double place = t < 1.0 / 6.0 ? 1.0 : t < 1.0 ? 1.5 - 3.0 * t : 3.0 * t - 4.5;
        CHECK(face.y[k] == Approx(place).margin(1e-9));
    }
    CHECK(face.y.front() == Approx(face.y.back()).epsilon(1e-9));
    const plot::Series& pressed = lineOf(figure, "in contact");
    CHECK(pressed.x.front() == 0.0);
    CHECK(pressed.x[pressed.x.size() - 2] == Approx(1.0 / 6.0));  // the last is the break

    // u(x, t) is that face in the middle, 0 at the clamps, and the same seen from either end.
    const plot::Series& field = figure.panels.front().series.front();
    const std::size_t instants = field.x.size();
    REQUIRE(field.z.size() == field.y.size() * instants);
    for (std::size_t m = 0; m < instants; ++m) {
        const double t = field.x[m];
        const double place = t < 1.0 / 6.0 ? 1.0 : t < 1.0 ? 1.5 - 3.0 * t : 3.0 * t - 4.5;
        const auto u = [&](std::size_t i) { return field.z[i * instants + m]; };
        CHECK(0.5 * (u(119) + u(120)) == Approx(place).margin(0.1));  // means over cells
        CHECK(std::abs(u(0)) < 0.02);
        for (std::size_t i = 0; i < field.y.size(); ++i) {
            CHECK(u(i) == Approx(u(field.y.size() - 1 - i)).margin(1e-9));
        }
    }

    NetworkClaim other = *found.motion;
    other.schedule.back().steps += 1;  // not its period
    CHECK_THROWS_AS(periodFigure(network, other, 1.0), std::runtime_error);
}

TEST_CASE("scene figures: a bar moves alike in pictures by its waves and by a simulation")
{
    const PeriodicResult found = findPeriodic(15, 90, 30);
    const Network network = networkOf(found.scene, 30);
    const NetworkClaim claim = claimOf(network, found.motion->state, found.schedule, {});
    const Motion motion(found.motion->state, found.schedule);
    const auto waves = motionFrames(MotionSamples(motion, found.scene), 7);
    const auto simulated = barsFrames({.parts = partsOf("clamp 30 stop=1e-3")}, network,
                                      shownPeriod(network, claim), 7);
    REQUIRE(waves.size() == 7);
    REQUIRE(simulated.size() == 7);
    for (std::size_t k = 0; k < waves.size(); ++k) {
        CHECK(waves[k].title == simulated[k].title);
        const plot::Series& u = waves[k].panels[1].series.back();
        const plot::Series& other = simulated[k].panels[1].series.back();
        REQUIRE(u.x.size() == 32);  // and the break behind them
        REQUIRE(other.x.size() == 32);
        for (std::size_t i = 0; i + 1 < u.x.size(); ++i) {
            CHECK(other.x[i] == Approx(u.x[i]).margin(1e-9));
            CHECK(other.y[i] == Approx(u.y[i]).margin(1e-9));
        }
    }
    // The least energy is 4 E_1: |s| = 2 g/L in the part that presses, drawn from the clamp on.
    const plot::Series& strain = waves.front().panels[2].series.front();
    CHECK(waves.front().panels[2].y.label == "s,  v/c  [10^{-3}]");
    CHECK(std::abs(strain.y.front()) == Approx(2.0));
}
