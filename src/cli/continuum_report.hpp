#pragma once
/// \file
/// A curve of motions in words and as JSON.

#include <optional>
#include <string>

#include "signorini/continuum.hpp"

namespace signorini::cli {

/// Several lines for people, with a final newline.
[[nodiscard]] std::string asText(const Continuum& curve, const std::optional<Member>& member);

/// The JSON of the contract, with a final newline.
[[nodiscard]] std::string asJson(const Continuum& curve, const std::optional<Member>& member);

}  // namespace signorini::cli
