#pragma once
/// \file
/// Forced motions of a schedule of any network: rows in (C, S) and in waves that nothing damps.
///
/// A period takes the waves x to W x + C f_0 + S f_1. Where everything is damped 1 - W is regular
/// and x = C x_0 + S x_1; else x has a part z_1 k_1 + ... of the kernel, and, W being a contraction
/// in the norm sum Z x^2, W^T has the same one there: k . (C f_0 + S f_1) = 0, no work on waves
/// that nothing damps. Pushes and distances are read off x_0, x_1 and k step by step. Constant
/// forces add waves of their own, and to right sides. The displacement of a bar that drifts appears
/// in distances alone: one that closes, for each such bar, says what it is, and is taken from the
/// others; and in a period the bar moves by 0.
/// docs/theory.md, sections 19 and 20.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "contact_spans.hpp"
#include "forced_line.hpp"

namespace signorini {

/// What a row is about.
struct NetworkCondition {
    enum class Kind {
        place,  ///< distance at a contact when a step begins: 0 where it closes, else >= 0
        push,   ///< of a contact in a closed step, >= 0
        work,   ///< on wave `step` of the kernel, 0
        tie,    ///< number `step` (contact_spans.hpp), 0
        drift,  ///< way in a period of number `step` of the bars that drift, 0
    };
    Kind kind = Kind::place;
    std::size_t contact = 0;
    std::int64_t step = 0;
    bool isEquality = false;
};

/// Largest number of waves: a matrix of as many rows is factored.
inline constexpr std::size_t mostForcedWaves = 2000;

class NetworkForced {
public:
    /// None, one or two shapes, as long as the schedule. O(waves^3 + n waves). \pre a valid
    /// network; a contact closes in step 0. \throws std::invalid_argument if no contact that closes
    /// ties a bar that drifts to what is held.
    NetworkForced(Network network, std::vector<ContactSpan> schedule,
                  std::vector<StepDrive> shapes);

    /// Does rounding tell which waves nothing damps? If not, there are no rows.
    [[nodiscard]] bool isClear() const { return isClear_; }
    /// Dimension of the kernel of W - 1.
    [[nodiscard]] std::int64_t freeWaves() const { return kernel_.cols(); }
    [[nodiscard]] const std::vector<NetworkCondition>& conditions() const { return conditions_; }
    /// A row for each condition, whose own number stands in place of the step; distances and pushes
    /// in units of the network. The first is the distance where the schedule begins.
    [[nodiscard]] const std::vector<ForcedRow>& rows() const { return rows_; }
    /// The waves at t = 0; the energy sum Z x^2 of free ones is the sum of their squares, to which
    /// constant forces add `steadyEnergy`.
    [[nodiscard]] std::vector<double> waves(Plane place, std::span<const double> free) const;
    [[nodiscard]] double steadyEnergy() const { return steady_.cwiseProduct(scale_).squaredNorm(); }
    /// Displacements of the nodes that go with them.
    [[nodiscard]] std::vector<double> displacements(Plane place,
                                                    std::span<const double> free) const;
    /// Multipliers for which these rows add up to nothing but their right sides, 1 together; those
    /// of inequalities >= 0. Empty if there are none. With a way: to nothing but -way . (C, S), and
    /// no right sides. O(rows^3).
    [[nodiscard]] std::vector<double> contradiction(std::span<const std::size_t> rows,
                                                    std::optional<Plane> way = {}) const;
    /// The sum of rows with multipliers, as what a march backwards checks. `isLeast`: they make the
    /// waves of least energy, those of constant forces among them.
    [[nodiscard]] EnergyFloor floor(std::span<const std::size_t> rows,
                                    std::span<const double> multipliers,
                                    bool isLeast = false) const;

    [[nodiscard]] const Network& network() const { return network_; }
    [[nodiscard]] const std::vector<ContactSpan>& schedule() const { return schedule_; }
    [[nodiscard]] const std::vector<StepDrive>& shapes() const { return shapes_; }

private:
    using Laws = std::vector<NetworkLaw<double>>;  ///< of each span

    void solve();
    void list();
    void choosePivots();
    void read();
    void addWork();
    void clearRounding();
    [[nodiscard]] std::vector<std::vector<double>> columns() const;
    [[nodiscard]] Eigen::VectorXd withoutDrifts(std::vector<double>& values) const;
    [[nodiscard]] std::vector<std::size_t> order() const;
    [[nodiscard]] ForcedRule ruleOf(const NetworkCondition& condition, bool isFirst) const;
    /// What the conditions are for waves x under a shape (none: not driven), gaps left out.
    [[nodiscard]] std::vector<double> watch(const Eigen::VectorXd& x, const Laws& laws,
                                            const StepDrive* shape) const;
    [[nodiscard]] Eigen::VectorXd carried(const Eigen::VectorXd& x, const Laws& laws,
                                          const StepDrive* shape) const;

    Network network_;
    std::vector<ContactSpan> schedule_;
    std::vector<StepDrive> shapes_;
    Laws laws_;              ///< without constant forces
    Laws forcedLaws_;        ///< with them; empty if there are none
    Eigen::VectorXd scale_;  ///< sqrt(Z) of each wave
    bool isClear_ = true;
    std::vector<Eigen::VectorXd> driven_;  ///< x_0, x_1
    Eigen::VectorXd steady_;               ///< waves that constant forces make
    Eigen::MatrixXd kernel_;               ///< columns, orthonormal in sum Z x^2
    std::vector<Plane> work_;              ///< on each of them
    std::vector<double> steadyWork_;       ///< of constant forces on each of them
    double forces_ = 0.0;                  ///< size of constant ones
    std::vector<std::vector<double>> ties_;
    std::vector<std::vector<std::pair<std::size_t, int>>> driftsAt_;  ///< by contact
    std::vector<std::size_t> bars_;                                   ///< that drift
    std::vector<std::size_t> pivots_;      ///< places among all conditions that say where they are
    std::vector<NetworkCondition> tied_;   ///< these
    Eigen::MatrixXd driftBy_;              ///< displacements by what these are but for them
    std::vector<Eigen::VectorXd> drifts_;  ///< of each shape, what is constant, each of the kernel
    std::vector<NetworkCondition> conditions_;
    std::vector<ForcedRow> rows_;
};

}  // namespace signorini
