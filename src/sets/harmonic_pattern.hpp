#pragma once
/// \file
/// Motions under an exact harmonic with any number of contacts in a period, from a start nearby.
///
/// A pattern says which contacts there are, on which stop, and which release a front ends: such a
/// release is whole cells away from the beginning of contact where the front left. What is not tied
/// has a place of its own in a cell; these places cut all cells into pieces, on each of which the
/// wave is one harmonic (harmonic_motion.hpp), whose kappa depends on the pattern alone. With
/// S releases that are smooth, K + S numbers are open,
///
///     arg A, c_2 ... c_K, tau_k where smooth:   u(L, c_k) = Re(Q_k A) = place,   R(tau_k) = 0,
///
/// and derivatives by the places are the jumps of r: Newton converges to rounding. The pattern is
/// read off anew from the waves, releases and beginnings in their order, until it stays the same.
/// docs/theory.md, section 21.

#include <optional>

#include "harmonic_motion.hpp"

namespace signorini {

/// Where to start.
struct HarmonicStart {
    double phase = 0.0;                     ///< [rad]
    std::vector<HarmonicContact> contacts;  ///< begin, end, stop, isPinned, front, travel
};

/// The motion near a start, measured; none if Newton does not come to one, its contacts are
/// more than maxHarmonicContacts, or a chain never flies. O(K nu + K^3) for each of a few steps.
[[nodiscard]] std::optional<HarmonicMotion> harmonicNear(const HarmonicCase& given,
                                                         const HarmonicStart& start);

/// Fronts of several contacts that meet, apart by rounding, make a flight of nothing: contacts with
/// one stop so near are one.
[[nodiscard]] std::vector<HarmonicContact> joined(const std::vector<HarmonicContact>& all,
                                                  double within);

/// [L/c], of fronts that travel alike.
inline constexpr double sameTravel = 1e-9;

/// The return on which a front ends a contact.
[[nodiscard]] std::int64_t returnOf(const HarmonicCase& given, const HarmonicContact& one);

/// Where a curve of motions of one period goes: by ln |A|, phase, and beginnings and ends.
using HarmonicDirection = std::vector<double>;

/// A step along that curve, as amplitude changes, of a length in ln |A|, rad and L/c; folds are no
/// obstacle. The amplitude of the case becomes that of the motion. \return false: there is none,
/// and nothing has changed. \pre 2 + 2K directions, or none: amplitude grows.
[[nodiscard]] bool stepAlongAmplitude(HarmonicCase& given, HarmonicMotion& motion,
                                      HarmonicDirection& direction, double length);

}  // namespace signorini
