#pragma once
/// \file
/// Free motions of a schedule of bars that may drift, stand under forces, or be held
/// (network_motions.hpp): which questions have an answer, and that of least energy.

#include "network_motions.hpp"
#include "signorini/find_periodic.hpp"

namespace signorini {

/// Largest residual of a motion.
inline constexpr double networkTolerance = 1e-9;

/// E_1 [Z_1 delta^2/h]; none where a bar drifts, or the gap is 0.
[[nodiscard]] std::optional<double> firstEnergy(const Network& network);

/// The energy to be held [Z_1 delta^2/h], of joules or of a multiple of E_1, if either is given.
/// \throws std::invalid_argument on a multiple where there is no E_1.
[[nodiscard]] std::optional<double> heldEnergy(const Network& network,
                                               const std::optional<double>& joules,
                                               const std::optional<double>& energyRatio);

/// E_1, or else what bars have that move by the gaps in a step, or under constant forces in a
/// period: motions of `hugeEnergyRatio` times as much are not looked for [Z_1 delta^2/h].
[[nodiscard]] double usualEnergy(const Network& network, const std::vector<ContactSpan>& schedule);

/// \throws std::invalid_argument as `leastMotion` does.
void requireKnown(const Network& network, const std::vector<ContactSpan>& schedule);

/// None: no motion has less than `largest` [Z_1 delta^2/h]. Found: the multipliers say that none
/// has less than `provedEnergy`.
/// \throws std::invalid_argument on an invalid network or schedule, one whose first step closes no
/// contact that was open before, one that does not tie a bar that drifts to what is held, or where
/// held bars at rest are a motion. Bars that drift may rest where they touch: a motion without
/// energy.
[[nodiscard]] LeastMotion leastMotion(const Network& network,
                                      const std::vector<ContactSpan>& schedule, double largest,
                                      const Cancel& cancel = {});

/// Which motion of a schedule, but for that of least energy.
struct NetworkWish {
    Objective objective = Objective::automatic;
    std::optional<double> energy = {};               ///< held [Z_1 delta^2/h]
    std::optional<std::vector<double>> target = {};  ///< to come nearest to, as waves

    [[nodiscard]] bool isOfLeast() const
    {
        return !energy && !target && objective != Objective::maxEnergy &&
               objective != Objective::maxImpulse && objective != Objective::minPeakStrain;
    }
};

/// The motion of a wish; of maxEnergy the most that is found, not proved the most. None, too: what
/// is proved of all motions excludes the energy held. What is proved stays that of least energy.
/// `options`: tolerance, back end and limits. \throws as `leastMotion`; std::invalid_argument on an
/// energy that is held along with an objective.
[[nodiscard]] LeastMotion wishedMotion(const Network& network,
                                       const std::vector<ContactSpan>& schedule, double largest,
                                       const NetworkWish& wish, const FindOptions& options);

/// Is there no pressing motion, as one would press a bar that drifts one way and nothing the other?
/// Its place is the same a period later, so on average pushes and forces balance; dashpots do by
/// themselves. O(contacts).
[[nodiscard]] bool pushesBalance(const Network& network, const std::vector<ContactSpan>& schedule);

}  // namespace signorini
