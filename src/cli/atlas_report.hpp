#pragma once
/// \file
/// What signorini atlas says: rows, groups, coverage and progress, as text or JSON.

#include <optional>
#include <string>
#include <vector>

#include "atlas_coverage.hpp"
#include "signorini/atlas_database.hpp"
#include "signorini/bar.hpp"

namespace signorini::cli {

/// The point that --near asks about.
struct AtlasPoint {
    double frequencyRatio = 0.0;  ///< [omega_1]
    double energyRatio = 0.0;     ///< [E_1]
    double distance = 0.0;        ///< [-], relative
};

/// What was asked, and what was found.
struct AtlasAnswer {
    std::vector<AtlasFamily> families;
    std::vector<AtlasEntry> schedules;  ///< those of no family, or all
    std::vector<Twins> groups;          ///< of --twins
    bool isTwins = false;               ///< show the groups
    std::optional<AtlasPoint> point;    ///< of --near
    AtlasCoverage coverage;
    Bar bar;  ///< for seconds, hertz and joules

    [[nodiscard]] bool isEmpty() const
    {
        return isTwins ? groups.empty() : families.empty() && schedules.empty();
    }
};

[[nodiscard]] std::string asText(const AtlasAnswer& answer);
[[nodiscard]] std::string asJson(const AtlasAnswer& answer);

/// The families of all cells, or of those asked for, one row each. \throws FileError.
void writeAtlasCsv(const std::string& path, const AtlasDatabase& atlas,
                   std::optional<std::int64_t> cells, const Bar& bar);

[[nodiscard]] std::string asText(const AtlasRun& run, const std::string& database);
[[nodiscard]] std::string asJson(const AtlasRun& run, const std::string& database,
                                 const Scene& scene);

}  // namespace signorini::cli
