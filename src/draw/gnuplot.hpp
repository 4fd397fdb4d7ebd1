#pragma once
/// \file
/// Runs gnuplot on a script.

#include <cstdint>
#include <string>
#include <vector>

#include "signorini/figures.hpp"

namespace signorini {

/// Writes `path` by running `script` with a terminal of the given format and size set up before it.
/// Width and height in centimetres. \throws BackendUnavailable, FileError.
void runGnuplot(const std::string& script, FigureFormat format, double width, double height,
                const std::string& path);

/// The same for a moving picture of all that the script plots, 20 frames a second.
void runGnuplot(const std::string& script, AnimationFormat format, const std::string& path);

/// A row, left of all that is drawn, for tables that may have no other: without one gnuplot fails,
/// and it crashes where all labels are undefined.
inline constexpr const char* offThePlot = "-1e9 1 \"\"\n";

/// 0, k, 2k, ... <= last, at most about `most`: an even grid, as an image needs it.
[[nodiscard]] std::vector<std::int64_t> evenly(std::int64_t last, std::int64_t most);

/// What print shows of a motion over one figure: so many nodes and instants, at the most.
inline constexpr std::int64_t maxNodes = 301;
inline constexpr std::int64_t maxInstants = 701;

}  // namespace signorini
