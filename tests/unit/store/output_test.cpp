#include "signorini/output.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "catch.hpp"
#include "folder.hpp"
#include "signorini/modes.hpp"
#include "signorini/one_phase_set.hpp"
#include "support.hpp"

using namespace signorini;
using test::Folder;
using test::onePhase;

namespace fs = std::filesystem;

namespace {

std::string contentOf(const std::string& path)
{
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

void writeText(const std::string& path, const std::string& text)
{
    TextFile file(path);
    file.write(text);
    file.close();
}

std::vector<std::vector<double>> rowsOf(const std::string& csv)
{
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    std::vector<std::vector<double>> rows;
    while (std::getline(lines, line)) {
        std::istringstream cells(line);
        std::string cell;
        rows.emplace_back();
        while (std::getline(cells, cell, ',')) {
            rows.back().push_back(std::stod(cell));
        }
    }
    return rows;
}

}  // namespace

TEST_CASE("output: files appear together at commit, and not at all without it")
{
    const Folder folder;
    {
        OutputFiles files;
        writeText(files.stage(folder.file("a.txt")), "one");
        CHECK_FALSE(fs::exists(folder.file("a.txt")));
    }
    CHECK(folder.files() == 0);
    OutputFiles files;
    writeText(files.stage(folder.file("a.txt")), "one");
    writeText(files.stage(folder.file("b.txt")), "two");
    files.commit();
    CHECK(contentOf(folder.file("a.txt")) == "one");
    CHECK(contentOf(folder.file("b.txt")) == "two");
    CHECK(folder.files() == 2);
}

TEST_CASE("output: an existing file stays until the new one is complete")
{
    const Folder folder;
    writeText(folder.file("a.txt"), "old");
    {
        OutputFiles files;
        writeText(files.stage(folder.file("a.txt")), "half");
    }
    CHECK(contentOf(folder.file("a.txt")) == "old");
    OutputFiles files;
    writeText(files.stage(folder.file("a.txt")), "new");
    files.commit();
    CHECK(contentOf(folder.file("a.txt")) == "new");
}

TEST_CASE("output: when one file cannot be put into place, those before it are put back")
{
    const Folder folder;
    writeText(folder.file("old.txt"), "old");
    writeText(folder.file("kept.txt"), "kept");
    {
        OutputFiles files;
        writeText(files.stage(folder.file("new.txt")), "new");
        writeText(files.stage(folder.file("old.txt")), "newer");
        writeText(files.stage(folder.file("bad.txt"), "--option bad.txt"), "never");
        writeText(files.stage(folder.file("kept.txt")), "newer");
        fs::create_directory(folder.file("bad.txt"));  // what renaming cannot replace
        CHECK_THROWS_WITH(files.commit(), containsText("--option bad.txt: cannot replace"));
    }
    CHECK(contentOf(folder.file("old.txt")) == "old");
    CHECK(contentOf(folder.file("kept.txt")) == "kept");
    CHECK(fs::is_directory(folder.file("bad.txt")));
    CHECK(fs::hard_link_count(folder.file("old.txt")) == 1);
    CHECK(folder.files() == 3);
}

TEST_CASE("output: when the last file cannot be put into place, those before it are put back")
{
    const Folder folder;
    writeText(folder.file("old.txt"), "old");
    {
        OutputFiles files;
        writeText(files.stage(folder.file("new.txt")), "new");
        writeText(files.stage(folder.file("old.txt")), "newer");
        writeText(files.stage(folder.file("bad.txt")), "never");
        fs::create_directory(folder.file("bad.txt"));
        CHECK_THROWS_AS(files.commit(), FileError);
    }
    CHECK(contentOf(folder.file("old.txt")) == "old");
    CHECK(folder.files() == 2);
}

TEST_CASE("output: nothing is in place before a device has taken all of its content")
{
    if (!fs::exists("/dev/full")) {
        return;
    }
    const Folder folder;
    writeText(folder.file("old.txt"), "old");
    {
        OutputFiles files;
        writeText(files.stage("/dev/full", "--full"), "text");
        writeText(files.stage(folder.file("old.txt")), "newer");
        writeText(files.stage(folder.file("new.txt")), "new");
        CHECK_THROWS_WITH(files.commit(), containsText("--full: cannot write: No space left"));
    }
    CHECK(contentOf(folder.file("old.txt")) == "old");
    CHECK(folder.files() == 1);
}

TEST_CASE("output: two names are one file when links lead there, even to what is not there yet")
{
    const Folder folder;
    fs::create_directories(folder.file("deep/sub"));
    fs::create_directory_symlink("deep/sub", folder.file("linked"));
    fs::create_symlink("new.txt", folder.file("dangling.txt"));
    fs::create_symlink("dangling.txt", folder.file("twice.txt"));
    fs::create_symlink("loop.txt", folder.file("loop.txt"));
    writeText(folder.file("one.txt"), "one");
    fs::create_hard_link(folder.file("one.txt"), folder.file("hard.txt"));
    const auto same = [&](const char* one, const char* two) {
        return isSameOutput(folder.file(one), folder.file(two));
    };
    CHECK(same("new.txt", "dangling.txt"));
    CHECK(same("twice.txt", "new.txt"));
    CHECK(same("linked/a.txt", "deep/sub/a.txt"));
    CHECK(same("linked/../a.txt", "deep/a.txt"));
    CHECK(same("one.txt", "hard.txt"));
    CHECK_FALSE(same("linked/../a.txt", "a.txt"));
    CHECK_FALSE(same("new.txt", "one.txt"));
    CHECK_FALSE(same("deep/new.txt", "new.txt"));
    CHECK_THROWS_WITH(outputPlace(folder.file("loop.txt")), containsText("symbolic links"));
    CHECK_THROWS_AS(outputPlace(folder.file("no/a.txt")), FileError);
    CHECK_THROWS_AS(outputPlace(folder.file(std::string(300, 'x').c_str())), FileError);
}

TEST_CASE("output: what cannot be written is reported with its reason")
{
    const Folder folder;
    OutputFiles files;
    CHECK_THROWS_WITH(files.stage("/no/such/folder/x.csv"), containsText("No such file"));
    CHECK_THROWS_WITH(files.stage(fs::temp_directory_path().string()),
                      containsText("is a directory"));
    CHECK_THROWS_AS(TextFile("/no/such/folder/x.csv"), FileError);
}

TEST_CASE("output: a full disk is an error, not a short file")
{
    if (!fs::exists("/dev/full")) {
        return;
    }
    CHECK_THROWS_WITH(writeText("/dev/full", "text"), containsText("No space left"));
    OutputFiles files;
    writeText(files.stage("/dev/full"), "text");
    CHECK_THROWS_AS(files.commit(), FileError);
}

TEST_CASE("output: the state file holds SI values that read back exactly")
{
    const Folder folder;
    const Bar steel = barOfMaterial(2.0, 210e9, 7800.0, 1e-4, 1e-6);
    const Scales unit = scales(steel);
    const State state = leastEnergyMotion(onePhaseSet(onePhase(7, 3, 23)));
    writeStateCsv(folder.file("state.csv"), state, steel);
    const std::string text = contentOf(folder.file("state.csv"));
    CHECK(text.starts_with("x,a,b,velocity,strain,displacement\n"));
    const auto rows = rowsOf(text);
    REQUIRE(rows.size() == 7);
    for (std::size_t i = 0; i < 7; ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        CHECK(rows[i][0] == Approx(static_cast<double>(i + 1) * 2.0 / 7.0));
        CHECK(rows[i][1] == state.a[k] * unit.strain);
        CHECK(rows[i][2] == state.b[k] * unit.strain);
        CHECK(rows[i][3] == Approx(steel.waveSpeed * (rows[i][1] + rows[i][2])).margin(1e-18));
        CHECK(rows[i][4] == Approx(rows[i][2] - rows[i][1]).margin(1e-18));
    }
    CHECK(rows[6][5] == Approx(1e-6).epsilon(1e-14));
}

TEST_CASE("output: the force in a bar of several segments is that of each one's own EA")
{
    const std::vector<Segment> segments{{.cells = 2}, {.cells = 3, .impedance = 1.3}};
    // At rest under pressure one force runs through all of them.
    const Eigen::VectorXd pressed{{0.65, 0.65, 0.5, 0.5, 0.5}};
    const State state{pressed, -pressed};
    const Schedule schedule{5, {{6, 4}}};
    const Motion motion(state, schedule, segments);
    Bar bar;
    bar.axialStiffness = 200.0;
    const MotionSamples samples(motion, Scene{bar, std::nullopt, segments});
    for (std::size_t node = 0; node <= 5; ++node) {
        CHECK(samples.force(node, 0) == Approx(-1.3 * 200.0 * 1e-3).epsilon(1e-14));
    }
    // Z v = EA s/c in every wave: a single one in each cell of the second segment.
    const Motion waves({Eigen::VectorXd::Zero(5), Eigen::VectorXd{{0.0, 0.0, 1.0, 0.0, 0.0}}},
                       schedule, segments);
    const MotionSamples other(waves, Scene{bar, std::nullopt, segments});
    CHECK(other.force(3, 0) == Approx(1.3 * 200.0 * 1e-3).epsilon(1e-14));
    CHECK(other.strain(3, 0) == Approx(1e-3).epsilon(1e-14));
    const Folder folder;
    fs::create_directory(folder.file("series"));
    writeMotionSeries(folder.file("m.pvd"), folder.file("series"), "series", samples);
    const std::string cells = contentOf(folder.file("series/bar_0000.vtu"));
    const std::size_t begin = cells.find("Name=\"force\"");
    std::istringstream values(cells.substr(cells.find('>', begin) + 1));
    for (int cell = 0; cell < 5; ++cell) {
        double value = 0.0;
        values >> value;
        CHECK(value == Approx(-0.26).epsilon(1e-14));
    }
}

TEST_CASE("output: motion files hold every node and instant of a small case")
{
    const Folder folder;
    const Schedule schedule = onePhase(5, 3, 14);
    const Motion motion(leastEnergyMotion(onePhaseSet(schedule)), schedule);
    writeMotionCsv(folder.file("m.csv"), MotionSamples(motion, Bar{}));
    const auto rows = rowsOf(contentOf(folder.file("m.csv")));
    REQUIRE(rows.size() == 18 * 6);
    CHECK(rows.front() == std::vector<double>{0, 0, 0, rows[1][3], rows[1][4], rows[1][5]});
    CHECK(rows.back()[0] == Approx(3.4));
    CHECK(rows.back()[2] == Approx(1e-3));

    writeMotionVtk(folder.file("m.vtk"), MotionSamples(motion, Bar{}));
    std::istringstream vtk(contentOf(folder.file("m.vtk")));
    std::string line;
    std::getline(vtk, line);
    CHECK(line == "# vtk DataFile Version 3.0");
    std::vector<std::string> words((std::istream_iterator<std::string>(vtk)), {});
    const auto at = [&](const char* word) {
        return std::find(words.begin(), words.end(), word) - words.begin();
    };
    CHECK(words[static_cast<std::size_t>(at("DIMENSIONS") + 1)] == "6");
    CHECK(words[static_cast<std::size_t>(at("DIMENSIONS") + 2)] == "18");
    CHECK(words[static_cast<std::size_t>(at("POINT_DATA") + 1)] == "108");
    CHECK(std::count(words.begin(), words.end(), "SCALARS") == 3);
    CHECK(words.size() - static_cast<std::size_t>(at("POINT_DATA")) == 2 + 3 * (4 + 2 + 108));
}

TEST_CASE("output: a mode is sampled over its own period")
{
    const Folder folder;
    const ModeMotion motion(*findMode(1, -1), 3.14159265358979);
    const Bar bar{2.0, 5000.0, 2e7, 1e-6};
    writeMotionCsv(folder.file("m.csv"), MotionSamples(motion, bar, 5));
    const auto rows = rowsOf(contentOf(folder.file("m.csv")));
    REQUIRE(rows.size() == 6 * 17);  // round(5 T) steps
    const Scales unit = scales(bar);
    CHECK(rows.back()[0] == Approx(motion.period() * unit.time));
    for (const auto& row : rows) {
        CHECK(row[2] == Approx(unit.displacement *
                               motion.displacement(row[1] / bar.length, row[0] / unit.time))
                            .margin(1e-15));
        CHECK(std::abs(row[3]) + bar.waveSpeed * std::abs(row[4]) ==
              Approx(2.0 * motion.amplitude() * unit.velocity));
    }
}

TEST_CASE("output: a time series appears with its folder, and takes the place of an older one")
{
    const Folder folder;
    const Schedule schedule = onePhase(5, 3, 14);
    const Motion motion(leastEnergyMotion(onePhaseSet(schedule)), schedule);
    const std::string series = folder.file("m_files");
    for (const std::int64_t instants : {18, 3}) {
        OutputFiles files;
        const std::string staged = files.stage(folder.file("m.pvd"));
        const std::string members = files.stageFolder(series, ".vtu");
        writeMotionSeries(staged, members, "m_files", MotionSamples(motion, Bar{}, instants));
        files.commit();
        CHECK(folder.files() == 2);
        CHECK(std::distance(fs::directory_iterator(series), fs::directory_iterator()) ==
              instants + 1);
    }
    const std::string collection = contentOf(folder.file("m.pvd"));
    CHECK_THAT(collection, containsText("file=\"m_files/bar_0002.vtu\""));

    // What is not ours is not replaced.
    writeText(series + "/thesis.txt", "dear");
    {
        OutputFiles files;
        CHECK_THROWS_WITH(files.stageFolder(series, ".vtu"), containsText("more than .vtu files"));
        CHECK_THROWS_AS(files.stageFolder(folder.file("m.pvd"), ".vtu"), FileError);
    }
    fs::remove(series + "/thesis.txt");
    // All or none: the last file cannot be put into place, and the old folder is back.
    {
        OutputFiles files;
        writeText(files.stageFolder(series, ".vtu") + "/new.vtu", "new");
        writeText(files.stage(folder.file("bad.txt")), "never");
        fs::create_directory(folder.file("bad.txt"));
        CHECK_THROWS_AS(files.commit(), FileError);
    }
    CHECK(std::distance(fs::directory_iterator(series), fs::directory_iterator()) == 4);
    CHECK(folder.files() == 3);
}
