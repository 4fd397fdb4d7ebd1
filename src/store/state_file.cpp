// States read from tables.

#include <fmt/format.h>

#include "measurements.hpp"
#include "signorini/output.hpp"
#include "state_table.hpp"
#include "table.hpp"

namespace signorini {

namespace {

constexpr std::string_view stateColumns =
    "a header with columns a and b, or x, velocity and strain, or x, velocity and displacement";

/// Columns a and b: one row per cell.
StateReading readCells(Table& table, const Bar& bar, std::int64_t mostCells)
{
    const double unit = scales(bar).strain;
    std::optional<double> first;  // u(x_1)
    const std::size_t atA = table.columnOf("a", stateColumns);
    const std::size_t atB = table.columnOf("b", stateColumns);
    std::vector<double> a;
    std::vector<double> b;
    while (table.next()) {
        if (static_cast<std::int64_t>(a.size()) == mostCells) {
            table.refuse(fmt::format("allowed at most {} rows, one per cell", mostCells));
        }
        if (a.empty() && table.has("displacement")) {
            first = table.numberAt(table.columnOf("displacement")) / scales(bar).displacement;
        }
        a.push_back(table.numberAt(atA) / unit);
        b.push_back(table.numberAt(atB) / unit);
    }
    if (a.empty()) {
        table.refuse("no rows: allowed one per cell");
    }
    const auto size = static_cast<Eigen::Index>(a.size());
    if (first) {
        *first -= (b[0] - a[0]) / static_cast<double>(size);
    }
    return {{Eigen::Map<const Eigen::VectorXd>(a.data(), size),
             Eigen::Map<const Eigen::VectorXd>(b.data(), size)},
            size,
            fmt::format("waves a, b in {} rows, one per cell", size),
            first};
}

/// The longer name of a quantity if the header has it, else the shorter one; not both.
std::string_view nameIn(const Table& table, std::string_view longer, std::string_view shorter)
{
    if (table.has(longer) && table.has(shorter)) {
        table.refuse(fmt::format("columns {} and {}: allowed one of them", longer, shorter));
    }
    return !table.has(longer) && table.has(shorter) ? shorter : longer;
}

std::string howBrought(const Measurements& measured, std::int64_t cells)
{
    const std::string what =
        fmt::format("velocity and {} in {} rows",
                    measured.isDisplacement ? "displacement" : "strain", measured.x.size());
    if (isOnCells(measured, cells)) {
        return what + ", one per cell";
    }
    return fmt::format(
        "{}, {} onto {} cells", what,
        static_cast<std::int64_t>(measured.x.size()) > cells ? "averaged" : "interpolated", cells);
}

StateReading readMeasurements(Table& table, const Bar& bar, std::int64_t cells)
{
    const Scales unit = scales(bar);
    Measurements measured;
    measured.isDisplacement =
        !table.has("strain") && !table.has("s") && (table.has("displacement") || table.has("u"));
    const std::size_t atX = table.columnOf("x", stateColumns);
    const std::size_t atVelocity = table.columnOf(nameIn(table, "velocity", "v"), stateColumns);
    const std::size_t atOther = table.columnOf(
        measured.isDisplacement ? nameIn(table, "displacement", "u") : nameIn(table, "strain", "s"),
        stateColumns);
    const double unitOfOther = measured.isDisplacement ? unit.displacement : unit.strain;
    constexpr double rounding = 1e-9;
    while (table.next()) {
        if (static_cast<std::int64_t>(measured.x.size()) == maxMeasurements) {
            table.refuse(fmt::format("allowed at most {} rows", maxMeasurements));
        }
        const double x = table.numberAt(atX, "m") / bar.length;
        if (!(x >= 0.0 && x <= 1.0 + rounding)) {
            table.refuse(atX, fmt::format("0..{} [m], the bar", bar.length));
        }
        if (!measured.x.empty() && x <= measured.x.back()) {
            table.refuse(atX, "positions [m] that ascend from row to row");
        }
        measured.x.push_back(x);
        measured.velocity.push_back(table.numberAt(atVelocity, "m/s") / unit.velocity);
        measured.other.push_back(table.numberAt(atOther, measured.isDisplacement ? "m" : "-") /
                                 unitOfOther);
    }
    const auto rows = static_cast<std::int64_t>(measured.x.size());
    if (rows < 2) {
        table.refuse(fmt::format("{}: allowed two rows of measurements or more",
                                 rows == 0 ? "no rows" : "one row"));
    }
    return {onCells(measured, cells), rows, howBrought(measured, cells)};
}

}  // namespace

StateReading readState(const std::string& path, const Bar& bar, std::int64_t cells,
                       std::optional<std::int64_t> mostCells)
{
    Table table(path);
    return readState(table, bar, cells, mostCells);
}

StateReading readState(Table& table, const Bar& bar, std::int64_t cells,
                       std::optional<std::int64_t> mostCells)
{
    const bool isMeasured = !table.has("a") && !table.has("b") && table.has("x") &&
                            (table.has("velocity") || table.has("v"));
    return isMeasured ? readMeasurements(table, bar, cells)
                      : readCells(table, bar, mostCells.value_or(cells));
}

}  // namespace signorini
