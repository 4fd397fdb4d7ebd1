#pragma once
/// \file
/// The response of a bar of several segments: all motions with one contact phase of one period.

#include <optional>

#include "signorini/response.hpp"

namespace signorini {

/// Most steps of a period.
inline constexpr std::int64_t maxSteppedResponse = 20'000;

/// \throws std::invalid_argument on what only a uniform bar can be asked: another stop, no gap, two
/// contacts.
void requireStepped(const ResponseRange& range);

/// As responseAt. O(n^2/G + n^2) with G = gcd(2N_1, ..., 2N_s, n), and O(n N) for each motion.
/// \pre a valid range with several segments.
[[nodiscard]] std::optional<FrequencyResponse> steppedResponseAt(const ResponseRange& range,
                                                                 std::int64_t steps,
                                                                 const Cancel& cancel);

}  // namespace signorini
