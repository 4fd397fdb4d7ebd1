#include "curve_points.hpp"

#include <algorithm>
#include <cmath>

#include "signorini/continuum.hpp"

namespace signorini {

void requireCurve(Faults& faults, std::int64_t points, double resolution, double tolerance)
{
    if (points < 2 || points > maxContinuumPoints) {
        faults.add("points", points, fmt::format("2..{}", maxContinuumPoints));
    }
    if (!(resolution >= 1e-6 && resolution <= 1.0)) {
        faults.add("resolution", resolution, "1e-6..1");
    }
    if (!(tolerance >= 1e-12 && tolerance <= 1e-2)) {
        faults.add("tolerance", tolerance, "1e-12..1e-2");
    }
}

std::size_t nearestTo(double lambda, const std::vector<double>& lambdas)
{
    const auto nearest =
        std::min_element(lambdas.begin(), lambdas.end(), [lambda](double one, double other) {
            return std::abs(one - lambda) < std::abs(other - lambda);
        });
    return static_cast<std::size_t>(nearest - lambdas.begin());
}

void requireWithin(double lambda, const std::vector<double>& lambdas)
{
    if (lambdas.empty() || !(lambda >= lambdas.front() && lambda <= lambdas.back())) {
        throwFault("member", lambda,
                   lambdas.empty()
                       ? "none: the curve has no points"
                       : fmt::format("lambda = {}..{}", lambdas.front(), lambdas.back()));
    }
}

}  // namespace signorini
