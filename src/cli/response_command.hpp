#pragma once
/// \file
/// signorini response

#include <optional>
#include <string>

#include "arguments.hpp"
#include "force_options.hpp"
#include "signorini/response.hpp"

namespace signorini::cli {

/// One call.
struct ResponseCommand {
    CommonOptions common;
    ForceOptions force;
    FrequencyOption from;
    FrequencyOption to;
    ResponseRange range;
    std::optional<double> band;
    std::optional<double> yieldStress;  ///< [Pa]
    bool wantsStability = false;
    bool isExact = false;  ///< the harmonic itself, not a staircase
    std::string csvFile;
    std::string figureFile;
    std::string mapFile;
    std::string mapCsvFile;
    std::string backboneFile;

    void addTo(CLI::App& command);

    /// Does the work; the report goes to stdout. SIGINT and SIGTERM end it, and the frequencies
    /// that were done are reported. Exceptions are for `main` to translate.
    [[nodiscard]] ExitStatus run() const;

private:
    [[nodiscard]] ExitStatus runExact(const ResponseRange& asked, const Scene& scene) const;
};

}  // namespace signorini::cli
