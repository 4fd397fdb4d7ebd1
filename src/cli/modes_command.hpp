#pragma once
/// \file
/// signorini modes

#include <optional>
#include <string>

#include "arguments.hpp"
#include "signorini/modes.hpp"

namespace signorini::cli {

/// One call.
struct ModesCommand {
    CommonOptions common;
    ModeBounds bounds;  ///< of the energy; the others depend on the number of contacts
    std::optional<std::int64_t> maxOrder;
    std::optional<double> maxPeriod;
    std::int64_t phases = 1;
    std::string csvFile;
    std::string figureFile;

    void addTo(CLI::App& command);

    /// Does the work; the report goes to stdout. SIGINT and SIGTERM end the search, and what was
    /// found is reported and drawn. Exceptions are for `main` to translate.
    [[nodiscard]] ExitStatus run() const;
};

}  // namespace signorini::cli
