#pragma once
/// \file
/// What curves of motions share, whatever their motions are: options in range, and lambdas.

#include <cstdint>
#include <vector>

#include "faults.hpp"

namespace signorini {

/// Adds what is out of range, as of ContinuumOptions.
void requireCurve(Faults& faults, std::int64_t points, double resolution, double tolerance);

/// Of all points, ascending.
[[nodiscard]] std::vector<double> lambdasOf(const auto& points)
{
    std::vector<double> all;
    all.reserve(points.size());
    for (const auto& point : points) {
        all.push_back(point.lambda);
    }
    return all;
}

/// Which of them is nearest to a lambda. \pre there are some.
[[nodiscard]] std::size_t nearestTo(double lambda, const std::vector<double>& lambdas);

/// \throws std::invalid_argument unless they hold one in their range.
void requireWithin(double lambda, const std::vector<double>& lambdas);

}  // namespace signorini
