#pragma once
/// \file
/// Runs gnuplot on a script.

#include <string>

#include "signorini/figures.hpp"

namespace signorini {

/// Writes `path` by running `script` with a terminal of the given format and size set up before it.
/// Width and height in centimetres. \throws BackendUnavailable, FileError.
void runGnuplot(const std::string& script, FigureFormat format, double width, double height,
                const std::string& path);

/// The same for a moving picture of all that the script plots, 20 frames a second.
void runGnuplot(const std::string& script, AnimationFormat format, const std::string& path);

}  // namespace signorini
