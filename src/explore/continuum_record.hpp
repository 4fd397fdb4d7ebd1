#pragma once
/// \file
/// A continuum on its way to an answer: what every way does with the motions it finds.

#include <cstdint>
#include <string>

#include "signorini/continuum.hpp"
#include "signorini/demands.hpp"

namespace signorini {

/// Of two states in the norm of the energy, sqrt(E/E_1).
[[nodiscard]] double energyDistance(const State& first, const State& second);

/// Verifies and keeps motions. Part of one call of traceContinuum, whose options it refers to.
class ContinuumRecord {
public:
    ContinuumRecord(const Schedule& schedule, double energyRatio, const ContinuumOptions& given);

    const ContinuumOptions& options;
    Demands demands;  ///< energy and strain limit, in scaled units
    Continuum result;

    [[nodiscard]] double energy() const { return result.energyRatio; }

    /// Where a path or a walk is to start and a path to end; null if the caller does not say.
    [[nodiscard]] const State* from() const;
    [[nodiscard]] const State* to() const;

    /// [-] at the clamp, in the unit of the bar.
    [[nodiscard]] double peakStrainOf(const State& state) const;

    /// An end that a user gave (not null) must be a motion of this schedule, energy and limit.
    /// \throws std::invalid_argument if it is not.
    void requireMotion(const char* field, const State* state) const;

    /// Verifies a motion and keeps it; false if the trace ends here, undecided.
    bool keep(double lambda, State state);

    /// Keeps a motion of a curve: lambda grows by the distance from the last one.
    bool keepNext(State state);

    /// True, and undecided, if the caller's token says so.
    bool isCancelled();

    void stop(std::string why);

    /// Found: states the resolution of what was kept.
    void finish(std::string detail = {});
};

/// Continuum::orbits of the points of a curve. O(n) per point, memory O(points).
[[nodiscard]] std::int64_t countOrbits(const Continuum& curve);

}  // namespace signorini
