#pragma once
/// \file
/// The paper's Figs. 2 and 3 for any traced continuum.

#include <string>

#include "signorini/continuum.hpp"
#include "signorini/figure.hpp"

namespace signorini {

/// Draws a curve of motions: strain and velocity at t = 0 along the bar, members stacked upwards by
/// lambda (the paper's Fig. 2), and below the displacement u(x, t) of two members, drawn in black
/// above (its Fig. 3). Long curves are thinned to what print can show.
/// \throws std::invalid_argument if the curve has no points, BackendUnavailable if gnuplot is
/// missing or fails, FileError if `path` cannot be written.
void drawContinuum(const Continuum& curve, FigureFormat format, const std::string& path);

}  // namespace signorini
