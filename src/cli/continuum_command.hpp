#pragma once
/// \file
/// signorini continuum NC NF [NC NF ...] --energy-ratio X

#include <string>
#include <vector>

#include "arguments.hpp"

namespace signorini::cli {

/// The words of one call.
struct ContinuumCommand {
    CommonOptions common;
    std::vector<std::string> steps;
    std::string energyRatio;
    std::string points;
    std::string fromFile;
    std::string toFile;
    std::string directionFile;
    bool sample = false;
    std::string seed;
    std::string engine;
    std::string strainLimit;
    std::string resolution;
    std::string tolerance;
    std::string csvFile;
    std::string figureFile;

    void addTo(CLI::App& command);

    /// Does the work; the report goes to stdout. SIGINT and SIGTERM end the trace, and what was
    /// found is reported and written. Exceptions are for `main` to translate.
    [[nodiscard]] ExitStatus run() const;
};

}  // namespace signorini::cli
