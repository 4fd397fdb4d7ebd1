#pragma once
/// \file
/// Motions that are known without any program, and what they say of a solver's claim.
///
/// A claim of an extreme is refuted by one motion that meets the same demands and is better. So
/// whatever is known of a schedule is held against every claim, whoever makes it.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "request.hpp"

namespace signorini {

/// Least and most energy, and nearest to the target, as far as they are known. O(N).
[[nodiscard]] std::vector<State> knownMotions(const Request& request);

/// Says by which of the known motions a claim is refuted; empty if by none. Least energy and
/// nearest motion are stationary, so rows at the tolerance allow its root there; elsewhere ten
/// times the tolerance. Motions that break the demands by more than the tolerance do not count.
/// O(known (N + n)).
[[nodiscard]] std::optional<std::string> refutation(const Demands& claim, const Schedule& schedule,
                                                    const State& claimed,
                                                    std::span<const State> known, double tolerance);

/// The motion of an energy between those of the least and of another motion of the set, on the
/// straight way between them: the set is convex, and the energy grows along it. Energies outside
/// give the nearer end. O(N).
[[nodiscard]] State motionOfEnergy(const State& least, const State& most, double energyRatio);

}  // namespace signorini
