#pragma once
/// \file
/// signorini find --scene: free motions of a schedule of a network in SI.

#include <string>
#include <vector>

#include "arguments.hpp"
#include "contact_spans.hpp"

namespace signorini::cli {

struct FindCommand;

/// The words of a schedule: NC NF [NC NF ...] where there is one contact, else SET:STEPS ..., SET
/// the numbers of closed contacts joined by +, or - for none.
/// \throws std::invalid_argument naming the word and what is allowed.
[[nodiscard]] std::vector<ContactSpan> parseSpans(const std::vector<std::string>& words,
                                                  std::size_t contacts);

/// Does the work of a call with --scene. Exceptions are for `main` to translate.
[[nodiscard]] ExitStatus findInScene(const FindCommand& command);

}  // namespace signorini::cli
