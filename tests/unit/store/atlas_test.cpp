#include "signorini/atlas.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <thread>

#include "atlas_batches.hpp"
#include "catch.hpp"
#include "database.hpp"
#include "decided.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/motion.hpp"
#include "support.hpp"

using namespace signorini;
using signorini::test::decideAll;

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

bool isSameRow(const AtlasRow& a, const AtlasRow& b)
{
    const auto equal = [](double x, double y) { return x == y || (x != x && y != y); };
    return a.number == b.number && a.status == b.status && a.reason == b.reason &&
           a.kernelDimension == b.kernelDimension && a.kind == b.kind &&
           a.dimension == b.dimension && a.contact == b.contact && a.isCanonical == b.isCanonical &&
           equal(a.energy.least, b.energy.least) && equal(a.energy.most, b.energy.most) &&
           a.steps == b.steps && a.familyTop == b.familyTop;
}

/// Every schedule of one phase, one `decide` each: what an atlas was before it knew what exists.
std::map<Phase, Verdict> decideEach(const AtlasRange& range)
{
    std::map<Phase, Verdict> all;
    std::vector<std::int8_t> signs;
    for (std::int64_t contact = 1; contact <= range.maxContact; ++contact) {
        for (std::int64_t free = 1; free <= range.maxFree; ++free) {
            all[{contact, free}] = decide(range.cells, {contact, free}, signs);
        }
    }
    return all;
}

bool isKept(const Verdict& verdict, const AtlasRange& range)
{
    return verdict.reason ? range.keepsRefuted : energyRange(verdict).least <= range.maxEnergyRatio;
}

/// The top of the set a schedule is a part of, by trying its neighbours of the same n: where they
/// press they share a set, and the whole one has the largest dimension. Grazing motions are all
/// those of n_c = 1 in the shortest period.
Phase topOf(const Phase& phase, const Verdict& verdict, std::vector<std::int8_t>& signs)
{
    if (verdict.contact == Contact::grazing) {
        return {1, 2 * verdict.classes - 1};
    }
    Phase top = phase;
    std::int64_t most = verdict.kernelDimension;
    for (const std::int64_t way : {-1, 1}) {
        for (Phase next = phase;;) {
            next = {next.contact + way, next.free - way};
            if (next.contact < 1 || next.free < 1) {
                break;
            }
            const Verdict other = decide(verdict.cells, next, signs);
            if (other.reason || other.contact == Contact::grazing) {
                break;
            }
            if (other.kernelDimension > most) {
                top = next;
                most = other.kernelDimension;
            }
        }
    }
    return top;
}

