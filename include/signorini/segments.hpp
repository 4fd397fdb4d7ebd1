#pragma once
/// \file
/// Strain and energy of states of a bar of several segments (bar.hpp), in scaled units.
///
/// With Z_i and c_i the impedances and speeds of the segments, EA s = Z_i (b - a) and the energy of
/// a cell is Z_i (a^2 + b^2) dt; velocity and displacement are those of a uniform bar, as all cells
/// take equal times. Energies are in E_1, that of a bar of the first material with the same travel
/// time. docs/theory.md, section 19.

#include <Eigen/Core>
#include <span>

#include "signorini/bar.hpp"
#include "signorini/motion.hpp"

namespace signorini {

/// s on each cell, (b - a)/(c_i/c_1) [g/L]; no segments: of a uniform bar. O(N).
/// \throws std::invalid_argument unless segments and state have as many cells.
[[nodiscard]] Eigen::VectorXd strain(const State& state, std::span<const Segment> segments);

/// E/E_1 = (2/N) sum (Z_i/Z_1)(a_i^2 + b_i^2); no segments: of a uniform bar. O(N).
/// \throws std::invalid_argument unless segments and state have as many cells.
[[nodiscard]] double energyRatio(const State& state, std::span<const Segment> segments);

}  // namespace signorini
