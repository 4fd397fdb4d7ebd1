#pragma once
/// \file
/// signorini modes

#include <string>

#include "arguments.hpp"
#include "signorini/modes.hpp"

namespace signorini::cli {

/// One call.
struct ModesCommand {
    CommonOptions common;
    ModeBounds bounds;
    std::string csvFile;
    std::string figureFile;

    void addTo(CLI::App& command);

    /// Does the work; the report goes to stdout. SIGINT and SIGTERM end the search, and what was
    /// found is reported and drawn. Exceptions are for `main` to translate.
    [[nodiscard]] ExitStatus run() const;
};

}  // namespace signorini::cli
