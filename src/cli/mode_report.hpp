#pragma once
/// \file
/// Modes in words.

#include <string>

#include "modes_answer.hpp"

namespace signorini::cli {

/// factor T - less with its positive term first; the number alone for factor 0.
[[nodiscard]] std::string linearAsText(std::int64_t factor, std::int64_t less);

/// "8 - 3T": the contact time of a mode in L/c.
[[nodiscard]] std::string contactAsText(const Mode& mode);

/// kappa T - mu > 0 with its positive term first.
[[nodiscard]] std::string rootAsText(const Mode& mode);

/// The motion of a mode: several lines for people, with a final newline.
[[nodiscard]] std::string asText(const answers::ModeAnswer& answer);

/// The sign of the gap. \throws std::invalid_argument where there is none: no mode has a stretch of
/// periods then.
[[nodiscard]] int gapSignOfModes(const Bar& bar);

}  // namespace signorini::cli
