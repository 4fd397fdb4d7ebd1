#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <string>
#include <string_view>

#include "catch.hpp"
#include "folder.hpp"
#include "signorini/atlas_database.hpp"
#include "signorini/figures.hpp"

using namespace signorini;
using test::Folder;

namespace fs = std::filesystem;

namespace {

AtlasRange twoBars()
{
    AtlasRange range;
    range.cells = 12;
    range.maxContact = 8;
    range.maxFree = 30;
    range.bars = Assembly{.parts = partsOf("clamp 6 stop=1e-3 gap=2e-3 6 clamp")};
    return range;
}

const plot::Series* named(const plot::Panel& panel, std::string_view legend)
{
    const auto at =
        std::find_if(panel.series.begin(), panel.series.end(),
                     [legend](const plot::Series& series) { return series.legend == legend; });
    return at == panel.series.end() ? nullptr : &*at;
}

}  // namespace

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

TEST_CASE("atlas figures: bars in a row have a map for each contact")
{
    const Folder folder;
    AtlasDatabase database = AtlasDatabase::create(folder.file("a.sqlite"));
    const AtlasRun run = buildAtlas(database, twoBars());
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
    CHECK_THAT(figure.title, containsText("clamp 6 stop=0.001 gap=0.002 6 clamp,  N = 12"));
}

TEST_CASE("atlas figures: of bars in a row the plot has a dot where each schedule is")
{
    const Folder folder;
    AtlasDatabase database = AtlasDatabase::create(folder.file("a.sqlite"));
    (void)buildAtlas(database, twoBars());
    const FigureData figure = frequencyEnergyFigure(database, 12);
    drawFigure(figure, FigureFormat::svg, folder.file("plot.svg"));
    CHECK(fs::file_size(folder.file("plot.svg")) > 2000);
    REQUIRE(figure.panels.size() == 1);
    const plot::Panel& panel = figure.panels[0];
    CHECK(panel.y.label == "least energy  E_{min}/E_1");
    REQUIRE(panel.x.other);
    CHECK(panel.x.other->factor == Approx(0.5));  // each bar is L/2 long: c/(4 L/2) = 0.5 Hz
    std::size_t rows = 0;
    std::set<const double*> hit;
    database.forEachFound({}, [&](const AtlasEntry& entry) {
        const bool isPressing = entry.row.contact == Contact::pressing;
        const int contact = static_cast<int>(entry.schedule.phases[0].stop) + 1;
        const plot::Series* series =
            named(panel, isPressing ? fmt::format("contact {} presses", contact)
                                    : std::string("grazing: contact without force"));
        REQUIRE(series != nullptr);
        bool isThere = false;
        for (std::size_t k = 0; k < series->x.size(); ++k) {
            // T = n/12 s, omega_1 = 0.5 Hz.
            if (series->x[k] == Approx(24.0 / static_cast<double>(entry.row.steps)) &&
                series->y[k] == Approx(entry.row.energy.least).epsilon(1e-3)) {
                isThere = true;
                hit.insert(&series->x[k]);
            }
        }
        CHECK(isThere);
        ++rows;
    });
    std::size_t dots = 0;
    for (const plot::Series& series : panel.series) {
        dots += series.x.size();
    }
    CHECK(rows > 40);
    CHECK(dots == hit.size());
    CHECK(figure.panels[0].y.low < 1.44);  // the least that presses: 24/23 of 6 steps, 1.44 E_1
}

TEST_CASE("atlas figures: segments have neither families nor their names")
{
    const Folder folder;
    AtlasDatabase database = AtlasDatabase::create(folder.file("a.sqlite"));
    AtlasRange range = usualRange(8);
    range.segments = {{.cells = 4}, {.cells = 4, .impedance = 1.3}};
    const AtlasRun run = buildAtlas(database, range);
    const FigureData map = existenceFigure(database, {});
    for (const plot::Series& series : map.panels.at(0).series) {
        CHECK(series.words.empty());
        CHECK_THAT(series.legend, !containsText("famil"));
    }
    const FigureData figure = frequencyEnergyFigure(database, {});
    CHECK_THAT(figure.title, containsText("segments 4:1:1:0,4:1.3:1:0,  N = 8"));
    const plot::Series* pressing = named(figure.panels.at(0), "pressing");
    REQUIRE(pressing != nullptr);
    CHECK(run.tally.pressing > 0);
    CHECK(static_cast<std::int64_t>(pressing->x.size()) <= run.tally.pressing);
    CHECK(named(figure.panels[0], "families on the grid") == nullptr);
    // Ends that are given cut.
    const FigureData cut = frequencyEnergyFigure(database, {}, {.maxFrequencyRatio = 1.2});
    for (const plot::Series& series : cut.panels[0].series) {
        for (const double x : series.x) {
            CHECK(x <= 1.2);
        }
    }
    CHECK(cut.panels[0].x.high == 1.2);
    CHECK_THROWS_WITH(frequencyEnergyFigure(database, {}, {.maxFrequencyRatio = 0.0}),
                      containsText("maxFrequencyRatio = 0"));
}

