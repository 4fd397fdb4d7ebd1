#include "near_schedule.hpp"

#include <cstdlib>
#include <vector>

#include "signorini/one_phase_set.hpp"

namespace signorini {

std::optional<Schedule> nearSchedule(const Schedule& schedule, int gapSign)
{
    if (schedule.phases.size() != 1 || schedule.phases.front().stop != Stop::right) {
        return std::nullopt;
    }
    const Phase asked = schedule.phases.front();
    std::vector<std::int8_t> signs;
    const auto presses = [&](const Phase& phase) {
        if (phase.contact < 1 || phase.contact > maxSteps || phase.free < 1 ||
            phase.free > maxSteps) {
            return false;
        }
        const Verdict verdict = decide(schedule.cells, phase, signs, gapSign);
        return !verdict.reason && verdict.contact == Contact::pressing;
    };
    for (std::int64_t away = 1; away <= farthestNearSchedule; ++away) {
        std::optional<Phase> best;
        std::int64_t least = 0;
        for (std::int64_t longer = -away; longer <= away; ++longer) {
            const std::int64_t rest = away - std::abs(longer);
            for (const std::int64_t freer : {rest, -rest}) {
                const Phase phase{asked.contact + longer, asked.free + freer};
                const std::int64_t change = std::abs(longer + freer);
                if ((!best || change < least) && presses(phase)) {
                    best = phase;
                    least = change;
                }
            }
        }
        if (best) {
            return Schedule{schedule.cells, {*best}};
        }
    }
    return std::nullopt;
}

}  // namespace signorini
