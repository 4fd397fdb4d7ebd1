#pragma once
/// \file
/// One measurement, and the table of all of them: a tidy CSV file.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace signorini::bench {

/// The figures a record may hold, in the order of the columns. Seconds are wall time, but of the
/// processor in marches of rivals.
inline constexpr std::array figureColumns{
    "cells",           ///< N
    "tolerance",       ///< asked for
    "variables",       ///< of the program
    "rows",            ///< of the program, without bounds
    "entries",         ///< of its matrices
    "pose_seconds",    ///< writing the program down, median
    "setup_seconds",   ///< handing it to the library and recomputing its claim, median
    "solve_seconds",   ///< inside the library, median
    "seconds_median",  ///< all of it
    "seconds_best",    ///< all of it
    "repeats",         ///< runs after the first; 0: the first took too long to be repeated
    "iterations",      ///< as the library counts them
    "error",           ///< largest of the errors below that apply to the request
    "periodicity",     ///< residual of (30)
    "gap",             ///< residual of (31)
    "pressure",        ///< residual of (10)
    "penetration",     ///< residual of (11), (12)
    "march",           ///< residual of an independent march
    "set_distance",    ///< to the solution set, relative
    "energy_ratio",    ///< E/E_1
    "energy_error",    ///< relative to what was asked for
    "tip_error",       ///< root mean square over time, relative to the reach of the tip
    "force_error",     ///< the same of the wall's force, relative to its own root mean square
    "energy_drift",    ///< energy at the end over that at the start, - 1
    "impulse_error",   ///< relative, of a period
    "contact_error",   ///< relative, of the time of contact
    "peak_error",      ///< relative, of the largest force
    "checked",         ///< how many schedules, periods or dimensions one record stands for
    "found",           ///< of them those with motions
    "families",        ///< sets of orbits that these belong to
    "wrong",           ///< how many of them came out wrong
    "peak_megabytes",  ///< of the process that measured
    "case_seconds",    ///< from its start to its end
};

/// Texts first identify the measurement, then say what came of it.
struct Record {
    std::string suite;        ///< "accuracy", "extremes", ...
    std::string problem;      ///< "A, N = 300"
    std::string backEnd;      ///< "glpk-simplex"
    std::string formulation;  ///< "sy"; "-": none
    std::string setting;      ///< "any, 1e-06"
    /// right, inaccurate, wrong: claims judged by other code. withdrawn: a claim the library did
    /// not believe. undecided: no claim. timeout, memory, crashed: the process was ended.
    /// skipped: an easier case of the series was ended. refused, absent: never tried.
    std::string outcome;
    std::string claim;       ///< what the back end said: found, none, withdrawn, limit, failed
    std::string detail;      ///< for people
    std::string provenance;  ///< id of the machine, build and commit it comes from
    std::map<std::string, double, std::less<>> figures;  ///< those of figureColumns that are known

    /// A figure, NaN if it is not known.
    [[nodiscard]] double figure(std::string_view name) const;
};

/// A record that so far only says what is to be measured.
[[nodiscard]] Record identified(std::string suite, std::string problem, std::string backEnd,
                                std::string formulation, std::string setting);

/// What tells one measurement from another: "suite/problem/back end/formulation/setting".
[[nodiscard]] std::string keyOf(const Record& record);

/// The first line of the table, without its end.
[[nodiscard]] std::string csvHeader();

/// One line, without its end. \throws std::logic_error for a figure that has no column.
[[nodiscard]] std::string csvLine(const Record& record);

/// The record of one line, none if it is not complete.
[[nodiscard]] std::optional<Record> parseCsvLine(const std::string& line);

/// All complete records of a file; none if there is no such file. A line cut short by the end of a
/// process is dropped. \throws FileError if the file is no table of these columns.
[[nodiscard]] std::vector<Record> readTable(const std::string& path);

}  // namespace signorini::bench
