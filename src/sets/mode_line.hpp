#pragma once
/// \file
/// Quantities of a mode are linear in its period.

#include <cmath>
#include <cstdint>

namespace signorini {

/// k T + l, rounded once. \pre |k|, |l| < 2^53.
[[nodiscard]] inline double linear(std::int64_t k, double period, std::int64_t l)
{
    return std::fma(static_cast<double>(k), period, static_cast<double>(l));
}

}  // namespace signorini
