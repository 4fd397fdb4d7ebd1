#include "signorini/figures.hpp"
#include "signorini/motion.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "catch.hpp"
#include "solver.hpp"

using namespace signorini;

namespace fs = std::filesystem;

namespace {

std::string temporary(const char* name)
{
    return (fs::temp_directory_path() / (std::to_string(getpid()) + name)).string();
}

std::string contentOf(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("figure: the ending of the name is the format, others are refused")
{
    CHECK(figureFormat("a.svg") == FigureFormat::svg);
    CHECK(figureFormat("b/a.png") == FigureFormat::png);
    CHECK(figureFormat("a.b.pdf") == FigureFormat::pdf);
    CHECK_THROWS_WITH(figureFormat("a.gif"), containsText("a.gif") && containsText(".svg"));
    CHECK_THROWS_AS(figureFormat("svg"), std::invalid_argument);
}

TEST_CASE("figure: each format is written, with labels and units in the vector ones")
{
    const PeriodicResult result = findPeriodic(5, 23, 8);
    struct Case {
        FigureFormat format;
        const char* start;
    };
    for (const Case& c : {Case{FigureFormat::svg, "<?xml"}, Case{FigureFormat::png, "\x89PNG"},
                          Case{FigureFormat::pdf, "%PDF"}}) {
        const std::string path = temporary("figure");
        drawFigure(motionFigure(result), c.format, path);
        const std::string content = contentOf(path);
        CHECK(content.starts_with(c.start));
        if (c.format == FigureFormat::svg) {
            for (const char* label :
                 {"position", "[m]", "time", "[s]", "displacement", "[mm]", "wall force", "[mN]",
                  "s(x, 0)", "v(x, 0)", "[mm/s]", "the wall presses", "L = 1 m"}) {
                CHECK_THAT(content, containsText(label));
            }
        }
        fs::remove(path);
    }
}

TEST_CASE("figure: axes are in the units of the bar, contact is where the wall presses")
{
    const auto drawn = [](const PeriodicResult& result) {
        const std::string path = temporary("units.svg");
        drawFigure(motionFigure(result), FigureFormat::svg, path);
        std::string content = contentOf(path);
        fs::remove(path);
        return content;
    };
    FindOptions steel;
    steel.scene = barOfMaterial(2.0, 210e9, 7800.0, 1e-4, 1e-5);
    CHECK_THAT(drawn(findPeriodic(150, 900, 300, steel)),
               containsText("[ms]") && containsText("[m]") && containsText("[µm]") &&
                   containsText("741.2 Hz") && containsText("c = 5.189 km/s"));
    CHECK_THAT(drawn(findPeriodic(2, 6, 2)), containsText("contact without force"));
    CHECK_THAT(drawn(findPeriodic({4, {{1, 12}, {3, 12}}})), containsText("wall force"));
}

TEST_CASE("figure: a continuum is drawn whatever its points are, down to one")
{
    const auto drawn = [](const Continuum& curve) {
        const std::string path = temporary("curve.svg");
        drawFigure(continuumFigure(curve), FigureFormat::svg, path);
        std::string content = contentOf(path);
        fs::remove(path);
        return content;
    };
    const Schedule schedule{12, {{6, 36}}};
    Continuum curve = traceContinuum(schedule, 8.0);
    REQUIRE(curve.points.size() > 10);
    CHECK_THAT(drawn(curve), containsText("force of the wall") && containsText("[mN]") &&
                                 containsText("s(x, 0)") && containsText("v(x, 0)") &&
                                 containsText("u(x, t)"));
    CHECK(continuumFigure(curve).panels.size() == 6);
    curve.points.resize(2);
    CHECK(continuumFigure(curve).panels.size() == 5);
    curve.points.resize(1);
    CHECK_THAT(drawn(curve), containsText("u(x, t)"));
    CHECK(continuumFigure(curve).panels.size() == 4);
    ContinuumOptions sample;
    sample.trace = trace::Sample{};
    sample.points = 5;
    CHECK_THAT(drawn(traceContinuum(schedule, 8.0, sample)), containsText("number"));
    curve.points.clear();
    CHECK_THROWS_AS(drawn(curve), std::invalid_argument);
}

TEST_CASE("figure: its data are the motion's, in the units that its axes name")
{
    const PeriodicResult result = findPeriodic(150, 900, 300);
    const FigureData figure = motionFigure(result);
    const Motion motion(result.motion->state, result.schedule);
    for (const plot::Panel& panel : figure.panels) {
        if (panel.name == "tip") {
            CHECK(panel.x.label == "tip  u(L, t)  [mm]");
            for (const plot::Series& series : panel.series) {
                if (series.kind == plot::Kind::line) {
                    CHECK(series.x.front() == Approx(motion.displacement(300, 0)));
                }
            }
        }
        if (panel.name == "strain") {  // a step less than a cell is wide is not there
            const std::vector<double>& s = panel.series.front().y;
            CHECK(*std::max_element(s.begin(), s.end()) ==
                  Approx(strain(result.motion->state).maxCoeff()));
        }
        for (const plot::Series& series : panel.series) {
            CHECK(series.x.size() == (series.kind == plot::Kind::image
                                          ? series.z.size() / series.y.size()
                                          : series.y.size()));
        }
    }
}

TEST_CASE("figure: without a motion there is nothing to draw")
{
    CHECK_THROWS_AS(
        drawFigure(motionFigure(findPeriodic(2, 4, 2)), FigureFormat::svg, temporary("none")),
        std::invalid_argument);
    CHECK_FALSE(fs::exists(temporary("none")));
}

TEST_CASE("figure: a missing gnuplot is named")
{
    const std::string path = std::getenv("PATH");
    setenv("PATH", "/nowhere", 1);
    CHECK_THROWS_WITH(
        drawFigure(motionFigure(findPeriodic(5, 23, 8)), FigureFormat::svg, temporary("none")),
        containsText("gnuplot"));
    setenv("PATH", path.c_str(), 1);
}
