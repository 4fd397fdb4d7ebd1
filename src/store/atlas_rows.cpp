#include "atlas_rows.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Exception.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "contact_spans.hpp"
#include "infinity.hpp"
#include "set_kind_names.hpp"
#include "verdict_names.hpp"

namespace signorini {

namespace {

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

/// Of bars in a row: "1:6 -:40 2:4 -:20". Anything else is no schedule.
std::vector<Phase> phasesOfBars(const std::string& given)
{
    std::istringstream in(given);
    const std::vector<std::string> words{std::istream_iterator<std::string>(in), {}};
    const std::vector<ContactSpan> spans = spansOf(words, maxContacts);
    std::vector<Phase> phases;
    for (std::size_t k = 0; k + 1 < spans.size(); k += 2) {
        const int contact = std::countr_zero(spans[k].closed);
        phases.push_back({spans[k].steps, spans[k + 1].steps, static_cast<Stop>(contact)});
    }
    return textOf(spansOf(Schedule{1, phases})) == given ? phases : std::vector<Phase>();
}

/// Is a schedule one of bars in a row?
bool isOfBars(const SQLite::Statement& s)
{
    return text(s, 2).find(' ') != std::string::npos;
}

std::vector<Phase> readPhases(const SQLite::Statement& s, int column, bool areOfBars)
{
    const std::string given = text(s, column);
    if (areOfBars) {
        std::vector<Phase> phases;
        try {
            phases = phasesOfBars(given);
        } catch (const std::invalid_argument&) {
            phases.clear();
        }
        if (phases.empty()) {
            refuse(s, column, "\"SET:STEPS -:STEPS[ SET:STEPS -:STEPS...]\", SET one contact");
        }
        return phases;
    }
    std::vector<Phase> phases;
    std::string_view rest = given;
    while (!rest.empty()) {
        Phase phase;
        if (rest.starts_with("L:")) {
            phase.stop = Stop::left;
            rest.remove_prefix(2);
        }
        if (!takeNumber(rest, ':', phase.contact) || rest.empty() ||
            !takeNumber(rest, ',', phase.free)) {
            break;
        }
        phases.push_back(phase);
    }
    if (phasesText(phases) != given) {
        refuse(s, column, "\"[L:]nc:nf[,[L:]nc:nf...]\"");
    }
    return phases;
}

/// Steps after which motions repeat, and what follows from them and the cells.
std::int64_t readSteps(const SQLite::Statement& s, std::int64_t cells)
{
    const std::int64_t steps = readWhole(s, 12, 1, maxSteps);
    const auto check = [&s](int column, double right) {
        if (real(s, column) != right) {
            refuse(s, column, fmt::format("{}", right));
        }
    };
    const auto size = static_cast<double>(cells);
    check(13, static_cast<double>(steps) / size);
    check(14, 4.0 * size / static_cast<double>(steps));
    return steps;
}

/// Its stops are those of the runs, which are not known here: some that stand apart.
Schedule readSchedule(const SQLite::Statement& s, bool isOfBars)
{
    Schedule schedule{readWhole(s, 1, 1, maxCells), readPhases(s, 2, isOfBars)};
    if (std::any_of(schedule.phases.begin(), schedule.phases.end(),
                    [](const Phase& phase) { return phase.stop == Stop::left; })) {
        schedule.stops.left = Fraction{1, 1};
    }
    try {
        validate(schedule);
    } catch (const std::invalid_argument& error) {
        refuse(s, 2, error.what());
    }
    return schedule;
}

EnergyRange readEnergy(const SQLite::Statement& s)
{
    const EnergyRange energy{real(s, 10), s.isColumnNull(11) ? infinity : real(s, 11)};
    const bool isOfAnySize = energy.least == 0.0 && std::isinf(energy.most);  // no gap
    if (!(energy.least > 0.0) && !isOfAnySize) {
        refuse(s, 10, "> 0");
    }
    if (!(energy.most >= energy.least)) {
        refuse(s, 11, ">= energy_ratio_min");
    }
    return energy;
}

/// w, nu, k of a family of the grid; grazing sets have none.
std::optional<Family> readTriple(const SQLite::Statement& s, std::int64_t cells)
{
    if (readName(s, 8, contactNames) == Contact::grazing) {
        for (const int column : {3, 4, 5}) {
            if (!s.isColumnNull(column)) {
                refuse(s, column, "NULL where motions graze");
            }
        }
        return std::nullopt;
    }
    const std::int64_t order = readWhole(s, 3, 1, 2 * cells);
    if (2 * cells % order != 0) {
        refuse(s, 3, fmt::format("divisors of {}", 2 * cells));
    }
    // A triple is a family for one sign of the gap only.
    for (const int gapSign : {1, -1, 0}) {
        if (const auto family = findFamily(order, readWhole(s, 4, 1, maxSteps),
                                           readWhole(s, 5, 1, maxSteps), gapSign)) {
            return family;
        }
    }
    refuse(s, 5, "contact blocks of a family");
}

/// The steps after which the motions of a schedule can repeat.
void checkSteps(const SQLite::Statement& s, const AtlasEntry& entry)
{
    const auto& [schedule, row, family, isOfBars] = entry;
    const std::int64_t n = steps(schedule);
    if (isOfBars && row.steps != n) {
        refuse(s, 12, fmt::format("{}", n));
    }
    if (schedule.phases.size() > 1 ? n % row.steps != 0 : row.steps != n) {
        // Motions that graze, and those whose tip never leaves the wall, repeat sooner.
        const std::int64_t classes = std::gcd(2 * schedule.cells, n);
        const bool grazes = row.contact == Contact::grazing;
        const bool isHeld = !grazes && schedule.phases.front().free < classes;
        if (row.status != Status::found || (!grazes && !isHeld) ||
            row.steps != (grazes ? 2 * classes : classes)) {
            refuse(s, 12, fmt::format("what belongs to {}", phasesText(schedule.phases)));
        }
    }
}

/// What is known of the motions of a schedule that has some.
void readSet(const SQLite::Statement& s, AtlasRow& row)
{
    row.kind = readName(s, 6, std::span(setKindNames).subspan(1));
    row.dimension = readWhole(s, 7, -1, maxSteps);
    row.contact = readName(s, 8, contactNames);
    row.isCanonical = readWhole(s, 9, 0, 1) != 0;
    row.energy = readEnergy(s);
}

/// "p/q", or NULL.
std::optional<Fraction> readFraction(const SQLite::Statement& s, int column)
{
    if (s.isColumnNull(column)) {
        return std::nullopt;
    }
    const std::string given = text(s, column);
    std::string_view rest = given;
    Fraction fraction{};
    if (!takeNumber(rest, '/', fraction.numerator) || rest.empty() ||
        !takeNumber(rest, '/', fraction.denominator) || !rest.empty() || fraction.numerator < 1 ||
        fraction.denominator < 1 || std::gcd(fraction.numerator, fraction.denominator) != 1) {
        refuse(s, column, "a fraction p/q > 0 in lowest terms");
    }
    return fraction;
}

}  // namespace

AtlasEntry readEntry(const SQLite::Statement& s)
{
    AtlasEntry entry;
    AtlasRow& row = entry.row;
    row.number = whole(s, 0);
    entry.isOfBars = isOfBars(s);
    entry.schedule = readSchedule(s, entry.isOfBars);
    row.steps = readSteps(s, entry.schedule.cells);
    if (!s.isColumnNull(15)) {
        entry.family = whole(s, 15);
    }
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
    checkSteps(s, entry);
    return entry;
}

AtlasFamily readFamily(const SQLite::Statement& s)
{
    AtlasFamily all;
    all.id = whole(s, 0);
    const Schedule schedule = readSchedule(s, false);
    all.cells = schedule.cells;
    all.top = schedule.phases.front();
    all.family = readTriple(s, all.cells);
    const Phase top =
        all.family ? scheduleOf(*all.family, all.cells).phases.front() : Phase{1, all.top.free};
    if (schedule.phases.size() != 1 || all.top != top) {
        refuse(s, 2, fmt::format("{}, the top of the family", phasesText({top})));
    }
    all.steps = readSteps(s, all.cells);
    if (all.steps != steps(schedule)) {
        refuse(s, 12, fmt::format("{}", steps(schedule)));
    }
    all.kind = readName(s, 6, std::span(setKindNames).subspan(1));
    all.dimension = readWhole(s, 7, 0, 2 * maxCells);
    all.schedules = readWhole(s, 9, 1, std::numeric_limits<std::int64_t>::max());
    all.energy = readEnergy(s);
    return all;
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
                 .keepsRefuted = readWhole(s, 6, 0, 1) != 0,
                 .familiesOnly = readWhole(s, 15, 0, 1) != 0,
                 .gapSign = static_cast<int>(readWhole(s, 17, -1, 1)),
                 .secondStop = readFraction(s, 19)};
    try {
        readScene(run.range, text(s, 18));
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
                 .undecided = readWhole(s, 13, 0, most),
                 .families = readWhole(s, 16, 0, most)};
    run.seconds = real(s, 14);
    return run;
}

}  // namespace signorini
