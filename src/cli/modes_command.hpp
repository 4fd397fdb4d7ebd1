#pragma once
/// \file
/// signorini modes

#include <string>

#include "arguments.hpp"

namespace signorini::cli {

/// The words of one call.
struct ModesCommand {
    CommonOptions common;
    std::string maxEnergyRatio;
    std::string maxOrder;
    std::string maxPeriod;
    std::string figureFile;

    void addTo(CLI::App& command);

    /// Does the work; the report goes to stdout. SIGINT and SIGTERM end the search, and what was
    /// found is reported and drawn. Exceptions are for `main` to translate.
    [[nodiscard]] ExitStatus run() const;
};

}  // namespace signorini::cli
