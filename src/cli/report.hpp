#pragma once
/// \file
/// A PeriodicResult in words and in JSON.

#include <string>

#include "json.hpp"
#include "signorini/find_periodic.hpp"

namespace signorini::cli {

/// Several lines for people, with a final newline.
[[nodiscard]] std::string asText(const PeriodicResult& result);

/// The JSON of the contract.
[[nodiscard]] Json answerOf(const PeriodicResult& result);

/// "physical" of an answer.
[[nodiscard]] Json physicalAsJson(const Physical& physical);

/// The same in lines for people.
[[nodiscard]] std::string asText(const Physical& physical);

/// Said of a range that has no proof.
inline constexpr const char* rangeNote =
    "this end of the range is computed, not checked by other code";

}  // namespace signorini::cli
