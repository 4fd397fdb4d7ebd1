#pragma once
/// \file
/// What the pieces of a motion under a harmonic say, and nothing else of what found it.
///
/// On each piece the push, the way of the tip and the strain at base and tip are one harmonic (and
/// a constant), of which extremes are known. Inside the bar s = B(t + 1 + x) - r(t + 1 - x), B(t) =
/// V(t - 1) - r(t) what has left the tip 2L/c before: the largest s where B is largest and r least
/// on their own no more than 2L/c apart, or at an end.

#include "harmonic_motion.hpp"

namespace signorini {

/// What a harmonic reaches.
struct HarmonicBounds {
    double least;
    double most;
};

/// Re(z e^{i angle}) for from <= angle <= to.
[[nodiscard]] HarmonicBounds boundsOf(std::complex<double> z, double from, double to);

/// Fills in extremes, residual, and of each contact impulse, force and speed; strains only where
/// the residual is one of a motion. \pre phase, pieces, and of each contact begin, end and stop
/// are there. O(pieces log pieces).
void measure(const HarmonicCase& given, HarmonicMotion& motion);

}  // namespace signorini
