#include "atlas_rows.hpp"

#include <fmt/format.h>

#include <charconv>
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

/// The value of an enumeration that has the name in a column.
template <typename Table>
auto readName(const Statement& s, int column, const Table& table)
{
    const auto value = valueIn(table, s.text(column));
    if (!value) {
        s.refuse(column, namesIn(table));
    }
    return *value;
}

std::int64_t readWhole(const Statement& s, int column, std::int64_t low, std::int64_t high)
{
    const std::int64_t value = s.whole(column);
    if (value < low || value > high) {
        s.refuse(column, fmt::format("{}..{}", low, high));
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

std::vector<Phase> readPhases(const Statement& s, int column)
{
    const std::string text = s.text(column);
    std::vector<Phase> phases;
    std::string_view rest = text;
    while (!rest.empty()) {
        Phase phase;
        if (!takeNumber(rest, ':', phase.contact) || rest.empty() ||
            !takeNumber(rest, ',', phase.free)) {
            break;
        }
        phases.push_back(phase);
    }
    if (phasesText(phases) != text) {
        s.refuse(column, "\"nc:nf[,nc:nf...]\"");
    }
    return phases;
}

/// Cells and phases, and what follows from them.
Schedule readSchedule(const Statement& s)
{
    Schedule schedule{readWhole(s, 1, 1, maxCells), readPhases(s, 2)};
    try {
        validate(schedule);
    } catch (const std::invalid_argument& error) {
        s.refuse(2, error.what());
    }
    if (s.whole(12) != steps(schedule)) {
        s.refuse(12, fmt::format("{}", steps(schedule)));
    }
    if (s.real(13) != period(schedule)) {
        s.refuse(13, fmt::format("{}", period(schedule)));
    }
    if (s.real(14) != frequencyRatio(schedule)) {
        s.refuse(14, fmt::format("{}", frequencyRatio(schedule)));
    }
    return schedule;
}

/// What is known of the motions of a schedule that has some.
void readSet(const Statement& s, AtlasRow& row)
{
    row.kind = readName(s, 6, std::span(setKindNames).subspan(1));
    row.dimension = readWhole(s, 7, -1, maxSteps);
    row.contact = readName(s, 8, contactNames);
    row.isCanonical = readWhole(s, 9, 0, 1) != 0;
    row.energy.least = s.real(10);
    row.energy.most = s.isNull(11) ? infinity : s.real(11);
    if (!(row.energy.least > 0.0)) {
        s.refuse(10, "> 0");
    }
    if (!(row.energy.most >= row.energy.least)) {
        s.refuse(11, ">= energy_ratio_min");
    }
}

}  // namespace

AtlasEntry readEntry(const Statement& s)
{
    AtlasEntry entry;
    AtlasRow& row = entry.row;
    row.number = s.whole(0);
    entry.schedule = readSchedule(s);
    row.status = readName(s, 3, statusNames);
    if (row.status == Status::none) {
        row.reason = readName(s, 4, reasonNames);
    }
    row.kernelDimension = s.isNull(5) ? -1 : readWhole(s, 5, 0, 2 * maxCells);
    if (row.status == Status::found) {
        readSet(s, row);
    } else {
        row.energy = {infinity, infinity};
    }
    return entry;
}

AtlasRun readRun(const Statement& s)
{
    constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
    AtlasRun run;
    run.id = s.whole(0);
    run.range = {.cells = s.whole(1),
                 .maxContact = s.whole(2),
                 .maxFree = s.whole(3),
                 .maxPhases = s.whole(4),
                 .maxEnergyRatio = s.isNull(5) ? infinity : s.real(5),
                 .keepsRefuted = readWhole(s, 6, 0, 1) != 0};
    try {
        validate(run.range);
    } catch (const std::invalid_argument& error) {
        s.refuse(1, error.what());
    }
    run.batches = readWhole(s, 7, 1, most);
    run.nextBatch = readWhole(s, 8, 0, run.batches);
    run.tally = {.decided = readWhole(s, 9, 0, most),
                 .pressing = readWhole(s, 10, 0, most),
                 .grazing = readWhole(s, 11, 0, most),
                 .refuted = readWhole(s, 12, 0, most),
                 .undecided = readWhole(s, 13, 0, most)};
    run.seconds = s.real(14);
    return run;
}

}  // namespace signorini
