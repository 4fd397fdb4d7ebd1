#pragma once
/// \file
/// What signorini atlas says: rows, groups, coverage and progress, as text or JSON.

#include <string>
#include <vector>

#include "signorini/atlas_database.hpp"
#include "signorini/bar.hpp"

namespace signorini::cli {

/// What a query asked, and what was found.
struct AtlasAnswer {
    std::vector<AtlasEntry> entries;  ///< of --near and --period
    std::vector<Twins> groups;        ///< of --twins
    bool isTwins = false;             ///< which of the two to show
    std::vector<AtlasRun> coverage;   ///< the runs of the cells asked about
    Bar bar;                          ///< for seconds and joules
    double shortestPeriod = 0.0;      ///< [L/c], asked about
    double energyRatio = 0.0;         ///< [E_1], highest asked about

    /// Is it empty because no finished run has decided what was asked?
    [[nodiscard]] bool isUndecided() const;
};

/// Why an answer may lack something, in one line; empty if every run of it is finished and kept
/// motions of that energy, and one reaches that period.
[[nodiscard]] std::string gapsOf(const AtlasAnswer& answer);

[[nodiscard]] std::string asText(const AtlasAnswer& answer);
[[nodiscard]] std::string asJson(const AtlasAnswer& answer, bool isComplete);

[[nodiscard]] std::string asText(const AtlasRun& run, const std::string& database);
[[nodiscard]] std::string asJson(const AtlasRun& run, const std::string& database, const Bar& bar);

}  // namespace signorini::cli
