// How a range falls into batches, and what each holds.

#include <algorithm>
#include <limits>
#include <utility>

#include "atlas_programs.hpp"
#include "several_phases.hpp"
#include "signorini/atlas.hpp"
#include "stops.hpp"
#include "tents.hpp"

namespace signorini {

namespace {

// Large enough that a transaction per batch costs little, small enough that an interrupted run
// loses little and a batch fits in memory: some ten thousand rows of one phase at any N.
constexpr std::int64_t stepsPerBatch = 1 << 9;
constexpr std::int64_t stepsPerBatchOfFamilies = 1 << 12;
constexpr std::int64_t rowsPerBatchOfAll = 1 << 16;
constexpr std::int64_t severalPhasesBatch = 1 << 12;
constexpr std::int64_t programBatch = 1 << 6;  // each the search for a least norm

std::int64_t pairsOf(const AtlasRange& range)
{
    return range.maxContact * range.maxFree;
}

std::int64_t batchesFor(std::int64_t numbers, std::int64_t size)
{
    return numbers / size + (numbers % size != 0 ? 1 : 0);
}

/// How many n a batch of one phase holds.
std::int64_t stepsIn(const AtlasRange& range)
{
    if (range.familiesOnly) {
        return stepsPerBatchOfFamilies;
    }
    const std::int64_t rowsPerSteps = std::min(range.maxContact, range.maxFree);
    return range.keepsRefuted
               ? std::clamp<std::int64_t>(rowsPerBatchOfAll / rowsPerSteps, 1, stepsPerBatch)
               : stepsPerBatch;
}

/// n = 2, 3, ..., contact + free.
std::int64_t onePhaseBatches(const AtlasRange& range)
{
    return batchesFor(range.maxContact + range.maxFree - 1, stepsIn(range));
}

AtlasRow rowOf(const AtlasRange& range, const Phase& phase, const Verdict& verdict)
{
    AtlasRow row;
    row.number = (phase.contact - 1) * range.maxFree + phase.free - 1;
    row.status = verdict.reason ? Status::none : Status::found;
    row.reason = verdict.reason;
    row.kernelDimension = verdict.kernelDimension;
    row.steps = phase.contact + phase.free;
    if (!verdict.reason) {
        row.kind = verdict.set.kind;
        row.dimension = verdict.set.dimension();
        row.contact = verdict.contact;
        row.isCanonical = verdict.isCanonical();
        row.energy = energyRange(verdict);
        row.steps = ownSteps(phase, verdict);
    }
    return row;
}

/// Counts a row, and keeps it if the range asks for it.
void enter(const AtlasRange& range, const AtlasRow& row, AtlasBatch& batch)
{
    ++batch.tally.decided;
    switch (row.status) {
        case Status::found:
            ++(row.contact == Contact::pressing ? batch.tally.pressing : batch.tally.grazing);
            if (row.energy.least <= range.maxEnergyRatio) {
                batch.rows.push_back(row);
            }
            return;
        case Status::none:
            ++batch.tally.refuted;
            if (range.keepsRefuted) {
                batch.rows.push_back(row);
            }
            return;
        case Status::undecided:
            ++batch.tally.undecided;
            batch.rows.push_back(row);
            return;
    }
}

/// Some n of one phase.
class OnePhaseBatch {
public:
    OnePhaseBatch(const AtlasRange& range, AtlasBatch& batch, std::vector<std::int8_t>& signs,
                  const Cancel& cancel)
        : range_(range), tents_(range), batch_(batch), signs_(signs), cancel_(cancel)
    {
    }

    /// False if it was stopped on the way.
    bool decide(std::int64_t begin, std::int64_t end)
    {
        for (std::int64_t n = begin; n < end; ++n) {
            if (isRequested(cancel_) || !decideSteps(n)) {
                return false;
            }
        }
        const AtlasTally& tally = batch_.tally;
        batch_.tally.refuted = tally.decided - tally.pressing - tally.grazing;
        return true;
    }

private:
    bool decideSteps(std::int64_t n)
    {
        const std::int64_t last = std::min(range_.maxContact, n - 1);
        std::int64_t next = std::max<std::int64_t>(1, n - range_.maxFree);
        batch_.tally.decided += last - next + 1;
        const bool isWhole = tents_.forEach(n, [&](Tent& tent) {
            enter(tent);
            if (tent.count() == 0 || !range_.keepsRefuted) {
                return true;
            }
            const std::int64_t first = std::exchange(next, tent.last + 1);
            return refute(n, first, tent.first);
        });
        return isWhole && (!range_.keepsRefuted || refute(n, next, last + 1));
    }

