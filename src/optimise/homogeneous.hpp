#pragma once
/// \file
/// Is there a feasible point? One linear program that always has a solution.
///
/// With one more unknown 0 <= theta <= 1 and every right side and bound times theta, x = 0 and
/// theta = 0 are feasible. The largest theta is 1 if the rows have a solution, and 0 if they have
/// none: feasible points of theta > 0 can be scaled. Its multipliers are then those of a proof, so
/// one call decides both ways, and no solver has to recognise an empty set by itself.

#include "program.hpp"

namespace signorini {

/// The program: the unknowns and rows of the old one first, in their order, then theta; finite
/// bounds other than 0 become inequalities. The energy equality and the objective are left out.
[[nodiscard]] Program homogeneous(const Program& program);

}  // namespace signorini
