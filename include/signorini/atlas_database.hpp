#pragma once
/// \file
/// An atlas kept in SQLite: written batch by batch, resumed after any interruption, asked later.
///
/// Table `families`, one row for each set of orbits on a grid (AtlasFamily): id, cells,
/// family_order (w), nu, contact_blocks (k), phases of the top schedule as text "nc:nf", steps (n),
/// period (n/N: dimensionless, in L/c, no seconds), frequency_ratio (4N/n), contact, kind,
/// dimension, energy_ratio_min, energy_ratio_max (of this grid: it grows with N), schedules (how
/// many of the range show some of its motions; of several ranges, in the one with most); unique in
/// (cells, phases). The grazing motions of one period are a row, too, with w, nu and k NULL.
///
/// Table `schedules`, one row for each schedule kept: cells, phases as text "nc:nf[,nc:nf...]", of
/// bars in a row "SET:STEPS -:STEPS[ SET:STEPS -:STEPS...]" with one contact in each set,
/// steps (after which all its motions repeat), period (steps/N), frequency_ratio (4N/steps),
/// status, reason, kernel_dimension, kind, dimension, contact, canonical (0 or 1),
/// energy_ratio_min, energy_ratio_max (NULL: unbounded or unknown), family (the id of its family;
/// NULL: several phases, or no motion, or several segments), proof (of a refuted schedule of a bar
/// of several segments, or of bars: AtlasProof); unique in (cells, phases), and within a run by n
/// and n_c, those of several phases in the order of the range. steps is n, or less where every
/// motion repeats sooner: a repetition never has a row of its own in `families`, and in `schedules`
/// it has the frequency of its motions.
///
/// Table `runs`, one row for each range: version, options, its bounds, next_batch of batches, the
/// tally so far (schedules, and the families of those with one phase), started, finished, seconds,
/// workers. A batch and the progress it means are one transaction, so that a process killed at any
/// moment loses the batches in flight, nothing else.
///
/// All ranges of a file have a gap of one sign, runs.gap_sign. Without a gap energies have no
/// meaning: energy_ratio_min is 0, energy_ratio_max NULL. They are of one scene, runs.segments
/// (`sceneText`), empty for a uniform bar. Of bars in a row energies are in E_1 or, where there is
/// none, in J, and frequency_ratio is 4N/steps as ever, not a multiple of their first frequency.
///
/// This is version 4 of the tables (user_version). An atlas of version 1, without `families`, 2,
/// without gap_sign, or 3, without segments, is refused: decide its range anew.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "signorini/atlas.hpp"
#include "signorini/control.hpp"

namespace signorini {

class Connection;
class BatchWriter;

/// Decided batches, one by one, by ascending number.
class BatchSource {
public:
    BatchSource() = default;
    BatchSource(const BatchSource&) = delete;
    BatchSource& operator=(const BatchSource&) = delete;
    virtual ~BatchSource() = default;

    /// The next batch; nothing after the last one, or once cancelled.
    [[nodiscard]] virtual std::optional<AtlasBatch> next() = 0;
    /// The same if it need not be waited for.
    [[nodiscard]] virtual std::optional<AtlasBatch> ready() { return std::nullopt; }
};

/// Which rows of table `schedules` to read.
enum class AtlasSchedules {
    all,
    withoutFamily,  ///< of several phases, or without motions; found by an index
};

/// An atlas that exists, or is to be made.
class AtlasDatabase {
public:
    /// Opens for writing, creating file and tables where they do not exist.
    /// Waits up to a minute for others who use it, here and in `write`, unless told to stop.
    /// \throws FileError if the file cannot be used or is no atlas.
    [[nodiscard]] static AtlasDatabase create(const std::string& path, Cancel cancel = {});
    /// Opens for asking. \throws FileError if the file cannot be read or is no atlas.
    [[nodiscard]] static AtlasDatabase open(const std::string& path);
    AtlasDatabase(AtlasDatabase&&) noexcept;
    AtlasDatabase& operator=(AtlasDatabase&&) noexcept;
    ~AtlasDatabase();

    /// What was decided, or begun: answers to the questions below cover no more. \throws FileError,
    /// also where they are of several scenes.
    [[nodiscard]] std::vector<AtlasRun> runs() const;
    /// Reads every page, and every row of the tables that a range left: how many there are by what
    /// they say. \throws FileError on what no atlas would contain.
    [[nodiscard]] AtlasTally rowsOf(const AtlasRange& range) const;
    /// Enters a new run. `options` is kept as it stands, for people.
    /// \throws FileError, std::invalid_argument on an invalid range.
    [[nodiscard]] AtlasRun start(const AtlasRange& range, std::string_view options);
    /// Writes batches and what they mean for the run, in one transaction. `seconds` is added to the
    /// time spent. \throws FileError, and then nothing of it was written; std::invalid_argument if
    /// they are not the next ones.
    void write(AtlasRun& run, std::span<const AtlasBatch> batches, double seconds,
               std::string_view workers);

