#pragma once
/// \file
/// A scene in words.

#include <string>

#include "json.hpp"
#include "network.hpp"
#include "scene_answer.hpp"

namespace signorini::cli {

using answers::contactsOf;

/// The line that restates the bars.
[[nodiscard]] std::string headline(const Assembly& assembly, const Network& network);

}  // namespace signorini::cli
