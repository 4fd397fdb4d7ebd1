#include "signorini/find_periodic.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "faults.hpp"
#include "network_route.hpp"
#include "routes.hpp"
#include "stepped_bar.hpp"

namespace signorini {

PeriodicResult findPeriodic(const Schedule& schedule, const FindOptions& options)
{
    if (!options.scene.segments.empty() && !asksOfJoints(options)) {
        requireCells(steppedBar(options.scene.segments), schedule.cells);
        FindOptions alike = options;
        alike.scene.segments.clear();
        PeriodicResult result = findPeriodic(schedule, alike);
        result.scene = options.scene;
        result.how.leftOut.emplace_back("joints: between equal segments no wave comes back");
        return result;
    }
    constexpr std::array<Route, 5> routes{refuseRoute, closedFormRoute, sumsRoute, programRoute,
                                          heldEnergyRoute};
    Request request = checked(schedule, options);
    if (asksOfJoints(options)) {
        Claim claim = networkRoute(request);
        return accept(request, std::move(claim));
    }
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

std::vector<Schedule> schedulesOfPeriod(std::int64_t cells, std::int64_t steps, int gapSign)
{
    Faults faults;
    faults.requireWhole("cells", cells, maxCells);
    faults.requireWhole("steps", steps, maxSteps);
    faults.throwIfAny();
    const std::int64_t classes = std::gcd(2 * cells, steps);
    const std::int64_t order = 2 * cells / classes;
    const std::int64_t blocks = steps / classes;
    std::vector<Schedule> sets;
    for (const Family& family : familiesAt(order, blocks, gapSign)) {
        if (family.contactBlocks < family.blocks || classes > 1) {
            sets.push_back(scheduleOf(family, cells));
        }
    }
    // p is antiperiodic after G steps: the period is 2G.
    if (gapSign > 0 && blocks == 2 && classes > 1) {
        sets.push_back({cells, {{1, steps - 1}}});
    }
    return sets;
}

std::string describe(const EnergyExclusion& exclusion)
{
    return fmt::format("E/E_1 = {} is outside the range [{}, {}] of the schedule{}",
                       exclusion.energyRatio, exclusion.range.least, exclusion.range.most,
                       std::isfinite(exclusion.strainLimit) ? " within the strain limit" : "");
}

}  // namespace signorini
