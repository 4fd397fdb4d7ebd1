#pragma once
/// \file
/// signorini find NC NF [NC NF ...]

#include <string>
#include <vector>

#include "arguments.hpp"

namespace signorini::cli {

/// The words of one call.
struct FindCommand {
    CommonOptions common;
    std::vector<std::string> steps;
    std::string solver;
    std::string formulation;
    std::string objective;
    std::string targetFile;
    std::string energyRatio;
    std::string strainLimit;
    std::string tipFloor;
    std::string tolerance;
    std::string timeLimit;
    std::string stateFile;
    std::string motionFile;
    std::string figureFile;

    void addTo(CLI::App& command);

    /// Does the work; the report goes to stdout. SIGINT and SIGTERM end a search that can be
    /// stopped. Exceptions are for `main` to translate.
    [[nodiscard]] ExitStatus run() const;
};

}  // namespace signorini::cli
