#pragma once
/// \file
/// The atlas: every schedule of a range decided, one after the other, in memory that does not grow.
///
/// A range holds all schedules on N cells with 1..K phases of 1..maxContact contact and 1..maxFree
/// free steps each. Schedules are numbered; those of one phase come first, by contact and then by
/// free steps, those of several phases follow in the same lexicographic order. Phases that are
/// the same but for the one the period starts with are one schedule, the first in this order.
///
/// One phase is decided by the closed form (`decide`), several by the exact sums (`lumpedSet`).
///
/// ## By what exists
///
/// The atlas of one contact phase by what exists: every schedule of a range that has motions, in
/// time that grows with their number and not with the size of the range.
///
/// The schedules that press are the tents of the grid's families (families.hpp). Those that graze
/// are known at once: n has more factors 2 than 2N, and n_c < G = gcd(2N, n); then d = G - n_c.
/// docs/theory.md, section 14.

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "signorini/control.hpp"
#include "signorini/one_phase_set.hpp"
#include "signorini/schedule.hpp"
#include "signorini/verdict.hpp"

namespace signorini {

/// Which schedules to decide, and which of them to keep.
struct AtlasRange {
    std::int64_t cells = 300;       ///< [-], N
    std::int64_t maxContact = 600;  ///< [steps], of each phase
    std::int64_t maxFree = 1200;    ///< [steps], of each phase
    std::int64_t maxPhases = 1;     ///< [-], K
    /// [E_1]; sets whose least energy is higher are counted, not kept.
    double maxEnergyRatio = std::numeric_limits<double>::infinity();
    bool keepsRefuted = false;  ///< keep the schedules that no motion follows, too

    friend bool operator==(const AtlasRange&, const AtlasRange&) = default;
};

/// Largest number of phases of a range.
inline constexpr std::int64_t maxAtlasPhases = 8;

/// The usual range: contact up to 2N and free flight up to 4N steps, beyond which states repeat.
/// \throws std::invalid_argument on cells outside 1..maxCells.
[[nodiscard]] AtlasRange usualRange(std::int64_t cells);

/// Reports all faults in one message; at most 2^62 numbers are allowed.
/// \throws std::invalid_argument with field, value and allowed range.
void validate(const AtlasRange& range);

/// One schedule of the range and what was decided.
struct AtlasRow {
    std::int64_t number = 0;  ///< place in the range
    Status status = Status::undecided;
    std::optional<Reason> reason;         ///< set exactly when there is no motion
    std::int64_t kernelDimension = -1;    ///< [-], dim ker(W - 1); -1: not known
    SetKind kind = SetKind::empty;        ///< the set of all motions
    std::int64_t dimension = -1;          ///< [-], its dimension; -1: empty or not known
    Contact contact = Contact::pressing;  ///< meaningful when there are motions
    /// Does the motion of least energy press at every contact step, and only once per period?
    bool isCanonical = false;
    EnergyRange energy;  ///< [E_1]; most: infinite if unbounded, NaN if not known
};

/// How many schedules there were of each sort.
struct AtlasTally {
    std::int64_t decided = 0;    ///< all of them
    std::int64_t pressing = 0;   ///< found, with force on the wall
    std::int64_t grazing = 0;    ///< found, without force
    std::int64_t refuted = 0;    ///< proved to have no motion
    std::int64_t undecided = 0;  ///< beyond the limits of `lumpedSet`

    AtlasTally& operator+=(const AtlasTally& other);
    friend bool operator==(const AtlasTally&, const AtlasTally&) = default;
};

/// The numbers begin..end-1 of a range: what one thread decides at a time, and one transaction
/// writes.
struct AtlasBatch {
    std::int64_t number = 0;     ///< place among the batches of the range
    AtlasTally tally;            ///< of all its schedules
    std::vector<AtlasRow> rows;  ///< those to keep, by number
};

/// How many numbers the range has. Rotations of a schedule have numbers, but are skipped. O(1).
[[nodiscard]] std::int64_t numbersOf(const AtlasRange& range);

/// How many batches the range falls into. O(1).
[[nodiscard]] std::int64_t batchesOf(const AtlasRange& range);

/// The first number of a batch; of the batch after the last: `numbersOf(range)`. O(1).
[[nodiscard]] std::int64_t firstNumberOf(const AtlasRange& range, std::int64_t batch);

/// The phases with a number in the range. O(K).
[[nodiscard]] std::vector<Phase> phasesAt(const AtlasRange& range, std::int64_t number);

/// Decides one batch; nothing if it was stopped on the way. `signs` is room to work in, to be
/// passed again. \pre `validate(range)` holds and 0 <= batch < batchesOf(range).
[[nodiscard]] std::optional<AtlasBatch> decideBatch(const AtlasRange& range, std::int64_t batch,
                                                    std::vector<std::int8_t>& signs,
                                                    const Cancel& cancel = {});

/// Asked for each schedule that has motions; false ends the search.
using ScheduleVisitor = std::function<bool(const Phase&, const Verdict&)>;

/// Visits the schedules of a range that have motions, by ascending n and then n_c, each with
/// the verdict of `decide`, number by number; those with a least energy above
/// `range.maxEnergyRatio` are left out. O(log N) for each n < 4N and O(1) for each schedule
/// visited, no memory: 0.1 ms at N = 300 (18,012 schedules with n_f <= 8N).
/// \returns false if the visitor or `cancel` ended it.
/// \throws std::invalid_argument on an invalid range, or one of several phases.
bool forEachSchedule(const AtlasRange& range, const ScheduleVisitor& visitor,
                     const Cancel& cancel = {});

/// The steps after which the motions of a schedule repeat: n if they press (no member repeats
/// sooner), 2G if they graze, as p is then antiperiodic after G steps whatever n is (single members
/// with p antiperiodic after G/3, G/5, ... repeat sooner). O(1).
/// \throws std::invalid_argument if the set is empty.
[[nodiscard]] std::int64_t ownSteps(const Phase& phase, const Verdict& verdict);

}  // namespace signorini
