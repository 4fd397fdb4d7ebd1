#include "network_set.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace signorini {

namespace {

constexpr double room = 1e-6;  // of the size of a motion: more than rounding, less than any bound

/// Rows of a polyhedron that has a point.
class ForcedRows {
public:
    explicit ForcedRows(const RowSystem& system)
        : system_(system), isForced_(static_cast<std::size_t>(system.rhs.size()), false)
    {
        std::fill_n(isForced_.begin(), system.equalities, true);
    }

    /// Finds them all. False if rounding, or `cancel`, does not let it.
    bool find(const Cancel& cancel)
    {
        const LeastNorm any = leastNorm(system_, met, infinite, cancel);
        const double size = any.z.norm() > 0.0 ? any.z.norm() : 1.0;
        while (any.end == LeastNormEnd::found) {
            const RowSystem roomy = withRoom(room * size);
            const LeastNorm least = leastNorm(roomy, met, infinite, cancel);
            if (least.end != LeastNormEnd::empty) {
                return least.end == LeastNormEnd::found;
            }
            if (!enter(least.multipliers, size)) {
                return false;
            }
        }
        return false;
    }

    [[nodiscard]] bool isForced(std::size_t row) const { return isForced_[row]; }

    /// Those that a choice of forced ones leaves, in columns of coordinates.
    [[nodiscard]] std::int64_t rank(Eigen::Index first, Eigen::Index columns,
                                    const auto& isChosen) const
    {
        std::vector<Eigen::Index> chosen;
        for (std::size_t k = 0; k < isForced_.size(); ++k) {
            if (isForced_[k] && isChosen(k)) {
                chosen.push_back(static_cast<Eigen::Index>(k));
            }
        }
        if (chosen.empty() || columns == 0) {
            return 0;
        }
        Eigen::MatrixXd all(static_cast<Eigen::Index>(chosen.size()), columns);
        for (Eigen::Index k = 0; k < all.rows(); ++k) {
            const auto row = system_.rows.row(chosen[static_cast<std::size_t>(k)]);
            const double length = row.norm();
            all.row(k) = row.segment(first, columns) / (length > 0.0 ? length : 1.0);
        }
        constexpr double dependent = 1e-9;
        return columns - LeastSquares(all, dependent).kernel().cols();
    }

private:
    static constexpr double met = 1e-10;
    static constexpr double infinite = 1e100;

    /// Forced rows first, as `leastNorm` wants them.
    [[nodiscard]] RowSystem withRoom(double width)
    {
        order_.clear();
        for (const bool isFirst : {true, false}) {
            for (std::size_t k = 0; k < isForced_.size(); ++k) {
                if (isForced_[k] == isFirst) {
                    order_.push_back(static_cast<Eigen::Index>(k));
                }
            }
        }
        RowSystem roomy{Eigen::MatrixXd(system_.rows.rows(), system_.rows.cols()),
                        Eigen::VectorXd(system_.rhs.size()),
                        std::count(isForced_.begin(), isForced_.end(), true)};
        for (Eigen::Index k = 0; k < roomy.rhs.size(); ++k) {
            const Eigen::Index row = order_[static_cast<std::size_t>(k)];
            roomy.rows.row(k) = system_.rows.row(row);
            const double length = roomy.rows.row(k).norm();
            roomy.rhs[k] = system_.rhs[row] + (k < roomy.equalities ? 0.0 : width * length);
        }
        return roomy;
    }

    /// Of what contradicts itself as soon as there is room, the inequalities are forced.
    bool enter(const Eigen::VectorXd& multipliers, double size)
    {
        constexpr double rounding = 1e-9;
        const double most = multipliers.cwiseAbs().maxCoeff();
        double asked = 0.0;
        double scale = 0.0;
        bool isNew = false;
        for (std::size_t k = 0; k < order_.size(); ++k) {
            const double value = multipliers[static_cast<Eigen::Index>(k)];
            const Eigen::Index row = order_[k];
            asked += value * system_.rhs[row];
            scale += std::abs(value) *
                     (std::abs(system_.rhs[row]) + system_.rows.row(row).norm() * size);
            const auto at = static_cast<std::size_t>(row);
            if (!isForced_[at] && value > rounding * most) {
                isForced_[at] = isNew = true;
            }
        }
        return isNew && std::abs(asked) <= rounding * scale;
    }

    const RowSystem& system_;
    std::vector<bool> isForced_;
    std::vector<Eigen::Index> order_;
};

/// Does a block of several residues in flight touch at both ends?
bool touchesAtBothEnds(const NetworkBlocks& blocks, const NetworkRows<double>& rows,
                       const ForcedRows& forced)
{
    std::set<std::tuple<std::size_t, std::int64_t, std::size_t>> touching;
    for (std::size_t k = 0; k < rows.conditions.size(); ++k) {
        const BlockCondition& of = rows.conditions[k];
        if (of.kind == BlockCondition::Kind::place && forced.isForced(k)) {
            touching.emplace(of.contact, of.turn, of.type);
        }
    }
    for (const BlockCondition& of : rows.tied) {
        touching.emplace(of.contact, of.turn, of.type);
    }
    const std::size_t types = blocks.types().size();
    for (std::size_t contact = 0; contact < blocks.network().contacts.size(); ++contact) {
        bool was = contains(blocks.closed(types - 1, blocks.turns() - 1), contact);
        for (std::int64_t turn = 0; turn < blocks.turns(); ++turn) {
            for (std::size_t type = 0; type < types; ++type) {
                const bool is = contains(blocks.closed(type, turn), contact);
                const bool isLast = type + 1 == types;
                const std::int64_t nextTurn = isLast ? (turn + 1) % blocks.turns() : turn;
                const std::size_t nextType = isLast ? 0 : type + 1;
                if (!is && blocks.types()[type].width > 1 &&
                    (was || touching.contains({contact, turn, type})) &&
                    touching.contains({contact, nextTurn, nextType})) {
                    return true;
                }
                was = is;
            }
        }
    }
    return false;
}

}  // namespace

std::optional<std::int64_t> dimensionOfSet(const NetworkBlocks& blocks,
                                           const NetworkKernel<double>& kernel,
                                           const NetworkRows<double>& rows, const Cancel& cancel)
{
    ForcedRows forced(rows.system);
    if (!forced.find(cancel) || touchesAtBothEnds(blocks, rows, forced)) {
        return std::nullopt;
    }
    std::int64_t dimension =
        kernel.dimension - forced.rank(0, kernel.coordinates(), [](std::size_t) { return true; });
    for (std::size_t type = 0; type < blocks.types().size(); ++type) {
        const std::int64_t others = blocks.types()[type].width - 1;
        const Eigen::Index first = kernel.firsts[type];
        dimension -=
            others == 0
                ? 0
                : others * forced.rank(first, kernel.firsts[type + 1] - first, [&](std::size_t k) {
                      const BlockCondition& of = rows.conditions[k];
                      return of.kind == BlockCondition::Kind::push && of.type == type;
                  });
    }
    return dimension;
}

}  // namespace signorini
