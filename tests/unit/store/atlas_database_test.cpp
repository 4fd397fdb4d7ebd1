#include "signorini/atlas_database.hpp"

#include <atomic>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <tuple>

#include "catch.hpp"
#include "database.hpp"
#include "folder.hpp"
#include "signorini/motion.hpp"
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
    CHECK(calls > 1);
    CHECK(calls <= batchesOf(range));
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

TEST_CASE("atlas database: families read back, and schedules refer to them")
{
    const Folder folder;
    AtlasDatabase database = AtlasDatabase::create(folder.file("a.sqlite"));
    AtlasRange range = usualRange(12);
    (void)buildAtlas(database, range);
    const std::string plain = folder.file("a.sqlite");
    // The paper's family at N = 12: G = 6 amplitudes, 11 schedules, top (6, 36).
    CHECK(number(plain,
                 "SELECT COUNT(*) FROM families WHERE cells = 12 AND family_order = 4 AND nu = 7 "
                 "AND contact_blocks = 1 AND phases = '6:36' AND steps = 42 AND period = 3.5 AND "
                 "frequency_ratio = 8.0/7.0 AND contact = 'pressing' AND kind = 'simplex' AND "
                 "dimension = 5 AND energy_ratio_min = 4 AND energy_ratio_max = 24 AND "
                 "schedules = 11") == 1);
    constexpr const char* unlike =
        "SELECT COUNT(*) FROM families f WHERE schedules <> "
        "(SELECT COUNT(*) FROM schedules s WHERE s.family = f.id)";
    CHECK(number(plain, unlike) == 0);
    CHECK(number(plain,
                 "SELECT COUNT(*) FROM schedules s JOIN families f ON s.family = f.id WHERE "
                 "s.steps <> f.steps OR s.contact <> f.contact OR s.energy_ratio_min < "
                 "f.energy_ratio_min OR s.energy_ratio_max > f.energy_ratio_max") == 0);
    CHECK(number(plain, "SELECT COUNT(*) FROM schedules WHERE family IS NULL") == 0);

    std::map<std::int64_t, AtlasFamily> read;
    database.forEachFamily(12, [&read](const AtlasFamily& all) { read[all.id] = all; });
    std::vector<std::int8_t> signs;
    std::int64_t place = 0;
    for (std::int64_t batch = 0; batch < batchesOf(range); ++batch) {
        const AtlasBatch decided = decideBatch(range, batch, signs).value();
        for (const AtlasFamily& all : decided.families) {
            CHECK(isSame(read.at(++place), all));
        }
    }
    CHECK(read.size() == static_cast<std::size_t>(place));
    database.forEachFamily(13, [](const AtlasFamily&) { FAIL("nothing is known of N = 13"); });
    database.forEachFound({}, [&read](const AtlasEntry& entry) {
        REQUIRE(entry.row.steps == read.at(entry.family.value()).steps);
    });

    // A larger range has more schedules of the same families; a smaller one leaves them.
    const std::int64_t grazing = number(plain, "SELECT schedules FROM families WHERE nu IS NULL");
    range.maxFree = 96;
    (void)buildAtlas(database, range);
    CHECK(number(plain, unlike) == 0);
    CHECK(number(plain, "SELECT schedules FROM families WHERE nu IS NULL") > grazing);
    range.maxFree = 20;
    (void)buildAtlas(database, range);
    CHECK(number(plain, unlike) == 0);

    // Families alone: the same table, and no schedules.
    AtlasDatabase only = AtlasDatabase::create(folder.file("only.sqlite"));
    range.maxFree = 96;
    range.familiesOnly = true;
    CHECK(buildAtlas(only, range).tally.pressing > 0);
    CHECK(number(folder.file("only.sqlite"), "SELECT COUNT(*) FROM schedules") == 0);
    std::set<std::pair<std::int64_t, std::int64_t>> some;
    std::set<std::pair<std::int64_t, std::int64_t>> all;
    only.forEachFamily(
        {}, [&some](const AtlasFamily& family) { some.emplace(family.steps, family.schedules); });
    database.forEachFamily(
        {}, [&all](const AtlasFamily& family) { all.emplace(family.steps, family.schedules); });
    CHECK(some == all);
}

