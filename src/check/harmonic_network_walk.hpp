#pragma once
/// \file
/// What the waves of a motion of a network under an exact harmonic say: moved step by step by the
/// law (N), and nothing of what found them.

#include "harmonic_network.hpp"

namespace signorini {

/// The contact that closes at one time: how far it is open, and the force of it.
struct ContactInstant {
    double time;
    double distance;
    double push;
};

/// Fills in impulse, peakForce, speed and residual. Distances follow from the waves at the start;
/// within a step push and rate are a harmonic, whose extremes are known. O(M + n nodes). `path`
/// hears of the contact, some times in a step and at the end. \pre no constant forces, no bar that
/// drifts.
void measure(const HarmonicNetwork& given, NetworkHarmonicMotion& motion,
             std::vector<ContactInstant>* path = nullptr);

}  // namespace signorini
