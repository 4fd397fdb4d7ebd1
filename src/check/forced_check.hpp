#pragma once
/// \file
/// Independent proofs that a schedule of a uniform bar has no forced motion.

#include <limits>
#include <span>

#include "signorini/certificate.hpp"
#include "signorini/schedule.hpp"
#include "signorini/simulation.hpp"

namespace signorini {

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

/// Do the conditions forbid all motions whose excitation has this amplitude > 0? Of the circle of
/// such (C, S) u(L, 0) = g and the conditions that no undamped wave is in leave nothing for certain
/// (energy_floor.hpp). O(n + conditions^2).
[[nodiscard]] bool forbidsAmplitude(const ForcedQuestion& question, double amplitude,
                                    std::span<const ForcedCondition> conditions);

}  // namespace signorini
