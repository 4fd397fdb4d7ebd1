#include "scene_forced.hpp"

#include "stepped_forced.hpp"

namespace signorini {

ForcedSet forcedScene(const Network& network, const std::vector<ContactSpan>& schedule,
                      const Forcing& forcing, double usualEnergy)
{
    ForcedSet set;
    set.forcing = forcing;
    set.waves = std::make_shared<const SteppedForced>(network, schedule, forcing, usualEnergy);
    set.waves->decide(set);
    return set;
}

NetworkClaim claimOf(const ForcedSet& set, const ForcedMotion& motion)
{
    return set.waves->claimOf(motion);
}

}  // namespace signorini
