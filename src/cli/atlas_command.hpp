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

/// The words of one call.
struct AtlasCommand {
    CommonOptions common;
    std::string database;
    std::string maxContact;
    std::string maxFree;
    std::string phases;
    std::string maxEnergyRatio;
    bool all = false;
    bool resume = false;
    std::vector<std::string> near;  ///< W E
    std::string within;
    std::string period;
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
    [[nodiscard]] AtlasRange parseRange() const;
    [[nodiscard]] Query parseQuery() const;
    void stagePictures(Pictures& pictures) const;
    [[nodiscard]] ExitStatus answer(const Query& query) const;
    [[nodiscard]] ExitStatus build(const AtlasRange& range, Ranks* ranks,
                                   std::optional<Interrupt>& interrupt) const;
    void fill(AtlasDatabase& atlas, AtlasRun& run, Ranks* ranks, const AtlasOptions& options) const;
    void draw(const AtlasDatabase& atlas, std::optional<std::int64_t> cells,
              Pictures& pictures) const;
};

}  // namespace signorini::cli
