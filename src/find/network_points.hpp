#pragma once
/// \file
/// Motions of a network that are not those of least energy, by programs for back ends in
/// coordinates of ker(W - 1) (`Formulation::kernel`).

#include <optional>
#include <string>

#include "network_rows.hpp"
#include "network_walk.hpp"
#include "program.hpp"
#include "signorini/find_periodic.hpp"
#include "stopwatch.hpp"

namespace signorini {

/// A point of the program, or why there is none.
struct NetworkPoint {
    Eigen::VectorXd z = {};
    std::string solver = {};
    std::int64_t iterations = 0;
    std::string detail = {};  ///< empty: z is the point
    bool isUnbounded = false;
};

class NetworkPoints {
public:
    /// O(state^3) for each block.
    NetworkPoints(const NetworkBlocks& blocks, const FindOptions& options);

    /// The motion of least energy, of most impulse, or whose deepest compression is least (then of
    /// blocks of single residues). \throws BackendUnavailable
    [[nodiscard]] NetworkPoint extreme(Objective objective);
    /// A motion of an energy [Z_1 delta^2/h], between that of least energy, whose waves are known,
    /// and one of more: the set is convex and the energy grows on the way. Those of more are
    /// vertices in several directions. \throws BackendUnavailable
    [[nodiscard]] NetworkPoint ofEnergy(double wanted, std::span<const double> leastWaves);
    /// The most energy that climbing finds, not proved the most. One of `beyond`
    /// [Z_1 delta^2/h], or of 10^6 times what a limit on strain leaves, counts as without a bound.
    /// \throws BackendUnavailable
    [[nodiscard]] NetworkPoint ofMostEnergy(double beyond);
    /// Waves, and where the nodes are at the start.
    [[nodiscard]] NetworkClaim motion(const NetworkPoint& point) const;

private:
    /// Of the program, and of the limit on strain, whose rows are added as they are broken; it is
    /// the last unknown if there is one more than coordinates.
    [[nodiscard]] NetworkPoint solved();
    [[nodiscard]] NetworkPoint solvedOnce() const;
    [[nodiscard]] NetworkPoint leastStrained();
    /// The energy is convex: from several directions, follows its linearisation from vertex to
    /// vertex while it grows, until one has as much as is `enough`. The best vertex, counted from
    /// what constant forces make of z, in a box about that.
    [[nodiscard]] NetworkPoint climbed(const Eigen::VectorXd& made, double box, double enough);
    /// Of constant forces that |z|^2 about theirs leaves out.
    [[nodiscard]] double steadyEnergy(const Eigen::VectorXd& made) const;
    /// Is the time over? Enters it.
    [[nodiscard]] bool isOver(NetworkPoint& point) const;
    void enterRows();
    /// Rows of a limit that the waves at z break. Are there any?
    bool addStrains(const Eigen::VectorXd& z, double limit);

    const NetworkBlocks& blocks_;
    const FindOptions& options_;
    std::optional<NetworkKernel<double>> kernel_;  ///< if within reach
    NetworkRows<double> rows_ = {};
    std::vector<double> limits_ = {};  ///< on strain, with which rows were made
    Program program_ = {};
    Stopwatch watch_ = {};
};

}  // namespace signorini
