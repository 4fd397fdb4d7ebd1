#pragma once
/// \file
/// signorini find NC NF --damping Z --force tip|base: the forced, damped motions of a schedule;
/// with
/// --period, --frequency or --hertz in place of NC NF those with one contact, on no grid.

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
    std::int64_t contacts = 1;

    void addTo(CLI::App& command);

    [[nodiscard]] bool isAsked() const { return force.ratio || force.place || force.amplitude; }
};

struct FindCommand;

/// The motions of one amplitude if it is given, else the one of least amplitude; the report goes to
/// stdout, the last motion, which has the largest impulse, to the files of the call, or the answer
/// "none" to its certificate. With a limit on strain [-], s >= -limit, only those within it.
[[nodiscard]] ExitStatus answerForced(const FindCommand& call, const Schedule& schedule);

/// All motions with one contact in a period under an exact harmonic of the amplitude given.
[[nodiscard]] ExitStatus answerHarmonic(const FindCommand& call);

}  // namespace signorini::cli
