#include "signorini/atlas_database.hpp"

#include <SQLiteCpp/Transaction.h>
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cmath>
#include <ctime>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "atlas_rows.hpp"
#include "connection.hpp"
#include "contact_spans.hpp"
#include "signorini/config.hpp"

namespace signorini {

namespace {

/// Marks the file as an atlas: "sgnr".
constexpr std::int64_t applicationId = 0x73676e72;
constexpr std::int64_t schemaVersion = 4;

constexpr const char* schema = R"(
CREATE TABLE families(
  id INTEGER PRIMARY KEY, cells INTEGER NOT NULL, family_order INTEGER, nu INTEGER,
  contact_blocks INTEGER, phases TEXT NOT NULL, steps INTEGER NOT NULL, period REAL NOT NULL,
  frequency_ratio REAL NOT NULL, contact TEXT NOT NULL, kind TEXT NOT NULL,
  dimension INTEGER NOT NULL, energy_ratio_min REAL NOT NULL, energy_ratio_max REAL,
  schedules INTEGER NOT NULL, UNIQUE(cells, phases));
CREATE TABLE schedules(
  cells INTEGER NOT NULL, phases TEXT NOT NULL, steps INTEGER NOT NULL, period REAL NOT NULL,
  frequency_ratio REAL NOT NULL, status TEXT NOT NULL, reason TEXT, kernel_dimension INTEGER,
  kind TEXT, dimension INTEGER, contact TEXT, canonical INTEGER,
  energy_ratio_min REAL, energy_ratio_max REAL, family INTEGER REFERENCES families(id),
  proof TEXT, UNIQUE(cells, phases));
CREATE INDEX schedules_without_family ON schedules(cells, steps) WHERE family IS NULL;
CREATE TABLE runs(
  id INTEGER PRIMARY KEY, version TEXT NOT NULL, options TEXT NOT NULL, cells INTEGER NOT NULL,
  max_contact INTEGER NOT NULL, max_free INTEGER NOT NULL, phases INTEGER NOT NULL,
  max_energy_ratio REAL, keeps_refuted INTEGER NOT NULL, families_only INTEGER NOT NULL,
  gap_sign INTEGER NOT NULL, segments TEXT NOT NULL, second_stop TEXT,
  batches INTEGER NOT NULL, next_batch INTEGER NOT NULL, decided INTEGER NOT NULL,
  pressing INTEGER NOT NULL, grazing INTEGER NOT NULL, refuted INTEGER NOT NULL,
  undecided INTEGER NOT NULL, families INTEGER NOT NULL,
  started TEXT NOT NULL, finished TEXT, seconds REAL NOT NULL, workers TEXT NOT NULL);
CREATE UNIQUE INDEX one_run_per_range ON runs(
  cells, max_contact, max_free, phases, ifnull(max_energy_ratio, -1), keeps_refuted,
  families_only);
PRAGMA application_id = 1936158322;
PRAGMA user_version = 4;
)";
static_assert(applicationId == 1936158322 && schemaVersion == 4, "as written in the schema");

constexpr const char* insertRow =
    "INSERT OR IGNORE INTO schedules(cells, phases, steps, period, frequency_ratio, status, "
    "reason, kernel_dimension, kind, dimension, contact, canonical, energy_ratio_min, "
    "energy_ratio_max, family, proof) VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)";

constexpr const char* insertFamily =
    "INSERT INTO families(cells, family_order, nu, contact_blocks, phases, steps, period, "
    "frequency_ratio, contact, kind, dimension, energy_ratio_min, energy_ratio_max, schedules) "
    "VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT(cells, phases) DO UPDATE SET "
    "schedules = max(schedules, excluded.schedules)";

constexpr const char* updateRun =
    "UPDATE runs SET next_batch = ?, decided = ?, pressing = ?, grazing = ?, refuted = ?, "
    "undecided = ?, families = ?, finished = ?, seconds = ?, workers = ?, version = ? "
    "WHERE id = ? AND next_batch = ?";

std::optional<std::string> fractionText(const std::optional<Fraction>& fraction)
{
    return fraction
               ? std::optional(fmt::format("{}/{}", fraction->numerator, fraction->denominator))
               : std::nullopt;
}

std::string now()
{
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

/// Makes sure that an open file is an atlas of this version.
void requireAtlas(const std::string& path, SQLite::Database& database)
{
    if (database.execAndGet("PRAGMA application_id").getInt64() != applicationId) {
        throw FileError(path, "cannot use: it is not an atlas of signorini");
    }
    const std::int64_t version = database.execAndGet("PRAGMA user_version").getInt64();
    if (version != schemaVersion) {
        throw FileError(
            path,
            fmt::format(
                "cannot use: it is an atlas of version {}: allowed {}{}", version, schemaVersion,
                version < schemaVersion ? "; decide its range anew into another file" : ""));
    }
}

/// Numbers that are not finite and optionals that are empty stay NULL.
template <typename Value>
void bindValue(SQLite::Statement& statement, int index, const Value& value)
{
    if constexpr (std::is_floating_point_v<Value>) {
        if (std::isfinite(value)) {
            statement.bind(index, value);
        }
    } else if constexpr (std::is_convertible_v<Value, std::string_view>) {
        statement.bind(index, std::string(value));
    } else if constexpr (std::is_integral_v<Value>) {
        statement.bind(index, static_cast<std::int64_t>(value));
    } else if (value) {
        bindValue(statement, index, *value);
    }
}

/// Runs a statement once more. Returns the number of rows that it changed.
template <typename... Values>
int run(SQLite::Statement& statement, const Values&... values)
{
    (void)statement.tryReset();  // says again what went wrong the last time
    statement.clearBindings();
    int index = 0;
    (bindValue(statement, ++index, values), ...);
    return statement.exec();
}

}  // namespace

/// The statements that write batches, prepared once.
class BatchWriter {
public:
    explicit BatchWriter(const SQLite::Database& database)
        : insert_(database, insertRow),
          insertFamily_(database, insertFamily),
          findFamily_(database, "SELECT id FROM families WHERE cells = ? AND phases = ?"),
          update_(database, updateRun)
    {
    }

