#include "driven_rows.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "energy_floor.hpp"
#include "largest.hpp"
#include "least_norm.hpp"
#include "periodic_multipliers.hpp"

namespace signorini {

namespace {

constexpr double negligible = 1e-11;  // of rows, relative to the largest

double sizeOf(const ForcedRow& row)
{
    return std::max({std::abs(row.plane.c), std::abs(row.plane.s),
                     largestSizeOf(row.free, [](const auto& entry) { return entry.second; })});
}

/// Shapes times C and S.
StepDrive combined(const std::vector<StepDrive>& shapes, Plane place)
{
    StepDrive sum = shapes.front();
    for (auto* list : {&sum.forces, &sum.velocities, &sum.places}) {
        for (double& value : *list) {
            value *= place.c;
        }
    }
    for (std::size_t m = 0; m < sum.forces.size() && shapes.size() > 1; ++m) {
        sum.forces[m] += place.s * shapes[1].forces[m];
        sum.velocities[m] += place.s * shapes[1].velocities[m];
        sum.places[m] += place.s * shapes[1].places[m];
    }
    return sum;
}

}  // namespace

DrivenRows::DrivenRows(Network network, std::vector<ContactSpan> schedule,
                       std::vector<StepDrive> shapes)
    : blocks_(std::move(network), std::move(schedule), false),
      shapes_(std::move(shapes)),
      kernel_(blocks_.stateSize() > mostDrivenState ? std::nullopt
                                                    : kernelOf<double>(blocks_, noPivot, shapes_))
{
    if (isClear()) {
        rows_ = rowsOf(blocks_, *kernel_);
        sort();
        read(0);
    }
}

bool DrivenRows::limitStrain(Plane place, std::span<const double> free)
{
    const std::size_t first = order_.size();
    const std::size_t added = addBrokenStrains(rows_, blocks_, *kernel_, network().strainLimit,
                                               coordinatesAt(free), inputsAt(place));
    for (std::size_t k = 0; k < added; ++k) {
        order_.push_back(first + k);
    }
    read(first);
    return added > 0;
}

std::int64_t DrivenRows::stepOf(std::size_t row) const
{
    const auto& [kind, contact, type, turn] = of(row);
    if (kind == BlockCondition::Kind::strain) {
        return static_cast<std::int64_t>(type);
    }
    if (kind != BlockCondition::Kind::place && kind != BlockCondition::Kind::push) {
        return 0;  // of the whole period, and no contact's
    }
    return blocks_.stepOf(network().contacts[contact].node, type, turn);
}

/// In the order of time, a distance that closes in front, or else another equality.
void DrivenRows::sort()
{
    const auto isInTime = [this](std::size_t k) {
        return rows_.conditions[k].kind == BlockCondition::Kind::place ||
               rows_.conditions[k].kind == BlockCondition::Kind::push;
    };
    for (std::size_t k = 0; k < rows_.conditions.size(); ++k) {
        order_.push_back(k);
    }
    std::vector<std::tuple<bool, std::int64_t, std::size_t, BlockCondition::Kind>> keys;
    for (std::size_t k = 0; k < order_.size(); ++k) {
        const BlockCondition& at = rows_.conditions[k];
        keys.emplace_back(!isInTime(k), isInTime(k) ? stepOf(k) : 0, at.contact, at.kind);
    }
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t x, std::size_t y) { return keys[x] < keys[y]; });
    std::iter_swap(order_.begin(), std::find_if(order_.begin(), order_.end(), [&](std::size_t k) {
                       return static_cast<Eigen::Index>(k) < rows_.system.equalities;
                   }));
}

ForcedRule DrivenRows::ruleOf(std::size_t row) const
{
    using Kind = BlockCondition::Kind;
    const bool isEquality = static_cast<Eigen::Index>(order_[row]) < rows_.system.equalities;
    return row == 0                      ? ForcedRule::gap
           : kindOf(row) == Kind::push   ? ForcedRule::pressure
           : kindOf(row) == Kind::work   ? ForcedRule::work
           : kindOf(row) == Kind::strain ? ForcedRule::strain
           : isEquality                  ? ForcedRule::closure
           : network().contacts[of(row).contact].kind == ContactKind::stopLeft
               ? ForcedRule::secondStop
               : ForcedRule::penetration;
}

void DrivenRows::read(std::size_t first)
{
    for (std::size_t row = first; row < order_.size(); ++row) {
        const auto k = static_cast<Eigen::Index>(order_[row]);
        ForcedRow& made = forced_.emplace_back();
        made.condition = {ruleOf(row), static_cast<std::int64_t>(row)};
        made.isEquality = k < rows_.system.equalities;
        made.plane = {rows_.driven(k, 0), rows_.driven.cols() > 1 ? rows_.driven(k, 1) : 0.0};
        made.limit = rows_.system.rhs[k];
        for (Eigen::Index wave = 0; wave < freeWaves(); ++wave) {
            made.free.emplace_back(static_cast<std::size_t>(wave), rows_.system.rows(k, wave));
        }
    }
    clearRounding();
}

/// What is 0 but for rounding is 0.
void DrivenRows::clearRounding()
{
    const double largest = largestOf(forced_, &sizeOf);
    for (ForcedRow& row : forced_) {
        const auto clear = [&](double& value) {
            value = std::abs(value) <= negligible * largest ? 0.0 : value;
        };
        clear(row.plane.c);
        clear(row.plane.s);
        for (auto& [wave, factor] : row.free) {
            clear(factor);
        }
        std::erase_if(row.free, [](const auto& entry) { return entry.second == 0.0; });
    }
}

