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

/// Is every motion's E/E_1 proved to stay below the ratio? Squares are largest at a vertex of the
/// sums, with a pressing sum in one class, or, with a strain limit [g/L], in as many of |z| =
/// limit/2 as it fills; a box is walked through from class to class. Where sums vary a limit is
/// used as sum z^2 <= limit/2 sum |z|, d limit^2/4 on a box. False as above, and where boxes vary
/// or are walked in more than 3e5 places. O(rows + G places).
[[nodiscard]] bool stayBelowEnergy(const Schedule& schedule, double energyRatio,
                                   double strainLimit = std::numeric_limits<double>::infinity());

}  // namespace signorini
