#pragma once
/// \file
/// An atlas kept in SQLite: written batch by batch, resumed after any interruption, asked later.
///
/// Table `schedules`, one row for each schedule kept: cells, phases as text "nc:nf[,nc:nf...]",
/// steps (n), period (n/N: dimensionless, in L/c, no seconds), frequency_ratio (4N/n), status,
/// reason, kernel_dimension, kind, dimension, contact, canonical (0 or 1), energy_ratio_min,
/// energy_ratio_max (NULL: unbounded or unknown); unique in (cells, phases), and within a run in
/// the order of the range.
///
/// Table `runs`, one row for each range: version, options, its bounds, next_batch of batches, the
/// tally so far, started, finished, seconds, workers. A batch and the progress it means are one
/// transaction, so that a process killed at any moment loses the batches in flight, nothing else.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "signorini/atlas.hpp"
#include "signorini/control.hpp"

namespace signorini {

class Connection;
class BatchWriter;

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

/// A row of table `schedules`.
struct AtlasEntry {
    Schedule schedule;
    AtlasRow row;  ///< `number`: its rowid; energies that are not known read as infinite
};

/// Decided batches, one by one, by ascending number.
class BatchSource {
public:
    BatchSource() = default;
    BatchSource(const BatchSource&) = delete;
    BatchSource& operator=(const BatchSource&) = delete;
    virtual ~BatchSource() = default;

    /// The next batch; nothing after the last one, or once cancelled.
    [[nodiscard]] virtual std::optional<AtlasBatch> next() = 0;
};

/// Schedules of one period whose motions of least energy have the same energy and differ.
using Twins = std::vector<AtlasEntry>;

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

    /// What was decided, or begun: answers to the questions below cover no more. \throws FileError.
    [[nodiscard]] std::vector<AtlasRun> runs() const;
    /// Enters a new run. `options` is kept as it stands, for people.
    /// \throws FileError, std::invalid_argument on an invalid range.
    [[nodiscard]] AtlasRun start(const AtlasRange& range, std::string_view options);
    /// Writes a batch and what it means for the run, in one transaction. `seconds` is added to the
    /// time spent. \throws FileError, and then nothing of it was written; std::invalid_argument if
    /// the batch is not the next one.
    void write(AtlasRun& run, const AtlasBatch& batch, double seconds, std::string_view workers);

    /// Every row with status found, in order; all cells, or those of N. \throws FileError.
    void forEachFound(std::optional<std::int64_t> cells,
                      const std::function<void(const AtlasEntry&)>& action) const;
    /// Schedules with motions near a point of the frequency-energy plot, nearest first: the
    /// distance is that of omega/omega_1, relative, and of the energy range, relative, as one
    /// Euclidean norm; at most `distance`. \throws FileError.
    [[nodiscard]] std::vector<AtlasEntry> near(double frequencyRatio, double energyRatio,
                                               double distance,
                                               std::optional<std::int64_t> cells = {}) const;
    /// All rows of one period T c/L, found or not. \throws FileError.
    [[nodiscard]] std::vector<AtlasEntry> ofPeriod(ExactPeriod period,
                                                   std::optional<std::int64_t> cells = {}) const;
    /// Different motions of equal T and E: among the canonical schedules of one N, those of equal n
    /// whose least energies agree to 1e-12; one of two that are each other backwards in time. By
    /// period, then energy. \throws FileError.
    [[nodiscard]] std::vector<Twins> twins(std::optional<std::int64_t> cells = {}) const;

private:
    explicit AtlasDatabase(std::unique_ptr<Connection> connection);

    std::unique_ptr<Connection> connection_;
    std::unique_ptr<BatchWriter> writer_;
};

/// How to make an atlas.
struct AtlasOptions {
    std::int64_t threads = 1;  ///< [-], of this process
    bool resume = false;       ///< go on with a run that is in the database
    Cancel cancel = {};        ///< ends after the batch being written
    std::string options = {};  ///< kept in `runs`, for people
    std::function<void(const AtlasRun&)> progress = {};  ///< called after each batch
};

/// Decides a range into a database: on threads of this process, or from any source of batches. A
/// finished run is left as it is. Returns how far it came; cancelled runs are not finished.
/// \throws FileError; std::invalid_argument on an invalid range, or if the database has an
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
