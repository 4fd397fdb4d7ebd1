#pragma once
/// \file
/// Segments as text, for databases and other processes: "150:1:1:0,150:1.3:1:0", that is cells,
/// impedance, speed and dashpot of each. All numbers come back exactly.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "signorini/bar.hpp"

namespace signorini {

/// Empty for a uniform bar without segments.
[[nodiscard]] std::string textOf(std::span<const Segment> segments);

/// \throws std::invalid_argument unless `textOf` may have written it.
[[nodiscard]] std::vector<Segment> segmentsOf(std::string_view text);

}  // namespace signorini