TEST_CASE("atlas database: queries agree with a search through all rows")
{
    const Folder folder;
    AtlasDatabase database = AtlasDatabase::create(folder.file("a.sqlite"));
    AtlasRange range = usualRange(12);
    range.maxFree = 96;
    (void)buildAtlas(database, range);
    const double distance = 0.05;
    const auto isNear = [distance](double frequency, const EnergyRange& whole) {
        const double energy = std::clamp(20.0, whole.least, whole.most);
        return std::hypot(frequency / (8.0 / 7.0) - 1.0, energy / 20.0 - 1.0) <= distance;
    };
    std::size_t schedules = 0;
    std::size_t repetitions = 0;
    database.forEachFound({}, [&](const AtlasEntry& entry) {
        schedules += isNear(frequencyRatio(entry), entry.row.energy) ? 1U : 0U;
        repetitions += entry.row.steps < steps(entry.schedule) ? 1U : 0U;
    });
    std::size_t families = 0;
    database.forEachFamily({}, [&](const AtlasFamily& all) {
        families += isNear(frequencyRatio(all), all.energy) ? 1U : 0U;
    });
    CHECK(repetitions > 0);
    const auto near = database.schedulesNear(8.0 / 7.0, 20.0, distance);
    CHECK(near.size() == schedules);
    REQUIRE_FALSE(near.empty());
    CHECK(steps(near.front().schedule) == 42);
    CHECK(database.schedulesNear(8.0 / 7.0, 20.0, distance, 13).empty());
    CHECK(database.schedulesNear(8.0 / 7.0, 20.0, distance, {}, AtlasSchedules::withoutFamily)
              .empty());
    const auto nearFamilies = database.familiesNear(8.0 / 7.0, 20.0, distance);
    CHECK(nearFamilies.size() == families);
    CHECK(nearFamilies.front().family == findFamily(4, 7, 1));
    CHECK(database.familiesNear(8.0 / 7.0, 20.0, 1e-9).size() == 1);

    // T = 10/3, exactly: n = 40. As a decimal it is no multiple of 1/12.
    const auto period = database.schedulesOfPeriod({10, 3});
    CHECK(std::count_if(period.begin(), period.end(),
                        [](const AtlasEntry& entry) { return entry.row.isCanonical; }) == 8);
    for (const AtlasEntry& entry : period) {
        CHECK(steps(entry.schedule) == 40);
    }
    const auto ofPeriod = database.familiesOfPeriod({10, 3});
    REQUIRE(ofPeriod.size() == 1);
    CHECK(ofPeriod.front().family == findFamily(3, 5, 1));
    CHECK(database.schedulesOfPeriod({3333, 1000}).empty());
    CHECK(database.familiesOfPeriod({3333, 1000}).empty());

    // All that graze have the period 4 of the linear motion, or an odd part of it.
    for (const AtlasEntry& entry : database.schedulesOfPeriod({4, 1})) {
        CHECK(entry.row.contact == Contact::grazing);
        CHECK(steps(entry.schedule) % 48 == 0);
    }
}

TEST_CASE("atlas database: twins are different orbits of equal period and energy")
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
        REQUIRE(twins.families.size() > 1);
        REQUIRE(twins.schedules.empty());
        std::vector<std::vector<double>> motions;
        for (const AtlasFamily& all : twins.families) {
            const Schedule schedule{all.cells, {all.top}};
            const State state = leastEnergyMotion(onePhaseSet(schedule));
            CHECK(energyRatio(state) == Approx(twins.families.front().energy.least).epsilon(1e-12));
            CHECK(verify(state, schedule).canonical == schedule.phases);
            CHECK(all.steps == twins.families.front().steps);
            std::vector<double> p = arrivals(state, schedule);
            for (const std::vector<double>& other : motions) {
                for (std::size_t shift = 0; shift < p.size(); ++shift) {
                    std::rotate(p.begin(), p.begin() + 1, p.end());
                    double apart = 0.0;
                    for (std::size_t m = 0; m < p.size(); ++m) {
                        apart = std::max(apart, std::abs(p[m] - other[m]));
                    }
                    REQUIRE(apart > 1e-3);
                }
            }
            motions.push_back(p);
            hasMainMode = hasMainMode || all.top.contact == 404 - all.steps;
        }
    }
    CHECK(hasMainMode);
}

