#pragma once
/// \file
/// Numbers as people write them: plain, or with their unit behind ("210GPa", "0.1 mm", "5%").

#include <cstdint>
#include <optional>
#include <string_view>

namespace signorini {

/// A whole number in [low, high]. Empty if the text is anything else.
[[nodiscard]] std::optional<std::int64_t> wholeIn(std::string_view text, std::int64_t low,
                                                  std::int64_t high);

/// A finite number; plain ones are in the given unit ("m", "Pa", "-" ...), and those of a unit that
/// differs from it by a power of ten are converted, as if the decimal point had been moved. Empty
/// if the text is anything else.
[[nodiscard]] std::optional<double> numberIn(std::string_view text, std::string_view unit);

}  // namespace signorini
