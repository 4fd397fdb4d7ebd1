#include "spread.hpp"

#include <algorithm>

#include "compensated_sum.hpp"

namespace signorini {

Spread spreadOf(std::span<const double> values, std::size_t parts)
{
    Spread spread{.count = static_cast<std::int64_t>(values.size())};
    if (values.empty()) {
        return spread;
    }
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    spread.least = *least;
    spread.most = *most;
    double lost = 0.0;
    for (const double value : values) {
        addCompensated(spread.total, lost, value);
    }
    spread.total += lost;
    spread.mean = spread.total / static_cast<double>(values.size());
    spread.histogram.assign(parts, 0);
    for (const double value : values) {
        const double part = *most > 0.0 ? value / *most * static_cast<double>(parts) : 0.0;
        ++spread.histogram[std::min(static_cast<std::size_t>(part), parts - 1)];
    }
    return spread;
}

}  // namespace signorini
