#pragma once
/// \file
/// signorini find NC NF [NC NF ...], or --period|--frequency|--hertz in place of the steps.

#include <string>
#include <vector>

#include "arguments.hpp"
#include "forced_find.hpp"
#include "motion_file.hpp"
#include "question.hpp"
#include "signorini/output.hpp"

namespace signorini::cli {

struct FindRequest;

/// One call.
struct FindCommand {
    CommonOptions common;
    std::vector<std::string> steps;
    PeriodQuestion question;
    ForcedFind forced;
    FindOptions options;
    std::optional<double> energy;       ///< [J]
    std::optional<double> yieldStress;  ///< [Pa]
    std::string targetFile;
    std::string stateFile;
    MotionFile motionFile;
    std::string figureFile;
    std::string animationFile;
    std::string certificateFile;
    bool wantsStability = false;

    void addTo(CLI::App& command);

    /// Does the work; the report goes to stdout. SIGINT and SIGTERM end a search that can be
    /// stopped. Exceptions are for `main` to translate.
    [[nodiscard]] ExitStatus run() const;

    /// Says on stderr where a motion is not what a bar could do.
    void warn(const Physical& physical) const;

private:
    /// The first demand given that forced motions, or scenes, do not have; nullptr: none.
    [[nodiscard]] const char* otherDemand(bool isScene) const;
    void requireStable(const Schedule& schedule) const;
    [[nodiscard]] ExitStatus answerSchedule(const Schedule& schedule,
                                            const FindRequest& request) const;
    [[nodiscard]] ExitStatus answerQuestion(const answers::AskedPeriod& asked,
                                            const FindRequest& request) const;
};

}  // namespace signorini::cli