    void insert(const AtlasRange& range, const AtlasBatch& batch)
    {
        top_ = {};  // its id may be that of a transaction that failed
        for (const AtlasFamily& family : batch.families) {
            insert(family);
        }
        auto proof = batch.proofs.begin();
        for (const AtlasRow& row : batch.rows) {
            const bool isProved = proof != batch.proofs.end() && proof->number == row.number;
            insert(range, row, isProved ? std::optional(proof++->multipliers) : std::nullopt);
        }
    }

    /// False if the row was not where this process left it.
    [[nodiscard]] bool update(std::int64_t before, const AtlasRun& after, std::string_view workers)
    {
        return run(update_, after.nextBatch, after.tally.decided, after.tally.pressing,
                   after.tally.grazing, after.tally.refuted, after.tally.undecided,
                   after.tally.families, after.isFinished() ? std::optional(now()) : std::nullopt,
                   after.seconds, workers, SIGNORINI_VERSION, after.id, before) == 1;
    }

private:
    void insert(const AtlasFamily& all)
    {
        const auto ofTriple = [&all](std::int64_t Family::*field) {
            return all.family ? std::optional((*all.family).*field) : std::nullopt;
        };
        run(insertFamily_, all.cells, ofTriple(&Family::order), ofTriple(&Family::blocks),
            ofTriple(&Family::contactBlocks), phasesText({all.top}), all.steps, period(all),
            frequencyRatio(all), name(all.contact()), name(all.kind), all.dimension,
            all.energy.least, all.energy.most, all.schedules);
    }

    void insert(const AtlasRange& range, const AtlasRow& row,
                const std::optional<std::string>& proof)
    {
        const Schedule schedule{range.cells, phasesAt(range, row.number)};
        const auto ifFound = [&row](auto value) {
            return row.status == Status::found ? std::optional(value) : std::nullopt;
        };
        const AtlasEntry entry{schedule, row, {}};
        const std::string text =
            range.bars ? textOf(spansOf(schedule)) : phasesText(schedule.phases);
        run(insert_, range.cells, text, row.steps, period(entry), frequencyRatio(entry),
            name(row.status), row.reason ? std::optional(name(*row.reason)) : std::nullopt,
            row.kernelDimension >= 0 ? std::optional(row.kernelDimension) : std::nullopt,
            ifFound(name(row.kind)), ifFound(row.dimension), ifFound(name(row.contact)),
            ifFound(row.isCanonical), ifFound(row.energy.least), ifFound(row.energy.most),
            row.familyTop ? std::optional(idOf(range.cells, *row.familyTop)) : std::nullopt, proof);
    }

    /// Of the family with that top. Rows of one family follow each other.
    std::int64_t idOf(std::int64_t cells, const Phase& top)
    {
        if (top != top_) {
            (void)findFamily_.tryReset();
            findFamily_.bind(1, cells);
            findFamily_.bind(2, phasesText({top}));
            if (!findFamily_.executeStep()) {
                throw SQLite::Exception(fmt::format("table families lacks {}", phasesText({top})));
            }
            id_ = findFamily_.getColumn(0).getInt64();
            top_ = top;
            findFamily_.reset();
        }
        return id_;
    }

