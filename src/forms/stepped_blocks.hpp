#pragma once
/// \file
/// A schedule of a stepped bar, in blocks of steps that may be taken for one.
///
/// Let the clock of each joint run ahead of the tip's by the travel time between them. Then what a
/// joint sends to the left arrives in the same step, and what it sends to the right through segment
/// i arrives 2 N_i steps later: steps m and m' have to do with each other only if they differ by a
/// multiple of G = gcd(2 N_1, ..., 2 N_s, n). The residues mod G obey equations of their own, those
/// between two switches of the schedule the same ones. Their mean obeys them, too; its prefix sums
/// run straight between those at the ends of a block, its energy is no larger. So a block of d
/// residues is as good as one of them whose sum is S: what exists, and what has the least energy,
/// is decided on n/G steps for each block. docs/theory.md, section 19.
///
/// With r^j the wave that arrives at joint j (the tip being the last, p = r^s) in blocks of M_i =
/// 2 N_i/G steps:
///
///     u(L, 0)/g = -(1/N) sum_i sum_{k < M_i} r^i_k,   E/E_1 = (2/N) sum_i Z_i sum_{k < M_i}
///     (r^i_k)^2

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "signorini/schedule.hpp"
#include "stepped_bar.hpp"
#include "stops.hpp"

namespace signorini {

/// Residues with the same switches.
struct ResidueType {
    std::int64_t first = 0;  ///< residue
    std::int64_t width = 1;  ///< d
};

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

/// Most steps of one period of a stepped bar, joints times steps being what a program is made of.
inline constexpr std::int64_t maxSteppedSteps = 1'000'000;

/// `tipFloor` [g]: the tip may not be lower. `lumps`: whether blocks of several residues are made;
/// else each residue is a block. O(blocks). \throws std::invalid_argument if the cells of segments
/// and schedule differ, or for too many steps.
[[nodiscard]] SteppedBlocks blocksOf(const SteppedBar& bar, const Schedule& schedule,
                                     double tipFloor, bool lumps);

/// r^j of a motion, as sums over blocks: column type * turns + k, row j.
using ArrivalSums = Eigen::MatrixXd;

/// The state at t = 0. O(n joints).
[[nodiscard]] State stateOf(const SteppedBlocks& blocks, const ArrivalSums& sums);

}  // namespace signorini
