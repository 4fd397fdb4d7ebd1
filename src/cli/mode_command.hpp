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

/// T in L/c as people give it: 22/7, 3.14, 3.
struct ModePeriod {
    double value = 0.0;
    std::optional<ExactPeriod> exact;  ///< unless it needs more than 18 digits
};

/// One call.
struct ModeCommand {
    CommonOptions common;
    std::vector<std::string> contact;  ///< 4a and b
    std::optional<ModePeriod> period;
    std::string stateFile;
    MotionFile motionFile;
    std::string figureFile;
    std::string animationFile;

    void addTo(CLI::App& command);

    /// Does the work; the report goes to stdout. Exceptions are for `main` to translate.
    [[nodiscard]] ExitStatus run() const;
};

}  // namespace signorini::cli
