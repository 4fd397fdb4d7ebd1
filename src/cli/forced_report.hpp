#pragma once
/// \file
/// The forced motions of a schedule, in words and as JSON.

#include <optional>
#include <string>
#include <vector>

#include "force_report.hpp"
#include "signorini/bar.hpp"
#include "signorini/response.hpp"

namespace signorini {
class SteppedForced;
}

namespace signorini::cli {

/// What is said of a schedule.
struct ForcedAnswer {
    ForcedSet set;
    Scene scene;
    Bar bar;                            ///< whose scales the answer has
    std::optional<double> asked;        ///< [N] or [m]
    std::vector<ForcedMotion> motions;  ///< by ascending impulse
    /// Where the set has motions, but none of the amplitude.
    std::optional<AmplitudeExclusion> exclusion = {};

    /// What an amplitude of 1 is [N] or [m].
    [[nodiscard]] double amplitudeUnit() const
    {
        return cli::amplitudeUnit(set.forcing.place, bar);
    }

    [[nodiscard]] Status status() const
    {
        return !exclusion ? set.status : exclusion->isCertain ? Status::none : Status::undecided;
    }
};

/// The motions of an amplitude [N] or [m], or if none is asked for the one of the least.
[[nodiscard]] ForcedAnswer answerOf(ForcedSet set, const Scene& scene, std::optional<double> asked);

/// The same of a bar of several segments.
[[nodiscard]] ForcedAnswer answerOf(const SteppedForced& forced, const Scene& scene,
                                    std::optional<double> asked);

/// Several lines for people, with a final newline.
[[nodiscard]] std::string asText(const ForcedAnswer& answer);

/// The JSON of the contract, with a final newline.
[[nodiscard]] std::string asJson(const ForcedAnswer& answer);

}  // namespace signorini::cli
