#pragma once
/// \file
/// A PeriodicResult in words and in JSON.

#include <string>

#include "signorini/find_periodic.hpp"

namespace signorini::cli {

/// Several lines for people, with a final newline.
[[nodiscard]] std::string asText(const PeriodicResult& result);

/// The JSON of the contract, with a final newline.
[[nodiscard]] std::string asJson(const PeriodicResult& result);

}  // namespace signorini::cli
