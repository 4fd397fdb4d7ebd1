#pragma once
/// \file
/// Multipliers of periodicity that go with those of a schedule's conditions.
///
/// A march backwards adds up the conditions to f, and |f + (W - 1)^T y| in the norm sum v^2/Z is
/// least for the y wanted (certificate.hpp, `EnergyFloor`). W is never written down: LSQR (Paige
/// and Saunders, 1982), its vectors kept orthogonal, takes a march forwards and one backwards a
/// step, and as many steps as W - 1 has different singular values, however many waves there are.

#include <span>

#include "network_kernel.hpp"
#include "signorini/certificate.hpp"
#include "signorini/control.hpp"

namespace signorini {

/// Enters `periodicity`, or adds to what is there, where places and pushes are given. Displacements
/// of bars that drift are left out to the last bit: places change by rounding; their ways stay.
/// O(steps (n channels + steps waves)). \pre their contacts and steps exist. `wanted`: waves x, so
/// that eta is near Z x; none: near 0.
void completeFloor(EnergyFloor& floor, const Network& network,
                   std::span<const ContactSpan> schedule, const Cancel& cancel = {},
                   std::span<const double> wanted = {});

/// Where 1 - W is factored (`isWhole`): y = f + W^T y by blocks, and once more for what was
/// rounded. O(n (channels + state)).
void completeFloor(EnergyFloor& floor, const NetworkBlocks& blocks,
                   const NetworkKernel<double>& kernel);

}  // namespace signorini
