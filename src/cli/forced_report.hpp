#pragma once
/// \file
/// The forced motions of a schedule, in words.

#include <string>

#include "forced_answer.hpp"
#include "harmonic_answer.hpp"

namespace signorini::cli {

/// Several lines for people, with a final newline.
[[nodiscard]] std::string asText(const answers::ForcedAnswer& answer);
[[nodiscard]] std::string asText(const answers::HarmonicAnswer& answer);

}  // namespace signorini::cli
