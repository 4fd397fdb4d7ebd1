#pragma once
/// \file
/// Whether a bar comes back to a motion under an exact harmonic: tried, not computed.

#include <cstdint>
#include <optional>

#include "harmonic_motion.hpp"

namespace signorini {

/// Its waves are changed by a random part of 1e-4 at most, and the bar is marched event by event
/// (harmonic_march.hpp). True: beginnings of contact come to be ten times nearer to those of the
/// motion than they were after the first periods; false: ten times further, or there are other
/// contacts. None: neither in so many periods. O(periods fronts).
[[nodiscard]] std::optional<bool> comesBack(const HarmonicCase& given, const HarmonicMotion& motion,
                                            std::int64_t periods = 150);

}  // namespace signorini
