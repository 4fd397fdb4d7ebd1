#pragma once
/// \file
/// What `find` says of a schedule or of a period, in words.

#include <string>

#include "question_answer.hpp"

namespace signorini::cli {

/// Several lines for people, with a final newline; if verbose, also the route that found it.
[[nodiscard]] std::string asText(const answers::FindAnswer& answer, bool isVerbose);
[[nodiscard]] std::string asText(const answers::QuestionAnswer& answer, bool isVerbose);

/// The same in lines for people.
[[nodiscard]] std::string asText(const Physical& physical);

/// "7/2" or "4".
[[nodiscard]] std::string fractionAsText(const ExactPeriod& fraction);

}  // namespace signorini::cli
