#pragma once
/// \file
/// Rows of an atlas that programs decide, one schedule after the other: of a bar of several
/// segments, and of bars in a row.

#include <optional>
#include <string>

#include "network.hpp"
#include "signorini/atlas.hpp"

namespace signorini {

/// Has a range no families, so that programs decide it?
[[nodiscard]] bool isOfPrograms(const AtlasRange& range);

/// A row, and why it has no motion, as `AtlasProof` has it.
struct ProgramRow {
    AtlasRow row;
    std::optional<std::string> proof = {};
};

/// Decides schedules of one range.
class ProgramRows {
public:
    /// \pre isOfPrograms(range), which outlives this.
    explicit ProgramRows(const AtlasRange& range);

    /// What `findPeriodic`, or of bars in a row `leastMotion`, says of the least energy.
    /// \throws BackendUnavailable where this build cannot tell.
    [[nodiscard]] ProgramRow decide(std::int64_t number, const Cancel& cancel) const;

private:
    [[nodiscard]] ProgramRow ofSegments(std::int64_t number, const Cancel& cancel) const;
    [[nodiscard]] ProgramRow ofBars(std::int64_t number, const Cancel& cancel) const;

    const AtlasRange& range_;
    std::optional<Network> network_;  ///< of bars in a row
    double energyUnit_ = 1.0;         ///< of their rows [Z_1 delta^2/h]: E_1, or a joule
};

}  // namespace signorini
