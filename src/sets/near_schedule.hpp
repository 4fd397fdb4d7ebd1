#pragma once
/// \file
/// Where the next motions are, for whoever asked beside them.

#include <cstdint>
#include <optional>

#include "signorini/schedule.hpp"

namespace signorini {

/// Steps by which contact and flight of such a schedule may differ, in all.
inline constexpr std::int64_t farthestNearSchedule = 200;

/// Of the schedules with one contact that have motions which press on the wall the one that differs
/// in the fewest steps, and of several that whose period differs least. None: there are none within
/// farthestNearSchedule steps, or `schedule` has not one contact, on the wall. Decides up to 80,000
/// schedules, a few steps each. \pre a valid schedule.
[[nodiscard]] std::optional<Schedule> nearSchedule(const Schedule& schedule, int gapSign);

}  // namespace signorini
