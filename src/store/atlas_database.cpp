#include "signorini/atlas_database.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <stdexcept>
#include <utility>

#include "atlas_batches.hpp"
#include "atlas_rows.hpp"
#include "signorini/config.hpp"
#include "signorini/output.hpp"
#include "sqlite.hpp"

namespace signorini {

namespace {

/// Marks the file as an atlas: "sgnr".
constexpr std::int64_t applicationId = 0x73676e72;
constexpr std::int64_t schemaVersion = 1;
/// Energies of twins agree to this, relative.
constexpr double twinTolerance = 1e-12;

constexpr const char* schema = R"(
CREATE TABLE schedules(
  cells INTEGER NOT NULL, phases TEXT NOT NULL, steps INTEGER NOT NULL, period REAL NOT NULL,
  frequency_ratio REAL NOT NULL, status TEXT NOT NULL, reason TEXT, kernel_dimension INTEGER,
  kind TEXT, dimension INTEGER, contact TEXT, canonical INTEGER,
  energy_ratio_min REAL, energy_ratio_max REAL, UNIQUE(cells, phases));
CREATE TABLE runs(
  id INTEGER PRIMARY KEY, version TEXT NOT NULL, options TEXT NOT NULL, cells INTEGER NOT NULL,
  max_contact INTEGER NOT NULL, max_free INTEGER NOT NULL, phases INTEGER NOT NULL,
  max_energy_ratio REAL, keeps_refuted INTEGER NOT NULL, batches INTEGER NOT NULL,
  next_batch INTEGER NOT NULL, decided INTEGER NOT NULL, pressing INTEGER NOT NULL,
  grazing INTEGER NOT NULL, refuted INTEGER NOT NULL, undecided INTEGER NOT NULL,
  started TEXT NOT NULL, finished TEXT, seconds REAL NOT NULL, workers TEXT NOT NULL);
CREATE UNIQUE INDEX one_run_per_range ON runs(
  cells, max_contact, max_free, phases, ifnull(max_energy_ratio, -1), keeps_refuted);
PRAGMA application_id = 1936158322;
PRAGMA user_version = 1;
)";
static_assert(applicationId == 1936158322 && schemaVersion == 1, "as written in the schema");

constexpr std::string_view insertRow =
    "INSERT OR IGNORE INTO schedules(cells, phases, steps, period, frequency_ratio, status, "
    "reason, kernel_dimension, kind, dimension, contact, canonical, energy_ratio_min, "
    "energy_ratio_max) VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)";

constexpr std::string_view updateRun =
    "UPDATE runs SET next_batch = ?, decided = ?, pressing = ?, grazing = ?, refuted = ?, "
    "undecided = ?, finished = ?, seconds = ?, workers = ?, version = ? "
    "WHERE id = ? AND next_batch = ?";

std::string now()
{
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

/// Makes sure that an open file is an atlas of this version.
void requireAtlas(const std::string& path, Connection& connection)
{
    if (connection.number("PRAGMA application_id") != applicationId) {
        throw FileError(path, "cannot use: it is no atlas of signorini");
    }
    const std::int64_t version = connection.number("PRAGMA user_version");
    if (version != schemaVersion) {
        throw FileError(path, fmt::format("cannot use: it is an atlas of version {}: allowed {}",
                                          version, schemaVersion));
    }
}

/// Entries of a query whose parameters are bound already.
std::vector<AtlasEntry> readAll(Statement statement)
{
    std::vector<AtlasEntry> entries;
    while (statement.step()) {
        entries.push_back(readEntry(statement));
    }
    return entries;
}

/// The phases of the same motion run backwards in time, the first of their rotations.
std::vector<Phase> backwards(const std::vector<Phase>& phases)
{
    const std::size_t count = phases.size();
    std::vector<Phase> mirror;
    for (std::size_t j = count; j-- > 0;) {
        // Each contact, then the flight that came before it.
        mirror.push_back({phases[j].contact, phases[(j + count - 1) % count].free});
    }
    std::vector<Phase> first = mirror;
    for (std::size_t shift = 1; shift < count; ++shift) {
        std::rotate(mirror.begin(), mirror.begin() + 1, mirror.end());
        first = std::min(first, mirror);
    }
    return first;
}

/// " AND cells = N" or nothing, for queries whose condition ends there.
std::string onCells(std::optional<std::int64_t> cells)
{
    return cells ? fmt::format(" AND cells = {}", *cells) : std::string();
}

}  // namespace

/// The statements that write batches, prepared once.
class BatchWriter {
public:
    explicit BatchWriter(const Connection& connection)
        : insert_(connection, insertRow), update_(connection, updateRun)
    {
    }

