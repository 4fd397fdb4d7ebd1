#pragma once
/// \file
/// Independent checks of forced motions: the rows of a schedule and a march that detects contact,
/// both on the cells of the bar, and proofs of absence.

#include <limits>
#include <span>

#include "signorini/certificate.hpp"
#include "signorini/motion.hpp"
#include "signorini/schedule.hpp"
#include "signorini/simulation.hpp"

namespace signorini {

/// What a walk over one period of the excitation saw. Residuals are relative, 0 for a motion.
struct ForcedWalk {
    double periodicity = 0.0;  ///< change of the state / its largest value
    double gap = 0.0;          ///< distance from the stop at the start of each contact phase / |g|;
                               ///< without a gap / the largest wave, as depths are
    double pressure = 0.0;     ///< largest tension between tip and wall / largest value
    double penetration = 0.0;  ///< depth of the tip inside a stop / |g|
    double balance = 0.0;      ///< work of the excitation - dissipation / the larger
    double march = 0.0;        ///< the march that knows no schedule: change of the state, or depth
    Extremes extremes;         ///< what the motion reaches

    [[nodiscard]] double worst() const;
};

/// Walks a state along the schedule, and marches it. O(n + N).
/// `tolerance`: how near a stop counts as there [|g|, or the largest wave].
/// \pre the schedule has the state's N cells, N steps per crossing, the excitation n steps.
[[nodiscard]] ForcedWalk walkForced(const State& state, const Schedule& schedule,
                                    const Damping& damping, const Excitation& excitation,
                                    double tolerance = 1e-9);

/// Whose motions are in question: C shape_0 + S shape_1, or a multiple of one shape.
struct ForcedQuestion {
    const Schedule& schedule;
    double rho = 1.0;
    std::span<const Excitation> shapes;                          ///< one or two, of n steps each
    double waveLimit = std::numeric_limits<double>::infinity();  ///< [g/L], no p_m beyond it
};

/// Amplitudes beyond it are no motions of a bar: where rows cancel but for rounding, a proof holds
/// up to it [EA g/L or g].
inline constexpr double mostForcedAmplitude = 1e9;

/// Do the conditions forbid any excitation to bring the tip to the stop at t = 0? True only if it
/// is certain. With u(L, 0) = g they are rows in C, S and the waves that nothing damps. Their
/// combination that is 0 in those waves, whose factors are integers, is found in rationals; in C
/// and S rows are enclosed, whatever was rounded on the way from the numbers of the shapes and rho,
/// and the combination that is 0 in them, too, is unique. It is a proof if its factors have the
/// right signs and its right side the wrong one for all values in the intervals. Where the bar at
/// rest is a motion any other is forbidden, and an excitation with it: C = S = 0 is what is left.
/// O(n + conditions^3).
[[nodiscard]] bool forbidsContact(const ForcedQuestion& question,
                                  std::span<const ForcedCondition> conditions);

/// Do the conditions forbid all motions whose excitation has this amplitude > 0? Of such there are
/// at most two with u(L, 0) = g, each of which must break one of the conditions for certain; or two
/// waves that nothing damps allow no excitation at all. O(n + conditions).
[[nodiscard]] bool forbidsAmplitude(const ForcedQuestion& question, double amplitude,
                                    std::span<const ForcedCondition> conditions);

}  // namespace signorini
