#pragma once
/// \file
/// The closed-form solver: extremes of sum z^2 over a simplex or a box, and the nearest
/// member, without a library.
///
/// The energy of a motion is diagonal in its class amplitudes, so the motions of least and of most
/// energy of a whole solution set are the nearest and the farthest point of an AmplitudeSet from
/// the origin.

#include <span>
#include <vector>

#include "signorini/amplitude_set.hpp"

namespace signorini {

/// Least value of sum z^2, reached at z = S/d everywhere: S^2/d. O(1).
/// A box must contain that point: lower <= min(0, S) and max(0, S) <= upper.
[[nodiscard]] double leastSquares(const AmplitudeSet& set);

/// Largest value of sum z^2: S^2 at a vertex of the simplex; on a box the partial sums alternate
/// between the bounds. O(1).
[[nodiscard]] double mostSquares(const AmplitudeSet& set);

/// The amplitudes of least sum z^2. O(d).
[[nodiscard]] std::vector<double> leastAmplitudes(const AmplitudeSet& set);

/// Amplitudes of largest sum z^2 (one of several equal choices). O(d).
[[nodiscard]] std::vector<double> mostAmplitudes(const AmplitudeSet& set);

/// The member nearest to given amplitudes t. Simplex: max(0, t_j - shift) with the shift that makes
/// the sum right, O(d log d). Box: the partial sums less those of t are a string pulled taut
/// through the bounds, O(d) knots, each found by looking as far as the string is straight: O(d) as
/// a rule, O(d^2) at worst. Only differences of targets matter, and their size costs no digits.
/// \throws std::invalid_argument for a wrong number of amplitudes, or an empty set.
[[nodiscard]] std::vector<double> nearestAmplitudes(const AmplitudeSet& set,
                                                    std::span<const double> target);

/// Amplitudes with a given sum z^2 between least and most: on the straight way from the least to
/// the most, where sum z^2 grows steadily because the way starts at right angles to the least.
/// O(d). \throws std::invalid_argument if `squares` lies outside [least, most] by more than
/// rounding.
[[nodiscard]] std::vector<double> amplitudesWithSquares(const AmplitudeSet& set, double squares);

}  // namespace signorini
