#pragma once
/// \file
/// The same set of motions written down in more ways than the library needs: what its formulations
/// leave out is put back here, one thing at a time, to measure what leaving it out gains.
///
/// | name         | unknowns                       | prefix sums of (12)                 |
/// |--------------|--------------------------------|-------------------------------------|
/// | sd           | a, b                           | dense rows: the paper's C           |
/// | sd-redundant | a, b                           | dense rows, all closures, row (11)  |
/// | paper        | a, b                           | N dense rows per step, as in (32)   |
/// | sy           | a, b, y                        | y_k = y_{k-1} + p_k, y_k <= 0       |
/// | dy           | p_0..p_{n-1}, y                | the same                            |
/// | ky           | one amplitude per class, y     | the same                            |
/// | kd           | one amplitude per class        | dense rows, one per step            |
/// | reduced      | amplitudes, their sums         | ends of blocks (the library's own)  |
/// | lumped       | sums of amplitudes             | ends of blocks (the library's own)  |

#include <string_view>
#include <vector>

#include "formulation.hpp"
#include "signorini/demands.hpp"

namespace signorini::bench {

/// What stands for the motion.
enum class Unknowns { waves, delay, amplitudes };

/// How a form of this file is built.
struct Form {
    std::string_view name;
    Unknowns unknowns = Unknowns::waves;
    bool isDense = false;       ///< prefix sums as dense rows instead of unknowns y
    bool hasRedundant = false;  ///< closure of the last flight, and (11) as a row of its own
    bool hasAllCells = false;   ///< N rows per step: contact rows repeated, (12) at N instants
};

/// The first five forms of the comparison with other solvers: sd, sy, dy, ky, kd.
[[nodiscard]] const std::vector<std::string_view>& comparedForms();

/// How much of what the library leaves out stays in.
struct Kept {
    bool longPhases = false;  ///< phases are not folded (waves and delay only)
    bool strainRows = false;  ///< a strain limit as one row per cell and step, not as bounds
};

/// Poses existence with an optional least or held energy and strain limit.
/// \throws std::invalid_argument for an unknown name or demands that a form does not know.
[[nodiscard]] Formulated poseForm(const Schedule& schedule, const Demands& demands,
                                  std::string_view form, const Kept& kept = {});

}  // namespace signorini::bench
