#include <filesystem>
#include <fstream>

#include "catch.hpp"
#include "folder.hpp"
#include "signorini/atlas_database.hpp"
#include "signorini/figures.hpp"

using namespace signorini;
using test::Folder;

namespace fs = std::filesystem;

TEST_CASE("atlas figures: both are drawn, of an empty atlas, too")
{
    const Folder folder;
    AtlasDatabase database = AtlasDatabase::create(folder.file("a.sqlite"));
    drawFigure(existenceFigure(database, {}), FigureFormat::svg, folder.file("none.svg"));
    CHECK(fs::file_size(folder.file("none.svg")) > 1000);
    (void)buildAtlas(database, usualRange(12));
    drawFigure(existenceFigure(database, 12), FigureFormat::svg, folder.file("map.svg"));
    drawFigure(frequencyEnergyFigure(database, 12), FigureFormat::svg, folder.file("plot.svg"));
    std::ifstream map(folder.file("map.svg"));
    const std::string text{std::istreambuf_iterator<char>(map), {}};
    CHECK_THAT(text, containsText("contact time"));
    CHECK(fs::file_size(folder.file("plot.svg")) > 2000);
}

TEST_CASE("atlas figures: bars in a row have a map for each contact, and no frequency-energy plot")
{
    const Folder folder;
    AtlasDatabase database = AtlasDatabase::create(folder.file("a.sqlite"));
    AtlasRange range;
    range.cells = 12;
    range.maxContact = 8;
    range.maxFree = 30;
    range.bars = Assembly{.parts = partsOf("clamp 6 stop=1e-3 gap=2e-3 6 clamp")};
    const AtlasRun run = buildAtlas(database, range);
    const FigureData figure = existenceFigure(database, {});
    REQUIRE(figure.panels.size() == 2);
    std::size_t dots = 0;
    for (const plot::Panel& panel : figure.panels) {
        for (const plot::Series& series : panel.series) {
            dots += series.x.size();
        }
    }
    CHECK(static_cast<std::int64_t>(dots) == run.tally.pressing + run.tally.grazing);
    CHECK(figure.panels[0].colour.label == "least energy  E_{min}/E_1");
    CHECK_THROWS_WITH(frequencyEnergyFigure(database, 12), containsText("allowed"));
}
