#pragma once
/// \file
/// What multipliers prove about the energy of all motions of a schedule: a march backwards.
///
/// With lambda <- S^T lambda + (rows of the step), from lambda = y at the end of the period back to
/// its start, eta = lambda - y is what `EnergyFloor` says. S does not increase sum Z x^2, so S^T
/// does not increase |lambda|^2 = sum lambda^2/Z: each rounding error keeps its size on the way,
/// and all of them together are bounded by their sum. O(n channels + waves per place listed).

///
/// What drives the network adds (derivatives by it) x (what it is) to eta . x: so multipliers also
/// say what excitations C shape_0 + S shape_1 motions have.

#include <span>
#include <vector>

#include "contact_spans.hpp"
#include "interval.hpp"
#include "signorini/certificate.hpp"

namespace signorini {

/// No motion of the schedule has less energy [Z_1 delta^2/h, sum Z x^2]; rounded downwards. 0 if
/// nothing is proved: steps or contacts that do not exist, an inequality with a multiplier < 0,
/// numbers that are not finite, waves that do not meet, displacements of bars that drift that are
/// left over. Constant forces are part of delta. \throws std::invalid_argument on contacts whose
/// pushes do not follow from the waves.
[[nodiscard]] double provedEnergy(const EnergyFloor& multipliers, const Network& network,
                                  std::span<const ContactSpan> schedule);

/// What multipliers say of all motions: c C + s S + norm sqrt(energy) >= right.
struct ExcitationCut {
    Interval c;
    Interval s;
    double norm = 0.0;   ///< rounded upwards
    double right = 0.0;  ///< rounded downwards
};

/// One for each list of multipliers and the motions of C shape_0 + S shape_1 (or without S), each
/// shape as long as the schedule. Empty if one proves nothing, as for `provedEnergy`.
[[nodiscard]] std::vector<ExcitationCut> cutsOf(std::span<const EnergyFloor> multipliers,
                                                const Network& network,
                                                std::span<const ContactSpan> schedule,
                                                std::span<const StepDrive> shapes);

/// Do the cuts leave no excitation up to an amplitude hypot(C, S), but with more energy?
[[nodiscard]] bool forbidUpTo(std::span<const ExcitationCut> cuts, double amplitude, double energy);

/// Do they leave none of just that amplitude > 0, but with more energy? On the circle each allows
/// an arc; arcs have nothing in common if one is empty, or no end of any of them is in all others.
[[nodiscard]] bool forbidJust(std::span<const ExcitationCut> cuts, double amplitude, double energy);

}  // namespace signorini
