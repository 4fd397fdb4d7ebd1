#pragma once
/// \file
/// What the parts of sphere_section.hpp share: sums, and the graph over a cap.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <stdexcept>
#include <vector>

#include "sphere_section.hpp"

namespace signorini {

inline double squaresOf(std::span<const double> z)
{
    return std::inner_product(z.begin(), z.end(), z.begin(), 0.0);
}

inline double sumOf(std::span<const double> z)
{
    return std::accumulate(z.begin(), z.end(), 0.0);
}

/// The point of the cap above y, with root = rho - |y|^2 (1 - rho) given.
inline std::vector<double> lifted(std::vector<double> y, std::size_t apex, double rho, double root)
{
    if (y.size() == 1) {
        return {1.0};
    }
    const double t = (1.0 - rho) / (1.0 + std::sqrt(root));
    for (double& value : y) {
        value *= t;
    }
    y[apex] = 1.0 - t;
    return y;
}

inline double rootAt(const std::vector<double>& y, double rho)
{
    return std::max(0.0, rho - squaresOf(y) * (1.0 - rho));
}

inline SphereSection clamped(const SphereSection& section)
{
    if (section.count < 1) {
        throw std::invalid_argument("sphere section: allowed at least one amplitude");
    }
    return {section.count,
            std::clamp(section.ratio, 1.0 / static_cast<double>(section.count), 1.0)};
}

}  // namespace signorini
