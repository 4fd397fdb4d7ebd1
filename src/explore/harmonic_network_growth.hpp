#pragma once
/// \file
/// By how much a small disturbance of a motion of a network under an exact harmonic grows in a
/// period.
///
/// A contact that begins late by a sends a front: for a time a the waves of the open network leave
/// in the place of those of the closed one. With D x the change of the contact's distance by waves
/// x that last so short, and y_s what is left of a front of unit time after s periods of (N), at
/// the beginning of contact,
///
///     sum over s >= 0 of D y_s a(s periods ago) = 0,   y_0 the front itself,
///
/// for the contact begins where the distance is 0. What arrives in step j, where a front ends the
/// contact, meets q_-/(q_- + |q_+|) of the closed network and else the open one, q the push before
/// and after that front. Where fronts of several periods meet an event it depends on which comes
/// first: all orders are tried (sets/harmonic_growth.hpp has one bar with several contacts).
/// docs/theory.md, section 21.

#include <optional>

#include "harmonic_network.hpp"

namespace signorini {

/// The largest growth, that of waves between fronts included: the network stays near the motion if
/// it is below 1. None where the orders differ by more than 2e-3, fronts fade too slowly, or a bar
/// drifts that does not press, or two. Where
/// it is below 1 and waves between fronts fade as slowly it is known to a hundredth only. \pre a
/// motion of this network, whose constant forces are on bars that drift. O(n nodes) for each period
/// in which a front is there, and O(waves).
[[nodiscard]] std::optional<double> growthOf(const HarmonicNetwork& given,
                                             const NetworkHarmonicMotion& motion);

}  // namespace signorini
