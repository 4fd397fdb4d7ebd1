#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "catch.hpp"
#include "signorini/atlas_database.hpp"
#include "signorini/figures.hpp"

using namespace signorini;

namespace {

namespace fs = std::filesystem;

/// A folder for one test.
class Folder {
public:
    Folder()
        : path_(fs::temp_directory_path() / ("signorini-atlas-figure-" + std::to_string(getpid())))
    {
        fs::remove_all(path_);
        fs::create_directories(path_);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() { fs::remove_all(path_); }
    [[nodiscard]] std::string file(const char* name) const { return (path_ / name).string(); }

private:
    fs::path path_;
};

}  // namespace

TEST_CASE("atlas figures: both are drawn, of an empty atlas, too")
{
    const Folder folder;
    AtlasDatabase database = AtlasDatabase::create(folder.file("a.sqlite"));
    drawExistenceMap(database, {}, FigureFormat::svg, folder.file("none.svg"));
    CHECK(fs::file_size(folder.file("none.svg")) > 1000);
    (void)buildAtlas(database, usualRange(12));
    drawExistenceMap(database, 12, FigureFormat::svg, folder.file("map.svg"));
    drawFrequencyEnergyPlot(database, 12, FigureFormat::svg, folder.file("plot.svg"));
    std::ifstream map(folder.file("map.svg"));
    const std::string text{std::istreambuf_iterator<char>(map), {}};
    CHECK_THAT(text, containsText("contact time"));
    CHECK(fs::file_size(folder.file("plot.svg")) > 2000);
}
