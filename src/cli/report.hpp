#pragma once
/// \file
/// A PeriodicResult in words and in JSON.

#include <optional>
#include <string>

#include "json.hpp"
#include "signorini/find_periodic.hpp"

namespace signorini::cli {

/// What a motion was to be near, and how it was read.
struct TargetReport {
    const State& state;
    const std::string& how;

    /// [-], of a state, in the norm of the energy, relative to the target's.
    [[nodiscard]] double distanceTo(const State& other) const;
};

/// Several lines for people, with a final newline.
[[nodiscard]] std::string asText(const PeriodicResult& result,
                                 const std::optional<TargetReport>& target = {});

/// The JSON of the contract but for "certificate", which is null: see certificate_report.hpp.
[[nodiscard]] Json answerWithoutProof(const PeriodicResult& result,
                                      const std::optional<TargetReport>& target = {});

/// All of it in one object, for proofs of modest size.
[[nodiscard]] Json answerOf(const PeriodicResult& result,
                            const std::optional<TargetReport>& target = {});

/// "physical" of an answer.
[[nodiscard]] Json physicalAsJson(const Physical& physical);

/// The same in lines for people.
[[nodiscard]] std::string asText(const Physical& physical);

/// "7/2" or "4".
[[nodiscard]] std::string fractionAsText(const ExactPeriod& fraction);

/// Said of a range that has no proof.
inline constexpr const char* rangeNote =
    "this end of the range is computed, not checked by other code";

}  // namespace signorini::cli
