#pragma once
/// \file
/// Forced motions with undamped waves as linear programs in the excitation and their amplitudes.

#include <cstdint>
#include <span>

#include "forced_line.hpp"
#include "program.hpp"

namespace signorini {

/// x = (C, S, z_1 ... z_d), or without S for a single shape. Each row is divided by its largest
/// coefficient.
struct ForcedUnknowns {
    bool isPlane = true;
    std::int64_t free = 0;  ///< d

    [[nodiscard]] Eigen::Index places() const { return isPlane ? 2 : 1; }
    [[nodiscard]] Eigen::Index count() const { return places() + free; }
};

/// The rows, |C|, |S| <= far, and nothing to minimise yet. O(entries).
[[nodiscard]] Program forcedProgram(std::span<const ForcedRow> rows, const ForcedUnknowns& unknowns,
                                    double far);

/// With one more unknown, the last, by which all rows may be missed, and which is to be least: 0 if
/// there is a motion. Inequalities alone; the first one of row k is number first[k], of an equality
/// the other one follows. O(entries).
struct MissedProgram {
    Program program;
    std::vector<Eigen::Index> first;
    std::vector<double> sizes;  ///< by which rows were divided
};
[[nodiscard]] MissedProgram leastMissed(std::span<const ForcedRow> rows,
                                        const ForcedUnknowns& unknowns);

}  // namespace signorini
