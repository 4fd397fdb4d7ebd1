#pragma once
/// \file
/// From the text of a question to a reply. The one entry of the library for the page.

#include <string>

#include "request.hpp"

namespace signorini::web {

/// Never throws on what is asked: a fault is {"error": one line}.
[[nodiscard]] Reply answer(const std::string& question);

}  // namespace signorini::web
