#pragma once
/// \file
/// What the tests of several contact phases share.

#include <random>
#include <string_view>

#include "has_solver.hpp"
#include "signorini/lumped_set.hpp"
#include "support.hpp"

namespace signorini::test {

/// Flights near 3N and very short ones in turn: sums that vary, phases that only touch, and
/// repeated motions are frequent here.
inline Schedule nearMultiples(std::mt19937_64& generator, std::int64_t maxCells, int maxPhases)
{
    const auto draw = [&generator](std::int64_t low, std::int64_t high) {
        return std::uniform_int_distribution<std::int64_t>(low, high)(generator);
    };
    Schedule schedule{draw(3, maxCells), {}};
    const std::int64_t count = draw(2, maxPhases);
    for (std::int64_t k = 0; k < count; ++k) {
        const std::int64_t contact = draw(1, std::max<std::int64_t>(1, schedule.cells / 3));
        const std::int64_t turns = draw(0, 3) == 0 ? 4 : 3;
        schedule.phases.push_back(
            {contact, draw(0, 2) == 0 ? draw(1, 4) : turns * schedule.cells + draw(-2, 3)});
    }
    return schedule;
}

/// One with motions, from either generator in turn.
inline Schedule feasibleSchedule(std::mt19937_64& generator, std::int64_t maxCells, int turn)
{
    while (true) {
        Schedule schedule = turn % 2 == 0 ? test::randomSchedule(generator, maxCells, 4)
                                          : nearMultiples(generator, maxCells, 4);
        if (!lumpedSet(schedule).absence) {
            return schedule;
        }
    }
}

}  // namespace signorini::test
