#pragma once
/// \file
/// All motions with one contact in a period of n steps of any network under a harmonic staircase:
/// every contact in turn is the one that closes, for every number of steps. Where dashpots damp all
/// waves of the open network its contacts grow (growing_contact.hpp), else each schedule is a
/// program (network_forced.hpp). docs/theory.md, sections 15, 19 and 20.

#include <optional>
#include <vector>

#include "contact_spans.hpp"
#include "harmonic_network.hpp"
#include "signorini/response.hpp"

namespace signorini {

/// Most steps of a period.
inline constexpr std::int64_t maxStaircaseSteps = 20'000;

/// The schedule in which a contact is closed in so many of n steps, from the first.
[[nodiscard]] std::vector<ContactSpan> spansOf(std::size_t contact, std::int64_t closed,
                                               std::int64_t steps);

/// What one contact has; n_c in place of a schedule.
struct ContactResponse {
    FrequencyResponse found;  ///< peak and amplitudes in units of the network
    /// The contact that never opens, where its sides press on each other at rest; phase 0.
    std::optional<ForcedMotion> permanent;
    double leastPush = 0.0;  ///< of it
    /// Least while all contacts are open, where waves are damped.
    std::optional<double> distance = {};
};

/// By contact, of the amplitude that is given, walked (network_walk.hpp): all waves in `a` of the
/// states, displacements of nodes in `b`, the impulse that of all contacts. O(n^2/G) for each
/// contact, and O(n (cells + n_c/G)) for each motion; schedule by schedule n times as much as
/// forcedScene. None if it was cancelled. Undecided: schedules whose waves the steps in flight fix
/// no better than rounding, residuals that say so, and what forcedScene does not decide.
/// \throws std::invalid_argument as requireAsked (harmonic_network.hpp), of at most
/// maxStaircaseSteps; as forcedScene.
[[nodiscard]] std::optional<std::vector<ContactResponse>> contactResponses(
    const HarmonicNetwork& given, const Cancel& cancel);

/// As responseAt, with one contact: that of the network of the bar. \pre a valid range with several
/// segments.
[[nodiscard]] std::optional<FrequencyResponse> steppedResponseAt(const ResponseRange& range,
                                                                 std::int64_t steps,
                                                                 const Cancel& cancel);

}  // namespace signorini
