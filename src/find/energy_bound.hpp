#pragma once
/// \file
/// Bounds on the energy of all motions of a schedule, proved in rational arithmetic by code that
/// shares nothing with the closed form and the projection that find them.

#include <limits>
#include <optional>

#include "signorini/certificate.hpp"
#include "signorini/schedule.hpp"

namespace signorini {

/// Is every motion's E/E_1 proved to exceed the ratio? By weak duality: for any multipliers y of
/// rows A S >= r (equalities with either sign)
///
///     sum S^2/d  >=  2 y . r - sum d (A^T y)^2,
///
/// where the most S^2/d - 2 c S can fall on S >= 0 is 0 if c < 0. The gap row (31) alone decides
/// one phase; several need their multipliers found first. False if nothing is proved, also where
/// rows or unknowns are more than exact arithmetic can take. O(rows).
[[nodiscard]] bool exceedEnergy(const Schedule& schedule, double energyRatio);

/// Multipliers of the rows of formulate(schedule, Formulation::lumped), those of inequalities >= 0,
/// that add up to r . S <= q < 0. By the inequality of Cauchy and Schwarz then
///
///     sum S^2/d  >=  q^2 / sum d r^2,     positive r on S >= 0 left out,
///
/// and this is the least there is. Empty where there is no motion, without a gap, or where rows or
/// unknowns are more than exact arithmetic can take. O(rows).
[[nodiscard]] std::optional<RationalProof> leastEnergyProof(const Schedule& schedule);

/// Is every motion's E/E_1 proved to stay below the ratio? One phase only: z >= 0 and sum z = S
/// give sum z^2 <= S^2; on the box of a grazing set squares are largest at its corners, which are
/// walked through from class to class. With a strain limit [g/L] also |z| <= limit/2 is known, so
/// that sum z^2 <= S limit/2, on a box d limit^2/4. O(G).
[[nodiscard]] bool stayBelowEnergy(const Schedule& schedule, double energyRatio,
                                   double strainLimit = std::numeric_limits<double>::infinity());

}  // namespace signorini