TEST_CASE("atlas figures: without an E_1 in joules, and what is undecided is no dot of the plot")
{
    const Folder folder;
    AtlasDatabase database = AtlasDatabase::create(folder.file("a.sqlite"));
    AtlasRange range;
    range.cells = 8;
    range.maxContact = 4;
    range.maxFree = 20;
    range.bars = Assembly{.parts = partsOf("clamp 4 stop=0 gap=1e-3 4 clamp")};
    const AtlasRun run = buildAtlas(database, range);
    REQUIRE(run.tally.undecided > 0);
    REQUIRE(run.tally.grazing > 0);
    const FigureData figure = frequencyEnergyFigure(database, {});
    CHECK(figure.panels.at(0).y.label == "least energy  E_{min}  [µJ]");
    CHECK_THAT(figure.title, containsText(fmt::format("{} undecided", run.tally.undecided)));
    const plot::Series* grazing = named(figure.panels[0], "grazing: contact without force");
    REQUIRE(grazing != nullptr);
    double least = std::numeric_limits<double>::infinity();
    database.forEachFound(
        {}, [&least](const AtlasEntry& entry) { least = std::min(least, entry.row.energy.least); });
    CHECK(*std::min_element(grazing->y.begin(), grazing->y.end()) == Approx(1e6 * least));
    CHECK_THROWS_WITH(frequencyEnergyFigure(database, {}, {.maxEnergyRatio = 9.0}),
                      containsText("allowed"));
    // Of the map they are crosses, one each.
    std::size_t crosses = 0;
    for (const plot::Panel& panel : existenceFigure(database, {}).panels) {
        for (const plot::Series& series : panel.series) {
            crosses += series.marker == plot::Marker::cross ? series.x.size() : 0;
        }
    }
    CHECK(static_cast<std::int64_t>(crosses) == run.tally.undecided);
}

TEST_CASE("atlas figures: bars that may rest have motions from no energy on, at the lower edge")
{
    const Folder folder;
    AtlasDatabase database = AtlasDatabase::create(folder.file("a.sqlite"));
    AtlasRange range;
    range.cells = 4;
    range.maxContact = 3;
    range.maxFree = 5;
    range.maxPhases = 2;
    range.bars = Assembly{.parts = partsOf("stop=1e-3 4 stop=1e-3")};
    (void)buildAtlas(database, range);
    const FigureData figure = frequencyEnergyFigure(database, {});
    const plot::Panel& panel = figure.panels.at(0);
    const plot::Series* rest = named(panel, "motions from E = 0 on, at the lower edge");
    REQUIRE(rest != nullptr);
    CHECK(std::all_of(rest->y.begin(), rest->y.end(),
                      [&panel](double y) { return y == *panel.y.low; }));
    CHECK(panel.y.low == 0.0);
    REQUIRE(panel.y.ticks.size() == 1);
    CHECK(panel.y.ticks[0].text == "0");
    drawFigure(figure, FigureFormat::svg, folder.file("plot.svg"));
    CHECK(fs::file_size(folder.file("plot.svg")) > 1000);
}

TEST_CASE("atlas figures: the plot of a uniform bar is that of a gap > 0 and one stop")
{
    const Folder folder;
    AtlasDatabase database = AtlasDatabase::create(folder.file("a.sqlite"));
    AtlasRange range = usualRange(4);
    range.gapSign = -1;
    (void)buildAtlas(database, range);
    CHECK_THROWS_WITH(frequencyEnergyFigure(database, {}), containsText("allowed"));
}
