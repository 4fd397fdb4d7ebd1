#include "force_history.hpp"

#include <algorithm>

namespace signorini {

std::vector<double> meanForces(std::span<const ForcePoint> points, double step, std::int64_t steps)
{
    std::vector<double> means(static_cast<std::size_t>(steps), 0.0);
    std::size_t at = 0;  // of the point before
    for (std::int64_t m = 0; m < steps; ++m) {
        const double begin = static_cast<double>(m) * step;
        const double end = static_cast<double>(m + 1) * step;
        double impulse = 0.0;
        while (at + 1 < points.size()) {
            const ForcePoint& left = points[at];
            const ForcePoint& right = points[at + 1];
            const double from = std::max(begin, left.time);
            const double to = std::min(end, right.time);
            if (to > from) {
                const double slope = (right.force - left.force) / (right.time - left.time);
                impulse += (left.force + slope * (0.5 * (from + to) - left.time)) * (to - from);
            }
            if (right.time > end) {
                break;
            }
            ++at;
        }
        means[static_cast<std::size_t>(m)] = impulse / step;
    }
    return means;
}

}  // namespace signorini
