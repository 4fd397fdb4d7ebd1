#pragma once
/// \file
/// signorini mode A4 B --period T

#include <optional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "motion_file.hpp"
#include "signorini/modes.hpp"

namespace signorini::cli {

/// One call.
struct ModeCommand {
    CommonOptions common;
    std::vector<std::string> contact;  ///< 4a and b
    std::optional<GivenNumber> period;
    std::string stateFile;
    MotionFile motionFile;
    std::string figureFile;
    std::string animationFile;

    void addTo(CLI::App& command);

    /// Does the work; the report goes to stdout. Exceptions are for `main` to translate.
    [[nodiscard]] ExitStatus run() const;
};

}  // namespace signorini::cli
