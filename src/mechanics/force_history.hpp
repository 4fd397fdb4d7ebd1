#pragma once
/// \file
/// A force that was measured, or that no formula describes.

#include <cstdint>
#include <span>
#include <vector>

namespace signorini {

/// A point of it; straight between neighbours, 0 before the first and after the last.
struct ForcePoint {
    double time = 0.0;
    double force = 0.0;
};

/// Its mean in each of so many steps from time 0: impulses are exact. O(points + steps).
/// \pre the times increase.
[[nodiscard]] std::vector<double> meanForces(std::span<const ForcePoint> points, double step,
                                             std::int64_t steps);

}  // namespace signorini
