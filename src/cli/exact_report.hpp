#pragma once
/// \file
/// A response to an exact harmonic in words and as a table.

#include <string>

#include "exact_answer.hpp"

namespace signorini::cli {

/// Several lines for people, with a final newline.
[[nodiscard]] std::string asText(const answers::ExactAnswer& answer);

/// A row for each contact of each motion, and one for each frequency without any. \throws
/// FileError.
void writeExactCsv(const std::string& path, const answers::ExactAnswer& answer);

}  // namespace signorini::cli
