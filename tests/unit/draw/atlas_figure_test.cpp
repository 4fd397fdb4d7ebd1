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
