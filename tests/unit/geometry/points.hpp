#pragma once
/// \file
/// Sums over the amplitudes of points, as plainly as can be.

#include <cmath>
#include <numeric>
#include <vector>

namespace signorini::test {

inline double sumOf(const std::vector<double>& z)
{
    return std::accumulate(z.begin(), z.end(), 0.0);
}

inline double squaresOf(const std::vector<double>& z)
{
    return std::inner_product(z.begin(), z.end(), z.begin(), 0.0);
}

inline double distance(const std::vector<double>& a, const std::vector<double>& b)
{
    double squares = 0.0;
    for (std::size_t j = 0; j < a.size(); ++j) {
        squares += (a[j] - b[j]) * (a[j] - b[j]);
    }
    return std::sqrt(squares);
}

}  // namespace signorini::test
