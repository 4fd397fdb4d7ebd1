#pragma once
/// \file
/// All motions with one contact in a period under an exactly harmonic force or base, contact and
/// release at any real times.
///
/// Cells of time and waves as in harmonic_motion.hpp: the law links cell m to m + w mod nu, one
/// chain through all. Contact [0, tau), tau = (j + sigma) h, cuts each
/// cell at sigma: before, the chain meets j + 1 cells of contact, after, j. On either part r is one
/// harmonic, Re(kappa A e^{i omega t}), and going once around gives kappa as a quotient. Then
/// u(L, 0) = Re(Q A), Q = alpha + beta e^{i omega sigma h}, is to be g, and the push R = f + 2r is
/// to pass through 0 at tau: *smooth*, R(tau) = 0, one arccos in sigma; or *pinned*, where a front
/// arrives just then: sigma = 0, two phases of A. No iteration, so no root is missed.
/// docs/theory.md, section 21.

#include "harmonic_motion.hpp"

namespace signorini {

/// The motions by ascending impulse; the phase is an answer. One stop is touched, the wall or
/// the second stop. Left out: contacts longer than T - h, where waves rest beside a tip that is
/// held (a set, not a motion). Motions that differ by less than 1e-7 are one. O(nu log nu), and
/// O(nu) for each candidate. \throws as harmonicCase.
[[nodiscard]] std::vector<HarmonicMotion> harmonicContacts(const HarmonicCase& given);
[[nodiscard]] std::vector<HarmonicMotion> harmonicContacts(const Damping& damping,
                                                           const Harmonic& excitation,
                                                           const Stops& stops = {});

}  // namespace signorini
