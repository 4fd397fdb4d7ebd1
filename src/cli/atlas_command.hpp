#pragma once
/// \file
/// signorini atlas --database FILE.sqlite

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "interrupt.hpp"
#include "ranks.hpp"
#include "signorini/atlas_database.hpp"
#include "signorini/output.hpp"

namespace signorini::cli {

/// One call.
struct AtlasCommand {
    CommonOptions common;
    std::string database;
    std::optional<std::int64_t> maxContact;
    std::optional<std::int64_t> maxFree;
    std::optional<std::int64_t> phases;
    std::optional<double> maxEnergyRatio;
    bool all = false;
    bool resume = false;
    std::vector<std::string> near;  ///< W E
    std::optional<double> within;
    std::optional<ExactPeriod> period;
    bool twins = false;
    std::string figureFile;
    std::string mapFile;

    void addTo(CLI::App& command);

    /// Decides the range, or answers a query; the report goes to stdout. SIGINT and SIGTERM end
    /// the work after the batch in flight. Exceptions are for `main` to translate.
    [[nodiscard]] ExitStatus run() const;

private:
    /// A question to a database.
    struct Query {
        std::optional<std::int64_t> cells;           ///< only these; otherwise all
        std::optional<ExactPeriod> period;           ///< --period
        std::optional<std::array<double, 2>> point;  ///< --near
        double distance = 0.0;                       ///< --within
        Bar bar;                                     ///< for seconds and joules
    };
    /// Pictures to be drawn, under their temporary names; empty: not asked for.
    struct Pictures {
        OutputFiles files;
        std::string figure;
        std::string map;
    };

    [[nodiscard]] bool isQuery() const;
    [[nodiscard]] bool namesRange() const;
    [[nodiscard]] bool makesRange() const;
    [[nodiscard]] AtlasRange range() const;
    [[nodiscard]] Query query() const;
    void stagePictures(Pictures& pictures) const;
    [[nodiscard]] ExitStatus answer(const Query& query) const;
    [[nodiscard]] ExitStatus build(const AtlasRange& range, Ranks* ranks,
                                   std::optional<Interrupt>& interrupt) const;
    void fill(AtlasDatabase& atlas, AtlasRun& run, Ranks* ranks, const AtlasOptions& options) const;
    void draw(const AtlasDatabase& atlas, std::optional<std::int64_t> cells,
              Pictures& pictures) const;
};

}  // namespace signorini::cli
