#pragma once
/// \file
/// --scene TEXT|FILE.json: bars in a row (assembly.hpp), with the scales of the common options.

#include <string>
#include <string_view>

#include "arguments.hpp"
#include "json.hpp"
#include "signorini/assembly.hpp"
#include "signorini/simulation.hpp"

namespace signorini::cli {

/// The words of a scene, or of a file, with the scales of a bar.
/// \throws std::invalid_argument on words that are no scene, scales beside a file; FileError.
[[nodiscard]] Assembly readAssembly(const std::string& text, const Bar& bar, double gravity);

/// The bar with stops at its tip that such words are, if they are one: clamped on the left, without
/// weight, springs and masses, its first segment of impedance and speed 1. \pre valid.
[[nodiscard]] std::optional<Scene> barOf(const Assembly& assembly);

/// Today's scenes in the same words. Damping as a dashpot at the tip; the tip is driven, the clamp
/// shaken. \pre a valid scene of so many cells.
[[nodiscard]] Assembly assemblyOf(const Scene& scene, std::int64_t cells, const Damping& damping);

/// As in docs/schema/scene.json.
[[nodiscard]] Json asJson(const Assembly& assembly);

/// What such a file holds. `name`: of the file, for messages.
/// \throws std::invalid_argument naming the entry, its value and what is allowed.
[[nodiscard]] Assembly assemblyOfJson(std::string_view text, const std::string& name);

}  // namespace signorini::cli
