#pragma once
/// \file
/// signorini find NC NF --damping Z --force tip|base: the forced, damped motions of a schedule;
/// with
/// --period, --frequency or --hertz in place of NC NF those with one contact, on no grid.

#include "arguments.hpp"
#include "signorini/schedule.hpp"

namespace signorini::cli {

struct FindCommand;

/// The motions of one amplitude if it is given, else the one of least amplitude; the report goes to
/// stdout, the last motion, which has the largest impulse, to the files of the call, or the answer
/// "none" to its certificate. With a limit on strain [-], s >= -limit, only those within it.
[[nodiscard]] ExitStatus answerForced(const FindCommand& call, const Schedule& schedule);

/// All motions with one contact in a period under an exact harmonic of the amplitude given.
[[nodiscard]] ExitStatus answerHarmonic(const FindCommand& call);

}  // namespace signorini::cli
