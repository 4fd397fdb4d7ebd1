#include "signorini/atlas.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "faults.hpp"
#include "signorini/lumped_set.hpp"

namespace signorini {

namespace {

// Large enough that a transaction per batch costs little, small enough that an interrupted run
// loses little: some hundredths of a second of work at N = 300.
constexpr std::int64_t onePhaseBatch = 1 << 16;
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

/// Of the rotations of a list of phases: is it the first, and is it a shorter list repeated?
struct Rotation {
    bool isFirst = true;
    bool repeats = false;
};

Rotation rotationOf(const std::vector<Phase>& phases)
{
    const std::size_t count = phases.size();
    Rotation result;
    for (std::size_t shift = 1; shift < count; ++shift) {
        std::size_t k = 0;
        auto order = std::strong_ordering::equal;
        while (k < count && order == std::strong_ordering::equal) {
            order = phases[(k + shift) % count] <=> phases[k];
            ++k;
        }
        result.isFirst = result.isFirst && order != std::strong_ordering::less;
        result.repeats = result.repeats || order == std::strong_ordering::equal;
    }
    return result;
}

AtlasRow rowOf(const Verdict& verdict, std::int64_t number)
{
    AtlasRow row;
    row.number = number;
    row.status = verdict.reason ? Status::none : Status::found;
    row.reason = verdict.reason;
    row.kernelDimension = verdict.kernelDimension;
    if (!verdict.reason) {
        row.kind = verdict.set.kind;
        row.dimension = verdict.set.dimension();
        row.contact = verdict.contact;
        row.isCanonical = verdict.isCanonical();
        row.energy = energyRange(verdict);
    }
    return row;
}

/// Several phases. Beyond the limits of exact arithmetic the row stays undecided.
AtlasRow decideSeveral(const Schedule& schedule, bool repeats, std::int64_t number)
{
    AtlasRow row;
    row.number = number;
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

    // In the motion of least energy a type presses where it has contact steps and a positive sum.
    row.contact = Contact::grazing;
    row.isCanonical = !repeats;
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

/// The same for one phase; most schedules are refuted and leave no row.
void enter(const AtlasRange& range, const Verdict& verdict, std::int64_t number, AtlasBatch& batch)
{
    if (verdict.reason && !range.keepsRefuted) {
        ++batch.tally.decided;
        ++batch.tally.refuted;
    } else {
        enter(range, rowOf(verdict, number), batch);
    }
}

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
        faults.throwIfAny();
    }
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
    const std::int64_t pairs = pairsOf(range);
    return batchesFor(pairs, onePhaseBatch) +
           batchesFor(numbersOf(range) - pairs, severalPhasesBatch);
}

std::int64_t firstNumberOf(const AtlasRange& range, std::int64_t batch)
{
    const std::int64_t pairs = pairsOf(range);
    const std::int64_t onePhase = batchesFor(pairs, onePhaseBatch);
    return batch < onePhase
               ? batch * onePhaseBatch
               : std::min(numbersOf(range), pairs + (batch - onePhase) * severalPhasesBatch);
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
    const std::int64_t begin = firstNumberOf(range, batch);
    const std::int64_t end = firstNumberOf(range, batch + 1);
    const bool isOnePhase = begin < pairsOf(range);  // of batches, too: none holds both sorts
    Phase phase = phasesAt(range, begin).front();
    for (std::int64_t number = begin; number < end; ++number) {
        if (isRequested(cancel)) {
            return std::nullopt;
        }
        if (isOnePhase) {
            enter(range, decide(range.cells, phase, signs), number, result);
            phase = phase.free < range.maxFree ? Phase{phase.contact, phase.free + 1}
                                               : Phase{phase.contact + 1, 1};
            continue;
        }
        const Schedule schedule{range.cells, phasesAt(range, number)};
        const Rotation rotation = rotationOf(schedule.phases);
        if (rotation.isFirst) {
            enter(range, decideSeveral(schedule, rotation.repeats, number), result);
        }
    }
    return result;
}

}  // namespace signorini
