#pragma once
/// \file
/// How numbers that were seen are spread.

#include <cstdint>
#include <span>
#include <vector>

namespace signorini {

struct Spread {
    std::int64_t count = 0;
    double mean = 0.0;
    double least = 0.0;
    double most = 0.0;
    double total = 0.0;
    /// How many lie in each of equal parts of [0, most], the last one closed. \pre no number < 0.
    std::vector<std::int64_t> histogram = {};
};

/// Of no numbers: zeros, and no histogram. O(values).
[[nodiscard]] Spread spreadOf(std::span<const double> values, std::size_t parts = 12);

}  // namespace signorini
