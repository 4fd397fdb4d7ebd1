#pragma once
/// \file
/// The motion of a schedule with several phases that is nearest to a given state.
///
/// The squared distance is a sum over the types. Given the sum S of a pressing type, its nearest
/// amplitudes are known (`nearestAmplitudes`), and their distance is convex in S and quadratic as
/// long as the same k amplitudes, the largest of the target, are positive: (S - c_k)^2 / k with c_k
/// the sum of those k targets. So the sums are found by projecting c exactly onto the polyhedron of
/// the sums, in the metric of the k, until the k are those of the point reached. Between the steps
/// a search along the way to the projection makes the distance fall, so none of them comes back.

#include <optional>

#include "signorini/lumped_set.hpp"
#include "signorini/motion.hpp"

namespace signorini {

/// The nearest motion; empty if the box of a grazing type varies with S and holds the motion, which
/// this cannot answer, or if the search does not end. The answer has passed `nearestResidual`.
/// O(N log N) in rationals.
[[nodiscard]] std::optional<State> nearestMotion(const LumpedSet& set, const LumpedShape& shape,
                                                 const State& target);

/// The same for one phase, by the closed form; empty where rounding spoils it. O(N log N).
/// \pre the set is not empty.
[[nodiscard]] std::optional<State> nearestMotion(const OnePhaseSet& whole, const State& target);

/// How far z is from meeting the conditions of the member nearest to t (Karush-Kuhn-Tucker),
/// relative to the largest bound of the set: of each amplitude (simplex) or partial sum (box), the
/// step to a bound or of a gradient, whichever is less. Knows nothing of how z was found. O(d).
[[nodiscard]] double nearestResidual(const AmplitudeSet& set, std::span<const double> z,
                                     std::span<const double> target);

}  // namespace signorini
