#pragma once
/// \file
/// The colours of all figures, after Okabe and Ito: any two of them, and white, stay apart for
/// colour-blind readers (tests/unit/palette_test.cpp). A colour means one thing on every figure,
/// and nothing is told by colour alone.

#include <array>
#include <cstddef>

namespace signorini::palette {

inline constexpr const char* ink = "#000000";       ///< lines one follows: tip, modes
inline constexpr const char* strain = "#0072b2";    ///< s
inline constexpr const char* velocity = "#56b4e9";  ///< v
inline constexpr const char* contact = "#d55e00";   ///< where the wall presses, its force
inline constexpr const char* faint = "#999999";     ///< wall, linear and grazing motions
inline constexpr std::array all{ink, strain, velocity, contact, faint};

inline constexpr const char* grid = "#dddddd";  ///< grid lines, behind everything

/// "viridis": a sequential map, even in lightness.
inline constexpr std::array sequence{"#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c",
                                     "#28ae80", "#5ec962", "#addc30", "#fde725"};

/// How many of them are dark enough for lines and dots on paper.
inline constexpr std::size_t onPaper = 8;

/// From compression through nothing to tension.
inline constexpr std::array diverging{"#b2182b", grid, "#2166ac"};

/// From bold to faint: what matters less and less.
inline constexpr std::array fading{"#440154", "#3b528b", "#21918c",
                                   "#86bdb9", "#b3d5d3", "#dbebea"};

}  // namespace signorini::palette
