// Atlases of bars of several segments.

#include <algorithm>
#include <iterator>
#include <sstream>
#include <variant>

#include "atlas_batches.hpp"
#include "catch.hpp"
#include "database.hpp"
#include "folder.hpp"
#include "signorini/atlas_database.hpp"
#include "signorini/find_periodic.hpp"
#include "solver.hpp"

using namespace signorini;
using namespace signorini::test;

namespace {

AtlasRange halves(std::int64_t contact, std::int64_t free, std::int64_t phases = 1)
{
    AtlasRange range;
    range.cells = 4;
    range.maxContact = contact;
    range.maxFree = free;
    range.maxPhases = phases;
    range.keepsRefuted = true;
    range.segments = {{.cells = 2}, {.cells = 2, .impedance = 1.3, .dashpot = 0.0}};
    return range;
}

/// All numbers of multipliers as the database keeps them.
std::vector<double> numbersIn(std::string text)
{
    std::replace(text.begin(), text.end(), ';', ' ');
    std::replace(text.begin(), text.end(), ':', ' ');
    std::istringstream in(text);
    return {std::istream_iterator<double>(in), std::istream_iterator<double>()};
}

std::vector<double> numbersOf(const EnergyFloor& proof)
{
    std::vector<double> all = proof.periodicity;
    for (const auto* list : {&proof.places, &proof.pushes}) {
        for (const ContactMultiplier& m : *list) {
            all.insert(all.end(),
                       {static_cast<double>(m.contact + 1), static_cast<double>(m.step), m.value});
        }
    }
    return all;
}

}  // namespace

TEST_CASE("stepped atlas: each row says what findPeriodic says of its schedule, with its proof",
          "[glpk][ipopt]")
{
    for (const int gapSign : {1, -1}) {
        AtlasRange range = halves(6, 17);
        range.gapSign = gapSign;
        AtlasTally tally;
        std::int64_t rows = 0;
        LocalBatches source(range, 1);
        while (const auto batch = source.next()) {
            tally += batch->tally;
            auto proof = batch->proofs.begin();
            for (const AtlasRow& row : batch->rows) {
                REQUIRE(row.number == rows++);
                FindOptions options;
                options.scene.bar.gap *= gapSign;
                options.scene.segments = range.segments;
                const Schedule schedule{range.cells, phasesAt(range, row.number)};
                const PeriodicResult found = findPeriodic(schedule, options);
                INFO(describe(schedule));
                CHECK(row.status == found.status);
                CHECK(row.steps == steps(schedule));
                CHECK(row.kernelDimension == found.set.kernelDimension.value_or(-1));
                if (found.motion) {
                    CHECK(row.energy.least == found.motion->energyRatio);
                    CHECK(row.contact == found.motion->contact);
                }
                if (found.absence) {
                    CHECK(row.reason == found.absence->reason);
                    REQUIRE(proof != batch->proofs.end());
                    CHECK(proof->number == row.number);
                    const auto& own = std::get<EnergyFloorProof>(found.absence->proof);
                    CHECK(numbersIn((proof++)->multipliers) == numbersOf(own.multipliers));
                }
            }
            CHECK(proof == batch->proofs.end());
        }
        CHECK(rows == 6 * 17);
        CHECK(tally.decided == rows);
        CHECK(tally.pressing + tally.grazing + tally.refuted == rows);
        CHECK(tally.pressing >= 4);
        CHECK(tally.families == 0);
    }
}

TEST_CASE("stepped atlas: of halves of four cells with impedances 1 and 1.3 forty schedules exist",
          "[glpk][ipopt]")
{
    AtlasRange range = halves(15, 39);
    range.cells = 8;
    range.segments = {{.cells = 4}, {.cells = 4, .impedance = 1.3}};
    range.keepsRefuted = false;
    LocalBatches source(range, 2);
    AtlasTally tally;
    std::size_t rows = 0;
    while (const auto batch = source.next()) {
        tally += batch->tally;
        rows += batch->rows.size();
        CHECK(batch->proofs.empty());
    }
    CHECK(tally.pressing + tally.grazing == 40);
    CHECK(tally.undecided == 0);
    CHECK(rows == 40);
}

