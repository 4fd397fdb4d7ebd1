#pragma once
/// \file
/// Whether the bar stays near a motion, in words and as JSON.

#include <string>

#include "json.hpp"
#include "signorini/response.hpp"

namespace signorini::cli {

/// What came of it, and what was tried.
struct StabilityReport {
    Damping damping;
    StabilityOptions options;
    StabilityResult result;
};

/// One line for people, with a final newline.
[[nodiscard]] std::string asText(const StabilityReport& report, const Bar& bar);

/// {"damping", "verdict", "periods", "drift", "contacts", "trials": [{"size", "start", "end"}]}.
[[nodiscard]] Json asJson(const StabilityReport& report, const Bar& bar);

}  // namespace signorini::cli
