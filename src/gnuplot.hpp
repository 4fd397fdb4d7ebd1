#pragma once
/// \file
/// Runs gnuplot on a script.

#include <string>

#include "signorini/figure.hpp"

namespace signorini {

/// Writes `path` by running `script` with a terminal of the given format and size set up before it.
/// Width and height in centimetres. \throws BackendUnavailable, FileError.
void runGnuplot(const std::string& script, FigureFormat format, double width, double height,
                const std::string& path);

}  // namespace signorini
