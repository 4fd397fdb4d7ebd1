#pragma once
/// \file
/// A PeriodicResult in words and in JSON.

#include <optional>
#include <string>

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

/// The JSON of the contract, with a final newline.
[[nodiscard]] std::string asJson(const PeriodicResult& result,
                                 const std::optional<TargetReport>& target = {});

}  // namespace signorini::cli
