#pragma once
/// \file
/// Checks by code that did not solve: residuals of (30)-(32), a march of the bar that decides
/// contact by itself, and proofs of absence checked in integers.

#include <cstdint>
#include <vector>

#include "signorini/certificate.hpp"
#include "signorini/schedule.hpp"
#include "signorini/state.hpp"

namespace signorini {

/// What a march over one period saw.
struct March {
    double residual = 0.0;  ///< [-], change of the state over the period / its amplitude, or the
                            ///< depth by which the tip would enter the wall / g, if that is larger
    std::int64_t firstFault = -1;  ///< step in which the tip would enter the wall; -1: none
    std::vector<Phase> phases;     ///< phases in which the wall is pressed, from the start of one;
                                   ///< empty for a grazing motion and after a fault
};

/// Marches the bar for `count` steps from t = 0 knowing nothing of any schedule. In each step the
/// Signorini rule decides: away from the wall the tip is free; at the wall it is held if the
/// arriving wave pushes (p > 0), and free otherwise.
///
/// `tolerance` (relative to g and to the amplitude) says when the tip counts as being at the wall
/// and when a contact step counts as pressed. A flight of 4N steps restores the state exactly, so
/// longer flights are not walked to their end. O(N + min(count, contact steps + 4N)).
/// \throws std::invalid_argument on a malformed state or a negative count.
[[nodiscard]] March march(const State& state, std::int64_t count, double tolerance = 1e-9);

/// Violations of the problem by a state, relative, 0 when there are none; all infinite when the
/// state holds a value that is not finite.
struct Residuals {
    double periodicity = 0.0;  ///< (30): max |W x - x| / max |x|
    double gap = 0.0;          ///< (31): max |u(L) - g| / g at the start of each contact phase
    double pressure = 0.0;     ///< (10): max tension of the tip on the wall / max |x|
    double penetration = 0.0;  ///< (11), (12): max depth of the tip inside the wall / g
    double march = 0.0;        ///< March::residual

    /// The largest of the five.
    [[nodiscard]] double worst() const;
};

/// Recomputes (30)-(32) for a state and a schedule by stepping, and marches the bar. O(N + min(n,
/// 12N)). \throws std::invalid_argument if the state does not have the schedule's cells.
[[nodiscard]] Residuals residuals(const State& state, const Schedule& schedule,
                                  double tolerance = 1e-9);

/// The schedule that has contact exactly where the wall is pressed, seen by a march; empty for a
/// grazing motion.
[[nodiscard]] std::vector<Phase> canonicalPhases(const State& state, const Schedule& schedule,
                                                 double tolerance = 1e-9);

/// Checks a certificate against the rows listed in certificate.hpp, in 64-bit integers that refuse
/// to overflow. O(N + rows). False for anything that is not a proof.
[[nodiscard]] bool isProof(const FarkasCertificate& certificate, const Schedule& schedule);

}  // namespace signorini
