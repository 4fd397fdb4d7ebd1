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

struct SceneOptions {
    std::string text;  ///< words, or the name of a file; empty: not given
    double gravity = 0.0;

    /// Adds --gravity, and --scene unless the words have a place of their own.
    void addTo(CLI::App& command, bool asOption = true);

    [[nodiscard]] bool isGiven() const { return !text.empty(); }
    /// \throws std::invalid_argument on words that are no scene, or options that clash with them;
    /// FileError.
    [[nodiscard]] Assembly assembly(const CommonOptions& common) const;
};

/// Today's scenes in the same words. Damping as a dashpot at the tip; the tip is driven, the clamp
/// shaken. \pre a valid scene of so many cells.
[[nodiscard]] Assembly assemblyOf(const Scene& scene, std::int64_t cells, const Damping& damping);

/// As in docs/schema/scene.json.
[[nodiscard]] Json asJson(const Assembly& assembly);

/// What such a file holds. `name`: of the file, for messages.
/// \throws std::invalid_argument naming the entry, its value and what is allowed.
[[nodiscard]] Assembly assemblyOfJson(std::string_view text, const std::string& name);

}  // namespace signorini::cli
