// Questions to an atlas.

#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <optional>
#include <string>
#include <utility>

#include "atlas_rows.hpp"
#include "connection.hpp"
#include "signorini/atlas_database.hpp"

namespace signorini {

namespace {

/// Energies of twins agree to this, relative.
constexpr double twinTolerance = 1e-12;

/// How each table is read.
struct Families {
    static AtlasFamily read(const SQLite::Statement& s) { return readFamily(s); }
    static const std::string& columns() { return familyColumns; }
    static std::string any() { return "WHERE 1"; }
};
struct Schedules {
    static AtlasEntry read(const SQLite::Statement& s) { return readEntry(s); }
    static const std::string& columns() { return entryColumns; }
    /// Whatever else a row says, which reading it will find out.
    static std::string any() { return "WHERE status NOT IN ('none', 'undecided')"; }
};

/// Every row of a table that meets a condition with these parameters, in order.
template <typename Table, typename Action, typename... Values>
void forEachRow(Connection& connection, const std::string& condition, const Action& action,
                const Values&... values)
{
    connection.use([&](SQLite::Database& database) {
        SQLite::Statement statement(database, Table::columns() + condition);
        SQLite::bind(statement, values...);
        while (statement.executeStep()) {
            action(Table::read(statement));
        }
    });
}

/// " AND cells = N" or nothing, for queries whose condition ends there.
std::string onCells(std::optional<std::int64_t> cells)
{
    return cells ? fmt::format(" AND cells = {}", *cells) : std::string();
}

/// " AND family IS NULL" or nothing.
std::string onFamily(AtlasSchedules which)
{
    return which == AtlasSchedules::withoutFamily ? " AND family IS NULL" : "";
}

/// Would a range have kept what has such energies?
bool isInside(const AtlasRange& range, const EnergyRange& energy)
{
    return energy.least <= range.maxEnergyRatio;
}

/// Does a range decide such a schedule?
bool isInside(const AtlasRange& range, const std::vector<Phase>& phases)
{
    return static_cast<std::int64_t>(phases.size()) <= range.maxPhases &&
           std::all_of(phases.begin(), phases.end(), [&range](const Phase& phase) {
               return phase.contact <= range.maxContact && phase.free <= range.maxFree;
           });
}

const EnergyRange& energyOf(const AtlasFamily& family)
{
    return family.energy;
}

const EnergyRange& energyOf(const AtlasEntry& entry)
{
    return entry.row.energy;
}

/// What lies near a point, nearest first. `rest` ends the condition.
template <typename Table>
auto nearest(Connection& connection, double frequency, double energyRatio, double distance,
             const std::string& rest)
{
    using Row = decltype(Table::read(std::declval<SQLite::Statement&>()));
    std::vector<std::pair<double, Row>> found;
    const auto keepNear = [&](Row row) {
        const double across = frequencyRatio(row) / frequency - 1.0;
        const EnergyRange& energy = energyOf(row);
        const double inside = std::clamp(energyRatio, energy.least, energy.most);
        const double apart = std::hypot(across, inside / energyRatio - 1.0);
        if (apart <= distance) {
            found.emplace_back(apart, std::move(row));
        }
    };
    const double most = energyRatio * (1.0 + distance);
    forEachRow<Table>(connection,
                      Table::any() +
                          " AND frequency_ratio BETWEEN ? AND ? AND energy_ratio_min <= ? AND "
                          "ifnull(energy_ratio_max, ?) >= ?" +
                          rest,
                      keepNear, frequency * (1.0 - distance), frequency * (1.0 + distance), most,
                      most, energyRatio * (1.0 - distance));
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Row> rows;
    rows.reserve(found.size());
    for (auto& [apart, row] : found) {
        rows.push_back(std::move(row));
    }
    return rows;
}

/// The rows of one period.
template <typename Table>
auto ofPeriod(Connection& connection, ExactPeriod period, const std::string& rest)
{
    std::vector<decltype(Table::read(std::declval<SQLite::Statement&>()))> rows;
    forEachRow<Table>(
        connection,
        "WHERE cells % ? = 0 AND steps = cells / ? * ?" + rest + " ORDER BY cells, rowid",
        [&rows](auto row) { rows.push_back(std::move(row)); }, period.denominator,
        period.denominator, period.numerator);
    return rows;
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

/// Rows of a table one by one.
template <typename Table>
class Rows {
public:
    using Row = decltype(Table::read(std::declval<SQLite::Statement&>()));

    Rows(const SQLite::Database& database, const std::string& condition)
        : statement_(database, Table::columns() + condition)
    {
        advance();
    }

    /// The next one; none after the last.
    [[nodiscard]] const std::optional<Row>& next() const { return next_; }
    [[nodiscard]] Row take()
    {
        Row row = *std::move(next_);
        advance();
        return row;
    }

private:
    void advance()
    {
        next_ = statement_.executeStep() ? std::optional(Table::read(statement_)) : std::nullopt;
    }

    SQLite::Statement statement_;
    std::optional<Row> next_;
};

/// What twins share: N, n and E.
struct SharedNumbers {
    std::int64_t cells = 0;
    std::int64_t steps = 0;
    double energy = 0.0;

    explicit SharedNumbers(const AtlasFamily& family)
        : cells(family.cells), steps(family.steps), energy(family.energy.least)
    {
    }
    explicit SharedNumbers(const AtlasEntry& entry)
        : cells(entry.schedule.cells), steps(entry.row.steps), energy(entry.row.energy.least)
    {
    }
    friend auto operator<=>(const SharedNumbers&, const SharedNumbers&) = default;

    [[nodiscard]] bool areThoseOf(const SharedNumbers& first) const
    {
        return cells == first.cells && steps == first.steps &&
               energy <= first.energy * (1.0 + twinTolerance);
    }
};

/// Adds a schedule, unless its motions are those of another one backwards in time.
void join(std::vector<AtlasEntry>& group, AtlasEntry entry)
{
    const std::vector<Phase> mirror = backwards(entry.schedule.phases);
    if (std::none_of(group.begin(), group.end(), [&mirror](const AtlasEntry& other) {
            return other.schedule.phases == mirror;
        })) {
        group.push_back(std::move(entry));
    }
}

}  // namespace

AtlasTally AtlasDatabase::rowsOf(const AtlasRange& range) const
{
    connection_->use([](SQLite::Database& database) {
        std::string said = database.execAndGet("PRAGMA quick_check(1)").getString();
        if (said != "ok") {
            std::replace(said.begin(), said.end(), '\n', ' ');
            throw SQLite::Exception("damaged: " + said);
        }
    });
    AtlasTally rows;
    const std::string where = "WHERE 1" + onCells(range.cells);
    forEachRow<Families>(*connection_, where, [&](const AtlasFamily& family) {
        rows.families += isInside(range, family.energy) ? 1 : 0;
    });
    forEachRow<Schedules>(*connection_, where, [&](const AtlasEntry& entry) {
        if (range.familiesOnly || !isInside(range, entry.schedule.phases)) {
            return;
        }
        switch (entry.row.status) {
            case Status::found:
                if (isInside(range, entry.row.energy)) {
                    ++(entry.row.contact == Contact::pressing ? rows.pressing : rows.grazing);
                }
                return;
            case Status::none:
                rows.refuted += range.keepsRefuted ? 1 : 0;
                return;
            case Status::undecided:
                ++rows.undecided;
        }
    });
    return rows;
}

void AtlasDatabase::forEachFamily(std::optional<std::int64_t> cells,
                                  const std::function<void(const AtlasFamily&)>& action) const
{
    forEachRow<Families>(*connection_, Families::any() + onCells(cells) + " ORDER BY id", action);
}

void AtlasDatabase::forEachFound(std::optional<std::int64_t> cells,
                                 const std::function<void(const AtlasEntry&)>& action,
                                 AtlasSchedules which) const
{
    forEachRow<Schedules>(*connection_,
                          Schedules::any() + onCells(cells) + onFamily(which) + " ORDER BY rowid",
                          action);
}

void AtlasDatabase::forEachSchedule(std::optional<std::int64_t> cells,
                                    const std::function<void(const AtlasEntry&)>& action) const
{
    forEachRow<Schedules>(*connection_, "WHERE 1" + onCells(cells) + " ORDER BY rowid", action);
}

std::vector<AtlasFamily> AtlasDatabase::familiesNear(double frequencyRatio, double energyRatio,
                                                     double distance,
                                                     std::optional<std::int64_t> cells) const
{
    return nearest<Families>(*connection_, frequencyRatio, energyRatio, distance, onCells(cells));
}

std::vector<AtlasEntry> AtlasDatabase::schedulesNear(double frequencyRatio, double energyRatio,
                                                     double distance,
                                                     std::optional<std::int64_t> cells,
                                                     AtlasSchedules which) const
{
    return nearest<Schedules>(*connection_, frequencyRatio, energyRatio, distance,
                              onCells(cells) + onFamily(which));
}

std::vector<AtlasFamily> AtlasDatabase::familiesOfPeriod(ExactPeriod period,
                                                         std::optional<std::int64_t> cells) const
{
    return ofPeriod<Families>(*connection_, period, onCells(cells));
}

std::vector<AtlasEntry> AtlasDatabase::schedulesOfPeriod(ExactPeriod period,
                                                         std::optional<std::int64_t> cells,
                                                         AtlasSchedules which) const
{
    return ofPeriod<Schedules>(*connection_, period, onCells(cells) + onFamily(which));
}

std::vector<Twins> AtlasDatabase::twins(std::optional<std::int64_t> cells) const
{
    const std::string order = onCells(cells) + " ORDER BY cells, steps, energy_ratio_min, rowid";
    std::vector<Twins> all;
    Twins group;
    std::optional<SharedNumbers> shared;
    const auto beginAnother = [&](const SharedNumbers& next) {
        if (shared && next.areThoseOf(*shared)) {
            return;
        }
        if (group.families.size() + group.schedules.size() > 1) {
            all.push_back(std::move(group));
        }
        group = {};
        shared = next;
    };
    connection_->use([&](SQLite::Database& database) {
        Rows<Families> families(database, "WHERE contact IS NOT 'grazing'" + order);
        Rows<Schedules> schedules(
            database, Schedules::any() + " AND canonical = 1 AND family IS NULL" + order);
        while (families.next() || schedules.next()) {
            if (!schedules.next() || (families.next() && SharedNumbers(*families.next()) <=
                                                             SharedNumbers(*schedules.next()))) {
                beginAnother(SharedNumbers(*families.next()));
                group.families.push_back(families.take());
            } else {
                beginAnother(SharedNumbers(*schedules.next()));
                join(group.schedules, schedules.take());
            }
        }
    });
    if (group.families.size() + group.schedules.size() > 1) {
        all.push_back(std::move(group));
    }
    return all;
}

}  // namespace signorini
