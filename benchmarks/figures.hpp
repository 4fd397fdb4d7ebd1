#pragma once
/// \file
/// The figures of a report, each from the table alone.

#include <string>
#include <vector>

#include "statistics.hpp"

namespace signorini::bench {

/// A figure that was drawn.
struct Figure {
    std::string file;     ///< inside the folder
    std::string caption;  ///< what is seen
};

/// Draws what the table has data for, as PNG into a folder. \throws BackendUnavailable if gnuplot
/// is missing, FileError.
[[nodiscard]] std::vector<Figure> drawFigures(const Table& table, const std::string& folder);

}  // namespace signorini::bench
