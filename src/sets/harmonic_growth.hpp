#pragma once
/// \file
/// By how much a small disturbance of a motion with one contact grows in a period.
///
/// A contact that begins late sends a front that sums to 0 over the next 2L/c; it comes back to the
/// tip after 2, 4, ... L/c and goes on times 1 in contact, -rho in flight, mu at a release that it
/// pins. With pi_i the product over its first i - 1 visits, w and nu as in harmonic_contact.hpp,
/// disturbances of the beginnings of contact grow as lambda^period, where
///
///     1 + sum over s >= 1 of pi_{floor(s nu/w) + 1} lambda^{-s} = 0,
///     mu = (q_- - rho |q_+|)/(q_- + |q_+|), q the push before and after that front.
///
/// This is exact where fronts have faded when they meet their own contact again, after nu visits.
/// Else it depends on which of two fronts at one instant comes first: all orders are tried.
/// docs/theory.md, section 21.

#include <optional>

#include "harmonic_contact.hpp"

namespace signorini {

/// The largest |lambda|: the bar stays near the motion if it is below 1. None where the orders
/// differ by more than 2e-3, or fronts fade too slowly. \pre the motion is one that
/// harmonicContacts found with these arguments. O(visits^2).
[[nodiscard]] std::optional<double> growthOf(const Damping& damping, const Harmonic& excitation,
                                             const HarmonicMotion& motion);

}  // namespace signorini
