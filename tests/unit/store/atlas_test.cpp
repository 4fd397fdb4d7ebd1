#include "signorini/atlas.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <set>
#include <thread>

#include "atlas_batches.hpp"
#include "catch.hpp"
#include "signorini/find_periodic.hpp"
#include "support.hpp"

using namespace signorini;

namespace {

AtlasRange smallRange(std::int64_t cells, std::int64_t contact, std::int64_t free,
                      std::int64_t phases = 1)
{
    AtlasRange range;
    range.cells = cells;
    range.maxContact = contact;
    range.maxFree = free;
    range.maxPhases = phases;
    range.keepsRefuted = true;
    return range;
}

struct Whole {
    AtlasTally tally;
    std::vector<AtlasRow> rows;
};

Whole decideAll(const AtlasRange& range, std::int64_t threads = 1)
{
    LocalBatches source(range, threads);
    Whole whole;
    std::int64_t number = 0;
    while (const auto batch = source.next()) {
        REQUIRE(batch->number == number++);
        whole.tally += batch->tally;
        whole.rows.insert(whole.rows.end(), batch->rows.begin(), batch->rows.end());
    }
    REQUIRE(number == batchesOf(range));
    return whole;
}

bool isSame(const AtlasRow& a, const AtlasRow& b)
{
    const auto equal = [](double x, double y) { return x == y || (x != x && y != y); };
    return a.number == b.number && a.status == b.status && a.reason == b.reason &&
           a.kernelDimension == b.kernelDimension && a.kind == b.kind &&
           a.dimension == b.dimension && a.contact == b.contact && a.isCanonical == b.isCanonical &&
           equal(a.energy.least, b.energy.least) && equal(a.energy.most, b.energy.most);
}

}  // namespace

TEST_CASE("atlas: numbers stand for every list of phases once, rotations are decided once")
{
    const AtlasRange range = smallRange(2, 3, 4, 3);
    const std::int64_t count = numbersOf(range);
    CHECK(count == 12 + 12 * 12 + 12 * 12 * 12);
    std::set<std::vector<std::pair<std::int64_t, std::int64_t>>> lists;
    std::set<std::vector<std::pair<std::int64_t, std::int64_t>>> firstRotations;
    for (std::int64_t number = 0; number < count; ++number) {
        std::vector<std::pair<std::int64_t, std::int64_t>> list;
        for (const Phase& phase : phasesAt(range, number)) {
            REQUIRE(phase.contact >= 1);
            REQUIRE(phase.contact <= 3);
            REQUIRE(phase.free >= 1);
            REQUIRE(phase.free <= 4);
            list.emplace_back(phase.contact, phase.free);
        }
        lists.insert(list);
        auto first = list;
        for (std::size_t k = 0; k < list.size(); ++k) {
            std::rotate(list.begin(), list.begin() + 1, list.end());
            first = std::min(first, list);
        }
        firstRotations.insert(first);
    }
    CHECK(static_cast<std::int64_t>(lists.size()) == count);
    const Whole whole = decideAll(range);
    CHECK(whole.tally.decided == static_cast<std::int64_t>(firstRotations.size()));
    CHECK(whole.rows.size() == firstRotations.size());
    CHECK(whole.tally.undecided == 0);
}

TEST_CASE("atlas: each row says what findPeriodic says of its schedule")
{
    for (const AtlasRange& range :
         {smallRange(1, 3, 9), smallRange(4, 9, 33), smallRange(2, 3, 8, 2), smallRange(3, 4, 5, 2),
          smallRange(1, 2, 4, 3)}) {
        for (const AtlasRow& row : decideAll(range).rows) {
            const Schedule schedule{range.cells, phasesAt(range, row.number)};
            const PeriodicResult truth = findPeriodic(schedule);
            INFO(describe(schedule));
            REQUIRE(row.status == truth.status);
            REQUIRE(row.reason.has_value() == truth.absence.has_value());
            REQUIRE((!truth.absence || row.reason == truth.absence->reason));
            REQUIRE(row.kernelDimension == truth.set.kernelDimension);
            if (truth.status == Status::found) {
                REQUIRE(row.kind == truth.set.kind);
                REQUIRE(row.dimension == truth.set.dimension);
                REQUIRE(row.contact == truth.motion->contact);
                REQUIRE(row.isCanonical == (truth.motion->canonical == schedule.phases &&
                                            truth.motion->repetitions == 1));
                REQUIRE(row.energy.least == Approx(truth.motion->energyRatio).epsilon(1e-12));
                REQUIRE(row.energy.most == Approx(truth.set.energy->most).epsilon(1e-12));
            }
        }
    }
}

