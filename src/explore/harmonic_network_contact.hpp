#pragma once
/// \file
/// All motions with one contact in a period of a network under an exact harmonic, where dashpots
/// damp all its waves; computed in doubles, so an empty list is no proof, but where momentum says
/// so.
///
/// A network answers a push of a step at contact k with rates g_m of its distance, and a harmonic
/// with the rate Y: in contact pushes Q_i, the same harmonics in all steps, keep it closed,
///
///     Y e^{i omega m} + sum over i < j of g_{m - i} Q_i = 0,   m = 0 ... j - 1,
///
/// a Toeplitz system, solved for all j by Levinson's recursion (growing_contact.hpp). The distance
/// at the start sums the displacements H that pushes leave, so the release is found as for a bar
/// (harmonic_release.hpp): four candidates with a smooth one for each j, two with a pinned one.
/// docs/theory.md, section 21.

#include <optional>
#include <vector>

#include "harmonic_network.hpp"

namespace signorini {

/// Longest period, in steps.
inline constexpr std::int64_t maxHarmonicSteps = 2'000;

/// What is asked, about the shape under constant forces.
struct StillCase {
    HarmonicNetwork given;
    HarmonicNetwork unforced;       ///< without what pulls at bars that drift
    std::vector<double> displaced;  ///< the nodes, by other constant forces
};

/// Distances counted from the shape under these. \throws std::invalid_argument.
[[nodiscard]] StillCase stillOf(const HarmonicNetwork& given);

/// Under constant forces on bars that drift each step has a constant push beside the harmonic one,
/// and the mean rate of the distance is 0 in place of the distance at the start.
///
/// The motions by ascending impulse, measured; residuals are at most `harmonicTolerance`. Every
/// contact in turn is the one that closes. O(n^2) and, for each frequency, channels^3; O(n^2) for
/// each candidate. \throws std::invalid_argument unless n is in 2..maxHarmonicSteps and K
/// in 1..n/2, something is driven and damped; Resonance.
[[nodiscard]] std::vector<NetworkHarmonicMotion> harmonicContacts(const HarmonicNetwork& given);

/// The mean push of a contact in a period in which no other one presses: what constant forces on
/// the bars that drift ask for, 0 if none of them is at it. None: no push gives them back their
/// momentum. O(nodes).
[[nodiscard]] std::optional<double> meanPushOf(const Network& network, std::size_t contact);

/// What is left at least of the distance of each contact while none closes; below 0 one would. Bars
/// that drift swing about their places in the scene; none where forces pull at them. O(channels^3).
/// \throws as `harmonicContacts`.
[[nodiscard]] std::optional<std::vector<double>> openDistances(const HarmonicNetwork& given);

}  // namespace signorini