    SQLite::Statement insert_;
    SQLite::Statement insertFamily_;
    SQLite::Statement findFamily_;
    SQLite::Statement update_;
    Phase top_;  ///< of the family looked up last
    std::int64_t id_ = 0;
};

AtlasDatabase::AtlasDatabase(std::unique_ptr<Connection> connection)
    : connection_(std::move(connection))
{
}
AtlasDatabase::AtlasDatabase(AtlasDatabase&&) noexcept = default;
AtlasDatabase& AtlasDatabase::operator=(AtlasDatabase&& other) noexcept
{
    writer_ = std::move(other.writer_);  // first: statements end before their connection
    connection_ = std::move(other.connection_);
    return *this;
}
AtlasDatabase::~AtlasDatabase() = default;

AtlasDatabase AtlasDatabase::create(const std::string& path, Cancel cancel)
{
    AtlasDatabase atlas(std::make_unique<Connection>(path, DatabaseMode::write, std::move(cancel)));
    atlas.connection_->use([&](SQLite::Database& database) {
        SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
        if (database.execAndGet("SELECT COUNT(*) FROM sqlite_master").getInt64() == 0 &&
            database.execAndGet("PRAGMA application_id").getInt64() == 0) {
            database.exec(schema);
        }
        requireAtlas(path, database);
        transaction.commit();
        // A rollback journal works on network file systems too. Nothing is lost if the process
        // dies.
        database.exec("PRAGMA journal_mode = DELETE; PRAGMA synchronous = NORMAL;");
        atlas.writer_ = std::make_unique<BatchWriter>(database);
    });
    return atlas;
}

AtlasDatabase AtlasDatabase::open(const std::string& path)
{
    auto connection = std::make_unique<Connection>(path, DatabaseMode::read);
    connection->use([&path](SQLite::Database& database) { requireAtlas(path, database); });
    return AtlasDatabase(std::move(connection));
}

std::vector<AtlasRun> AtlasDatabase::runs() const
{
    return connection_->use([](SQLite::Database& database) {
        SQLite::Statement statement(database, runColumns + "ORDER BY id");
        std::vector<AtlasRun> all;
        while (statement.executeStep()) {
            all.push_back(readRun(statement));
            if (sceneText(all.back().range) != sceneText(all.front().range)) {
                throw SQLite::Exception("runs are of several scenes: allowed one");
            }
        }
        return all;
    });
}

std::optional<Assembly> barsOf(const std::vector<AtlasRun>& runs)
{
    return runs.empty() ? std::nullopt : runs.front().range.bars;
}

bool hasFamilies(const AtlasRange& range)
{
    return range.segments.empty() && !range.bars;
}

bool hasFamilies(const std::vector<AtlasRun>& runs)
{
    return runs.empty() || hasFamilies(runs.front().range);
}

AtlasRun AtlasDatabase::start(const AtlasRange& range, std::string_view options)
{
    validate(range);
    return connection_->use([&](SQLite::Database& database) {
        AtlasRun entered;
        entered.range = range;
        entered.batches = batchesOf(range);
        SQLite::Statement insert(
            database,
            "INSERT INTO runs(version, options, cells, max_contact, max_free, phases, "
            "max_energy_ratio, keeps_refuted, families_only, gap_sign, segments, second_stop, "
            "batches, "
            "next_batch, "
            "decided, pressing, grazing, refuted, undecided, families, started, seconds, workers) "
            "VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, 0, 0, 0, 0, 0, 0, 0, ?, 0, '')");
        run(insert, SIGNORINI_VERSION, options, range.cells, range.maxContact, range.maxFree,
            range.maxPhases, range.maxEnergyRatio, range.keepsRefuted, range.familiesOnly,
            range.gapSign, sceneText(range), fractionText(range.secondStop), entered.batches,
            now());
        entered.id = database.getLastInsertRowid();
        return entered;
    });
}

void AtlasDatabase::write(AtlasRun& run, std::span<const AtlasBatch> batches, double seconds,
                          std::string_view workers)
{
    AtlasRun after = run;
    for (const AtlasBatch& batch : batches) {
        if (batch.number != after.nextBatch || after.isFinished()) {
            throw std::invalid_argument(fmt::format("batch = {} is out of order: allowed {} of {}",
                                                    batch.number, after.nextBatch, run.batches));
        }
        after.nextBatch += 1;
        after.tally += batch.tally;
    }
    after.seconds += seconds;
    connection_->use([&](SQLite::Database& database) {
        SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
        for (const AtlasBatch& batch : batches) {
            writer_->insert(after.range, batch);
        }
        if (!writer_->update(run.nextBatch, after, workers)) {
            throw FileError("run " + std::to_string(after.id),
                            "cannot use: another process is writing the same range");
        }
        transaction.commit();
    });
    run = after;
}

}  // namespace signorini
