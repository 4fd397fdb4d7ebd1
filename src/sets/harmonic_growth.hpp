#pragma once
/// \file
/// By how much a small disturbance of a motion under an exact harmonic grows in a period.
///
/// A contact that begins late sends a front that, with those under way, sums to 0 over the next
/// 2L/c; it comes back to the tip after 2, 4, ... L/c and goes on times 1 in contact, -rho in
/// flight, mu at a release that it pins. With pi_i the product over its first i - 1 visits, late
/// beginnings a_k of contact obey
///
///     sum over j and s >= 0 of pi^j_i a_j(s periods ago) = 0,   i = floor((c_k - c_j + sT)/2) + 1,
///     mu = (q_- - rho |q_+|)/(q_- + |q_+|), q the push before and after that front.
///
/// This is exact where fronts have faded when they meet an event a second time. Else it depends on
/// which of two fronts at one instant comes first: all orders are tried. docs/theory.md, section
/// 21.

#include <optional>

#include "harmonic_motion.hpp"

namespace signorini {

/// The largest growth: the bar stays near the motion if it is below 1. None where the orders differ
/// by more than 2e-3, or fronts fade too slowly. \pre the motion is one of this case. O(K^2
/// visits).
[[nodiscard]] std::optional<double> growthOf(const HarmonicCase& given,
                                             const HarmonicMotion& motion);

}  // namespace signorini
