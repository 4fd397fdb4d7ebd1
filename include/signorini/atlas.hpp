#pragma once
/// \file
/// The atlas: every schedule of a range decided, in memory that does not grow.
///
/// A range holds all schedules on N cells with 1..K phases of 1..maxContact contact and 1..maxFree
/// free steps each. Schedules are numbered; those of one phase come first, by contact and then by
/// free steps, those of several phases follow in the same lexicographic order. Phases that are
/// the same but for the one the period starts with are one schedule, the first in this order. All
/// are of one stop; without a gap energies have no meaning, and ranges of energy are from 0 on.
///
/// ## By what exists
///
/// The cost of one contact phase grows with the motions that exist, not with the range asked: no
/// schedule without motions is examined. The schedules that press are the tents of the grid's
/// families (modes.hpp). Those that graze are known at once: n has more factors 2 than 2N, and n_c
/// < G = gcd(2N, n); then d = G - n_c. docs/theory.md, section 14. With a negative gap none graze,
/// and those with n_f < G have motions whose tip never leaves the wall, d = G - n_f. Only a range
/// that keeps the refuted schedules asks `decide` for the reason of each. Several phases are
/// decided one by one by the exact sums
/// (`lumpedSet`).
///
/// ## A bar of several segments
///
/// It has no families: every schedule is decided one by one, as `findPeriodic` does, and a row
/// holds the least energy. What is refuted is proved in rationals; what is not is undecided.
///
/// ## Bars in a row
///
/// Each phase closes one of their contacts alone. Programs decide, as above. Energies are in E_1 of
/// the bars, or in joules where they have none (a bar drifts, or contact 1 has no gap). A schedule
/// that held bars at rest follow, or that leaves a bar untied, has motions of any size, or any
/// place: it stays undecided. Periods are multiples of h, in which a wave crosses one cell: L/c
/// means N h.

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "signorini/assembly.hpp"
#include "signorini/bar.hpp"
#include "signorini/control.hpp"
#include "signorini/modes.hpp"
#include "signorini/one_phase_set.hpp"
#include "signorini/schedule.hpp"

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
    bool familiesOnly = false;  ///< keep no schedule; one phase only
    int gapSign = 1;            ///< [-], of the gap: 1, 0 or -1
    /// Clamp first; empty: a uniform bar. Then a gap of 1 or -1, and schedules, not families, are
    /// kept.
    std::vector<Segment> segments = {};
    /// h in units of displacement (Stops::left): then phases touch either stop. Families are those
    /// of the wall that it leaves.
    std::optional<Fraction> secondStop = std::nullopt;
    /// Bars in a row in place of one bar: N cells in all; then gapSign is 1, and of segments,
    /// second stop and families there are none.
    std::optional<Assembly> bars = std::nullopt;

    friend bool operator==(const AtlasRange&, const AtlasRange&) = default;
};

/// The stops of a range.
[[nodiscard]] Stops stopsOf(const AtlasRange& range);

/// How many contacts a phase has to choose from.
[[nodiscard]] std::int64_t contactsOf(const AtlasRange& range);

/// What is decided, but for the sign of the gap and a second stop, as one line of text: nothing of
/// a uniform bar, "cells:impedance:speed:dashpot,..." of segments, "words; length wave_speed
/// axial_stiffness gravity young" of bars in a row, young 0 if it is not known.
[[nodiscard]] std::string sceneText(const AtlasRange& range);

/// Enters what such a text says. \throws std::invalid_argument on any other text.
void readScene(AtlasRange& range, std::string_view text);

/// Largest number of phases of a range.
inline constexpr std::int64_t maxAtlasPhases = 8;

/// The usual range: contact up to 2N and free flight up to 4N steps, beyond which states repeat.
/// \throws std::invalid_argument on cells outside 1..maxCells.
[[nodiscard]] AtlasRange usualRange(std::int64_t cells);

/// Reports all faults in one message; at most 2^62 numbers are allowed.
/// \throws std::invalid_argument with field, value and allowed range.
void validate(const AtlasRange& range);

/// A range as one line of text, for other processes. All its numbers come back exactly.
[[nodiscard]] std::string textOf(const AtlasRange& range);

/// \throws std::invalid_argument unless `textOf` wrote it.
[[nodiscard]] AtlasRange rangeOf(std::string_view text);

/// A set of orbits on a grid, and how many schedules of the range show some of them: the simplex of
/// a family (modes.hpp), or all grazing motions of one period, which have no (w, nu, k).
struct AtlasFamily {
    std::int64_t id = 0;           ///< of its row in a database
    std::int64_t cells = 0;        ///< [-], N
    std::optional<Family> family;  ///< none: grazing
    Phase top;                     ///< the schedule whose set is the whole; grazing: (1, 2G - 1)
    std::int64_t steps = 0;        ///< [steps], n, after which the motions repeat; grazing: 2G
    SetKind kind = SetKind::point;
    std::int64_t dimension = 0;  ///< [-], of the whole set
    EnergyRange energy;          ///< [E_1], of the whole set on this grid; `most` grows with N
    /// [-], schedules of the range with a motion of these and an energy to keep; all repetitions
    /// of grazing motions count here
    std::int64_t schedules = 0;

    [[nodiscard]] Contact contact() const { return family ? Contact::pressing : Contact::grazing; }
};

/// n/N [L/c].
[[nodiscard]] double period(const AtlasFamily& family);

/// omega/omega_1 = 4N/n.
[[nodiscard]] double frequencyRatio(const AtlasFamily& family);

