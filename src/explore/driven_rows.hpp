#pragma once
/// \file
/// The rows of a schedule of any network that is driven (network_rows.hpp), in the plane (C, S) and
/// in waves that nothing damps. docs/theory.md, sections 19 and 20.

#include <span>
#include <vector>

#include "forced_line.hpp"
#include "network_rows.hpp"

namespace signorini {

/// Largest state of a block: a matrix of as many rows is factored for each.
inline constexpr std::int64_t mostDrivenState = 2000;

class DrivenRows {
public:
    /// One or two shapes, as long as the schedule. \pre a valid network; a contact closes in step
    /// 0. \throws std::invalid_argument as `rowsOf` does.
    DrivenRows(Network network, std::vector<ContactSpan> schedule, std::vector<StepDrive> shapes);

    [[nodiscard]] bool isWithinReach() const { return kernel_.has_value(); }
    /// Does rounding tell which waves nothing damps? If not, there are no rows.
    [[nodiscard]] bool isClear() const { return kernel_ && kernel_->isClear; }
    /// Dimension of the kernel of W - 1.
    [[nodiscard]] std::int64_t freeWaves() const { return kernel_->coordinates(); }
    /// In the order of time, their own numbers in place of steps; distances and pushes in units of
    /// the network. The first is the distance where the schedule begins.
    [[nodiscard]] const std::vector<ForcedRow>& rows() const { return forced_; }
    /// Adds rows of the limit on strain that the motion at a place breaks. Are there any?
    bool limitStrain(Plane place, std::span<const double> free);
    /// What a row is about, and its step.
    [[nodiscard]] BlockCondition::Kind kindOf(std::size_t row) const { return of(row).kind; }
    [[nodiscard]] std::int64_t stepOf(std::size_t row) const;
    /// The waves at t = 0, and displacements of the nodes that go with them.
    [[nodiscard]] std::vector<double> waves(Plane place, std::span<const double> free) const;
    [[nodiscard]] std::vector<double> displacements(Plane place,
                                                    std::span<const double> waves) const;
    /// Multipliers for which these rows add up to nothing but their right sides, 1 together; those
    /// of inequalities >= 0. Empty if there are none. Those nearest to a multiple of a start.
    /// O(rows^3).
    [[nodiscard]] std::vector<double> contradiction(std::span<const std::size_t> rows,
                                                    std::span<const double> start = {}) const;
    /// Those for which they add up to -way . (C, S) >= some right side, or none.
    [[nodiscard]] std::vector<double> barrier(std::span<const std::size_t> rows,
                                              std::span<const double> start, Plane way,
                                              bool hasRightSide) const;
    /// The sum of rows with multipliers, as what a march backwards checks.
    [[nodiscard]] EnergyFloor floor(std::span<const std::size_t> rows,
                                    std::span<const double> multipliers) const;

    [[nodiscard]] const Network& network() const { return blocks_.network(); }
    [[nodiscard]] const std::vector<ContactSpan>& schedule() const { return blocks_.schedule(); }
    [[nodiscard]] const std::vector<StepDrive>& shapes() const { return shapes_; }

private:
    [[nodiscard]] const BlockCondition& of(std::size_t row) const
    {
        return rows_.conditions[order_[row]];
    }
    /// Of limits, places and free waves of the rows, so that they add up to such a column.
    [[nodiscard]] std::vector<double> multipliersOf(std::span<const std::size_t> rows,
                                                    Eigen::VectorXd near, bool hasLimits,
                                                    const Eigen::Vector3d& sum) const;
    [[nodiscard]] Eigen::VectorXd inputsAt(Plane place) const;
    [[nodiscard]] Eigen::VectorXd coordinatesAt(std::span<const double> free) const;
    void sort();
    /// The rows from this one on.
    void read(std::size_t first);
    void clearRounding();
    void addWork(EnergyFloor& floor, Eigen::Vector3d sum) const;
    [[nodiscard]] ForcedRule ruleOf(std::size_t row) const;

    NetworkBlocks blocks_;
    std::vector<StepDrive> shapes_;
    std::optional<NetworkKernel<double>> kernel_;
    NetworkRows<double> rows_;
    std::vector<std::size_t> order_;  ///< of the rows
    std::vector<ForcedRow> forced_;
};

}  // namespace signorini
