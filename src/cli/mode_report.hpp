#pragma once
/// \file
/// Modes in words and in JSON.

#include <string>

#include "json.hpp"
#include "signorini/modes.hpp"

namespace signorini::cli {

/// factor T - less with its positive term first; the number alone for factor 0.
[[nodiscard]] std::string linearAsText(std::int64_t factor, std::int64_t less);

/// [p, q].
[[nodiscard]] Json fractionAsJson(const ExactPeriod& number);

/// "8 - 3T": the contact time of a mode in L/c.
[[nodiscard]] std::string contactAsText(const Mode& mode);

/// kappa T - mu > 0 with its positive term first.
[[nodiscard]] std::string rootAsText(const Mode& mode);

/// contact, period_range, inverse_sqrt_energy, and family, null if it has no name.
[[nodiscard]] Json identityAsJson(const Mode& mode);

/// The motion of a mode: several lines for people, with a final newline.
[[nodiscard]] std::string asText(const Mode& mode, const ModeMotion& motion, const Bar& bar);

/// The sign of the gap. \throws std::invalid_argument where there is none: no mode has a stretch of
/// periods then.
[[nodiscard]] int gapSignOfModes(const Bar& bar);

/// The JSON of the contract, with a final newline.
[[nodiscard]] std::string asJson(const Mode& mode, const ModeMotion& motion, const Bar& bar);

}  // namespace signorini::cli
