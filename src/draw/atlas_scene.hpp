#pragma once
/// \file
/// What figures of an atlas say of its scene.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "atlas_answer.hpp"
#include "signorini/atlas_database.hpp"

namespace signorini {

/// Words of segments or of bars in a row, and N; nothing of a uniform bar.
[[nodiscard]] std::string captionOf(const std::vector<AtlasRun>& runs,
                                    std::optional<std::int64_t> cells);

/// Of bars in a row their own, else those of `bar`.
[[nodiscard]] answers::AtlasUnits unitsOf(const std::vector<AtlasRun>& runs, const Bar& bar);

}  // namespace signorini
