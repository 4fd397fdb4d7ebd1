// Atlases of bars in a row.

#include <algorithm>
#include <cmath>
#include <sstream>

#include "catch.hpp"
#include "contact_spans.hpp"
#include "database.hpp"
#include "decided.hpp"
#include "folder.hpp"
#include "network_find.hpp"
#include "scene_answer.hpp"
#include "signorini/atlas_database.hpp"

using namespace signorini;
using namespace signorini::test;

namespace {

AtlasRange rangeOfBars(const Assembly& bars, std::int64_t contact, std::int64_t free,
                       std::int64_t phases = 1)
{
    AtlasRange range;
    range.cells = networkOf(bars).cells();
    range.maxContact = contact;
    range.maxFree = free;
    range.maxPhases = phases;
    range.keepsRefuted = true;
    range.bars = bars;
    return range;
}

/// By their numbers.
AtlasBatch rowsOf(const AtlasRange& range)
{
    AtlasBatch all = decideAll(range);
    std::sort(all.rows.begin(), all.rows.end(),
              [](const AtlasRow& a, const AtlasRow& b) { return a.number < b.number; });
    return all;
}

}  // namespace

TEST_CASE("atlas of bars: of one bar it is the atlas that the theory of one bar makes")
{
    struct Case {
        Scene scene;
        std::int64_t cells, contact, free, phases;
    };
    Scene two;
    two.secondStop = 2.5e-3;
    for (const Case& of : {Case{{}, 4, 9, 18, 1}, Case{{}, 3, 2, 12, 2}, Case{two, 3, 2, 12, 2}}) {
        AtlasRange plain = rangeOfBars(answers::assemblyOf(of.scene, of.cells, {}), of.contact,
                                       of.free, of.phases);
        const AtlasRange inRow = plain;
        plain.bars.reset();
        plain.secondStop = stopsOf(of.scene).left;
        REQUIRE(numbersOf(plain) == numbersOf(inRow));
        const AtlasBatch theory = rowsOf(plain);
        const AtlasBatch programs = rowsOf(inRow);
        REQUIRE(theory.rows.size() == programs.rows.size());
        CHECK(programs.tally.undecided == 0);
        CHECK(programs.tally.pressing + programs.tally.grazing > 3);
        for (std::size_t k = 0; k < theory.rows.size(); ++k) {
            const AtlasRow& wanted = theory.rows[k];
            const AtlasRow& row = programs.rows[k];
            INFO(describe(phasesAt(plain, row.number)));
            REQUIRE(row.number == wanted.number);
            CHECK(row.status == wanted.status);
            CHECK(row.kernelDimension == wanted.kernelDimension);
            if (wanted.status == Status::found) {
                CHECK(row.energy.least == Approx(wanted.energy.least).epsilon(1e-9));
                CHECK(row.contact == wanted.contact);
                CHECK(row.isCanonical == wanted.isCanonical);
            }
        }
    }
}

TEST_CASE("atlas of bars: a row is what find says, and each without motions has its proof")
{
    const Assembly bars{.parts = partsOf("clamp 3 stop=1e-3 gap=1.5e-3 4:1.3 free")};
    const Network network = networkOf(bars);
    const AtlasRange range = rangeOfBars(bars, 3, 12);
    CHECK(contactsOf(range) == 2);
    const AtlasBatch all = rowsOf(range);
    REQUIRE(all.rows.size() == 72);
    auto proof = all.proofs.begin();
    for (const AtlasRow& row : all.rows) {
        const Schedule schedule{range.cells, phasesAt(range, row.number)};
        const std::vector<ContactSpan> spans = spansOf(schedule);
        INFO(textOf(spans));
        CHECK(spans.front().closed == (row.number < 36 ? 1U : 2U));
        if (row.status == Status::undecided) {
            CHECK_THROWS_AS(leastMotion(network, spans, 1e9), std::invalid_argument);
            continue;
        }
        const LeastMotion least =
            leastMotion(network, spans, hugeEnergyRatio * usualEnergy(network, spans));
        CHECK(row.status == least.status);
        if (row.status == Status::none) {
            REQUIRE(proof != all.proofs.end());
            CHECK((proof++)->number == row.number);
        } else {
            CHECK(row.energy.least == least.energy / firstEnergy(network).value());
        }
    }
    CHECK(proof == all.proofs.end());
}

TEST_CASE("atlas of bars: what is written is read back, and nothing that no atlas would contain")
{
    Assembly bars{.parts = partsOf("free 3 gap=1e-3 4 clamp"), .length = 0.7, .waveSpeed = 5e3};
    bars.young = 2.1e11;
    const AtlasRange range = rangeOfBars(bars, 2, 9, 2);
    CHECK(rangeOf(textOf(range)) == range);
    const Folder folder;
    const std::string path = folder.file("a.sqlite");
    AtlasDatabase database = AtlasDatabase::create(path);
    const AtlasRun run = buildAtlas(database, range);
    CHECK(run.isFinished());
    CHECK(buildAtlas(database, range).tally == run.tally);  // its rows are all there
    CHECK(database.runs().front().range == range);
    std::vector<std::vector<Phase>> wanted;
    for (const AtlasRow& row : rowsOf(range).rows) {
        if (row.status == Status::found) {
            wanted.push_back(phasesAt(range, row.number));
        }
    }
    std::vector<std::vector<Phase>> found;
    database.forEachFound({}, [&found](const AtlasEntry& entry) {
        CHECK(entry.isOfBars);
        found.push_back(entry.schedule.phases);
    });
    CHECK(found == wanted);
    CHECK(!found.empty());

    AtlasRange other = range;
    other.bars->gravity = 1.0;
    CHECK_THROWS_WITH(buildAtlas(database, other), containsText("ranges of other bars"));
    for (const char* phases : {"1+2:1 -:4", "1:1 2:4", "0:1 -:4", "1:1 -:4 1:2", "1:01 -:4"}) {
        opened(path).exec(std::string("UPDATE schedules SET phases = '") + phases +
                          "' WHERE rowid = 1");
        CHECK_THROWS_WITH(database.rowsOf(range), containsText("SET one contact"));
    }
}

TEST_CASE("atlas of bars: ranges that make no sense are refused by name")
{
    const AtlasRange good = rangeOfBars({.parts = partsOf("free 3 gap=1e-3 4 clamp")}, 2, 9);
    const auto refuses = [&good](auto change, const char* words) {
        AtlasRange range = good;
        change(range);
        CHECK_THROWS_WITH(validate(range), containsText(words) && containsText("allowed"));
    };
    refuses([](AtlasRange& r) { r.cells = 8; }, "cells = 8");
    refuses([](AtlasRange& r) { r.familiesOnly = true; }, "families only");
    refuses([](AtlasRange& r) { r.secondStop = Fraction{2, 1}; }, "second stop");
    refuses([](AtlasRange& r) { r.gapSign = -1; }, "gap sign");
    refuses([](AtlasRange& r) { r.maxFree = 200'000; }, "max contact + max free");
    for (const char* text : {"clamp 3 stop=1e-3; 1 1 1 0", "clamp 3; a 1 1 0 0", "3:1"}) {
        AtlasRange range;
        CHECK_THROWS_AS(readScene(range, text), std::invalid_argument);
    }
}