    void enter(Tent& tent)
    {
        (tent.family ? batch_.tally.pressing : batch_.tally.grazing) += tent.count();
        if (tent.isOwn()) {
            batch_.tally.families += tent.count() > 0 ? 1 : 0;
            if (tent.keepsAny()) {
                batch_.families.push_back(tents_.familyOf(tent));
            }
        }
        if (range_.familiesOnly) {
            return;
        }
        for (std::int64_t contact = tent.firstKept; contact <= tent.lastKept; ++contact) {
            batch_.rows.push_back(rowOf(range_, {contact, tent.steps - contact}, tent.at(contact)));
            batch_.rows.back().familyTop = tent.top();
        }
    }

    /// The reasons of the schedules with begin <= n_c < end, between tents.
    bool refute(std::int64_t n, std::int64_t begin, std::int64_t end)
    {
        for (std::int64_t contact = begin; contact < end; ++contact) {
            if (isRequested(cancel_)) {
                return false;
            }
            const Phase phase{contact, n - contact};
            Verdict verdict = signorini::decide(range_.cells, phase, signs_, range_.gapSign);
            if (!verdict.reason) {  // a tent that the second stop is in the way of
                verdict.reason = Reason::penetration;
            }
            batch_.rows.push_back(rowOf(range_, phase, verdict));
        }
        return true;
    }

    const AtlasRange& range_;
    Tents tents_;
    AtlasBatch& batch_;
    std::vector<std::int8_t>& signs_;
    const Cancel& cancel_;
};

/// Some neighbouring numbers of what programs decide.
std::optional<AtlasBatch> decideProgramBatch(const AtlasRange& range, std::int64_t batch,
                                             const Cancel& cancel)
{
    AtlasBatch result;
    result.number = batch;
    const ProgramRows rows(range);
    const std::int64_t begin = batch * programBatch;
    const std::int64_t end = std::min(begin + programBatch, numbersOf(range));
    for (std::int64_t number = begin; number < end; ++number) {
        if (isRequested(cancel)) {
            return std::nullopt;
        }
        if (!rotationOf(phasesAt(range, number)).isFirst) {
            continue;
        }
        ProgramRow decided = rows.decide(number, cancel);
        if (isRequested(cancel)) {
            return std::nullopt;
        }
        if (decided.proof && range.keepsRefuted) {
            result.proofs.push_back({number, std::move(*decided.proof)});
        }
        enter(range, decided.row, result);
    }
    return result;
}

}  // namespace

std::int64_t batchesOf(const AtlasRange& range)
{
    if (isOfPrograms(range)) {
        return batchesFor(numbersOf(range), programBatch);
    }
    return onePhaseBatches(range) +
           batchesFor(numbersOf(range) - pairsOf(range), severalPhasesBatch);
}

std::optional<AtlasBatch> decideBatch(const AtlasRange& range, std::int64_t batch,
                                      std::vector<std::int8_t>& signs, const Cancel& cancel)
{
    if (isOfPrograms(range)) {
        return decideProgramBatch(range, batch, cancel);
    }
    AtlasBatch result;
    result.number = batch;
    const std::int64_t onePhase = onePhaseBatches(range);
    if (batch < onePhase) {
        const std::int64_t begin = 2 + batch * stepsIn(range);
        const std::int64_t end =
            std::min(begin + stepsIn(range), range.maxContact + range.maxFree + 1);
        const bool isWhole = OnePhaseBatch(range, result, signs, cancel).decide(begin, end);
        return isWhole ? std::optional(std::move(result)) : std::nullopt;
    }
    const std::int64_t begin = pairsOf(range) + (batch - onePhase) * severalPhasesBatch;
    const std::int64_t end = std::min(begin + severalPhasesBatch, numbersOf(range));
    for (std::int64_t number = begin; number < end; ++number) {
        if (isRequested(cancel)) {
            return std::nullopt;
        }
        Schedule schedule{range.cells, phasesAt(range, number), stopsOf(range)};
        const Rotation rotation = rotationOf(schedule.phases);
        if (!rotation.isFirst) {
            continue;
        }
        // Without a gap motions that only touch the wall are as small as a second stop asks for.
        const bool isAnySize = range.secondStop && canRest(schedule.phases, schedule.stops);
        if (isAnySize) {
            schedule.stops.left.reset();
        }
        AtlasRow row = decideSeveral(schedule, rotation.length, number);
        if (isAnySize && row.status == Status::found) {
            row.energy.most = std::numeric_limits<double>::quiet_NaN();
        }
        enter(range, row, result);
    }
    return result;
}

}  // namespace signorini
