#pragma once
/// \file
/// signorini find NC NF [NC NF ...], or --period|--frequency|--hertz in place of the steps.

#include <string>
#include <vector>

#include "arguments.hpp"
#include "force_options.hpp"
#include "given.hpp"
#include "motion_file.hpp"
#include "question.hpp"
#include "signorini/output.hpp"

namespace signorini::cli {

struct FindRequest;

/// One call.
struct FindCommand {
    const Given& given;
    CommonOptions common;
    PeriodQuestion question;
    ForceOptions force;
    std::int64_t cycles;  ///< of the force in a period
    FindOptions options;
    std::optional<double> yieldStress;  ///< [Pa]
    MotionFile motionFile;

    explicit FindCommand(const Given& words);

    [[nodiscard]] ExitStatus run() const;
    [[nodiscard]] bool isForced() const { return force.ratio || force.place || force.amplitude; }

    /// Says on stderr where a motion is not what a bar could do.
    void warn(const Physical& physical) const;

private:
    /// answers::asks::..., of a bar.
    [[nodiscard]] unsigned kind() const;
    void requireStable(const Schedule& schedule) const;
    [[nodiscard]] ExitStatus answerSchedule(const Schedule& schedule,
                                            const FindRequest& request) const;
    [[nodiscard]] ExitStatus answerQuestion(const answers::AskedPeriod& asked,
                                            const FindRequest& request) const;
};

}  // namespace signorini::cli
