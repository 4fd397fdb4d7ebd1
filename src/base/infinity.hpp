#pragma once
/// \file
/// What bounds nothing.

#include <limits>

namespace signorini {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace signorini
