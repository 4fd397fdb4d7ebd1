#include "signorini/atlas_database.hpp"

#include <atomic>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "catch.hpp"
#include "database.hpp"
#include "folder.hpp"
#include "signorini/output.hpp"
#include "signorini/verification.hpp"
#include "support.hpp"

using namespace signorini;
using namespace signorini::test;

namespace {

namespace fs = std::filesystem;

AtlasRange pairsRange()
{
    AtlasRange range;
    range.cells = 4;
    range.maxContact = 6;
    range.maxFree = 16;
    range.maxPhases = 2;
    return range;
}

}  // namespace

TEST_CASE("atlas database: rows read back as they were decided")
{
    const Folder folder;
    AtlasRange range = pairsRange();
    range.keepsRefuted = true;
    AtlasDatabase database = AtlasDatabase::create(folder.file("a.sqlite"));
    const AtlasRun run = buildAtlas(database, range, {.options = "as tested"});
    REQUIRE(run.isFinished());
    CHECK(run.tally.decided == 96 + 96 * 97 / 2);
    CHECK(dump(folder.file("a.sqlite")).size() == static_cast<std::size_t>(run.tally.decided));

    std::int64_t found = 0;
    database.forEachFound(4, [&found](const AtlasEntry& entry) {
        const PeriodicResult truth = findPeriodic(entry.schedule);
        INFO(describe(entry.schedule));
        REQUIRE(truth.status == Status::found);
        REQUIRE(entry.row.kind == truth.set.kind);
        REQUIRE(entry.row.energy.least == Approx(truth.motion->energyRatio).epsilon(1e-12));
        REQUIRE(entry.row.contact == truth.motion->contact);
        ++found;
    });
    CHECK(found == run.tally.pressing + run.tally.grazing);
    const std::string plain = folder.file("a.sqlite");
    CHECK(number(plain,
                 "SELECT COUNT(*) FROM schedules WHERE status = 'none' AND reason IS NULL") == 0);
    CHECK(number(plain,
                 "SELECT COUNT(*) FROM runs WHERE options = 'as tested' AND finished IS NOT "
                 "NULL AND version <> ''") == 1);
    CHECK(number(plain,
                 "SELECT COUNT(*) FROM schedules WHERE phases = '2:12' AND period = 3.5 AND "
                 "frequency_ratio = 8.0/7.0 AND energy_ratio_min = 4 AND energy_ratio_max = 8 AND "
                 "kind = 'simplex'") == 1);
}

TEST_CASE("atlas database: interrupted at every batch and resumed, the rows are the same")
{
    const Folder folder;
    const AtlasRange range = pairsRange();
    AtlasDatabase whole = AtlasDatabase::create(folder.file("whole.sqlite"));
    const AtlasRun unbroken = buildAtlas(whole, range);

    int calls = 0;
    AtlasRun run;
    do {
        AtlasDatabase database = AtlasDatabase::create(folder.file("parts.sqlite"));
        std::atomic<bool> stop = false;
        AtlasOptions options;
        options.threads = 1 + calls % 3;
        options.resume = calls > 0;
        options.cancel = [&stop] { return stop.load(); };
        options.progress = [&stop](const AtlasRun&) { stop = true; };
        run = buildAtlas(database, range, options);
        ++calls;
    } while (!run.isFinished() && calls < 100);
    CHECK(calls == batchesOf(range));
    CHECK(run.tally == unbroken.tally);
    CHECK(dump(folder.file("parts.sqlite")) == dump(folder.file("whole.sqlite")));
}

TEST_CASE("atlas database: several ranges live in one file, each row once")
{
    const Folder folder;
    AtlasDatabase database = AtlasDatabase::create(folder.file("a.sqlite"));
    AtlasRange range = usualRange(12);
    const AtlasRun small = buildAtlas(database, range);
    range.maxFree = 96;
    const AtlasRun large = buildAtlas(database, range);
    CHECK(large.id != small.id);
    (void)buildAtlas(database, usualRange(6));
    const auto rows = dump(folder.file("a.sqlite"));
    std::int64_t count = 0;
    database.forEachFound(12, [&count](const AtlasEntry&) { ++count; });
    CHECK(count == large.tally.pressing + large.tally.grazing);

    // A finished range is done: asking again changes nothing.
    const AtlasRun again = buildAtlas(database, range);
    CHECK(again.id == large.id);
    CHECK(again.isFinished());
    CHECK(dump(folder.file("a.sqlite")) == rows);
}

