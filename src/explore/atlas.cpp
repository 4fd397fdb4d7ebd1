#include "signorini/atlas.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "faults.hpp"
#include "signorini/lumped_set.hpp"
#include "tents.hpp"

namespace signorini {

namespace {

// Large enough that a transaction per batch costs little, small enough that an interrupted run
// loses little and a batch fits in memory: some ten thousand rows of one phase at any N.
constexpr std::int64_t stepsPerBatch = 1 << 9;
constexpr std::int64_t stepsPerBatchOfFamilies = 1 << 12;
constexpr std::int64_t rowsPerBatchOfAll = 1 << 16;
constexpr std::int64_t severalPhasesBatch = 1 << 12;

std::int64_t pairsOf(const AtlasRange& range)
{
    return range.maxContact * range.maxFree;
}

std::int64_t batchesFor(std::int64_t numbers, std::int64_t size)
{
    return numbers / size + (numbers % size != 0 ? 1 : 0);
}

/// pairs + pairs^2 + ... + pairs^phases, if that is at most 2^62.
std::optional<std::int64_t> countNumbers(std::int64_t contact, std::int64_t free,
                                         std::int64_t phases)
{
    constexpr std::int64_t limit = maxSteps;
    if (contact > limit / free) {
        return std::nullopt;
    }
    const std::int64_t pairs = contact * free;
    std::int64_t power = 1;
    std::int64_t sum = 0;
    for (std::int64_t k = 0; k < phases; ++k) {
        if (power > limit / pairs || sum > limit - power * pairs) {
            return std::nullopt;
        }
        power *= pairs;
        sum += power;
    }
    return sum;
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

/// Of the rotations of a list of phases: is it the first, and how long is the list it repeats?
struct Rotation {
    bool isFirst = true;
    std::size_t length = 0;  ///< of the shortest list that it repeats
};

Rotation rotationOf(const std::vector<Phase>& phases)
{
    const std::size_t count = phases.size();
    Rotation result{.length = count};
    for (std::size_t shift = count - 1; shift > 0; --shift) {
        std::size_t k = 0;
        auto order = std::strong_ordering::equal;
        while (k < count && order == std::strong_ordering::equal) {
            order = phases[(k + shift) % count] <=> phases[k];
            ++k;
        }
        result.isFirst = result.isFirst && order != std::strong_ordering::less;
        result.length = order == std::strong_ordering::equal ? shift : result.length;
    }
    return result;
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

/// The steps after which all motions of several phases repeat: where no live class touches the wall
/// p is antiperiodic after 2N; a list of phases that repeats a shorter one with as large a kernel
/// has the same motions.
std::int64_t ownSteps(const Schedule& schedule, std::size_t length, const ClassTypes& classes)
{
    const std::int64_t n = steps(schedule);
    if (std::none_of(classes.types.begin(), classes.types.end(), [](const ClassType& type) {
            return type.isLive() && type.contactMembers > 0;
        })) {
        return std::gcd(4 * schedule.cells, n);
    }
    if (length == schedule.phases.size()) {
        return n;
    }
    Schedule once{
        schedule.cells,
        {schedule.phases.begin(), schedule.phases.begin() + static_cast<std::ptrdiff_t>(length)}};
    return classTypes(once).kernelDimension == classes.kernelDimension ? steps(once) : n;
}

/// Several phases. Beyond the limits of exact arithmetic the row stays undecided.
AtlasRow decideSeveral(const Schedule& schedule, std::size_t length, std::int64_t number)
{
    AtlasRow row;
    row.number = number;
    row.steps = steps(schedule);
    LumpedSet set;
    try {
        set = lumpedSet(schedule);
    } catch (const std::overflow_error&) {
        return row;
    } catch (const std::invalid_argument&) {
        return row;
    }
    row.kernelDimension = set.classes.kernelDimension;
    if (set.absence) {
        row.status = Status::none;
        row.reason = absenceReason(set.classes);
        return row;
    }
    const LumpedShape shape = shapeOf(set);
    row.status = Status::found;
    row.kind = shape.kind;
    row.dimension = shape.dimension;
    row.energy = {set.leastEnergy, shape.energy.most};
    row.steps = ownSteps(schedule, length, set.classes);

    // In the motion of least energy a type presses where it has contact steps and a positive sum.
    row.contact = Contact::grazing;
    row.isCanonical = length == schedule.phases.size();
    std::size_t place = 0;
    for (const ClassType& type : set.classes.types) {
        const bool isPressed = type.isLive() && set.leastSums[place] > 0.0;
        place += type.isLive() ? 1 : 0;
        if (type.contactMembers > 0 && isPressed) {
            row.contact = Contact::pressing;
        } else if (type.contactMembers > 0) {
            row.isCanonical = false;
        }
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
        if (tent.keepsAny() && tent.isOwn()) {
            batch_.families.push_back(tents_.familyOf(tent));
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
            batch_.rows.push_back(
                rowOf(range_, phase, signorini::decide(range_.cells, phase, signs_)));
        }
        return true;
    }

    const AtlasRange& range_;
    Tents tents_;
    AtlasBatch& batch_;
    std::vector<std::int8_t>& signs_;
    const Cancel& cancel_;
};

}  // namespace

AtlasRange usualRange(std::int64_t cells)
{
    if (cells < 1 || cells > maxCells) {
        Faults faults;
        faults.add("cells", cells, fmt::format("1..{}", maxCells));
        faults.throwIfAny();
    }
    AtlasRange range;
    range.cells = cells;
    range.maxContact = 2 * cells;
    range.maxFree = 4 * cells;
    return range;
}

void validate(const AtlasRange& range)
{
    Faults faults;
    const auto check = [&faults](const char* field, std::int64_t value, std::int64_t most) {
        if (value < 1 || value > most) {
            faults.add(field, value, fmt::format("1..{}", most));
        }
    };
    check("cells", range.cells, maxCells);
    check("max contact", range.maxContact, maxSteps / (2 * maxAtlasPhases));
    check("max free", range.maxFree, maxSteps / (2 * maxAtlasPhases));
    check("phases", range.maxPhases, maxAtlasPhases);
    if (!(range.maxEnergyRatio > 0.0)) {
        faults.add("max energy ratio", range.maxEnergyRatio, "numbers > 0 [E_1]");
    }
    faults.throwIfAny();
    if (!countNumbers(range.maxContact, range.maxFree, range.maxPhases)) {
        faults.add("the number of schedules", "more than 2^62", "at most 2^62");
    }
    if (range.familiesOnly && range.maxPhases != 1) {
        faults.add("phases", range.maxPhases, "1 where families alone are kept");
    }
    if (range.familiesOnly && range.keepsRefuted) {
        faults.add("families only", true, "false where refuted schedules are kept");
    }
    faults.throwIfAny();
}

double period(const AtlasFamily& family)
{
    return static_cast<double>(family.steps) / static_cast<double>(family.cells);
}

double frequencyRatio(const AtlasFamily& family)
{
    return 4.0 * static_cast<double>(family.cells) / static_cast<double>(family.steps);
}

AtlasTally& AtlasTally::operator+=(const AtlasTally& other)
{
    decided += other.decided;
    pressing += other.pressing;
    grazing += other.grazing;
    refuted += other.refuted;
    undecided += other.undecided;
    return *this;
}

std::int64_t numbersOf(const AtlasRange& range)
{
    return countNumbers(range.maxContact, range.maxFree, range.maxPhases).value();
}

std::int64_t batchesOf(const AtlasRange& range)
{
    return onePhaseBatches(range) +
           batchesFor(numbersOf(range) - pairsOf(range), severalPhasesBatch);
}

std::vector<Phase> phasesAt(const AtlasRange& range, std::int64_t number)
{
    const std::int64_t pairs = pairsOf(range);
    std::size_t count = 1;
    for (std::int64_t power = pairs; number >= power; power *= pairs) {
        number -= power;
        ++count;
    }
    std::vector<Phase> phases(count);
    for (std::size_t k = count; k-- > 0; number /= pairs) {
        const std::int64_t pair = number % pairs;
        phases[k] = {pair / range.maxFree + 1, pair % range.maxFree + 1};
    }
    return phases;
}

std::optional<AtlasBatch> decideBatch(const AtlasRange& range, std::int64_t batch,
                                      std::vector<std::int8_t>& signs, const Cancel& cancel)
{
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
        const Schedule schedule{range.cells, phasesAt(range, number)};
        const Rotation rotation = rotationOf(schedule.phases);
        if (rotation.isFirst) {
            enter(range, decideSeveral(schedule, rotation.length, number), result);
        }
    }
    return result;
}

}  // namespace signorini
