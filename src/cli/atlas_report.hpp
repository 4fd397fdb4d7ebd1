#pragma once
/// \file
/// What signorini atlas says: rows, groups, coverage and progress, as text or JSON.

#include <optional>
#include <string>

#include "atlas_answer.hpp"
#include "signorini/atlas_database.hpp"

namespace signorini::cli {

using answers::AtlasAnswer;
using answers::AtlasBuilt;

[[nodiscard]] std::string asText(const AtlasAnswer& answer);
[[nodiscard]] std::string asJson(const AtlasAnswer& answer);
[[nodiscard]] std::string asText(const AtlasBuilt& built);
[[nodiscard]] std::string asJson(const AtlasBuilt& built);

/// The families of all cells, or of those asked for, one row each. \throws FileError.
void writeAtlasCsv(const std::string& path, const AtlasDatabase& atlas,
                   std::optional<std::int64_t> cells, const Bar& bar);

}  // namespace signorini::cli
