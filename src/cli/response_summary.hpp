#pragma once
/// \file
/// What motions over a range of frequencies come to, in words: where bars rattle, and what is
/// worst.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "text.hpp"

namespace signorini::cli {

struct SummedMotion {
    bool isImpact = true;  ///< else contact never opens: strains alone count
    double force = 0.0;    ///< [N]
    double impulse = 0.0;  ///< [N s], in a period
    double speed = 0.0;    ///< [m/s], before a contact
    double strain = 0.0;
    std::optional<double> stress = {};  ///< [Pa]
    std::string called = {};            ///< behind its frequency
};

struct SummedFrequency {
    double hertz = 0.0;
    std::optional<double> ratio = {};
    bool isKnown = true;         ///< what the linear response does
    bool mustRattle = false;     ///< it would have bars overlap, and no contact is closed for good
    std::int64_t undecided = 0;  ///< schedules, or 1 if anything is
    std::string reason = {};     ///< of that
    std::vector<SummedMotion> motions = {};
};

/// By ascending frequency.
struct ResponseSummary {
    std::vector<SummedFrequency> frequencies;
    bool isComplete;                    ///< false: interrupted
    const char* which;                  ///< no motion: "with one contact"
    const char* because;                ///< without contacts: "the linear response meets a stop"
    const char* hint;                   ///< what else may be asked where no motion is listed
    bool countsSchedules;               ///< that are undecided
    std::optional<double> yieldStress;  ///< [Pa]

    /// "400 … 410 Hz (0.95 … 0.98 ω₁), 530 Hz (1.26 ω₁) and 2 more"; empty: nowhere.
    [[nodiscard]] std::string where(const std::function<bool(const SummedFrequency&)>& holds) const;
    /// Lines: where they can and must rattle. `otherwise`: why nowhere.
    void addRattles(Text& text, const char* otherwise) const;
    /// Lines: frequencies where the list may not be all there is.
    void addGaps(Text& text) const;
    /// Lines: the largest force, impulse, speed and strain, and stress where it is known.
    void addWorst(Text& text) const;
};

}  // namespace signorini::cli
