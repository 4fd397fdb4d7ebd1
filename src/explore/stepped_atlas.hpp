#pragma once
/// \file
/// Rows of a bar of several segments.

#include <optional>

#include "signorini/atlas.hpp"

namespace signorini {

/// A row, and for one that is refuted its proof.
struct SteppedRow {
    AtlasRow row;
    std::optional<AtlasProof> proof;
};

/// What `findPeriodic` says of the least energy of one schedule; nothing once cancelled.
/// \throws BackendUnavailable where this build cannot tell. \pre the range has segments.
[[nodiscard]] std::optional<SteppedRow> decideStepped(const AtlasRange& range, std::int64_t number,
                                                      const Cancel& cancel);

}  // namespace signorini
