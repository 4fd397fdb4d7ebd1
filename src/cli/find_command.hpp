#pragma once
/// \file
/// signorini find NC NF [NC NF ...]

#include <string>
#include <vector>

#include "arguments.hpp"
#include "motion_file.hpp"

namespace signorini::cli {

/// One call.
struct FindCommand {
    CommonOptions common;
    std::vector<std::string> steps;
    FindOptions options;
    std::string targetFile;
    std::string stateFile;
    MotionFile motionFile;
    std::string figureFile;
    std::string animationFile;

    void addTo(CLI::App& command);

    /// Does the work; the report goes to stdout. SIGINT and SIGTERM end a search that can be
    /// stopped. Exceptions are for `main` to translate.
    [[nodiscard]] ExitStatus run() const;
};

}  // namespace signorini::cli
