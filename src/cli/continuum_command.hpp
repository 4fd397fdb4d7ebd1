#pragma once
/// \file
/// signorini continuum NC NF [NC NF ...] --energy-ratio X | --energy J

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "signorini/continuum.hpp"

namespace signorini::cli {

/// One call.
struct ContinuumCommand {
    CommonOptions common;
    std::vector<std::string> steps;
    std::optional<double> energyRatio;
    std::optional<double> energy;  ///< [J]
    ContinuumOptions options;
    bool sample = false;
    std::optional<std::uint64_t> seed;
    std::string fromFile;
    std::string toFile;
    std::string directionFile;
    std::optional<double> member;  ///< lambda
    std::string stateFile;
    std::string csvFile;
    std::string figureFile;
    std::string animationFile;

    void addTo(CLI::App& command);

    /// Does the work; the report goes to stdout. SIGINT and SIGTERM end the trace, and what was
    /// found is reported and written. Exceptions are for `main` to translate.
    [[nodiscard]] ExitStatus run() const;
};

}  // namespace signorini::cli