TEST_CASE(
    "stepped atlas: a database keeps the bar, its rows, and its proofs; threads change nothing",
    "[glpk][ipopt]")
{
    const Folder folder;
    const AtlasRange range = halves(4, 10, 2);
    const std::string one = folder.file("one.sqlite");
    const std::string two = folder.file("two.sqlite");
    {
        AtlasDatabase database = AtlasDatabase::create(one);
        CHECK(buildAtlas(database, range).isFinished());
        AtlasDatabase other = AtlasDatabase::create(two);
        CHECK(buildAtlas(other, range, {.threads = 2}).isFinished());
    }
    CHECK(dump(one) == dump(two));
    AtlasDatabase database = AtlasDatabase::create(one);
    const std::vector<AtlasRun> runs = database.runs();
    REQUIRE(runs.size() == 1);
    CHECK(runs.front().range == range);
    CHECK(number(one,
                 "SELECT COUNT(*) FROM schedules WHERE (status = 'none') != "
                 "(proof IS NOT NULL)") == 0);
    CHECK(number(one, "SELECT COUNT(*) FROM schedules WHERE status = 'found'") ==
          runs.front().tally.pressing + runs.front().tally.grazing);
    std::int64_t found = 0;
    database.forEachFound({}, [&](const AtlasEntry& entry) {
        ++found;
        CHECK(entry.row.energy.least > 0.0);
        CHECK_FALSE(entry.family);
        CHECK_FALSE(
            database.schedulesNear(frequencyRatio(entry), entry.row.energy.least, 1e-6).empty());
    });
    CHECK(found == runs.front().tally.pressing + runs.front().tally.grazing);
    AtlasRange other = range;
    other.segments.back().impedance = 1.4;
    CHECK_THROWS_WITH(buildAtlas(database, other), containsText("segments"));
    other.segments.clear();
    CHECK_THROWS_WITH(buildAtlas(database, other), containsText("segments"));
}

TEST_CASE("stepped atlas: a range is one line of text, and comes back from it")
{
    AtlasRange range = halves(7, 90, 3);
    range.segments = {{.cells = 1, .impedance = 1.0 / 3.0, .speed = 2.0, .dashpot = 0.1},
                      {.cells = 3, .impedance = 1e-300}};
    CHECK(rangeOf(textOf(range)) == range);
    range.maxEnergyRatio = 0.1;
    range.gapSign = -1;
    CHECK(rangeOf(textOf(range)) == range);
    const AtlasRange uniform = usualRange(300);
    CHECK(rangeOf(textOf(uniform)) == uniform);
    for (const char* wrong : {"", "300", "300 1 1 1 inf 0 0 1", "300 1 1 1 inf 0 0 1 4:1",
                              "300 1 1 1 inf 0 0 1 4:1:1:0,", "300 1 1 1 inf 0 0 1 4:1:1:x"}) {
        INFO(wrong);
        CHECK_THROWS_AS(rangeOf(wrong), std::invalid_argument);
    }
}

TEST_CASE("stepped atlas: a range that cannot be meant is refused")
{
    AtlasRange range = halves(4, 10);
    range.cells = 5;
    CHECK_THROWS_WITH(validate(range), containsText("cells of all segments = 4"));
    range = halves(4, 10);
    range.gapSign = 0;
    CHECK_THROWS_WITH(validate(range), containsText("gap sign = 0"));
    range = halves(4, 10);
    range.keepsRefuted = false;
    range.familiesOnly = true;
    CHECK_THROWS_WITH(validate(range), containsText("families only"));
    CHECK_THROWS_WITH(validate(halves(4, 1'000'000)), containsText("max contact + max free"));
}
