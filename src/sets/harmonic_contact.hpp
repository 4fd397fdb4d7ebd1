#pragma once
/// \file
/// All motions with one contact in a period under an exactly harmonic force or base, contact and
/// release at any real times.
///
/// Units L = c = 1, displacements in |g|. The excitation is Re(A e^{i omega t}), K cycles in
/// T = n/N. With G = gcd(2N, n), w = 2N/G, nu = n/G a crossing to and fro takes w cells of time
/// h = 2/w, a period nu, and the wave r that arrives at the tip obeys
///
///     r(t + 2) = s r(t) + source,   s = 1 in contact, -rho in flight:
///
/// one chain through all cells m -> m + w mod nu. Contact [0, tau), tau = (j + sigma) h, cuts each
/// cell at sigma: before, the chain meets j + 1 cells of contact, after, j. On either part r is one
/// harmonic, Re(kappa A e^{i omega t}), and going once around gives kappa as a quotient. Then
/// u(L, 0) = Re(Q A), Q = alpha + beta e^{i omega sigma h}, is to be g, and the push R = f + 2r is
/// to pass through 0 at tau: *smooth*, R(tau) = 0, one arccos in sigma; or *pinned*, where a front
/// arrives just then: sigma = 0, two phases of A. No iteration, so no root is missed.
/// docs/theory.md, section 21.

#include <complex>
#include <cstdint>
#include <vector>

#include "signorini/motion.hpp"
#include "signorini/simulation.hpp"

namespace signorini {

/// The wave that arrives at the tip up to a time, from the end of the piece before.
struct HarmonicPiece {
    double end = 0.0;           ///< [L/c]
    std::complex<double> wave;  ///< [g/L], r = Re(wave e^{i omega t})
};

/// One motion; t = 0 is the start of contact, tau = extremes.contactTime its release.
struct HarmonicMotion {
    double phase = 0.0;                 ///< [rad], of amplitude cos(omega t - phase), in ]-pi, pi]
    bool isPinned = false;              ///< is it a front that ends the contact?
    std::vector<HarmonicPiece> pieces;  ///< one period T
    Extremes extremes;                  ///< of it
    /// [-], the worst defect of law, gap, flight and inequalities, taken from the pieces alone.
    double residual = 0.0;
};

/// Residual of a motion, at most; motions nearer than this to a bound are taken as touching it.
inline constexpr double harmonicTolerance = 1e-9;

/// Largest nu and w.
inline constexpr std::int64_t maxHarmonicCells = 20'000;

/// The motions by ascending impulse. Read of the harmonic: place, amplitude, cycles and the period
/// T = steps/stepsPerCrossing [L/c]; its phase is an answer. The wall is touched, a second stop is
/// not. Left out: contacts longer than T - h, where waves rest beside a tip that is held (a set,
/// not a motion). Motions that differ by less than 1e-7 are one. O(nu^2). \throws
/// std::invalid_argument unless the damping ratio is in ]0, maxDampingRatio], amplitude finite and
/// > 0, stepsPerCrossing whole, cycles, nu and w in 1..maxHarmonicCells.
[[nodiscard]] std::vector<HarmonicMotion> harmonicContacts(const Damping& damping,
                                                           const Harmonic& excitation,
                                                           const Stops& stops = {});

}  // namespace signorini
