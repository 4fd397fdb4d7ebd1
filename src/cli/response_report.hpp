#pragma once
/// \file
/// A response in words, as JSON and as a table.

#include <string>

#include "response_answer.hpp"

namespace signorini::cli {

using answers::ResponseAnswer;

/// Several lines for people, with a final newline: where it rattles, the worst values and where.
[[nodiscard]] std::string asText(const ResponseAnswer& answer);

/// The JSON of the contract, with a final newline.
[[nodiscard]] std::string asJson(const ResponseAnswer& answer);

/// A row for each motion, and one for each frequency without any. \throws FileError.
void writeResponseCsv(const std::string& path, const ResponseAnswer& answer);

}  // namespace signorini::cli
