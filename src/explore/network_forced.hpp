#pragma once
/// \file
/// Forced motions of a schedule of any network, among them a bar of several segments: a harmonic
/// force on its driven nodes, or shaken clamps. What is left of the plane (C, S) is described as
/// for a bar (forced_set.hpp). docs/theory.md, sections 15, 19 and 20.

#include "driven_rows.hpp"
#include "forced_set.hpp"
#include "network_simulation.hpp"
#include "network_walk.hpp"
#include "stepped_bar.hpp"

namespace signorini {

class NetworkForced {
public:
    /// Of a set's schedule, damping, forcing and segments, which are kept. O(N^3 + n N).
    /// \throws std::invalid_argument on segments that are none or have other cells, a shape, more
    /// than maxNetworkSteps steps.
    explicit NetworkForced(const ForcedSet& set);
    /// Of any network, with its forces on driven nodes or its shaken clamps; `usualEnergy`: motions
    /// of `hugeEnergyRatio` times as much are not looked for. \throws std::invalid_argument as
    /// `leastMotion` does, and if nothing is driven.
    NetworkForced(Network network, std::vector<ContactSpan> spans, const Forcing& forcing,
                  double usualEnergy);

    /// What motions there are. O(n) and a proof, or, where nothing damps some waves, a few dozen
    /// linear programs.
    void decide(ForcedSet& set) const;
    /// The motion at (C, S), walked and marched. O(n N). Of a network that is no bar all waves are
    /// in `a` of the state, displacements of nodes in `b`, and the impulse is that of all contacts.
    [[nodiscard]] MotionAt motionAt() const;
    [[nodiscard]] const std::vector<ContactSpan>& schedule() const { return waves_.schedule(); }
    /// Why none has an amplitude.
    [[nodiscard]] AmplitudeExclusion exclusion(const ForcedSet& set, double amplitude) const;
    /// Do the multipliers leave no excitation?
    [[nodiscard]] bool isCertain(std::span<const EnergyFloor> cuts) const;

private:
    /// Adds the rows of a limit on strain that motions would break.
    void limitStrain();
    [[nodiscard]] ForcedLine line() const;
    [[nodiscard]] ForcedCondition named(std::size_t row) const;
    [[nodiscard]] std::vector<ForcedCondition> named(std::span<const std::size_t> rows) const;
    void explainAbsence(ForcedSet& set, const std::vector<std::size_t>& conflict,
                        std::span<const double> start = {}) const;
    /// That a way leads nowhere: way . (C, S) is at most `most`, or, of none, 0. Enters the rows.
    [[nodiscard]] std::optional<EnergyFloor> barrier(Plane way, std::optional<double> most,
                                                     std::vector<std::size_t>& used) const;
    void explainRest(ForcedSet& set) const;
    /// The sides of a polygon, as far as programs prove them. Enters their rows.
    [[nodiscard]] std::vector<EnergyFloor> bordersOf(const std::vector<ForcedCorner>& corners,
                                                     std::vector<std::size_t>& used) const;
    void enterProof(ForcedSet& set, std::span<const std::size_t> conflict,
                    std::vector<EnergyFloor> cuts) const;
    void decidePolytope(ForcedSet& set) const;
    [[nodiscard]] std::vector<EnergyFloor> floorsOf(std::span<const std::size_t> rows) const;

    Schedule schedule_;
    Damping damping_;
    std::optional<SteppedBar> bar_;
    std::vector<Excitation> shapes_;
    DrivenRows waves_;
    bool canRest_;
    bool isLimited_ = true;  ///< no motion that is left breaks a limit on strain
    double mostEnergy_;
};

/// Decides a schedule. Amplitudes are in units of the network, energies of motions at most
/// `hugeEnergyRatio` times `usualEnergy`. Questions about the set (response.hpp) take it:
/// leastAmplitudeMotion, motionsOfAmplitude, exclusionOf, isCertain.
/// \throws std::invalid_argument as `requireKnown` does (network_find.hpp), if nothing is driven,
/// or cycles unless 1 <= K < n/2.
[[nodiscard]] ForcedSet forcedScene(const Network& network,
                                    const std::vector<ContactSpan>& schedule,
                                    const Forcing& forcing, double usualEnergy);

/// A motion whose state has all waves of a network in `a` and displacements of its nodes in `b`, as
/// what is walked.
[[nodiscard]] NetworkClaim claimOf(std::span<const ContactSpan> schedule,
                                   const ForcedMotion& motion);
/// Enters such a state, its residual, the impulse of all contacts and the largest speed with which
/// one closes.
void enterWalk(ForcedMotion& motion, const Network& network, std::span<const ContactSpan> schedule,
               const NetworkStart& state);

/// A motion of a set of `forcedScene` as what is walked.
[[nodiscard]] NetworkClaim claimOf(const ForcedSet& set, const ForcedMotion& motion);

}  // namespace signorini
