#pragma once
/// \file
/// Does a schedule of a stepped bar have motions? In doubles; what is claimed of it is checked
/// elsewhere: motions by a march, multipliers by what they prove (energy_floor.hpp).

#include <string>
#include <vector>

#include "contact_spans.hpp"
#include "signorini/certificate.hpp"
#include "signorini/control.hpp"
#include "solver.hpp"
#include "stepped_form.hpp"

namespace signorini {

/// A condition with its multiplier.
struct SteppedMultiplier {
    SteppedCondition of;
    double value = 0.0;
};

/// The answer of a method.
struct SteppedExistence {
    Status status = Status::undecided;
    std::string detail = {};  ///< why undecided
    /// none: of conditions that contradict each other; found by `leastMotion`: of those that make
    /// the energy no less.
    std::vector<SteppedMultiplier> multipliers = {};
    Eigen::VectorXd x = {};  ///< found: a solution
    std::int64_t iterations = 0;
};

/// The motion of least energy in the kernel form: an active set method of a few steps.
[[nodiscard]] SteppedExistence leastMotion(const SteppedProgram& kernel, const Cancel& cancel);

/// Some motion, by one linear program (homogeneous.hpp) for a back end that returns duals.
[[nodiscard]] SteppedExistence existence(const SteppedProgram& posed, const Solver& simplex,
                                         const SolverOptions& options);

/// The bar with its stops, and, contact number three or last, the floor that its tip keeps above.
[[nodiscard]] Network networkOf(const SteppedBlocks& blocks, const Scene& scene, double tipFloor);

/// The same multipliers of distances and pushes of that network, step by step, with those of
/// periodicity that go with them.
[[nodiscard]] EnergyFloor floorOf(const std::vector<SteppedMultiplier>& multipliers,
                                  const SteppedBlocks& blocks, const Network& network,
                                  const Cancel& cancel);

/// Why there is no motion, from what the proof needs.
[[nodiscard]] Reason reasonOf(const std::vector<SteppedMultiplier>& multipliers,
                              const SteppedBlocks& blocks,
                              std::optional<std::int64_t> kernelDimension);

}  // namespace signorini
