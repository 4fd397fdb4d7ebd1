#pragma once
/// \file
/// A bar as a drawing has it, piece after piece in SI units, on cells that a wave crosses in one
/// time each.
///
/// Piece i of length l_i, Young's modulus E_i, density rho_i and cross-section A_i has waves of
/// speed c_i = sqrt(E_i/rho_i), impedance Z_i = E_i A_i/c_i and travel time t_i = l_i/c_i. Motions
/// hang on impedances and travel times alone. With n_i cells and the step h = (sum t_i)/(sum n_i)
/// it becomes n_i c_i h long: speeds, impedances and the time through all pieces are kept,
/// lengths are rounded.

#include <cstdint>
#include <span>

#include "signorini/bar.hpp"

namespace signorini {

/// One piece.
struct BarPiece {
    double length = 0.0;   ///< [m], > 0
    double young = 0.0;    ///< [Pa], > 0
    double density = 0.0;  ///< [kg/m^3], > 0
    double area = 0.0;     ///< [m^2], > 0
};

/// What a grid makes of them.
struct PiecedBar {
    Scene scene;             ///< of one piece: uniform; its modulus where all pieces have one
    std::int64_t cells = 0;  ///< N, of all pieces
    double rounding = 0.0;   ///< [-], largest |n_i c_i h/l_i - 1|
};

/// Most cells among which a grid is sought.
inline constexpr std::int64_t mostPieceCells = 1'000'000;

/// For sum n_i up to `mostCells` each n_i is t_i/h rounded, 1 at least; of these grids the one that
/// rounds least is taken, and of several that round alike the finest. Clamp first; a stop at
/// u(L) = gap.
/// O(mostCells pieces).
/// \throws std::invalid_argument naming piece, value and range.
[[nodiscard]] PiecedBar barOfPieces(std::span<const BarPiece> pieces, double gap = Bar{}.gap,
                                    std::int64_t mostCells = 300);

}  // namespace signorini
