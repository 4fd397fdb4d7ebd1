#pragma once
/// \file
/// Forced motions whose excitation does not fix all waves: linear programs in (C, S) and the
/// amplitudes of those that nothing damps.

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "forced_form.hpp"
#include "forced_line.hpp"
#include "signorini/response.hpp"

namespace signorini {

/// What the programs say.
struct ForcedPolytope {
    std::string detail;  ///< why they say nothing
    /// There is no motion, for these conditions.
    std::optional<std::vector<ForcedCondition>> conflict;
    /// As the program knows them: of the distance where contact starts, then of these conditions.
    std::vector<double> multipliers = {};
    double added = 0.0;                 ///< of another row with the rule `gap`
    std::vector<ForcedCorner> corners;  ///< as in ForcedSet
    bool isBounded = true;
};

/// Finds the polygon of all (C, S), corner by corner, each the farthest in some direction.
/// A few programs for each corner.
[[nodiscard]] ForcedPolytope forcedPolytope(std::vector<ForcedRow> rows,
                                            const ForcedUnknowns& unknowns);

/// The mean of corners that lies at a place of their polygon. O(corners).
[[nodiscard]] ForcedCorner meanAt(const std::vector<ForcedCorner>& corners,
                                  std::array<double, 2> place);

/// The place of least amplitude. \pre there is a corner. O(corners).
[[nodiscard]] std::array<double, 2> nearestPlace(const std::vector<ForcedCorner>& corners);
/// Least and largest amplitude. \pre there is a corner. O(corners).
[[nodiscard]] std::pair<double, double> amplitudesOf(const ForcedPolytope& polytope);
/// A place of this amplitude on the way from the nearest to the farthest.
[[nodiscard]] std::array<double, 2> placeOfAmplitude(const std::vector<ForcedCorner>& corners,
                                                     double amplitude);

}  // namespace signorini
