#pragma once
/// \file
/// Forced, damped motions with two contacts in a period: every schedule of n steps.

#include "signorini/response.hpp"

namespace signorini {

/// How many schedules of n steps have two contacts, a rotation being the same: on one stop those
/// without a period of n/2 steps, with flights of two steps or more (a flight of one step closes if
/// the tip rests in it, which is a contact), and those with one contact on either stop.
[[nodiscard]] double twoContactSchedules(std::int64_t steps, const Stops& stops = {});

/// Adds those motions to a response. The flight between the contacts closes: a line of the plane
/// (C, S). On one stop it goes through 0, and along it every other row is R >= 0 or u(L) <= g times
/// a number, so a schedule is refuted by two signs that differ; between two stops it does not, and
/// rows cut what it has in common with u(L, 0) = g. What is left is decided by forcedMotions.
/// O(n) at most for each schedule. \return false if it was cancelled.
[[nodiscard]] bool addTwoContacts(FrequencyResponse& response, const ResponseRange& range,
                                  const Cancel& cancel);

}  // namespace signorini
