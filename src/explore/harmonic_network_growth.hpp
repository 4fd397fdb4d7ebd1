#pragma once
/// \file
/// By how much a small disturbance of a motion of a network under an exact harmonic grows in a
/// period.
///
/// A contact that begins late by a sends a front: for a time a the waves of the network without it
/// leave in the place of those of the network with it. With D_k x the change of the distance of
/// contact k by waves x that last so short, and y_j what is left, s periods later, just after the
/// last step of this front before contact k begins, of a front of unit time from beginning j, by
/// (N) with the contacts closed that the motion has,
///
///     sum over j and s >= 0 of D_k y_j a_j(s periods ago) = 0,   y_k of s = 0 the front itself,
///
/// for contact begins where the distance is 0. What arrives just where a front ends a contact meets
/// q_-/(q_- + |q_+|) of the network that has it closed and else the one that has it open, q the
/// push before and after that front. Where fronts of several beginnings or periods meet an event it
/// depends on which comes first: all orders are tried (sets/harmonic_growth.hpp has one bar).
/// docs/theory.md, section 21.

#include <optional>

#include "harmonic_network.hpp"

namespace signorini {

/// The largest growth, that of waves between fronts included: the network stays near the motion if
/// it is below 1. None where the orders differ by more than 2e-3, fronts fade too slowly, or a bar
/// drifts that does not press, or two, or contacts begin at one instant that join each other. Where
/// it is below 1 and waves between fronts fade as slowly it is known to a hundredth only. \pre a
/// motion of this network, whose constant forces are on bars that drift. O(n K nodes)
/// for each period in which a front is there, and O(K^2 waves).
[[nodiscard]] std::optional<double> growthOf(const HarmonicNetwork& given,
                                             const NetworkHarmonicMotion& motion);

}  // namespace signorini
