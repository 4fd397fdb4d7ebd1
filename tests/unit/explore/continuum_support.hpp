#pragma once
/// \file
/// What the tests of continua share.

#include <cmath>

#include "catch.hpp"
#include "signorini/continuum.hpp"
#include "signorini/verification.hpp"
#include "support.hpp"

namespace signorini::test {

inline const Schedule paper = onePhase(300, 150, 900);

inline void requirePoints(const Continuum& curve, std::size_t count, double accuracy)
{
    INFO(curve.detail);
    REQUIRE(curve.status == Status::found);
    REQUIRE(curve.points.size() == count);
    for (const ContinuumPoint& point : curve.points) {
        CHECK(std::abs(point.energyRatio / curve.energyRatio - 1.0) <= accuracy);
        CHECK(point.residual <= accuracy);
        CHECK(verify(point.state, curve.schedule).residuals.worst() <= accuracy);
        CHECK(point.peakStrain > 0.0);
    }
}

}  // namespace signorini::test
