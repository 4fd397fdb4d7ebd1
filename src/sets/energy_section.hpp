#pragma once
/// \file
/// The motions of one schedule and one energy: what is known of them for certain, before and
/// without any solver.
///
/// Let P be the polytope of all motions in class amplitudes z, Q = sum z^2, and q > min Q. The
/// components of { z in P : Q = q } are those of a graph: the vertices of P with Q >= q, two of
/// them joined if Q >= q all along the segment between them. A motion belongs to the vertex that an
/// ascent of Q reaches. docs/theory.md, section 11, has the proof; here it is carried out for
/// simplices, boxes, and the sets of several phases whose vertices are known.

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "signorini/lumped_set.hpp"
#include "signorini/motion.hpp"
#include "signorini/one_phase_set.hpp"
#include "signorini/schedule.hpp"
#include "sphere_section.hpp"

namespace signorini {

/// The facts. An empty optional: not known.
struct SectionFacts {
    EnergyRange range;                       ///< of all motions; `most` may be infinite or NaN
    std::int64_t dimension = -1;             ///< of the motions of this energy; -1: none, not known
    std::optional<bool> isConnected;         ///< can all of them be joined
    std::optional<std::int64_t> components;  ///< also empty if they do not fit in 64 bits
    bool isFinite = false;                   ///< finitely many, see EnergySection::isolated
    /// [g/L] no |p| of a motion of this energy exceeds it.
    double largestWave = std::numeric_limits<double>::infinity();
    /// Set if the motions of this energy are the sphere section of one simplex, or if some of them
    /// (`isWhole` false) are: then in shares z/S.
    std::optional<SphereSection> simplex;
    bool isWhole = true;
    /// The simplex is one of pulses that several types share: for the split pulse alone.
    bool isShared = false;
    double unit = 0.0;  ///< length of a share of 1 in the norm of the energy
};

/// The motions of one energy.
class EnergySection {
public:
    EnergySection() = default;
    EnergySection(const EnergySection&) = delete;
    EnergySection& operator=(const EnergySection&) = delete;
    virtual ~EnergySection() = default;

    [[nodiscard]] const SectionFacts& facts() const { return facts_; }

    /// Do two motions of this energy lie in the same component? Empty: not known.
    [[nodiscard]] virtual std::optional<bool> joins(const State& from, const State& to) const = 0;

    /// Where facts().isFinite: the motions themselves, the first `most` of them.
    [[nodiscard]] virtual std::vector<State> isolated(std::int64_t most) const = 0;

    /// Where facts().simplex: the amplitudes of a state in it, as shares, and back. O(N).
    [[nodiscard]] virtual std::vector<double> sharesOf(const State& state) const = 0;
    [[nodiscard]] virtual State motionOf(const std::vector<double>& shares) const = 0;

    /// Where facts().simplex: the set in shares from which members of this energy are drawn.
    [[nodiscard]] virtual AmplitudeSet sampled() const = 0;

protected:
    SectionFacts facts_;
};

/// The motions of one energy without a gap: a convex cone cut by a sphere.
class ConeSection : public EnergySection {
public:
    /// A member at random. O(N + blocks).
    [[nodiscard]] virtual State draw(std::mt19937_64& generator) const = 0;
};

/// Of any number of contact phases, where there is no gap and no second stop; there facts().simplex
/// are motions that share one impulse. Null if there is one of them, the schedule has no motion, or
/// exact arithmetic cannot reach it.
[[nodiscard]] std::unique_ptr<ConeSection> sectionOfCone(const Schedule& schedule,
                                                         double energyRatio);

/// Of one contact phase, decided in rational numbers. Null if the schedule has no motion.
[[nodiscard]] std::unique_ptr<EnergySection> sectionOfOnePhase(const Schedule& schedule,
                                                               double energyRatio);

/// Of several contact phases or two stops, decided in double precision with a rounding of 1e-13.
/// Null if the schedule has no motion, or exact arithmetic cannot reach it.
[[nodiscard]] std::unique_ptr<EnergySection> sectionOfPhases(const Schedule& schedule,
                                                             double energyRatio);

/// One z per class: the shares of the least sum of a live type that are given, where it carries
/// them, else equal ones.
[[nodiscard]] std::vector<double> sharedOut(const LumpedSet& set, const std::vector<double>& shares,
                                            const std::function<bool(std::size_t live)>& carries);

/// The set that decides several phases, two stops or a cone. Empty if it has no motion, or exact
/// arithmetic cannot reach it.
[[nodiscard]] std::optional<LumpedSet> reachableSet(const Schedule& schedule);

/// The connected components of the motions of one energy, of one contact phase.
struct Connectivity {
    bool isConnected = true;
    std::optional<std::int64_t> components = 1;  ///< empty: more than 2^62
};

/// Of a simplex, point or box with motions, at an energy in the range.
[[nodiscard]] Connectivity connectivityOf(const OnePhaseSet& whole, double energyRatio);

}  // namespace signorini
