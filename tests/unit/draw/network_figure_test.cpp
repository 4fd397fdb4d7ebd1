#include "catch.hpp"
#include "network_find.hpp"
#include "scene_figures.hpp"

using namespace signorini;

namespace {

/// Its series of these words, point by point.
const plot::Series& lineOf(const FigureData& figure, std::string_view words)
{
    for (const plot::Series& series : figure.panels.front().series) {
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
    const FigureData figure = periodFigure(network, *found.motion);
    REQUIRE(figure.panels.size() == 1);
    CHECK(*figure.panels.front().x.high == Approx(11.0 / 6.0));
    CHECK(figure.panels.front().x.label.find("[s]") != std::string::npos);
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

    NetworkClaim other = *found.motion;
    other.schedule.back().steps += 1;  // not its period
    CHECK_THROWS_AS(periodFigure(network, other), std::runtime_error);
}
