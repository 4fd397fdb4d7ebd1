#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

#include "network_rows.hpp"

namespace signorini {

namespace {

constexpr std::size_t mostAdded = 64;  // rows, at once
template <typename Number>
constexpr double metStrain = isFine<Number> ? 1e-14 : 2e-10;  // a row broken by less is met
template <typename Number>
constexpr double noCoefficient = isFine<Number> ? 1e-35 : 1e-11;  // of two waves of size 1

/// Row of cells and steps of a limit that is there already.
using KnownStrains = std::set<std::tuple<std::size_t, std::int64_t, std::int64_t>>;

/// What arrives at both ends of a row of cells.
template <typename Number>
class StrainRows {
public:
    StrainRows(const NetworkBlocks& blocks, const NetworkKernel<Number>& kernel, double limit,
               std::size_t row)
        : blocks_(blocks),
          kernel_(kernel),
          limit_(limit),
          row_(row),
          steps_(blocks.turns() * blocks.unit())
    {
    }

    /// For each wave that arrives on the right the one from the left with which it breaks the limit
    /// most, and by how much, but for what is known.
    void collect(std::vector<std::pair<double, StrainMultiplier>>& broken,
                 const VectorOf<Number>& z, const VectorOf<Number>& inputs,
                 const KnownStrains& known) const
    {
        const std::vector<double> rights = arriving(2 * row_, z, inputs);
        const std::vector<double> lefts = arriving(2 * row_ + 1, z, inputs);
        double size = 0.0;
        for (std::size_t k = 0; k < rights.size(); ++k) {
            size = std::max({size, std::abs(rights[k]), std::abs(lefts[k])});
        }
        const Network& network = blocks_.network();
        const std::int64_t cells = network.rows[row_].cells;
        const std::int64_t all = std::min(steps_, 2 * cells + 1);
        for (std::int64_t p = 0; p < steps_; ++p) {
            std::pair<double, StrainMultiplier> most{0.0, {row_, p, p, 0.0}};
            for (std::int64_t k = 0; k < all; ++k) {
                const std::int64_t q = around(p + k - cells);
                const double least = *leastDifference(network, limit_, row_, p, q, steps_);
                const double missing = least - (lefts[static_cast<std::size_t>(q)] -
                                                rights[static_cast<std::size_t>(p)]);
                if (missing > std::max(most.first, metStrain<Number> * (size + std::abs(least))) &&
                    !known.contains({row_, p, q})) {
                    most = {missing, {row_, p, q, 0.0}};
                }
            }
            if (most.first > 0.0) {
                broken.push_back(most);
            }
        }
    }

    /// l_q - r_p in the coordinates, and in the inputs.
    [[nodiscard]] std::pair<VectorOf<Number>, VectorOf<Number>> difference(
        const StrainMultiplier& of) const
    {
        using std::abs;
        VectorOf<Number> row = VectorOf<Number>::Zero(kernel_.coordinates());
        VectorOf<Number> driven = VectorOf<Number>::Zero(kernel_.inputs());
        for (const bool isLeft : {false, true}) {
            const auto [type, index] =
                placeOf(2 * row_ + (isLeft ? 1 : 0), isLeft ? of.left : of.right);
            const auto& waves = kernel_.waves[type];
            const Number sign = isLeft ? 1 : -1;
            row.segment(kernel_.firsts[type], waves.cols()) += sign * waves.row(index).transpose();
            driven += sign * kernel_.driven[type].row(index).transpose();
        }
        row = row.unaryExpr([](const Number& value) {
            return abs(value) <= noCoefficient<Number> ? Number(0) : value;
        });
        return {row, driven};
    }

private:
    [[nodiscard]] std::int64_t around(std::int64_t step) const
    {
        return (step % steps_ + steps_) % steps_;
    }

    /// Type, and row of its waves.
    [[nodiscard]] std::pair<std::size_t, Eigen::Index> placeOf(std::size_t channel,
                                                               std::int64_t step) const
    {
        const auto [type, turn] = blocks_.placeOf(blocks_.network().nodeOf(channel), step);
        return {type, static_cast<Eigen::Index>(channel) * blocks_.turns() + turn};
    }

    [[nodiscard]] std::vector<double> arriving(std::size_t channel, const VectorOf<Number>& z,
                                               const VectorOf<Number>& inputs) const
    {
        std::vector<double> all;
        for (std::int64_t step = 0; step < steps_; ++step) {
            const auto [type, index] = placeOf(channel, step);
            const auto& waves = kernel_.waves[type];
            Number wave = waves.row(index).dot(z.segment(kernel_.firsts[type], waves.cols()));
            wave += kernel_.driven[type].row(index).dot(inputs);
            all.push_back(static_cast<double>(wave));
        }
        return all;
    }

    const NetworkBlocks& blocks_;
    const NetworkKernel<Number>& kernel_;
    double limit_;
    std::size_t row_;
    std::int64_t steps_;
};

}  // namespace

template <typename Number>
std::size_t addBrokenStrains(NetworkRows<Number>& rows, const NetworkBlocks& blocks,
                             const NetworkKernel<Number>& kernel, double limit,
                             const VectorOf<Number>& z, const VectorOf<Number>& inputs)
{
    const Network& network = blocks.network();
    if (limit == infinity) {
        return 0;
    }
    KnownStrains known;
    for (const BlockCondition& of : rows.conditions) {
        if (of.kind == BlockCondition::Kind::strain) {
            known.emplace(of.contact, static_cast<std::int64_t>(of.type), of.turn);
        }
    }
    std::vector<std::pair<double, StrainMultiplier>> broken;
    for (std::size_t row = 0; row < network.rows.size(); ++row) {
        StrainRows<Number>(blocks, kernel, limit, row).collect(broken, z, inputs, known);
    }
    std::sort(broken.begin(), broken.end(),
              [](const auto& one, const auto& other) { return one.first > other.first; });
    broken.resize(std::min(broken.size(), mostAdded));
    RowSystemOf<Number>& system = rows.system;
    const auto added = static_cast<Eigen::Index>(broken.size());
    Eigen::Index next = system.rows.rows();
    system.rows.conservativeResize(next + added, Eigen::NoChange);
    system.rhs.conservativeResize(next + added);
    rows.driven.conservativeResize(next + added, Eigen::NoChange);
    const std::int64_t steps = blocks.turns() * blocks.unit();
    for (const auto& [missing, one] : broken) {
        const auto [row, driven] =
            StrainRows<Number>(blocks, kernel, limit, one.row).difference(one);
        system.rows.row(next) = row.transpose();
        rows.driven.row(next) = driven.head(rows.driven.cols()).transpose();
        system.rhs[next] = *leastDifference(network, limit, one.row, one.right, one.left, steps);
        if (kernel.hasForces) {
            system.rhs[next] -= driven[driven.size() - 1];
        }
        ++next;
        rows.conditions.push_back(
            {BlockCondition::Kind::strain, one.row, static_cast<std::size_t>(one.right), one.left});
    }
    return broken.size();
}

template std::size_t addBrokenStrains(NetworkRows<double>&, const NetworkBlocks&,
                                      const NetworkKernel<double>&, double, const VectorOf<double>&,
                                      const VectorOf<double>&);
template std::size_t addBrokenStrains(NetworkRows<FineNumber>&, const NetworkBlocks&,
                                      const NetworkKernel<FineNumber>&, double,
                                      const VectorOf<FineNumber>&, const VectorOf<FineNumber>&);

}  // namespace signorini
