#pragma once
/// \file
/// A sweep in words, as JSON and as a table.

#include <string>

#include "sweep_answer.hpp"

namespace signorini::cli {

using answers::SweepAnswer;

/// Several lines for people, with a final newline: what it settles on where, and the worst values.
[[nodiscard]] std::string asText(const SweepAnswer& answer);

/// A row for each value and direction. \throws FileError.
void writeSweepCsv(const std::string& path, const SweepAnswer& answer);

}  // namespace signorini::cli
