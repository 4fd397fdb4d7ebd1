#pragma once
/// \file
/// Checks that are independent of the solvers: residuals of (30)-(32), time stepping that is not
/// told the schedule, and proofs of absence checked in integers.

#include <cstdint>
#include <vector>

#include "signorini/certificate.hpp"
#include "signorini/motion.hpp"
#include "signorini/schedule.hpp"

namespace signorini {

/// What a march over one period saw.
struct March {
    double residual = 0.0;         ///< [-], change of the state over the period / its amplitude, or
                                   ///< the depth by which the tip enters the wall / g
    std::int64_t firstFault = -1;  ///< step in which the tip enters the wall; -1: none
    std::vector<Phase> phases;     ///< phases in which the wall is pressed, from the start of one;
                                   ///< empty for a grazing motion and after a fault
};

/// Marches the bar for `count` steps from t = 0 knowing nothing of any schedule. In each step the
/// Signorini rule decides: a tip that is at the wall and pushed (p > 0) is held, any other is free.
/// A tip that would meet the wall in the middle of a step leaves the grid: a fault. So at a second
/// stop, where a push is p < 0.
///
/// `tolerance` says how near the wall counts as being there, relative to g, and how strong a push
/// counts as pressing, relative to the amplitude. A flight of 4N steps restores the state exactly,
/// so longer flights are not walked to their end. O(N + min(count, contact steps + 4N)). \throws
/// std::invalid_argument on a malformed state or a negative count.
[[nodiscard]] March march(const State& state, std::int64_t count, double tolerance = 1e-9,
                          const Stops& stops = {});

/// Violations of the problem by a state, relative, 0 when there are none; all infinite when the
/// state holds a value that is not finite.
struct Residuals {
    double periodicity = 0.0;  ///< (30): max |W x - x| / max |x|
    /// (31): max |u(L) - place of the stop| / |g| at the start of each contact phase
    double gap = 0.0;
    double pressure = 0.0;     ///< (10): max tension of the tip on the wall / max |x|
    double penetration = 0.0;  ///< (11), (12): max depth of the tip inside a stop / |g|
    double march = 0.0;        ///< March::residual
    double demands = 0.0;      ///< further demands of a request: see demands.hpp

    /// The largest of them.
    [[nodiscard]] double worst() const;
};

/// What can be said of a state without knowing how it was found.
struct Verification {
    Residuals residuals;           ///< of (30)-(32) and the march
    double peakStrain = 0.0;       ///< [g/L], deepest compression: -min s over all x and t
    std::vector<Phase> canonical;  ///< the schedule with contact exactly where the wall is pressed,
                                   ///< seen by the march over the shortest period after which
                                   ///< the state is back; empty for a grazing motion
    std::int64_t repetitions = 1;  ///< how often the motion repeats in the schedule's period
    std::vector<bool> pressing;    ///< for each phase of the schedule: is the wall pressed at all?
    bool isSymmetric = false;  ///< two stops: is the second half of the period the first, mirrored?
};

/// Recomputes (30)-(32) for a state and a schedule with its stops by stepping, and marches the bar
/// over a period; where the pressed phases repeat, also over the shorter periods they suggest. The
/// march is not told the schedule; as long as it follows it, both are one walk. O(N +
/// min(n, 12N)) time per phase, no copy of the state. \throws std::invalid_argument if the state
/// does not have the schedule's cells.
[[nodiscard]] Verification verify(const State& state, const Schedule& schedule,
                                  double tolerance = 1e-9);

/// Checks a certificate against the rows listed in certificate.hpp, in 64-bit integers that refuse
/// to overflow. O(K (N + rows)). False for anything that is not a proof.
[[nodiscard]] bool isProof(const FarkasCertificate& certificate, const Schedule& schedule);

}  // namespace signorini
