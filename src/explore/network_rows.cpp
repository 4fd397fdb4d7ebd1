#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "faults.hpp"
#include "network_forced.hpp"

namespace signorini {

namespace {

constexpr double negligible = 1e-11;  // of rows, relative to the largest of their kind

double sizeOf(const ForcedRow& row)
{
    double largest = std::max(std::abs(row.plane.c), std::abs(row.plane.s));
    for (const auto& [wave, factor] : row.free) {
        largest = std::max(largest, std::abs(factor));
    }
    return largest;
}

}  // namespace

/// Distances that close tie bars that drift to others or to the ground: as many as it takes.
void NetworkForced::choosePivots()
{
    const auto count = static_cast<Eigen::Index>(bars_.size());
    std::vector<std::size_t> tree(bars_.size() + 1);  // bars tied together; the last is the ground
    std::iota(tree.begin(), tree.end(), std::size_t{0});
    Eigen::MatrixXd signs = Eigen::MatrixXd::Zero(count, count);
    for (std::size_t i = 0; i < conditions_.size(); ++i) {
        const NetworkCondition& condition = conditions_[i];
        if (condition.kind != NetworkCondition::Kind::place || !condition.isEquality) {
            continue;
        }
        const auto& drifts = driftsAt_[condition.contact];
        const std::size_t one = drifts.empty() ? tree.back() : tree[drifts.front().first];
        const std::size_t other = drifts.size() < 2 ? tree.back() : tree[drifts.back().first];
        if (one == other) {
            continue;
        }
        for (const auto& [bar, sign] : drifts) {
            signs(static_cast<Eigen::Index>(pivots_.size()), static_cast<Eigen::Index>(bar)) = sign;
        }
        std::replace(tree.begin(), tree.end(), other, one);
        pivots_.push_back(i);
        tied_.push_back(condition);
    }
    for (std::size_t k = 0; k < bars_.size(); ++k) {
        if (tree[k] != tree.back()) {
            Faults faults;
            faults.add("bar", bars_[k] + 1,
                       "bars that drift with contacts that close and tie them to what is held: the "
                       "place of this one is not told by the schedule");
            faults.throwIfAny();
        }
    }
    driftBy_ = -signs.inverse();
}

/// From the values of the conditions those that are left once bars that drift have gone where what
/// closes wants them: there.
Eigen::VectorXd NetworkForced::withoutDrifts(std::vector<double>& values) const
{
    Eigen::VectorXd missing(static_cast<Eigen::Index>(pivots_.size()));
    for (std::size_t k = 0; k < pivots_.size(); ++k) {
        missing[static_cast<Eigen::Index>(k)] = values[pivots_[k]];
    }
    Eigen::VectorXd drifts = driftBy_ * missing;
    for (std::size_t i = 0; i < values.size() && !bars_.empty(); ++i) {
        if (conditions_[i].kind == NetworkCondition::Kind::place) {
            for (const auto& [bar, sign] : driftsAt_[conditions_[i].contact]) {
                values[i] += sign * drifts[static_cast<Eigen::Index>(bar)];
            }
        }
    }
    return drifts;
}

/// Of the conditions that stay: a distance that closes, or else another equality, in front.
std::vector<std::size_t> NetworkForced::order() const
{
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < conditions_.size(); ++i) {
        if (std::find(pivots_.begin(), pivots_.end(), i) == pivots_.end()) {
            order.push_back(i);
        }
    }
    std::iter_swap(order.begin(), std::find_if(order.begin(), order.end(), [this](std::size_t i) {
                       return conditions_[i].isEquality;
                   }));
    return order;
}

ForcedRule NetworkForced::ruleOf(const NetworkCondition& condition, bool isFirst) const
{
    using Kind = NetworkCondition::Kind;
    return isFirst                        ? ForcedRule::gap
           : condition.kind == Kind::push ? ForcedRule::pressure
           : condition.kind == Kind::work ? ForcedRule::work
           : condition.isEquality         ? ForcedRule::closure
           : network_.contacts[condition.contact].kind == ContactKind::stopLeft
               ? ForcedRule::secondStop
               : ForcedRule::penetration;
}

/// What the conditions are: for each shape, constant, for each wave of the kernel.
std::vector<std::vector<double>> NetworkForced::columns() const
{
    std::vector<std::vector<double>> columns;
    for (std::size_t k = 0; k < shapes_.size(); ++k) {
        columns.push_back(watch(driven_[k], laws_, &shapes_[k]));
    }
    columns.push_back(watch(steady_, forcedLaws_.empty() ? laws_ : forcedLaws_, nullptr));
    for (std::size_t i = 0; i < conditions_.size(); ++i) {
        if (conditions_[i].kind == NetworkCondition::Kind::place) {
            columns.back()[i] += network_.contacts[conditions_[i].contact].gap;
        }
    }
    for (Eigen::Index k = 0; k < kernel_.cols(); ++k) {
        columns.push_back(watch(kernel_.col(k), laws_, nullptr));
    }
    return columns;
}

/// No work on waves that nothing damps, where something could do some.
void NetworkForced::addWork()
{
    for (std::size_t k = 0; k < steadyWork_.size(); ++k) {
        const bool isWork = std::abs(steadyWork_[k]) > negligible * forces_;
        if (!shapes_.empty() || isWork) {
            rows_.push_back({{ForcedRule::work, static_cast<std::int64_t>(rows_.size())},
                             true,
                             work_[k],
                             {},
                             isWork ? -steadyWork_[k] : 0.0});
            conditions_.push_back(
                {NetworkCondition::Kind::work, 0, static_cast<std::int64_t>(k), true});
        }
    }
}

void NetworkForced::read()
{
    using Kind = NetworkCondition::Kind;
    std::vector<std::vector<double>> all = columns();
    const std::size_t shapes = shapes_.size();
    std::array<double, 2> most{0.0, forces_};  // of what is constant: displacements, pushes
    for (std::size_t i = 0; i < conditions_.size(); ++i) {
        double& size = most[conditions_[i].kind == Kind::push ? 1 : 0];
        size = std::max(size, std::abs(all[shapes][i]));
    }
    for (std::vector<double>& values : all) {
        drifts_.push_back(withoutDrifts(values));
    }
    std::vector<NetworkCondition> kept;
    for (const std::size_t i : order()) {
        const NetworkCondition& condition = conditions_[i];
        ForcedRow row{{ruleOf(condition, rows_.empty()), static_cast<std::int64_t>(rows_.size())},
                      condition.isEquality,
                      {shapes > 0 ? all[0][i] : 0.0, shapes > 1 ? all[1][i] : 0.0},
                      {},
                      -all[shapes][i]};
        for (std::size_t k = shapes + 1; k < all.size(); ++k) {
            row.free.emplace_back(k - shapes - 1, all[k][i]);
        }
        if (std::abs(row.limit) <= negligible * most[condition.kind == Kind::push ? 1 : 0]) {
            row.limit = 0.0;
        }
        rows_.push_back(std::move(row));
        kept.push_back(condition);
    }
    conditions_ = std::move(kept);
    addWork();
    clearRounding();
}

/// What is 0 but for rounding is 0.
void NetworkForced::clearRounding()
{
    double largest = 0.0;
    for (const ForcedRow& row : rows_) {
        largest = std::max(largest, sizeOf(row));
    }
    for (ForcedRow& row : rows_) {
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

}  // namespace signorini
