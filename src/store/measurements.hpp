#pragma once
/// \file
/// Fields measured at some places of the bar, brought onto the cells.

#include <cstdint>
#include <string>
#include <vector>

#include "signorini/motion.hpp"

namespace signorini {

/// What was measured along the bar, in scaled units.
struct Measurements {
    std::vector<double> x;         ///< [L], ascending in [0, 1], two places or more
    std::vector<double> velocity;  ///< [c g/L]
    std::vector<double> other;     ///< strain [g/L], or displacement [g]
    bool isDisplacement = false;   ///< which of them
};

/// Do the rows stand at x_i = i dx of these cells, as our own files have them?
[[nodiscard]] bool isOnCells(const Measurements& measured, std::int64_t cells);

/// The state whose velocity and strain on each cell are the means of those measured, joined by
/// straight lines: constant beyond the ends, but for u, which starts from 0 at the clamp and goes
/// on straight at the tip. Rows on the cells are the values there. O(N + rows).
[[nodiscard]] State onCells(const Measurements& measured, std::int64_t cells);

}  // namespace signorini