    /// Every family in the order of the table; all cells, or those of N. \throws FileError.
    void forEachFamily(std::optional<std::int64_t> cells,
                       const std::function<void(const AtlasFamily&)>& action) const;
    /// Every row of `schedules` with status found, in order. \throws FileError.
    void forEachFound(std::optional<std::int64_t> cells,
                      const std::function<void(const AtlasEntry&)>& action,
                      AtlasSchedules which = AtlasSchedules::all) const;
    /// The same of every row, whatever was decided. \throws FileError.
    void forEachSchedule(std::optional<std::int64_t> cells,
                         const std::function<void(const AtlasEntry&)>& action) const;
    /// Families with motions near a point of the frequency-energy plot, nearest first: the
    /// distance is that of omega/omega_1, relative, and of the energy range, relative, as one
    /// Euclidean norm; at most `distance`. \throws FileError.
    [[nodiscard]] std::vector<AtlasFamily> familiesNear(
        double frequencyRatio, double energyRatio, double distance,
        std::optional<std::int64_t> cells = {}) const;
    /// The same for schedules. \throws FileError.
    [[nodiscard]] std::vector<AtlasEntry> schedulesNear(
        double frequencyRatio, double energyRatio, double distance,
        std::optional<std::int64_t> cells = {}, AtlasSchedules which = AtlasSchedules::all) const;
    /// All families of one period T c/L. \throws FileError.
    [[nodiscard]] std::vector<AtlasFamily> familiesOfPeriod(
        ExactPeriod period, std::optional<std::int64_t> cells = {}) const;
    /// All schedules whose motions have it, and the refuted ones of that period. \throws FileError.
    [[nodiscard]] std::vector<AtlasEntry> schedulesOfPeriod(
        ExactPeriod period, std::optional<std::int64_t> cells = {},
        AtlasSchedules which = AtlasSchedules::all) const;
    /// Different orbits of equal T and E: of one N those of equal n whose least energies agree to
    /// 1e-12, among the families that press and the canonical schedules of several phases; one of
    /// two that are each other backwards in time. By period, then energy. \throws FileError.
    [[nodiscard]] std::vector<Twins> twins(std::optional<std::int64_t> cells = {}) const;

private:
    explicit AtlasDatabase(std::unique_ptr<Connection> connection);

    std::unique_ptr<Connection> connection_;
    std::unique_ptr<BatchWriter> writer_;
};

/// The bars in a row that an atlas is of, if it is.
[[nodiscard]] std::optional<Assembly> barsOf(const std::vector<AtlasRun>& runs);

/// Are schedules in families? Those of segments and of bars in a row are not.
[[nodiscard]] bool hasFamilies(const AtlasRange& range);
[[nodiscard]] bool hasFamilies(const std::vector<AtlasRun>& runs);

/// How to make an atlas.
struct AtlasOptions {
    std::int64_t threads = 1;  ///< [-], of this process
    bool resume = false;       ///< go on with a run that is in the database
    Cancel cancel = {};        ///< ends after what is being written
    std::string options = {};  ///< kept in `runs`, for people
    std::function<void(const AtlasRun&)> progress = {};  ///< called after each write
};

/// Decides a range into a database: on threads of this process, or from any source of batches. A
/// finished run is left as it is. Returns how far it came; cancelled runs are not finished.
/// \throws FileError, also where rows of a run that is there already are damaged, or not as many as
/// it wrote; std::invalid_argument on an invalid range, or if the database has an
/// unfinished run of this range and `resume` is not set, or of another range only and it is.
AtlasRun buildAtlas(AtlasDatabase& database, const AtlasRange& range,
                    const AtlasOptions& options = {});

/// The run to work on: the one in the database, or a new one. Errors as above.
[[nodiscard]] AtlasRun beginAtlas(AtlasDatabase& database, const AtlasRange& range,
                                  const AtlasOptions& options);

/// Writes batches run.nextBatch, ... as they come. `workers` is kept in `runs`, for people.
void fillAtlas(AtlasDatabase& database, AtlasRun& run, BatchSource& source,
               std::string_view workers, const AtlasOptions& options);

/// "nc:nf[,nc:nf...]".
[[nodiscard]] std::string phasesText(const std::vector<Phase>& phases);

}  // namespace signorini
