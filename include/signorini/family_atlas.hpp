#pragma once
/// \file
/// The atlas of one contact phase by what exists: every schedule of a range that has motions, in
/// time that grows with their number and not with the size of the range.
///
/// The schedules that press are the tents of the grid's families (families.hpp). Those that graze
/// are known at once: n has more factors 2 than 2N, and n_c < G = gcd(2N, n); then d = G - n_c.
/// docs/theory.md, section 14.

#include <cstdint>
#include <functional>

#include "signorini/atlas.hpp"
#include "signorini/control.hpp"
#include "signorini/reduction.hpp"
#include "signorini/schedule.hpp"

namespace signorini {

/// Asked for each schedule that has motions; false ends the search.
using ScheduleVisitor = std::function<bool(const Phase&, const Verdict&)>;

/// Visits the schedules of a range that have motions, by ascending n and then n_c, each with
/// the verdict of `decide`, number by number; those with a least energy above
/// `range.maxEnergyRatio` are left out. O(log N) for each n < 4N and O(1) for each schedule
/// visited, no memory: 0.1 ms at N = 300 (18,012 schedules with n_f <= 8N).
/// \returns false if the visitor or `cancel` ended it.
/// \throws std::invalid_argument on an invalid range, or one of several phases.
bool forEachSchedule(const AtlasRange& range, const ScheduleVisitor& visitor,
                     const Cancel& cancel = {});

/// The steps after which the motions of a schedule repeat: n if they press (no member repeats
/// sooner), 2G if they graze, as p is then antiperiodic after G steps whatever n is (single members
/// with p antiperiodic after G/3, G/5, ... repeat sooner). O(1).
/// \throws std::invalid_argument if the set is empty.
[[nodiscard]] std::int64_t ownSteps(const Phase& phase, const Verdict& verdict);

}  // namespace signorini