TEST_CASE("atlas: N = 300, n_c <= 600, n_f <= 2400: 18,012 of 1.44 million schedules exist")
{
    AtlasRange range = usualRange(300);
    CHECK(range.maxContact == 600);
    CHECK(range.maxFree == 1200);
    range.maxFree = 2400;
    const Whole whole = decideAll(range, 2);
    CHECK(whole.tally.decided == 1'440'000);
    CHECK(whole.tally.pressing == 12'962);
    CHECK(whole.tally.grazing == 5'050);
    CHECK(whole.tally.refuted == 1'440'000 - 18'012);
    CHECK(whole.rows.size() == 18'012);
    range.maxEnergyRatio = 50.0;
    const Whole low = decideAll(range);
    CHECK(low.tally == whole.tally);
    CHECK(static_cast<std::ptrdiff_t>(low.rows.size()) ==
          std::count_if(whole.rows.begin(), whole.rows.end(),
                        [](const AtlasRow& row) { return row.energy.least <= 50.0; }));
}

TEST_CASE("atlas: at N = 12, T <= 8, 36 schedules press through every contact step")
{
    AtlasRange range = smallRange(12, 24, 95);
    range.keepsRefuted = false;
    std::map<std::int64_t, std::vector<std::int64_t>> contacts;  // by n
    std::int64_t count = 0;
    for (const AtlasRow& row : decideAll(range).rows) {
        const Phase phase = phasesAt(range, row.number).front();
        if (row.isCanonical && phase.contact + phase.free <= 96) {
            contacts[phase.contact + phase.free].push_back(phase.contact);
            ++count;
        }
    }
    CHECK(count == 36);
    CHECK(contacts[40] == std::vector<std::int64_t>{1, 2, 3, 4, 5, 6, 7, 8});  // T = 10/3
    CHECK(contacts[42] == std::vector<std::int64_t>{1, 2, 3, 4, 5, 6});        // T = 7/2
}

TEST_CASE("atlas: neither the number of threads nor who takes which batch changes a result")
{
    const AtlasRange range = smallRange(4, 8, 18, 2);
    REQUIRE(batchesOf(range) == 7);
    const Whole one = decideAll(range, 1);
    for (const std::int64_t threads : {2, 5}) {
        const Whole many = decideAll(range, threads);
        CHECK(many.tally == one.tally);
        REQUIRE(many.rows.size() == one.rows.size());
        CHECK(std::equal(one.rows.begin(), one.rows.end(), many.rows.begin(), isSame));
    }
    Whole shared;
    LocalBatches first(range, 1, {}, 1, 3);
    LocalBatches second(range, 2, {}, 2, 3);
    LocalBatches third(range, 1, {}, 3, 3);
    std::vector<std::int8_t> signs;
    shared.rows = decideBatch(range, 0, signs).value().rows;
    for (std::int64_t number = 1; number < 7; ++number) {
        LocalBatches* owner = number % 3 == 1 ? &first : number % 3 == 2 ? &second : &third;
        const auto batch = owner->next();
        REQUIRE(batch);
        CHECK(batch->number == number);
        shared.rows.insert(shared.rows.end(), batch->rows.begin(), batch->rows.end());
    }
    CHECK_FALSE(third.next());
    REQUIRE(shared.rows.size() == one.rows.size());
    CHECK(std::equal(one.rows.begin(), one.rows.end(), shared.rows.begin(), isSame));
}

TEST_CASE("atlas: a cancelled source ends, however many threads wait")
{
    std::atomic<bool> stop = false;
    LocalBatches source(smallRange(100, 200, 4000), 3, [&stop] { return stop.load(); });
    REQUIRE(source.next());
    stop = true;
    CHECK_FALSE(source.next());

    // In the middle of a batch, too: this one would take minutes.
    const auto start = std::chrono::steady_clock::now();
    {
        std::atomic<bool> soon = false;
        LocalBatches large(smallRange(99'999'989, 6, 30'000), 2, [&soon] { return soon.load(); });
        std::thread stopper([&soon] {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            soon = true;
        });
        CHECK_FALSE(large.next());
        stopper.join();
    }
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(60));
}

TEST_CASE("atlas: several phases beyond exact arithmetic are kept as undecided")
{
    AtlasRange range = smallRange(maxCells, 1, 2'000'000'000, 2);
    range.keepsRefuted = false;
    std::vector<std::int8_t> signs;
    const AtlasBatch last = decideBatch(range, batchesOf(range) - 1, signs).value();
    CHECK(last.tally.undecided > 0);
    CHECK(last.tally.undecided == last.tally.decided);
    CHECK(static_cast<std::int64_t>(last.rows.size()) == last.tally.undecided);
    CHECK(last.rows.front().status == Status::undecided);
}

TEST_CASE("atlas: a wrong range is refused, with every fault")
{
    AtlasRange range = smallRange(0, 0, -1, 99);
    range.maxEnergyRatio = -1.0;
    CHECK_THROWS_WITH(validate(range),
                      containsText("cells = 0") && containsText("max contact = 0") &&
                          containsText("max free = -1") && containsText("phases = 99") &&
                          containsText("max energy ratio = -1"));
    CHECK_THROWS_WITH(validate(smallRange(300, 600, 1200, 4)), containsText("number of schedules"));
    CHECK_THROWS_AS(usualRange(0), std::invalid_argument);
    CHECK_THROWS_AS(LocalBatches(smallRange(1, 1, 1), 0), std::invalid_argument);
    CHECK_THROWS_AS(LocalBatches(smallRange(1, 1, 1), 1, {}, 0, 0), std::invalid_argument);
}
