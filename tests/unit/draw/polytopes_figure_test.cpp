#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "catch.hpp"
#include "signorini/figures.hpp"

using namespace signorini;

namespace fs = std::filesystem;

namespace {

std::string draw(std::int64_t phases, std::int64_t order, double maxEnergyRatio)
{
    const std::string path =
        (fs::temp_directory_path() / (std::to_string(getpid()) + "polytopes.svg")).string();
    ModeBounds bounds;
    bounds.maxOrder = order;
    bounds.maxPeriod = 40.0;
    FrequencyEnergyOptions options;
    options.maxEnergyRatio = maxEnergyRatio;
    drawFigure(polytopesFigure(findPolytopes(phases, bounds), options), FigureFormat::svg, path);
    std::ifstream file(path, std::ios::binary);
    std::string content{std::istreambuf_iterator<char>(file), {}};
    fs::remove(path);
    return content;
}

}  // namespace

TEST_CASE("polytopes figure: polygons, isolated motions and modes of one contact are told apart")
{
    const std::string figure = draw(2, 5, 100.0);
    for (const char* label :
         {"first contact", "period", "frequency", "energy", "contact shared freely",
          "isolated at each T", "one contact, 2 times", "2 contacts: isolated", "8 − 3T"}) {
        CHECK_THAT(figure, containsText(label));
    }
    CHECK_THAT(draw(3, 5, 100.0), containsText("3 contacts: isolated"));
}

TEST_CASE("polytopes figure: nothing to draw and a top below E_1 are refused")
{
    CHECK_THROWS_WITH(draw(2, 1, 100.0), containsText("no motion"));
    CHECK_THROWS_WITH(draw(2, 3, 0.5), containsText("maxEnergyRatio = 0.5"));
}
