#include "signorini/find_periodic.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "accept.hpp"
#include "routes.hpp"

namespace signorini {

PeriodicResult findPeriodic(const Schedule& schedule, const FindOptions& options)
{
    constexpr std::array<Route, 5> routes{refuseRoute, closedFormRoute, sumsRoute, programRoute,
                                          heldEnergyRoute};
    Request request = checked(schedule, options);
    for (const Route route : routes) {
        if (auto claim = route(request)) {
            return accept(request, std::move(*claim));
        }
    }
    throw std::logic_error("findPeriodic: no route took the request");
}

PeriodicResult findPeriodic(std::int64_t contactSteps, std::int64_t freeSteps, std::int64_t cells,
                            const FindOptions& options)
{
    return findPeriodic(Schedule{cells, {{contactSteps, freeSteps}}}, options);
}

std::string describe(const EnergyExclusion& exclusion)
{
    return fmt::format("E/E_1 = {} is outside the range [{}, {}] of the schedule{}",
                       exclusion.energyRatio, exclusion.range.least, exclusion.range.most,
                       std::isfinite(exclusion.strainLimit) ? " within the strain limit" : "");
}

}  // namespace signorini
