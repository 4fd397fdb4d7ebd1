#pragma once
/// \file
/// What a database has decided of a question.

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "signorini/atlas_database.hpp"

namespace signorini::cli {

/// Which part of the frequency-energy plane was asked about; all of it unless it says otherwise.
struct AtlasQuestion {
    std::optional<std::int64_t> cells;                                  ///< only this grid
    std::optional<ExactPeriod> period;                                  ///< exactly this
    double lowestFrequency = 0.0;                                       ///< [omega_1]
    double highestFrequency = std::numeric_limits<double>::infinity();  ///< [omega_1]
    double highestEnergy = 0.0;                                         ///< [E_1]
    bool wantsSchedules = false;                                        ///< not families alone
};

/// The runs that bear on a question, and how far they answer it.
class AtlasCoverage {
public:
    AtlasCoverage() = default;
    AtlasCoverage(AtlasQuestion question, const std::vector<AtlasRun>& all);

    /// The runs of the grids asked about.
    [[nodiscard]] const std::vector<AtlasRun>& runs() const { return runs_; }
    /// Has a finished run decided what was asked? Otherwise an empty answer proves nothing.
    [[nodiscard]] bool isDecided() const;
    /// Why an answer may lack something, in one line; empty if every run is finished and kept what
    /// was asked, and one reaches a period that was asked about.
    [[nodiscard]] std::string gaps() const;

private:
    [[nodiscard]] bool reaches(const AtlasRun& run) const;
    [[nodiscard]] bool keptIt(const AtlasRun& run) const;

    AtlasQuestion question_;
    std::vector<AtlasRun> runs_;
    std::string grids_;  ///< "N = 12, 300", all that the database has decided something of
};

/// "N = 300, contact 1..600, ...".
[[nodiscard]] std::string describe(const AtlasRange& range);

}  // namespace signorini::cli
