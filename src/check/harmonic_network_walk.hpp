#pragma once
/// \file
/// What the waves of a motion of a network under an exact harmonic say: moved step by step by the
/// law (N), and nothing of what found them.

#include <functional>
#include <span>

#include "harmonic_network.hpp"
#include "network_simulation.hpp"

namespace signorini {

/// A contact of the motion at one time: how far it is open, and the force of it.
struct ContactInstant {
    std::size_t contact;
    double time;
    double distance;
    double push;
};

/// What is told on the way.
struct HarmonicWatch {
    std::vector<ContactInstant>* path = nullptr;  ///< some times in a step, its ends too
    /// At each step and at the end, waves as means over cells; O(M) each.
    std::function<void(std::int64_t step, const NetworkStart& now)> state = {};
    /// What arrives in a part of each step, by channel, and which part [from, to] that is.
    std::function<void(std::span<const SteadyHarmonic> arriving, double from, double to)> arrivals =
        {};
};

/// Fills in impulse, peakForce and speed, of each contact too, and residual. Distances follow from
/// the waves at the start and the places of bars that drift. Within a step push and rate are a
/// constant and a harmonic, whose extremes are known. O(M + n nodes) for each lane.
void measure(const HarmonicNetwork& given, NetworkHarmonicMotion& motion,
             const HarmonicWatch& watch = {});

/// How far each contact is open at t = 0, as above. O(M) for each lane.
[[nodiscard]] std::vector<double> startDistances(const HarmonicNetwork& given,
                                                 NetworkHarmonicMotion motion);

/// Fills in leastStrain and mostStrain, over a shape in which constant forces have displaced the
/// nodes so far. What meets in a cell during a step are all times of two harmonics, so these bounds
/// are reached; at the ends of a row they hold. O(n M). \pre as `measure`.
void measureStrains(const HarmonicNetwork& given, std::span<const double> displaced,
                    NetworkHarmonicMotion& motion);

}  // namespace signorini
