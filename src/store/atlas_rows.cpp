#include "atlas_rows.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Exception.h>
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "set_kind_names.hpp"
#include "verdict_names.hpp"

namespace signorini {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Any value as text; NULL is empty.
std::string text(const SQLite::Statement& s, int column)
{
    return s.getColumn(column).getText();
}

/// Says that the value of a column cannot be.
[[noreturn]] void refuse(const SQLite::Statement& s, int column, std::string_view allowed)
{
    constexpr std::size_t shown = 60;
    throw SQLite::Exception(
        fmt::format("a row has {} = {}: allowed {}", s.getColumnName(column),
                    s.isColumnNull(column) ? "NULL" : text(s, column).substr(0, shown), allowed));
}

/// SQLite would make a number of anything.
std::int64_t whole(const SQLite::Statement& s, int column)
{
    if (!s.getColumn(column).isInteger()) {
        refuse(s, column, "whole numbers");
    }
    return s.getColumn(column).getInt64();
}

double real(const SQLite::Statement& s, int column)
{
    const SQLite::Column value = s.getColumn(column);
    if ((!value.isFloat() && !value.isInteger()) || !std::isfinite(value.getDouble())) {
        refuse(s, column, "finite numbers");
    }
    return value.getDouble();
}

/// The value of an enumeration that has the name in a column.
template <typename Table>
auto readName(const SQLite::Statement& s, int column, const Table& table)
{
    const auto value = valueIn(table, text(s, column));
    if (!value) {
        refuse(s, column, namesIn(table));
    }
    return *value;
}

std::int64_t readWhole(const SQLite::Statement& s, int column, std::int64_t low, std::int64_t high)
{
    const std::int64_t value = whole(s, column);
    if (value < low || value > high) {
        refuse(s, column, fmt::format("{}..{}", low, high));
    }
    return value;
}

/// Takes a whole number and the character after it from the front of a text; the last number of
/// the text needs none.
bool takeNumber(std::string_view& text, char after, std::int64_t& value)
{
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || (stop != end && (*stop != after || stop + 1 == end))) {
        return false;
    }
    text.remove_prefix(static_cast<std::size_t>(stop - text.data()) + (stop == end ? 0 : 1));
    return true;
}

std::vector<Phase> readPhases(const SQLite::Statement& s, int column)
{
    const std::string given = text(s, column);
    std::vector<Phase> phases;
    std::string_view rest = given;
    while (!rest.empty()) {
        Phase phase;
        if (!takeNumber(rest, ':', phase.contact) || rest.empty() ||
            !takeNumber(rest, ',', phase.free)) {
            break;
        }
        phases.push_back(phase);
    }
    if (phasesText(phases) != given) {
        refuse(s, column, "\"nc:nf[,nc:nf...]\"");
    }
    return phases;
}

/// Cells and phases, and what follows from them.
Schedule readSchedule(const SQLite::Statement& s)
{
    Schedule schedule{readWhole(s, 1, 1, maxCells), readPhases(s, 2)};
    try {
        validate(schedule);
    } catch (const std::invalid_argument& error) {
        refuse(s, 2, error.what());
    }
    if (whole(s, 12) != steps(schedule)) {
        refuse(s, 12, fmt::format("{}", steps(schedule)));
    }
    if (real(s, 13) != period(schedule)) {
        refuse(s, 13, fmt::format("{}", period(schedule)));
    }
    if (real(s, 14) != frequencyRatio(schedule)) {
        refuse(s, 14, fmt::format("{}", frequencyRatio(schedule)));
    }
    return schedule;
}

/// What is known of the motions of a schedule that has some.
void readSet(const SQLite::Statement& s, AtlasRow& row)
{
    row.kind = readName(s, 6, std::span(setKindNames).subspan(1));
    row.dimension = readWhole(s, 7, -1, maxSteps);
    row.contact = readName(s, 8, contactNames);
    row.isCanonical = readWhole(s, 9, 0, 1) != 0;
    row.energy.least = real(s, 10);
    row.energy.most = s.isColumnNull(11) ? infinity : real(s, 11);
    if (!(row.energy.least > 0.0)) {
        refuse(s, 10, "> 0");
    }
    if (!(row.energy.most >= row.energy.least)) {
        refuse(s, 11, ">= energy_ratio_min");
    }
}

}  // namespace

AtlasEntry readEntry(const SQLite::Statement& s)
{
    AtlasEntry entry;
    AtlasRow& row = entry.row;
    row.number = whole(s, 0);
    entry.schedule = readSchedule(s);
    row.status = readName(s, 3, statusNames);
    if (row.status == Status::none) {
        row.reason = readName(s, 4, reasonNames);
    }
    row.kernelDimension = s.isColumnNull(5) ? -1 : readWhole(s, 5, 0, 2 * maxCells);
    if (row.status == Status::found) {
        readSet(s, row);
    } else {
        row.energy = {infinity, infinity};
    }
    return entry;
}

AtlasRun readRun(const SQLite::Statement& s)
{
    constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
    AtlasRun run;
    run.id = whole(s, 0);
    run.range = {.cells = whole(s, 1),
                 .maxContact = whole(s, 2),
                 .maxFree = whole(s, 3),
                 .maxPhases = whole(s, 4),
                 .maxEnergyRatio = s.isColumnNull(5) ? infinity : real(s, 5),
                 .keepsRefuted = readWhole(s, 6, 0, 1) != 0};
    try {
        validate(run.range);
    } catch (const std::invalid_argument& error) {
        refuse(s, 1, error.what());
    }
    run.batches = readWhole(s, 7, 1, most);
    run.nextBatch = readWhole(s, 8, 0, run.batches);
    run.tally = {.decided = readWhole(s, 9, 0, most),
                 .pressing = readWhole(s, 10, 0, most),
                 .grazing = readWhole(s, 11, 0, most),
                 .refuted = readWhole(s, 12, 0, most),
                 .undecided = readWhole(s, 13, 0, most)};
    run.seconds = real(s, 14);
    return run;
}

}  // namespace signorini
