#pragma once
/// \file
/// What the figures of a response show, as tables.

#include <string>

#include "response_report.hpp"

namespace signorini::cli {

/// A row for each interval of amplitudes with a motion: without contact, with one, with two.
/// \throws FileError.
void writeResponseMapCsv(const std::string& path, const ResponseAnswer& answer);

/// A row for each point of the curves of the modes. \throws FileError.
void writeBackboneCsv(const std::string& path, const ResponseAnswer& answer);

}  // namespace signorini::cli
