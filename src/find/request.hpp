#pragma once
/// \file
/// A question to `findPeriodic`, checked, and what exact arithmetic knows of its schedule.

#include <optional>
#include <string>

#include "signorini/find_periodic.hpp"
#include "signorini/lumped_set.hpp"
#include "stopwatch.hpp"

namespace signorini {

/// What is known of a schedule whichever route answers.
struct Known {
    MotionSet set;
    std::optional<OnePhaseSet> onePhase;  ///< one phase
    std::optional<LumpedSet> sums;        ///< several phases, if within exact arithmetic
    LumpedShape shape;                    ///< of the sums
    Reason reason =
        Reason::penetration;  ///< several phases: why there is no motion, if there is none
    std::string outOfReach;   ///< why no route can answer; empty if one can
    double seconds = 0.0;     ///< [s], spent on all this
};

/// A checked question. Refers to the options it was made of.
struct Request {
    Schedule schedule;           ///< as asked for
    const FindOptions& options;  ///< as asked for
    Demands demands;             ///< those of the options
    Known known;                 ///< of the schedule

    /// May the answer come from the exact sets, without a program?
    [[nodiscard]] bool allowsExact() const;
    /// Has every multiple of a motion to be a motion, too? Then the energy sets its size.
    [[nodiscard]] bool isOfAnySize() const;
    /// A motion at the energy asked for, where motions are of any size; otherwise the same.
    [[nodiscard]] State sized(State state) const;
    /// Does a motion meet the demands within the tolerance?
    [[nodiscard]] bool isMetBy(const State& state) const;
};

/// What can be said of options without a schedule. \throws as `findPeriodic`.
void checkOptions(const FindOptions& options);

/// Validates, and asks exact arithmetic once. O(n/G), for several phases O(n/G K) and what
/// `lumpedSetOf` takes. \throws as `findPeriodic`.
[[nodiscard]] Request checked(const Schedule& schedule, const FindOptions& options);

}  // namespace signorini
