#pragma once
/// \file
/// signorini atlas --database FILE.sqlite

#include <string>
#include <vector>

#include "arguments.hpp"
#include "signorini/atlas_database.hpp"

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
    [[nodiscard]] bool isQuery() const;
    [[nodiscard]] AtlasRange parseRange() const;
    [[nodiscard]] ExitStatus answer() const;
    [[nodiscard]] ExitStatus build() const;
    void draw(const AtlasDatabase& atlas) const;
};

}  // namespace signorini::cli
