#pragma once
/// \file
/// Forced, damped motions with two contacts in a period: every schedule of n steps.

#include "contact_response.hpp"
#include "signorini/response.hpp"

namespace signorini {

/// [steps]; a flight of one step closes if the tip rests in it: that is a contact.
inline constexpr std::int64_t shortestFlight = 2;

/// How many schedules of n steps have two contacts, one after the other, a rotation being the same:
/// twice at the same one those without a period of n/2 steps, with flights of two steps or more (a
/// flight of one step closes if the tip rests in it, which is a contact), and those with one
/// contact at each of two.
[[nodiscard]] double twoContactSchedules(std::int64_t steps, std::size_t contacts = 1);

/// Adds those motions to a response of a uniform bar. The flight between the contacts closes: a
/// line of the plane (C, S). On one stop it goes through 0, and along it every other row is R >= 0
/// or u(L) <= g times a number, so a schedule is refuted by two signs that differ; between two
/// stops it does not, and rows cut what it has in common with u(L, 0) = g. What is left is decided
/// by forcedMotions. O(n) at most for each schedule. \return false if it was cancelled.
[[nodiscard]] bool addTwoContacts(FrequencyResponse& response, const ResponseRange& range,
                                  const Cancel& cancel);

/// Most schedules with two contacts that a range of a network may hold, of all its n and contacts.
inline constexpr double maxNetworkPairs = 2e7;
/// Most of one n, of those that are decided by programs of their own, one by one; of a range where
/// bars drift.
inline constexpr double maxDecidedPairs = 2000;

/// \throws std::invalid_argument if there are more of them than are allowed.
void requireFewPairs(double schedules, double most);

/// How a schedule of two contacts is decided, in the units of a response.
struct PairQuestion {
    double amplitude = 0.0;  ///< motions of amplitudes within `band` of it, relative, are listed
    double band = 0.0;
    Stops stops = {};  ///< of a bar
    std::function<ForcedSet(const Schedule&)> decide = {};
    /// Is a motion one of n/2 steps, gone through twice?
    std::function<bool(const ForcedMotion&)> isTwice = {};
};

/// Adds what a schedule has, but motions gone through twice and those that rest in contact.
void addPair(FrequencyResponse& response, const Schedule& schedule, const PairQuestion& question);

/// The same of any network, at any two of its contacts or twice at one of them, one closed at a
/// time. Where dashpots damp all waves of the open network a schedule is a point of (C, S), whose
/// pushes and distances are looked at (pair_pushes.hpp); what they do not refute is decided. O(n^2)
/// at most for each schedule, and decisions; where nothing damps some waves, or bars drift, every
/// schedule is decided, and more than maxDecidedPairs are undecided. \return false if it was
/// cancelled. \throws as contactResponses.
[[nodiscard]] bool addTwoContacts(FrequencyResponse& response, const HarmonicNetwork& given,
                                  const PairQuestion& question, const Cancel& cancel);

/// Of a network by itself: motions, of amplitudes within `band` of what is given, and schedules, in
/// its units. None if it was cancelled. \throws as contactResponses.
[[nodiscard]] std::optional<FrequencyResponse> pairResponse(const HarmonicNetwork& given,
                                                            double band, const Cancel& cancel);
/// The question of a bar, of these segments, or of none.
[[nodiscard]] PairQuestion pairsOf(const ResponseRange& range);

}  // namespace signorini
