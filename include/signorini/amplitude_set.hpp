#pragma once
/// \file
/// The shape of a solution set in class amplitudes z_1..z_d: pure geometry.
///
///     simplex   z >= 0,  sum z = S
///     box       lower <= Z_j <= upper for the partial sums Z_j = z_1 + ... + z_j,  Z_d = S
///
/// Both have d - 1 dimensions; with d = 1 either is a single point.

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
};

/// "empty", "point", "simplex", "box", "polytope".
[[nodiscard]] std::string_view name(SetKind kind);

/// A simplex or a box of amplitudes, scaled units (g/L).
struct AmplitudeSet {
    SetKind kind = SetKind::empty;  ///< empty, point, simplex or box
    std::int64_t count = 0;         ///< [-], d, number of amplitudes
    double sum = 0.0;               ///< [g/L], S
    double lower = 0.0;             ///< [g/L], bound on partial sums (box)
    double upper = 0.0;             ///< [g/L], bound on partial sums (box)

    /// d - 1, or -1 for the empty set.
    [[nodiscard]] std::int64_t dimension() const { return count - 1; }
};

/// How far z lies outside the set, relative to |S|: the largest violation of a bound or of the sum.
/// 0 inside; infinite if z is not finite. O(d).
/// \throws std::invalid_argument if z does not hold d values.
[[nodiscard]] double distanceOutside(const AmplitudeSet& set, std::span<const double> z);

/// A random member, reproducible from the generator: uniform on the simplex, and on the box each
/// partial sum independent and uniform. O(d). \throws std::invalid_argument if the set is empty.
[[nodiscard]] std::vector<double> drawAmplitudes(const AmplitudeSet& set,
                                                 std::mt19937_64& generator);

}  // namespace signorini
