#include "signorini/figures.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "catch.hpp"

using namespace signorini;

namespace fs = std::filesystem;

namespace {

std::string draw(const FrequencyEnergyPlot& plot, const FrequencyEnergyOptions& options = {})
{
    const std::string path =
        (fs::temp_directory_path() / (std::to_string(getpid()) + "fep.svg")).string();
    drawFigure(frequencyEnergyFigure(plot, options), FigureFormat::svg, path);
    std::ifstream file(path, std::ios::binary);
    std::string content{std::istreambuf_iterator<char>(file), {}};
    fs::remove(path);
    return content;
}

}  // namespace

TEST_CASE("frequency-energy figure: axes, families and the paper's case are labelled")
{
    const std::vector<Mode> modes = findModes();
    const std::vector<EnergyBar> bars{{8.0 / 7.0, 4.0, 600.0, Contact::pressing},
                                      {1.0, 1.0, 2.0, Contact::grazing}};
    const std::string figure = draw({.modes = modes, .families = findFamilies(12), .bars = bars});
    for (const char* label : {"frequency", "energy", "main", "subharmonic", "higher", "twin",
                              "other", "paper", "graze", "several contacts", "order w ≤ 4<",
                              "order w ≤ 12<", "is the grid", "(3, 5, 1)", "(7, 12, 2)"}) {
        CHECK_THAT(figure, containsText(label));
    }
    // Another bar than the paper's has not its motion, but its hertz.
    const std::string steel =
        draw({.modes = modes}, {.bar = barOfMaterial(2.0, 210e9, 7800.0, 1e-4, 1e-5)});
    CHECK_THAT(steel, !containsText("paper") && containsText("[Hz]"));
}

TEST_CASE("frequency-energy figure: what is not there is not in the key")
{
    const std::string empty = draw({});
    CHECK_THAT(empty, containsText("paper") && !containsText("main") && !containsText("families") &&
                          !containsText("contacts"));
    const std::vector<Mode> modes = findModes({.maxOrder = 1});
    CHECK_THAT(draw({.modes = modes}), containsText("main") && !containsText("subharmonic"));
}

TEST_CASE("frequency-energy figure: families above the top or right of the edge are left out")
{
    FrequencyEnergyOptions options;
    options.maxEnergyRatio = 8.0;
    const std::string figure = draw({.families = findFamilies(12)}, options);
    CHECK_THAT(figure, !containsText("(3, 5, 1)") && containsText("(4, 7, 1)"));
    const std::vector<Family> one{findFamily(4, 7, 1).value()};
    CHECK(draw({.families = findFamilies(60)}).size() > draw({.families = one}).size());
    CHECK_THAT(draw({.onGrid = one}), containsText("on the grid"));
}

TEST_CASE("frequency-energy figure: 50,000 bars that overlap make a small file")
{
    std::vector<EnergyBar> bars;
    for (int k = 0; k < 50'000; ++k) {
        const double least = 1.0 + k / 5000.0;
        bars.push_back({1.0 + (k % 20) / 10.0, least, 2.0 * least,
                        k % 2 == 0 ? Contact::pressing : Contact::grazing});
    }
    bars.push_back({1.05, 3.0, std::numeric_limits<double>::infinity(), Contact::pressing});
    CHECK(draw({.bars = bars}).size() < 60'000);
}

TEST_CASE("frequency-energy figure: bars and options out of range are refused by name")
{
    const double infinity = std::numeric_limits<double>::infinity();
    for (const EnergyBar& bar :
         {EnergyBar{0.0, 1.0, 2.0, Contact::pressing}, EnergyBar{infinity, 1.0, 2.0, {}},
          EnergyBar{1.0, 2.0, 1.0, {}}, EnergyBar{1.0, 0.0, 1.0, {}}}) {
        CHECK_THROWS_WITH(draw({.bars = {&bar, 1}}), containsText("energy bar"));
    }
    FrequencyEnergyOptions options;
    options.maxEnergyRatio = 1.0;
    CHECK_THROWS_WITH(draw({}, options), containsText("maxEnergyRatio = 1"));
    options = {};
    options.maxFrequencyRatio = -1.0;
    CHECK_THROWS_WITH(draw({}, options), containsText("maxFrequencyRatio = -1"));
}