    void insert(const AtlasRange& range, const AtlasRow& row)
    {
        const Schedule schedule{range.cells, phasesAt(range, row.number)};
        const bool isFound = row.status == Status::found;
        insert_.bind(0, range.cells)
            .bind(1, phasesText(schedule.phases))
            .bind(2, steps(schedule))
            .bind(3, period(schedule))
            .bind(4, frequencyRatio(schedule))
            .bind(5, name(row.status));
        row.reason ? insert_.bind(6, name(*row.reason)) : insert_.bindNull(6);
        row.kernelDimension >= 0 ? insert_.bind(7, row.kernelDimension) : insert_.bindNull(7);
        if (isFound) {
            insert_.bind(8, name(row.kind))
                .bind(9, row.dimension)
                .bind(10, name(row.contact))
                .bind(11, std::int64_t{row.isCanonical ? 1 : 0})
                .bind(12, row.energy.least)
                .bind(13, row.energy.most);
        } else {
            for (int k = 8; k <= 13; ++k) {
                insert_.bindNull(k);
            }
        }
        insert_.execute();
    }

    void update(const AtlasRun& run, std::string_view workers)
    {
        update_.bind(0, run.nextBatch)
            .bind(1, run.tally.decided)
            .bind(2, run.tally.pressing)
            .bind(3, run.tally.grazing)
            .bind(4, run.tally.refuted)
            .bind(5, run.tally.undecided);
        run.isFinished() ? update_.bind(6, now()) : update_.bindNull(6);
        update_.bind(7, run.seconds)
            .bind(8, workers)
            .bind(9, SIGNORINI_VERSION)
            .bind(10, run.id)
            .bind(11, run.nextBatch - 1)
            .execute();
    }

private:
    Statement insert_;
    Statement update_;
};

AtlasDatabase::AtlasDatabase(std::unique_ptr<Connection> connection)
    : connection_(std::move(connection))
{
}
AtlasDatabase::AtlasDatabase(AtlasDatabase&&) noexcept = default;
AtlasDatabase& AtlasDatabase::operator=(AtlasDatabase&&) noexcept = default;
AtlasDatabase::~AtlasDatabase() = default;

AtlasDatabase AtlasDatabase::create(const std::string& path, Cancel cancel)
{
    auto connection = std::make_unique<Connection>(path, DatabaseMode::write, std::move(cancel));
    {
        Transaction transaction(*connection);
        if (connection->number("SELECT COUNT(*) FROM sqlite_master") == 0 &&
            connection->number("PRAGMA application_id") == 0) {
            connection->run(schema);
        }
        requireAtlas(path, *connection);
        transaction.commit();
    }
    // A rollback journal works on network file systems too. Nothing is lost if the process dies.
    connection->run("PRAGMA journal_mode = DELETE; PRAGMA synchronous = NORMAL;");
    AtlasDatabase database(std::move(connection));
    database.writer_ = std::make_unique<BatchWriter>(*database.connection_);
    return database;
}

AtlasDatabase AtlasDatabase::open(const std::string& path)
{
    auto connection = std::make_unique<Connection>(path, DatabaseMode::read);
    requireAtlas(path, *connection);
    return AtlasDatabase(std::move(connection));
}

std::vector<AtlasRun> AtlasDatabase::runs() const
{
    Statement s(*connection_, std::string(runColumns) + "ORDER BY id");
    std::vector<AtlasRun> all;
    while (s.step()) {
        all.push_back(readRun(s));
    }
    return all;
}

AtlasRun AtlasDatabase::start(const AtlasRange& range, std::string_view options)
{
    validate(range);
    AtlasRun run;
    run.range = range;
    run.batches = batchesOf(range);
    Statement(*connection_,
              "INSERT INTO runs(version, options, cells, max_contact, max_free, phases, "
              "max_energy_ratio, keeps_refuted, batches, next_batch, decided, pressing, grazing, "
              "refuted, undecided, started, seconds, workers) "
              "VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, 0, 0, 0, 0, 0, 0, ?, 0, '')")
        .bind(0, SIGNORINI_VERSION)
        .bind(1, options)
        .bind(2, range.cells)
        .bind(3, range.maxContact)
        .bind(4, range.maxFree)
        .bind(5, range.maxPhases)
        .bind(6, range.maxEnergyRatio)
        .bind(7, std::int64_t{range.keepsRefuted ? 1 : 0})
        .bind(8, run.batches)
        .bind(9, now())
        .execute();
    run.id = connection_->lastId();
    return run;
}

void AtlasDatabase::write(AtlasRun& run, const AtlasBatch& batch, double seconds,
                          std::string_view workers)
{
    if (batch.number != run.nextBatch || run.isFinished()) {
        throw std::invalid_argument(fmt::format("batch = {} is out of order: allowed {} of {}",
                                                batch.number, run.nextBatch, run.batches));
    }
    AtlasRun after = run;
    after.nextBatch += 1;
    after.tally += batch.tally;
    after.seconds += seconds;
    Transaction transaction(*connection_);
    for (const AtlasRow& row : batch.rows) {
        writer_->insert(run.range, row);
    }
    writer_->update(after, workers);
    if (connection_->changes() != 1) {
        throw FileError("run " + std::to_string(run.id),
                        "cannot use: another process is writing the same range");
    }
    transaction.commit();
    run = after;
}

void AtlasDatabase::forEachFound(std::optional<std::int64_t> cells,
                                 const std::function<void(const AtlasEntry&)>& action) const
{
    Statement s(*connection_, std::string(entryColumns) +
                                  "WHERE status NOT IN ('none', 'undecided')" + onCells(cells) +
                                  " ORDER BY rowid");
    while (s.step()) {
        action(readEntry(s));
    }
}

std::vector<AtlasEntry> AtlasDatabase::near(double frequencyRatio, double energyRatio,
                                            double distance,
                                            std::optional<std::int64_t> cells) const
{
    Statement s(*connection_,
                std::string(entryColumns) +
                    "WHERE status NOT IN ('none', 'undecided') AND frequency_ratio BETWEEN ? AND ?"
                    " AND energy_ratio_min <= ? AND ifnull(energy_ratio_max, ?) >= ?" +
                    onCells(cells));
    const double most = energyRatio * (1.0 + distance);
    s.bind(0, frequencyRatio * (1.0 - distance))
        .bind(1, frequencyRatio * (1.0 + distance))
        .bind(2, most)
        .bind(3, most)
        .bind(4, energyRatio * (1.0 - distance));
    std::vector<std::pair<double, AtlasEntry>> found;
    for (AtlasEntry& entry : readAll(std::move(s))) {
        const double across = signorini::frequencyRatio(entry.schedule) / frequencyRatio - 1.0;
        const double inside =
            std::clamp(energyRatio, entry.row.energy.least, entry.row.energy.most);
        const double apart = std::hypot(across, inside / energyRatio - 1.0);
        if (apart <= distance) {
            found.emplace_back(apart, std::move(entry));
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<AtlasEntry> entries;
    entries.reserve(found.size());
    for (auto& [apart, entry] : found) {
        entries.push_back(std::move(entry));
    }
    return entries;
}

std::vector<AtlasEntry> AtlasDatabase::ofPeriod(ExactPeriod period,
                                                std::optional<std::int64_t> cells) const
{
    Statement s(*connection_, std::string(entryColumns) +
                                  "WHERE cells % ? = 0 AND steps = cells / ? * ?" + onCells(cells) +
                                  " ORDER BY cells, rowid");
    s.bind(0, period.denominator).bind(1, period.denominator).bind(2, period.numerator);
    return readAll(std::move(s));
}

std::vector<Twins> AtlasDatabase::twins(std::optional<std::int64_t> cells) const
{
    Statement s(*connection_, std::string(entryColumns) +
                                  "WHERE status NOT IN ('none', 'undecided') AND canonical = 1" +
                                  onCells(cells) +
                                  " ORDER BY cells, steps, energy_ratio_min, rowid");
    std::vector<Twins> all;
    Twins group;
    const auto close = [&all, &group] {
        if (group.size() > 1) {
            all.push_back(std::move(group));
        }
        group.clear();
    };
    while (s.step()) {
        AtlasEntry entry = readEntry(s);
        if (!group.empty()) {
            const AtlasEntry& first = group.front();
            const bool isTwin =
                entry.schedule.cells == first.schedule.cells &&
                steps(entry.schedule) == steps(first.schedule) &&
                entry.row.energy.least <= first.row.energy.least * (1.0 + twinTolerance);
            if (!isTwin) {
                close();
            }
        }
        const std::vector<Phase> mirror = backwards(entry.schedule.phases);
        const bool isKnown = std::any_of(
            group.begin(), group.end(),
            [&mirror](const AtlasEntry& other) { return other.schedule.phases == mirror; });
        if (!isKnown) {
            group.push_back(std::move(entry));
        }
    }
    close();
    return all;
}

AtlasRun beginAtlas(AtlasDatabase& database, const AtlasRange& range, const AtlasOptions& options)
{
    validate(range);
    const std::vector<AtlasRun> runs = database.runs();
    const auto before = std::find_if(runs.begin(), runs.end(),
                                     [&range](const AtlasRun& run) { return run.range == range; });
    if (before == runs.end()) {
        const bool othersWait = std::any_of(runs.begin(), runs.end(),
                                            [](const AtlasRun& run) { return !run.isFinished(); });
        if (options.resume && othersWait) {
            throw std::invalid_argument(
                "resume (--resume): the unfinished run in the database is of another range: "
                "allowed the same bounds and choice of what to keep");
        }
        return database.start(range, options.options);
    }
    if (before->batches != batchesOf(range)) {
        throw FileError("run " + std::to_string(before->id),
                        "cannot use: another version divided the range differently");
    }
    if (!before->isFinished() && !options.resume) {
        throw std::invalid_argument(fmt::format(
            "the database has decided {} of {} batches of this range: allowed only with "
            "resume (--resume), or another file",
            before->nextBatch, before->batches));
    }
    return *before;
}

void fillAtlas(AtlasDatabase& database, AtlasRun& run, BatchSource& source,
               std::string_view workers, const AtlasOptions& options)
{
    using Clock = std::chrono::steady_clock;
    Clock::time_point last = Clock::now();
    while (const std::optional<AtlasBatch> batch = source.next()) {
        const Clock::time_point here = Clock::now();
        database.write(run, *batch, std::chrono::duration<double>(here - last).count(), workers);
        last = here;
        if (options.progress) {
            options.progress(run);
        }
    }
}

AtlasRun buildAtlas(AtlasDatabase& database, const AtlasRange& range, const AtlasOptions& options)
{
    AtlasRun run = beginAtlas(database, range, options);
    LocalBatches source(range, options.threads, options.cancel, run.nextBatch);
    fillAtlas(database, run, source, fmt::format("{} threads", source.threads()), options);
    return run;
}

std::string phasesText(const std::vector<Phase>& phases)
{
    std::string text;
    for (const Phase& phase : phases) {
        text += fmt::format("{}{}:{}", text.empty() ? "" : ",", phase.contact, phase.free);
    }
    return text;
}

}  // namespace signorini