TEST_CASE("atlas database: queries agree with a search through all rows")
{
    const Folder folder;
    AtlasDatabase database = AtlasDatabase::create(folder.file("a.sqlite"));
    AtlasRange range = usualRange(12);
    range.maxFree = 96;
    (void)buildAtlas(database, range);
    std::vector<AtlasEntry> all;
    database.forEachFound({}, [&all](const AtlasEntry& entry) { all.push_back(entry); });

    const double distance = 0.05;
    const auto near = database.near(8.0 / 7.0, 20.0, distance);
    std::size_t expected = 0;
    for (const AtlasEntry& entry : all) {
        const double across = frequencyRatio(entry.schedule) / (8.0 / 7.0) - 1.0;
        const double energy = std::clamp(20.0, entry.row.energy.least, entry.row.energy.most);
        expected += std::hypot(across, energy / 20.0 - 1.0) <= distance ? 1U : 0U;
    }
    CHECK(near.size() == expected);
    REQUIRE_FALSE(near.empty());
    CHECK(steps(near.front().schedule) == 42);
    CHECK(database.near(8.0 / 7.0, 20.0, distance, 13).empty());

    // T = 10/3, exactly: n = 40. As a decimal it is no multiple of 1/12.
    const auto period = database.ofPeriod({10, 3});
    CHECK(std::count_if(period.begin(), period.end(),
                        [](const AtlasEntry& entry) { return entry.row.isCanonical; }) == 8);
    for (const AtlasEntry& entry : period) {
        CHECK(steps(entry.schedule) == 40);
    }
    CHECK(database.ofPeriod({3333, 1000}).empty());
}

TEST_CASE("atlas database: twins are different motions of equal period and energy")
{
    // The twin mode k = 1, t_c = 16 - 5T, and the main mode t_c = 4 - T at T = 3.1: n = 310.
    const Folder folder;
    AtlasDatabase database = AtlasDatabase::create(folder.file("a.sqlite"));
    AtlasRange range = usualRange(101);
    range.maxEnergyRatio = 150.0;
    (void)buildAtlas(database, range);
    const auto groups = database.twins();
    REQUIRE_FALSE(groups.empty());
    bool hasMainMode = false;
    for (const Twins& twins : groups) {
        REQUIRE(twins.size() > 1);
        std::vector<State> states;
        for (const AtlasEntry& entry : twins) {
            const State state = leastEnergyMotion(onePhaseSet(entry.schedule));
            CHECK(energyRatio(state) == Approx(twins.front().row.energy.least).epsilon(1e-12));
            CHECK(verify(state, entry.schedule).canonical == entry.schedule.phases);
            CHECK(steps(entry.schedule) == steps(twins.front().schedule));
            for (const State& other : states) {
                CHECK((other.a - state.a).norm() + (other.b - state.b).norm() > 1e-3);
            }
            states.push_back(state);
        }
        const auto isMain = [](const AtlasEntry& entry) {
            return entry.schedule.phases.front().contact == 404 - steps(entry.schedule);
        };
        hasMainMode = hasMainMode || std::any_of(twins.begin(), twins.end(), isMain);
    }
    CHECK(hasMainMode);
}

TEST_CASE("atlas database: what cannot be used is refused and left as it is")
{
    const Folder folder;
    std::ofstream(folder.file("text.sqlite")) << "not a database, but long enough to look at";
    CHECK_THROWS_AS(AtlasDatabase::create(folder.file("text.sqlite")), FileError);
    CHECK_THROWS_AS(AtlasDatabase::open(folder.file("text.sqlite")), FileError);
    CHECK_THROWS_AS(AtlasDatabase::open(folder.file("missing.sqlite")), FileError);
    CHECK_FALSE(fs::exists(folder.file("missing.sqlite")));
    CHECK_THROWS_AS(AtlasDatabase::create(folder.file("no/such/folder.sqlite")), FileError);
    opened(folder.file("other.sqlite"), SQLite::OPEN_CREATE)
        .exec("CREATE TABLE mine(x); INSERT INTO mine VALUES(1)");
    CHECK_THROWS_WITH(AtlasDatabase::create(folder.file("other.sqlite")),
                      containsText("no atlas of signorini"));
    CHECK(number(folder.file("other.sqlite"), "SELECT COUNT(*) FROM sqlite_master") == 1);

    AtlasDatabase database = AtlasDatabase::create(folder.file("a.sqlite"));
    AtlasRange range = pairsRange();
    AtlasRun run = database.start(range, "");
    AtlasBatch batch;
    batch.number = 1;
    CHECK_THROWS_WITH(database.write(run, batch, 0.0, ""), containsText("out of order"));
    // Without resume an unfinished run is not touched.
    CHECK_THROWS_WITH(buildAtlas(database, range), containsText("--resume"));
    // Two processes on one range: the second sees that it is not alone.
    std::vector<std::int8_t> signs;
    AtlasRun second = run;
    database.write(run, decideBatch(range, 0, signs).value(), 0.0, "");
    const auto rows = dump(folder.file("a.sqlite"));
    CHECK_THROWS_WITH(database.write(second, decideBatch(range, 0, signs).value(), 0.0, ""),
                      containsText("another process"));
    CHECK(dump(folder.file("a.sqlite")) == rows);
}
