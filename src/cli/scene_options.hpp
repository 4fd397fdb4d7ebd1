#pragma once
/// \file
/// --scene TEXT|FILE.json: bars in a row (assembly.hpp), with the scales of the common options.

#include <string>
#include <string_view>

#include "arguments.hpp"
#include "scene_answer.hpp"

namespace signorini::cli {

/// The words of a scene, or of a file, with the scales of a bar.
/// \throws std::invalid_argument on words that are no scene, scales beside a file; FileError.
[[nodiscard]] Assembly readAssembly(const std::string& text, const Bar& bar, double gravity);

using answers::assemblyOf;
using answers::barOf;

/// What a file as docs/schema/scene.json holds. `name`: of the file, for messages.
/// \throws std::invalid_argument naming the entry, its value and what is allowed.
[[nodiscard]] Assembly assemblyOfJson(std::string_view text, const std::string& name);

}  // namespace signorini::cli
