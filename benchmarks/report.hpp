#pragma once
/// \file
/// The report: tables and figures from the CSV file alone.

#include <string>

namespace signorini::bench {

/// The table of a folder: "folder/results.csv".
[[nodiscard]] std::string tableIn(const std::string& folder);

/// Writes report.md and the figures for the rows of the last provenance in the table, and returns a
/// short summary for people. \throws FileError if there is no table.
std::string makeReport(const std::string& folder);

}  // namespace signorini::bench
