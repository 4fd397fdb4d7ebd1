#pragma once
/// \file
/// The forced motions of a schedule, in words.

#include <string>

#include "forced_answer.hpp"

namespace signorini::cli {

/// Several lines for people, with a final newline.
[[nodiscard]] std::string asText(const answers::ForcedAnswer& answer);

}  // namespace signorini::cli
