// Questions to an atlas.

#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "atlas_rows.hpp"
#include "connection.hpp"
#include "signorini/atlas_database.hpp"

namespace signorini {

namespace {

/// Energies of twins agree to this, relative.
constexpr double twinTolerance = 1e-12;

/// Whatever else a row says, which reading it will find out.
const std::string isFound = "WHERE status NOT IN ('none', 'undecided')";

/// Every row that meets a condition with these parameters, in order.
template <typename Action, typename... Values>
void forEachRow(Connection& connection, const std::string& condition, const Action& action,
                const Values&... values)
{
    connection.use([&](SQLite::Database& database) {
        SQLite::Statement statement(database, entryColumns + condition);
        SQLite::bind(statement, values...);
        while (statement.executeStep()) {
            action(readEntry(statement));
        }
    });
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

void AtlasDatabase::forEachFound(std::optional<std::int64_t> cells,
                                 const std::function<void(const AtlasEntry&)>& action) const
{
    forEachRow(*connection_, isFound + onCells(cells) + " ORDER BY rowid", action);
}

std::vector<AtlasEntry> AtlasDatabase::near(double frequencyRatio, double energyRatio,
                                            double distance,
                                            std::optional<std::int64_t> cells) const
{
    std::vector<std::pair<double, AtlasEntry>> found;
    const auto keepNear = [&](AtlasEntry entry) {
        const double across = signorini::frequencyRatio(entry.schedule) / frequencyRatio - 1.0;
        const double inside =
            std::clamp(energyRatio, entry.row.energy.least, entry.row.energy.most);
        const double apart = std::hypot(across, inside / energyRatio - 1.0);
        if (apart <= distance) {
            found.emplace_back(apart, std::move(entry));
        }
    };
    const double most = energyRatio * (1.0 + distance);
    forEachRow(*connection_,
               isFound +
                   " AND frequency_ratio BETWEEN ? AND ? AND energy_ratio_min <= ? AND "
                   "ifnull(energy_ratio_max, ?) >= ?" +
                   onCells(cells),
               keepNear, frequencyRatio * (1.0 - distance), frequencyRatio * (1.0 + distance), most,
               most, energyRatio * (1.0 - distance));
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
    std::vector<AtlasEntry> entries;
    forEachRow(
        *connection_,
        "WHERE cells % ? = 0 AND steps = cells / ? * ?" + onCells(cells) + " ORDER BY cells, rowid",
        [&entries](AtlasEntry entry) { entries.push_back(std::move(entry)); }, period.denominator,
        period.denominator, period.numerator);
    return entries;
}

std::vector<Twins> AtlasDatabase::twins(std::optional<std::int64_t> cells) const
{
    std::vector<Twins> all;
    Twins group;
    const auto close = [&all, &group] {
        if (group.size() > 1) {
            all.push_back(std::move(group));
        }
        group.clear();
    };
    const auto isTwin = [&group](const AtlasEntry& entry) {
        const AtlasEntry& first = group.front();
        return entry.schedule.cells == first.schedule.cells &&
               steps(entry.schedule) == steps(first.schedule) &&
               entry.row.energy.least <= first.row.energy.least * (1.0 + twinTolerance);
    };
    const auto join = [&](AtlasEntry entry) {
        if (!group.empty() && !isTwin(entry)) {
            close();
        }
        const std::vector<Phase> mirror = backwards(entry.schedule.phases);
        const bool isKnown = std::any_of(
            group.begin(), group.end(),
            [&mirror](const AtlasEntry& other) { return other.schedule.phases == mirror; });
        if (!isKnown) {
            group.push_back(std::move(entry));
        }
    };
    forEachRow(*connection_,
               isFound + " AND canonical = 1" + onCells(cells) +
                   " ORDER BY cells, steps, energy_ratio_min, rowid",
               join);
    close();
    return all;
}

}  // namespace signorini
