#pragma once
/// \file
/// Which motion of a stepped bar: objectives over its programs.

#include <string>

#include "signorini/find_periodic.hpp"
#include "stepped_form.hpp"

namespace signorini {

/// A point of a program, or why there is none.
struct SteppedPoint {
    Eigen::VectorXd x;
    std::string solver;
    std::int64_t iterations = 0;
    std::string detail;  ///< empty: x is the point

    [[nodiscard]] bool isFound() const { return detail.empty(); }
};

/// The objective that a request without one gets: least energy where a back end can do it.
[[nodiscard]] Objective objectiveOf(const FindOptions& options);

/// The motion of least energy, or of most impulse. Leaves the objective in the program.
[[nodiscard]] SteppedPoint extremePoint(SteppedProgram& posed, Objective objective,
                                        const FindOptions& options);

/// A motion of the energy to hold, between that of least energy and one of more: the set is convex
/// and the energy grows on the way. Those of more are vertices in several directions.
[[nodiscard]] SteppedPoint pointOfEnergy(SteppedProgram& posed, const FindOptions& options);

}  // namespace signorini
