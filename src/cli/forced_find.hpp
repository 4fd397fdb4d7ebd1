#pragma once
/// \file
/// signorini find NC NF --damping Z --force tip|base: the forced, damped motions of a schedule.

#include <cstdint>
#include <string>

#include "arguments.hpp"
#include "force_options.hpp"
#include "signorini/response.hpp"

namespace signorini::cli {

/// The part of a call of `find` that makes its motions forced ones.
struct ForcedFind {
    ForceOptions force;
    std::int64_t cycles = 1;

    void addTo(CLI::App& command);

    [[nodiscard]] bool isAsked() const { return force.ratio || force.place || force.amplitude; }

    /// Those of one amplitude if it is given, else the one of least amplitude; the report goes to
    /// stdout, the state of the last one, which has the largest impulse, to `stateFile`, an answer
    /// "none" to `certificateFile`. With a limit on strain [-], s >= -strainLimit, only those
    /// within it.
    [[nodiscard]] ExitStatus answer(const Schedule& schedule, const CommonOptions& common,
                                    const std::string& stateFile,
                                    const std::string& certificateFile, double strainLimit) const;
};

}  // namespace signorini::cli
