#pragma once
/// \file
/// Figures, drawn by gnuplot at run time.

#include <string>

#include "signorini/find_periodic.hpp"

namespace signorini {

/// What a figure file holds.
enum class FigureFormat { svg, png, pdf };

/// By the ending of the name: .svg, .png or .pdf.
/// \throws std::invalid_argument for any other ending.
[[nodiscard]] FigureFormat figureFormat(const std::string& path);

/// Draws a found motion as in the paper's Fig. 3: the initial strain and velocity along the bar,
/// the displacement u(x, t) over one period, and the path of the tip beside the wall with the
/// contact phases marked. Long motions are thinned to what print can show. \throws
/// std::invalid_argument if the result holds no motion, BackendUnavailable if gnuplot is missing or
/// fails, FileError if `path` cannot be written.
void drawMotion(const PeriodicResult& result, FigureFormat format, const std::string& path);

}  // namespace signorini
