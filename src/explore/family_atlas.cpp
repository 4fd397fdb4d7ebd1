#include "signorini/atlas.hpp"

#include <stdexcept>

#include "faults.hpp"
#include "tents.hpp"

namespace signorini {

bool forEachSchedule(const AtlasRange& range, const ScheduleVisitor& visitor, const Cancel& cancel)
{
    validate(range);
    if (range.maxPhases != 1) {
        throwFault("phases", range.maxPhases, "1 (families have one contact phase)");
    }
    const Tents tents(range);
    const std::int64_t last = range.maxContact + range.maxFree;
    for (std::int64_t n = 2; n <= last; n = tents.candidate(n + 1)) {
        const auto visitTent = [&](Tent& tent) {
            for (std::int64_t contact = tent.firstKept; contact <= tent.lastKept; ++contact) {
                if (!visitor({contact, n - contact}, tent.at(contact))) {
                    return false;
                }
            }
            return true;
        };
        if (isRequested(cancel) || !tents.forEach(n, visitTent)) {
            return false;
        }
    }
    return true;
}

std::int64_t ownSteps(const Phase& phase, const Verdict& verdict)
{
    if (verdict.reason) {
        throw std::invalid_argument("verdict: the schedule has no motion");
    }
    if (verdict.contact == Contact::grazing) {
        return 2 * verdict.classes;
    }
    const bool isHeld = verdict.contactMembers == verdict.members;
    return isHeld ? verdict.classes : phase.contact + phase.free;
}

}  // namespace signorini