/// Rows, families and counts against every schedule of the range.
void compareWithEach(AtlasRange range)
{
    INFO(range.cells << " " << range.maxContact << " " << range.maxFree << " "
                     << range.maxEnergyRatio << " " << range.keepsRefuted);
    std::vector<std::int8_t> signs;
    const AtlasBatch whole = decideAll(range);
    std::map<Phase, AtlasRow> rows;
    for (const AtlasRow& row : whole.rows) {
        REQUIRE(rows.emplace(phasesAt(range, row.number).front(), row).second);
    }
    AtlasTally tally;
    std::map<Phase, std::int64_t> families;
    std::set<Phase> all;  // those of an energy that is not kept, too
    for (const auto& [phase, verdict] : decideEach(range)) {
        ++tally.decided;
        ++(verdict.reason                         ? tally.refuted
           : verdict.contact == Contact::pressing ? tally.pressing
                                                  : tally.grazing);
        if (!verdict.reason) {
            all.insert(topOf(phase, verdict, signs));
        }
        const auto row = rows.find(phase);
        REQUIRE((row != rows.end()) == isKept(verdict, range));
        if (row == rows.end()) {
            continue;
        }
        REQUIRE(row->second.reason == verdict.reason);
        REQUIRE(row->second.kernelDimension == verdict.kernelDimension);
        REQUIRE(row->second.familyTop.has_value() == !verdict.reason);
        if (!verdict.reason) {
            REQUIRE(row->second.contact == verdict.contact);
            REQUIRE(row->second.isCanonical == verdict.isCanonical());
            REQUIRE(row->second.kind == verdict.set.kind);
            REQUIRE(row->second.dimension == verdict.set.dimension());
            REQUIRE(row->second.energy.least == energyRange(verdict).least);
            REQUIRE(row->second.energy.most == energyRange(verdict).most);
            REQUIRE(row->second.familyTop == topOf(phase, verdict, signs));
            ++families[*row->second.familyTop];
        }
    }
    tally.families = static_cast<std::int64_t>(all.size());
    CHECK(whole.tally == tally);
    REQUIRE(whole.families.size() == families.size());
    for (const AtlasFamily& family : whole.families) {
        REQUIRE(families[family.top] == family.schedules);
        const Verdict top = decide(range.cells, family.top, signs);
        REQUIRE(family.contact() == top.contact);
        REQUIRE(family.steps == family.top.contact + family.top.free);
        REQUIRE(family.dimension == top.set.dimension());
        REQUIRE(family.energy.least == energyRange(top).least);
        REQUIRE(family.energy.most == energyRange(top).most);
    }
    if (!range.keepsRefuted) {
        range.familiesOnly = true;
        const AtlasBatch only = decideAll(range);
        CHECK(only.tally == tally);
        CHECK(std::equal(only.families.begin(), only.families.end(), whole.families.begin(),
                         whole.families.end(), test::isSame));
        CHECK(only.rows.empty());
    }
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
    const AtlasBatch whole = decideAll(range);
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

TEST_CASE("atlas: one phase, the rows, families and counts of an exhaustive search")
{
    for (std::int64_t cells = 1; cells <= 20; ++cells) {
        AtlasRange range = smallRange(cells, 2 * cells, 8 * cells);
        range.keepsRefuted = cells % 2 == 0;
        compareWithEach(range);
    }
    std::mt19937_64 generator(5);
    for (int i = 0; i < 60; ++i) {
        const auto draw = [&generator](std::int64_t most) {
            return std::uniform_int_distribution<std::int64_t>(1, most)(generator);
        };
        AtlasRange range = smallRange(draw(18), draw(50), draw(200));
        range.keepsRefuted = i % 3 == 0;
        range.maxEnergyRatio = i % 4 == 0   ? std::numeric_limits<double>::infinity()
                               : i % 4 == 1 ? 4.0
                                            : 27.3;
        compareWithEach(range);
    }
    // Many repetitions of grazing motions, in many batches; few contacts, few flights.
    for (AtlasRange range :
         {smallRange(9, 40, 3'000), smallRange(15, 3, 2'500), smallRange(4, 2'000, 5)}) {
        range.keepsRefuted = false;
        REQUIRE(batchesOf(range) > 3);
        compareWithEach(range);
    }
}

TEST_CASE("atlas: motions of several phases repeat after the steps of their row")
{
    std::int64_t shorter = 0;
    for (const AtlasRange& range :
         {smallRange(2, 4, 7, 2), smallRange(3, 4, 6, 2), smallRange(1, 2, 4, 3)}) {
        for (const AtlasRow& row : decideAll(range).rows) {
            const Schedule schedule{range.cells, phasesAt(range, row.number)};
            INFO(describe(schedule));
            if (row.status != Status::found) {
                REQUIRE(row.steps == steps(schedule));
                continue;
            }
            REQUIRE(steps(schedule) % row.steps == 0);
            shorter += row.steps < steps(schedule) ? 1 : 0;
            const PeriodicResult least = findPeriodic(schedule);
            const PeriodicResult any = findPeriodic(schedule, {.objective = Objective::any});
            for (const PeriodicResult* result : {&least, &any}) {
                const std::vector<double> p = arrivals(result->motion->state, schedule);
                for (std::size_t m = 0; m < p.size(); ++m) {
                    const auto later = m + static_cast<std::size_t>(row.steps);
                    REQUIRE(p[m] == Approx(p[later % p.size()]).margin(1e-9));
                }
            }
            if (row.isCanonical) {
                REQUIRE(row.steps == steps(schedule));
            }
        }
    }
    CHECK(shorter > 0);
}

TEST_CASE("atlas: N = 300, n_c <= 600, n_f <= 2400: 18,012 of 1.44 million schedules exist")
{
    AtlasRange range = usualRange(300);
    CHECK(range.maxContact == 600);
    CHECK(range.maxFree == 1200);
    range.maxFree = 2400;
    const AtlasBatch whole = decideAll(range, 2);
    CHECK(whole.tally.decided == 1'440'000);
    CHECK(whole.tally.pressing == 12'962);
    CHECK(whole.tally.grazing == 5'050);
    CHECK(whole.tally.refuted == 1'440'000 - 18'012);
    CHECK(whole.rows.size() == 18'012);
    CHECK(whole.families.size() == 1'380 + 6);
    std::int64_t members = 0;
    for (const AtlasFamily& all : whole.families) {
        members += all.schedules;
    }
    CHECK(members == 18'012);
    // Rows are by n and n_c; the exhaustive search goes through them in that order.
    auto row = whole.rows.begin();
    std::vector<std::int8_t> signs;
    for (std::int64_t n = 2; n <= range.maxContact + range.maxFree; ++n) {
        for (std::int64_t contact = std::max<std::int64_t>(1, n - range.maxFree);
             contact <= std::min(range.maxContact, n - 1); ++contact) {
            const Phase phase{contact, n - contact};
            const Verdict verdict = decide(range.cells, phase, signs);
            if (!verdict.reason) {
                REQUIRE(row != whole.rows.end());
                REQUIRE(phasesAt(range, row->number).front() == phase);
                REQUIRE(row->dimension == verdict.set.dimension());
                REQUIRE(row->energy.least == energyRange(verdict).least);
                REQUIRE(row->energy.most == energyRange(verdict).most);
                ++row;
            }
        }
    }
    CHECK(row == whole.rows.end());
    range.maxEnergyRatio = 50.0;
    const AtlasBatch low = decideAll(range);
    CHECK(low.tally == whole.tally);
    CHECK(static_cast<std::ptrdiff_t>(low.rows.size()) ==
          std::count_if(whole.rows.begin(), whole.rows.end(),
                        [](const AtlasRow& kept) { return kept.energy.least <= 50.0; }));
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
    const AtlasBatch one = decideAll(range, 1);
    for (const std::int64_t threads : {2, 5}) {
        const AtlasBatch many = decideAll(range, threads);
        CHECK(many.tally == one.tally);
        REQUIRE(many.rows.size() == one.rows.size());
        CHECK(std::equal(one.rows.begin(), one.rows.end(), many.rows.begin(), isSameRow));
    }
    AtlasBatch shared;
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
    CHECK(std::equal(one.rows.begin(), one.rows.end(), shared.rows.begin(), isSameRow));
}

TEST_CASE("atlas: batches that need not be waited for are those that come next")
{
    const AtlasRange range = smallRange(20, 40, 160);
    LocalBatches source(range, 2);
    std::int64_t number = 0;
    for (auto batch = source.next(); batch; ++number) {
        CHECK(batch->number == number);
        batch = source.ready();
        if (!batch) {
            batch = source.next();
        }
    }
    CHECK(number == batchesOf(range));
    CHECK_FALSE(source.ready());
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
        LocalBatches large(
            smallRange(99'999'989, 6, 40'000'000), 2, [&soon] { return soon.load(); }, 60'000);
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
    AtlasRange pairs = smallRange(4, 8, 16, 2);
    pairs.familiesOnly = true;
    CHECK_THROWS_WITH(validate(pairs),
                      containsText("phases = 2") && containsText("families only = true"));
    CHECK_THROWS_WITH(validate(range),
                      containsText("cells = 0") && containsText("max contact = 0") &&
                          containsText("max free = -1") && containsText("phases = 99") &&
                          containsText("max energy ratio = -1"));
    CHECK_THROWS_WITH(validate(smallRange(300, 600, 1200, 4)), containsText("number of schedules"));
    CHECK_THROWS_AS(usualRange(0), std::invalid_argument);
    CHECK_THROWS_AS(LocalBatches(smallRange(1, 1, 1), 0), std::invalid_argument);
    CHECK_THROWS_AS(LocalBatches(smallRange(1, 1, 1), 1, {}, 0, 0), std::invalid_argument);
}