TEST_CASE("atlas database: twins of several phases, and and of both sorts")
{
    const Folder folder;
    AtlasDatabase database = AtlasDatabase::create(folder.file("a.sqlite"));
    (void)buildAtlas(database, {.cells = 8, .maxContact = 4, .maxFree = 26, .maxPhases = 2});
    // By comparing all with all: canonical schedules of several phases and families that press.
    std::vector<std::tuple<std::int64_t, double, std::string, std::string>> all;
    database.forEachFamily({}, [&all](const AtlasFamily& family) {
        if (family.contact() == Contact::pressing) {
            const std::string text = phasesText({family.top});
            all.emplace_back(family.steps, family.energy.least, text, text);
        }
    });
    database.forEachFound({}, [&all](const AtlasEntry& entry) {
        if (!entry.family && entry.row.isCanonical) {
            const Phase a = entry.schedule.phases[0];
            const Phase b = entry.schedule.phases[1];
            // Backwards each contact is followed by the flight before it.
            std::vector<Phase> mirror{{a.contact, b.free}, {b.contact, a.free}};
            if (mirror[1] < mirror[0]) {
                std::swap(mirror[0], mirror[1]);
            }
            all.emplace_back(entry.row.steps, entry.row.energy.least,
                             phasesText(entry.schedule.phases), phasesText(mirror));
        }
    });
    std::int64_t expected = 0;
    for (const auto& one : all) {
        expected += std::any_of(all.begin(), all.end(), [&one](const auto& other) {
            const auto& [steps, energy, name, mirror] = one;
            return std::get<0>(other) == steps && std::get<2>(other) != name &&
                   std::get<2>(other) != mirror &&
                   std::abs(std::get<1>(other) / energy - 1.0) <= 1e-12;
        });
    }
    std::int64_t found = 0;
    const std::vector<Twins> groups = database.twins();
    for (const Twins& twins : groups) {
        found += static_cast<std::int64_t>(twins.families.size());
        for (const AtlasEntry& entry : twins.schedules) {
            const std::vector<Phase>& p = entry.schedule.phases;
            const bool isOwnMirror = p[0].free == p[1].free || p[0].contact == p[1].contact;
            found += isOwnMirror ? 1 : 2;
        }
    }
    CHECK(found == expected);
    CHECK(expected > 0);
    CHECK(std::any_of(groups.begin(), groups.end(), [](const Twins& twins) {
        return !twins.families.empty() && !twins.schedules.empty();
    }));
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
                      containsText("not an atlas of signorini"));
    CHECK(number(folder.file("other.sqlite"), "SELECT COUNT(*) FROM sqlite_master") == 1);

    // Atlases of the former tables are refused in words that say what to do.
    (void)AtlasDatabase::create(folder.file("former.sqlite"));
    opened(folder.file("former.sqlite")).exec("DROP TABLE families; PRAGMA user_version = 1");
    CHECK_THROWS_WITH(AtlasDatabase::open(folder.file("former.sqlite")),
                      containsText("version 1") && containsText("anew"));
    CHECK_THROWS_AS(AtlasDatabase::create(folder.file("former.sqlite")), FileError);

    AtlasDatabase database = AtlasDatabase::create(folder.file("a.sqlite"));
    AtlasRange range = pairsRange();
    AtlasRun run = database.start(range, "");
    AtlasBatch batch;
    batch.number = 1;
    CHECK_THROWS_WITH(database.write(run, {&batch, 1}, 0.0, ""), containsText("out of order"));
    // Without resume an unfinished run is not touched.
    CHECK_THROWS_WITH(buildAtlas(database, range), containsText("--resume"));
    // Two processes on one range: the second sees that it is not alone.
    std::vector<std::int8_t> signs;
    AtlasRun second = run;
    const std::vector first{decideBatch(range, 0, signs).value()};
    const std::vector twice{first.front(), first.front()};
    CHECK_THROWS_WITH(database.write(run, twice, 0.0, ""), containsText("out of order"));
    CHECK(run.nextBatch == 0);
    CHECK(number(folder.file("a.sqlite"), "SELECT COUNT(*) FROM schedules") == 0);
    database.write(run, first, 0.0, "");
    const auto rows = dump(folder.file("a.sqlite"));
    CHECK_THROWS_WITH(database.write(second, first, 0.0, ""), containsText("another process"));
    CHECK(dump(folder.file("a.sqlite")) == rows);
}