/// One schedule of the range and what was decided.
struct AtlasRow {
    std::int64_t number =
        0;  ///< place in the range: of each number of phases those on the wall first
    Status status = Status::undecided;
    std::optional<Reason> reason;         ///< set exactly when there is no motion
    std::int64_t kernelDimension = -1;    ///< [-], dim ker(W - 1); -1: not known
    SetKind kind = SetKind::empty;        ///< the set of all motions
    std::int64_t dimension = -1;          ///< [-], its dimension; -1: empty or not known
    Contact contact = Contact::pressing;  ///< meaningful when there are motions
    /// Does the motion of least energy press at every contact step, and only once per period?
    bool isCanonical = false;
    /// [E_1]; most: infinite if unbounded, NaN if not known, as that up to which a second stop lets
    /// motions grow that have any size
    EnergyRange energy;
    /// [steps], after which all its motions repeat: n, or less (`ownSteps`)
    std::int64_t steps = 0;
    std::optional<Phase> familyTop;  ///< of the family it belongs to; several phases have none
};

/// How many schedules there were of each sort.
struct AtlasTally {
    std::int64_t decided = 0;    ///< all of them
    std::int64_t pressing = 0;   ///< found, with force on the wall
    std::int64_t grazing = 0;    ///< found, without force
    std::int64_t refuted = 0;    ///< proved to have no motion
    std::int64_t undecided = 0;  ///< beyond the limits of `lumpedSet`
    std::int64_t families = 0;   ///< sets of orbits that those found with one phase belong to

    AtlasTally& operator+=(const AtlasTally& other);
    friend bool operator==(const AtlasTally&, const AtlasTally&) = default;
};

/// A row of table `schedules`.
struct AtlasEntry {
    Schedule schedule;  ///< of bars in a row `Stop` numbers contacts
    AtlasRow row;       ///< `number`: its rowid; energies that are not known read as infinite
    std::optional<std::int64_t> family;  ///< id of its AtlasFamily (`row.familyTop` is not read)
    bool isOfBars = false;               ///< in a row
};

/// steps/N [L/c], of its motions.
[[nodiscard]] double period(const AtlasEntry& entry);

/// 4N/steps, of its motions.
[[nodiscard]] double frequencyRatio(const AtlasEntry& entry);

/// Different orbits of one period and one energy: the motions of least energy of families and of
/// schedules of several phases.
struct Twins {
    std::vector<AtlasFamily> families;
    std::vector<AtlasEntry> schedules;
};

/// T [L/c], omega/omega_1 and E/E_1 of all of them.
[[nodiscard]] inline double period(const Twins& twins)
{
    return twins.families.empty() ? period(twins.schedules[0]) : period(twins.families[0]);
}
[[nodiscard]] inline double frequencyRatio(const Twins& twins)
{
    return twins.families.empty() ? frequencyRatio(twins.schedules[0])
                                  : frequencyRatio(twins.families[0]);
}
[[nodiscard]] inline double energyRatio(const Twins& twins)
{
    return twins.families.empty() ? twins.schedules[0].row.energy.least
                                  : twins.families[0].energy.least;
}

/// A range in a database and how far it has come.
struct AtlasRun {
    std::int64_t id = 0;
    AtlasRange range;
    std::int64_t nextBatch = 0;  ///< the first not decided yet
    std::int64_t batches = 0;    ///< all of them
    AtlasTally tally;            ///< of the batches decided
    double seconds = 0.0;        ///< [s], spent on it by all calls together

    [[nodiscard]] bool isFinished() const { return nextBatch == batches; }
};

/// The proof that a schedule of a bar of several segments has no motion, as docs/certificates.md
/// describes its numbers, in text: multipliers over the rows of the joints form, "row:value ..." of
/// the equalities, "; ", and the same of the inequalities; or of a march backwards (`EnergyFloor`),
/// "y ..." of the waves, "; ", "contact:step:value ..." of distances, contacts from 1, "; ", and
/// the same of pushes.
struct AtlasProof {
    std::int64_t number = 0;  ///< of its row
    std::string multipliers;

    friend bool operator==(const AtlasProof&, const AtlasProof&) = default;
};

/// What one thread decides at a time, and one transaction writes: of one phase some neighbouring n,
/// of several some neighbouring numbers.
struct AtlasBatch {
    std::int64_t number = 0;            ///< place among the batches of the range
    AtlasTally tally;                   ///< of all its schedules
    std::vector<AtlasFamily> families;  ///< whose n is in it, by n and k
    std::vector<AtlasRow> rows;  ///< those to keep, by n and n_c; of several phases by number
    std::vector<AtlasProof> proofs = {};  ///< of refuted rows that are kept, ascending
};

/// How many numbers the range has. Rotations of a schedule have numbers, but are skipped. O(1).
[[nodiscard]] std::int64_t numbersOf(const AtlasRange& range);

/// How many batches the range falls into. O(1).
[[nodiscard]] std::int64_t batchesOf(const AtlasRange& range);

/// The phases with a number in the range. O(K).
[[nodiscard]] std::vector<Phase> phasesAt(const AtlasRange& range, std::int64_t number);

/// Decides one batch; nothing if it was stopped on the way. `signs` is room to work in, to be
/// passed again. A row of a family follows it, in the same batch or a later one. \pre
/// `validate(range)` holds and 0 <= batch < batchesOf(range).
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
/// sooner), G if the tip never leaves the wall, 2G if they graze, as p is then antiperiodic after G
/// steps whatever n is (single members with p antiperiodic after G/3, G/5, ... repeat sooner).
/// O(1). \throws std::invalid_argument if the set is empty.
[[nodiscard]] std::int64_t ownSteps(const Phase& phase, const Verdict& verdict);

}  // namespace signorini
