#pragma once
/// \file
/// The shape of a solution set in class amplitudes z_1..z_d: pure geometry.
///
///     simplex   z >= 0,  sum z = S
///     box       lower <= Z_j <= upper for the partial sums Z_j = z_1 + ... + z_j,  Z_d = S
///
/// Both have d - 1 dimensions; with d = 1 either is a single point. A cone, z >= 0 of any size, is
/// held by its section of one sum S: all below treats it as that simplex.
///
/// The closed-form solver: extremes of sum z^2 over a simplex or a box, and the nearest
/// member, without a library.
///
/// The energy of a motion is diagonal in its class amplitudes, so the motions of least and of most
/// energy of a whole solution set are the nearest and the farthest point of an AmplitudeSet from
/// the origin.

#include <cstdint>
#include <random>
#include <span>
#include <string_view>
#include <vector>

namespace signorini {

/// What the set of all motions of a schedule looks like.
enum class SetKind {
    empty,     ///< no motion
    point,     ///< one motion
    simplex,   ///< amplitudes of one sign with a given sum
    box,       ///< independent bounds on each partial sum
    polytope,  ///< a general polytope
    cone,      ///< motions of every size: without a gap a multiple of a motion is one
};

/// "empty", "point", "simplex", "box", "polytope", "cone".
[[nodiscard]] std::string_view name(SetKind kind);

/// A simplex or a box of amplitudes, or the section of a cone, scaled units (g/L).
struct AmplitudeSet {
    SetKind kind = SetKind::empty;  ///< empty, point, simplex, box or cone
    std::int64_t count = 0;         ///< [-], d, number of amplitudes
    double sum = 0.0;               ///< [g/L], S
    double lower = 0.0;             ///< [g/L], bound on partial sums (box)
    double upper = 0.0;             ///< [g/L], bound on partial sums (box)

    /// d - 1, d for a cone, or -1 for the empty set.
    [[nodiscard]] std::int64_t dimension() const
    {
        return kind == SetKind::cone ? count : count - 1;
    }
};

/// How far z lies outside the set, relative to |S|: the largest violation of a bound or of the sum.
/// 0 inside; infinite if z is not finite. O(d).
/// \throws std::invalid_argument if z does not hold d values.
[[nodiscard]] double distanceOutside(const AmplitudeSet& set, std::span<const double> z);

/// A random member, reproducible from the generator: uniform on the simplex, and on the box each
/// partial sum independent and uniform. O(d). \throws std::invalid_argument if the set is empty.
[[nodiscard]] std::vector<double> drawAmplitudes(const AmplitudeSet& set,
                                                 std::mt19937_64& generator);

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

/// Amplitudes with a given sum z^2 and the least max |z|, rho = squares/S^2. Simplex: m =
/// floor(1/rho) of them are equal,
///
///     z = S (1 + sqrt(((m + 1) rho - 1)/m))/(m + 1),
///
/// the next is the rest of S, the others are 0; no other z but its permutations is as flat. Box
/// between 0 and S: all are of one size but one, in as few strokes from end to end as there can be.
/// O(d). \throws std::invalid_argument if `squares` lies outside [least, most] by more than
/// rounding, or the box has other bounds.
[[nodiscard]] std::vector<double> flattestAmplitudes(const AmplitudeSet& set, double squares);

/// The amplitudes of a simplex with a given sum z^2 that are nearest to t: max(0, t_j - shift),
/// stretched; where the largest targets are equal and one of many choices has to be made, the
/// flattest. O(d log d). \throws std::invalid_argument for another set, a wrong number of
/// amplitudes, or `squares` outside [least, most] by more than rounding.
[[nodiscard]] std::vector<double> nearestWithSquares(const AmplitudeSet& set,
                                                     std::span<const double> target,
                                                     double squares);

}  // namespace signorini