Eigen::VectorXd DrivenRows::inputsAt(Plane place) const
{
    Eigen::VectorXd inputs = steadyInputs(*kernel_);
    inputs[0] = place.c;
    if (shapes_.size() > 1) {
        inputs[1] = place.s;
    }
    return inputs;
}

Eigen::VectorXd DrivenRows::coordinatesAt(std::span<const double> free) const
{
    Eigen::VectorXd z = Eigen::VectorXd::Zero(freeWaves());
    std::copy(free.begin(), free.end(), z.begin());
    return z;
}

std::vector<double> DrivenRows::waves(Plane place, std::span<const double> free) const
{
    return wavesAt(blocks_, *kernel_, coordinatesAt(free), inputsAt(place));
}

std::vector<double> DrivenRows::displacements(Plane place, std::span<const double> waves) const
{
    return displacementsAt(blocks_, rows_, waves, combined(shapes_, place));
}

std::vector<double> DrivenRows::multipliersOf(std::span<const std::size_t> rows,
                                              Eigen::VectorXd near, bool hasLimits,
                                              const Eigen::Vector3d& sum) const
{
    const auto count = static_cast<Eigen::Index>(rows.size());
    Eigen::MatrixXd parts = Eigen::MatrixXd::Zero(3 + freeWaves(), count);
    for (Eigen::Index k = 0; k < count; ++k) {
        const ForcedRow& row = forced_[rows[static_cast<std::size_t>(k)]];
        parts(0, k) = hasLimits ? row.limit : 0.0;
        parts(1, k) = row.plane.c;
        parts(2, k) = row.plane.s;
        for (const auto& [wave, factor] : row.free) {
            parts(3 + static_cast<Eigen::Index>(wave), k) = factor;
        }
    }
    Eigen::VectorXd right = Eigen::VectorXd::Zero(parts.rows());
    right.head(3) = sum;
    near += LeastSquares(parts).solve(right - parts * near);
    if (!((parts * near - right).norm() < 1e-6)) {
        return {};
    }
    std::vector<double> multipliers(near.begin(), near.end());
    for (std::size_t k = 0; k < rows.size(); ++k) {
        if (!forced_[rows[k]].isEquality) {
            multipliers[k] = std::max(multipliers[k], 0.0);
        }
    }
    return multipliers;
}

std::vector<double> DrivenRows::contradiction(std::span<const std::size_t> rows,
                                              std::span<const double> start) const
{
    Eigen::VectorXd near = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows.size()));
    if (start.size() == rows.size()) {
        double whole = 0.0;
        for (std::size_t k = 0; k < rows.size(); ++k) {
            whole += forced_[rows[k]].limit * start[k];
        }
        near = Eigen::Map<const Eigen::VectorXd>(start.data(), near.size()) *
               (whole > 0.0 ? 1.0 / whole : 0.0);
    }
    return multipliersOf(rows, std::move(near), true, {1.0, 0.0, 0.0});
}

std::vector<double> DrivenRows::barrier(std::span<const std::size_t> rows,
                                        std::span<const double> start, Plane way,
                                        bool hasRightSide) const
{
    return multipliersOf(
        rows,
        Eigen::Map<const Eigen::VectorXd>(start.data(), static_cast<Eigen::Index>(start.size())),
        !hasRightSide, {0.0, -way.c, -way.s});
}

EnergyFloor DrivenRows::floor(std::span<const std::size_t> rows,
                              std::span<const double> multipliers) const
{
    Eigen::VectorXd all = Eigen::VectorXd::Zero(rows_.system.rhs.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
        all[static_cast<Eigen::Index>(order_[rows[k]])] += multipliers[k];
    }
    EnergyFloor floor = conditionsOf(blocks_, *kernel_, rows_, all);
    completeFloor(floor, blocks_, *kernel_);
    if (freeWaves() > 0) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const ForcedRow& row = forced_[rows[k]];
            sum += multipliers[k] * Eigen::Vector3d(row.plane.c, row.plane.s, -row.limit);
        }
        addWork(floor, sum);
    }
    return floor;
}

/// Rows are told by the clocks of nodes, steps by one: where waves are not those that repeat they
/// differ by some work on waves that nothing damps.
void DrivenRows::addWork(EnergyFloor& floor, Eigen::Vector3d sum) const
{
    const auto cuts = cutsOf(std::span(&floor, 1), network(), schedule(), shapes_);
    if (cuts.empty()) {
        return;
    }
    const auto middle = [](const Interval& value) { return 0.5 * (value.low + value.high); };
    sum -= Eigen::Vector3d(middle(cuts[0].c), middle(cuts[0].s), -cuts[0].right);
    const auto shapes = static_cast<Eigen::Index>(shapes_.size());
    Eigen::MatrixXd work = Eigen::MatrixXd::Zero(3, freeWaves());
    Eigen::Index next = 0;
    for (const Eigen::MatrixXd& part : kernel_->work) {
        work.block(0, next, shapes, part.rows()) = part.leftCols(shapes).transpose();
        if (kernel_->hasForces) {
            work.block(2, next, 1, part.rows()) = part.rightCols(1).transpose();
        }
        next += part.rows();
    }
    const Eigen::VectorXd z = LeastSquares(work).solve(sum);
    const std::vector<double> waves =
        wavesAt(blocks_, *kernel_, z, Eigen::VectorXd(Eigen::VectorXd::Zero(kernel_->inputs())));
    const std::vector<double> impedances = impedancesOf(network());
    for (std::size_t k = 0; k < waves.size(); ++k) {
        floor.periodicity[k] += impedances[k] * waves[k];
    }
}

}  // namespace signorini
