#pragma once
/// \file
/// A schedule of a stepped bar, in blocks of steps that may be taken for one.
///
/// The blocks are those of network_blocks.hpp, in the order of the tip's time; of d residues the
/// sum is taken.
///
/// With r^j the wave that arrives at joint j (the tip being the last, p = r^s) in blocks of M_i =
/// 2 N_i/G steps:
///
///     u(L, 0)/g = -(1/N) sum_i sum_{k < M_i} r^i_k,   E/E_1 = (2/N) sum_i Z_i sum_{k < M_i}
///     (r^i_k)^2

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "network_blocks.hpp"
#include "signorini/schedule.hpp"
#include "stepped_bar.hpp"
#include "stops.hpp"

namespace signorini {

/// One type in one stretch of G steps.
struct StepBlock {
    std::size_t type = 0;
    std::int64_t turn = 0;  ///< k in 0..n/G-1
    bool isContact = false;
    bool isFlightEnd = false;  ///< the last of its flight
    double bound = 0.0;        ///< in flight, prefix sum at its end <= bound
    double floor = 0.0;        ///< and >= floor, perhaps -infinity
    double landing = 0.0;      ///< at the end of a flight, = landing
    int push = 1;              ///< in contact, push p >= 0: 1 at the right stop, -1 at the left
};

/// The schedule of a stepped bar.
struct SteppedBlocks {
    SteppedBar bar;
    Schedule schedule;
    std::int64_t unit = 1;             ///< G
    std::int64_t turns = 1;            ///< n/G
    std::vector<std::int64_t> delays;  ///< M_i
    std::vector<ResidueType> types;
    std::vector<StepBlock> blocks;  ///< in order of time
    /// -1 or 1, what the tip makes of a wave: entry type * turns + k.
    std::vector<int> echo;

    /// u(L, 0), where the first contact begins [g].
    [[nodiscard]] double startPlace() const
    {
        return placeOf(schedule.stops, schedule.phases.front().stop).value();
    }
    /// All M_i.
    [[nodiscard]] std::int64_t stateSize() const;
    [[nodiscard]] int echoOf(std::size_t type, std::int64_t turn) const
    {
        return echo[type * static_cast<std::size_t>(turns) + static_cast<std::size_t>(turn)];
    }
};

/// `tipFloor` [g]: the tip may not be lower. O(blocks). \throws std::invalid_argument if the cells
/// of segments and schedule differ.
[[nodiscard]] SteppedBlocks blocksOf(const SteppedBar& bar, const Schedule& schedule,
                                     double tipFloor);

}  // namespace signorini
