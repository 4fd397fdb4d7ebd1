#pragma once
/// \file
/// Free motions of a schedule of any network: that of least energy, or a proof that there is none.
///
/// In coordinates of ker(W - 1) (network_kernel.hpp) the point of least norm that meets all rows,
/// or multipliers of rows that contradict each other, come from least_norm.hpp: in doubles, and
/// where these do not tell, and the state is small, in 50 digits. Nothing of it is believed: a
/// motion is walked by code of its own, and absence, and that no motion has less energy, is what a
/// march backwards makes of the multipliers. docs/theory.md, section 20.

#include <optional>
#include <string>
#include <vector>

#include "network_rows.hpp"
#include "network_walk.hpp"
#include "signorini/control.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/schedule.hpp"

namespace signorini {

/// What has to be known.
struct LeastDemands {
    /// Where rows contradict each other: no motion of less energy is to be proved
    /// [Z_1 delta^2/h].
    double absent = 0.0;
    double tolerance = 1e-9;  ///< largest residual of a motion
    /// What absence is to be proved of, if not of the same gaps.
    const Network* relaxed = nullptr;
    /// Nearest to these waves (`Network::waves`), in the norm of the energy, in place of none.
    std::optional<std::vector<double>> target = {};
    bool asksSet = false;  ///< what the set of all motions looks like, too
    Cancel cancel = {};
};

/// What is known of a schedule.
struct LeastMotion {
    Status status = Status::undecided;
    std::string detail = {};                           ///< why not decided
    std::optional<std::int64_t> kernelDimension = {};  ///< if rounding does not hide it
    /// Of all motions, whatever limits strains; asked for, and if rounding does not hide it.
    std::optional<SetKind> kind = {};
    std::int64_t dimension = -1;  ///< known if the kind is; -1: empty
    Provenance how = {};
    bool isEmpty = false;  ///< rows contradict each other, as far as rounding tells
    std::optional<NetworkClaim> motion = {};  ///< found
    NetworkResiduals residuals = {};          ///< of it
    double energy = 0.0;                      ///< of it
    /// Rows in force, or those that contradict each other, those of no weight left out.
    std::vector<BlockCondition> conditions = {};
    EnergyFloor multipliers = {};  ///< none, or after `prove`
    double provedEnergy = 0.0;     ///< none, or after `prove`: rounded downwards
    /// Of the conditions of the rows, all of them, as steps.
    EnergyFloor unproved = {};
    std::vector<double> steady = {};  ///< waves that constant forces make; empty: none
    /// Proved: every motion of the schedule is compressed by more somewhere [delta/h over speeds].
    std::optional<double> provedStrain = {};
};

/// O(G-blocks of turns waves + state^3 each, and a proof where there is none). \pre a valid
/// network. \throws std::invalid_argument as `rowsOf` does.
[[nodiscard]] LeastMotion leastMotion(const NetworkBlocks& blocks, const LeastDemands& demands);

/// How an answer was got so far: why so, what blocks leave out, and the active set method.
[[nodiscard]] Provenance howOf(const NetworkBlocks& blocks, std::string reason);
/// Who solved it in the end.
void enterSolver(Provenance& how, std::string_view solver);

/// The coordinates of what is nearest to waves, in the norm of the energy: x^T Z times them for
/// each x of the basis. O(M coordinates).
template <typename Number>
[[nodiscard]] VectorOf<Number> coordinatesOf(const NetworkBlocks& blocks,
                                             const NetworkKernel<Number>& kernel,
                                             std::span<const double> waves);

/// The same of the waves that constant forces make alone: at t = 0 these need not be at right
/// angles to the kernel, as forces work on waves on their way from node to node.
template <typename Number>
[[nodiscard]] VectorOf<Number> steadyCoordinates(const NetworkBlocks& blocks,
                                                 const NetworkKernel<Number>& kernel);

/// sum Z x^2 of waves in the order of `Network::waves`, or of none.
[[nodiscard]] double energyOf(const Network& network, std::span<const double> waves);

/// Walks a motion and, if no residual exceeds the tolerance, enters it: true; else says why not.
bool enterMotion(LeastMotion& result, const NetworkBlocks& blocks, NetworkClaim claim,
                 double tolerance);

/// Enters what the multipliers prove of all motions of a network whose gaps may be others.
void prove(LeastMotion& motion, const NetworkBlocks& blocks, const Network& network,
           const Cancel& cancel = {});

/// Why there is no motion, from what the proof needs.
[[nodiscard]] Reason reasonOf(const LeastMotion& motion, const NetworkBlocks& blocks);

}  // namespace signorini
