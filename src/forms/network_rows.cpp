#include "network_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "faults.hpp"

namespace signorini {

namespace {

template <typename Number>
constexpr double cancelled = isFine<Number> ? 1e-35 : 1e-11;  // of a sum of waves of size 1
constexpr double surelyNone = 3e-15;  // what is smaller is rounding of doubles

/// Collects rows, of coordinates, inputs, and displacements of bars that drift.
template <typename Number>
class RowMaker {
    using Vector = VectorOf<Number>;
    using Kind = BlockCondition::Kind;

public:
    RowMaker(const NetworkBlocks& blocks, const NetworkKernel<Number>& kernel)
        : blocks_(blocks),
          network_(blocks.network()),
          kernel_(kernel),
          bars_(driftingBars(network_)),
          laws_(network_),
          inputs_(kernel.coordinates()),
          drifts_(inputs_ + kernel.inputs())
    {
        rows_.impulse = Vector::Zero(inputs_);
    }

    NetworkRows<Number> run()
    {
        for (std::size_t contact = 0; contact < network_.contacts.size(); ++contact) {
            follow(contact);
        }
        leaveDriftsOut();
        addTies();
        addWays();
        addWork();
        return assembled();
    }

private:
    struct Made {
        Vector row;
        Number rhs;
        BlockCondition of;
    };

    [[nodiscard]] Vector nothing() const
    {
        return Vector::Zero(drifts_ + static_cast<Eigen::Index>(bars_.size()));
    }

    /// Adds a form in what arrives in a block.
    void addWaves(Vector& to, const LinearForm<Number>& form, std::size_t type, std::int64_t turn,
                  const Number& factor) const
    {
        const auto& waves = kernel_.waves[type];
        for (const auto& term : form.terms) {
            const Eigen::Index row =
                static_cast<Eigen::Index>(term.channel) * blocks_.turns() + turn;
            const Number all = factor * term.coefficient;
            to.segment(kernel_.firsts[type], waves.cols()) += all * waves.row(row).transpose();
            to.segment(inputs_, kernel_.inputs()) +=
                all * kernel_.driven[type].row(row).transpose();
        }
    }

    /// The same of what a node does in a block, that of inputs included.
    void add(Vector& to, const LinearForm<Number>& form, std::size_t node, std::size_t type,
             std::int64_t turn, const Number& factor) const
    {
        addWaves(to, form, type, turn, factor);
        const auto step = static_cast<std::size_t>(blocks_.stepOf(node, type, turn));
        Eigen::Index input = inputs_;
        for (const StepDrive& shape : kernel_.shapes) {
            to[input++] += factor * (form.perForce * Number(shape.forces[step]) +
                                     form.perBase * Number(shape.velocities[step]));
        }
        if (kernel_.hasForces) {
            to[input] += factor * form.constant;
        }
    }

    /// u of a node when its clock begins, but for the drift of its bar; along a row it falls by
    /// what arrives at its right end.
    [[nodiscard]] Vector displacement(std::size_t node) const
    {
        const DisplacementForm form = displacementOf(network_, node);
        Vector u = nothing();
        for (const auto& [row, sign] : form.rows) {
            for (std::size_t type = 0; type < kernel_.waves.size(); ++type) {
                const auto width = static_cast<double>(-sign * blocks_.types()[type].width);
                for (std::int64_t k = 0; k < blocks_.delay(2 * row); ++k) {
                    addWaves(u, {{{2 * row, Number(1)}}}, type, k % blocks_.turns(), width);
                }
            }
        }
        if (form.spring) {
            addWaves(u, {{{2 * network_.rows.size() + *form.spring, Number(1)}}}, 0, 0, Number(-1));
        }
        if (form.clamp && network_.nodes[*form.clamp].isShaken) {
            const auto step = static_cast<std::size_t>(blocks_.stepOf(*form.clamp, 0, 0));
            for (std::size_t k = 0; k < kernel_.shapes.size(); ++k) {
                u[inputs_ + static_cast<Eigen::Index>(k)] += Number(kernel_.shapes[k].places[step]);
            }
        }
        return u;
    }

    /// When the clock of its node begins.
    [[nodiscard]] Vector distanceAt(std::size_t number) const
    {
        Vector distance = nothing();
        forEachSide(network_.contacts[number], [&](std::size_t node, int sign) {
            distance += Number(sign) * displacement(node);
        });
        for (const auto& [bar, factor] : driftsOf(network_, number)) {
            distance[drifts_ + static_cast<Eigen::Index>(bar)] += Number(factor);
        }
        return distance;
    }

    /// Distances and pushes of one contact, block after block of its clock.
    void follow(std::size_t number)
    {
        const NetworkContact& contact = network_.contacts[number];
        Vector distance = distanceAt(number);
        const std::size_t last = blocks_.types().size() - 1;
        bool was = contains(blocks_.closed(last, blocks_.turns() - 1), number);
        for (std::int64_t turn = 0; turn < blocks_.turns(); ++turn) {
            for (std::size_t type = 0; type <= last; ++type) {
                const ContactSet closed = blocks_.closed(type, turn);
                const auto& law = laws_.of(closed);
                const bool is = contains(closed, number);
                if (!was) {
                    auto& list = is ? equalities_ : inequalities_;
                    list.push_back({distance,
                                    -asNumber<Number>(contact.gap),
                                    {Kind::place, number, type, turn}});
                }
                const auto width = static_cast<double>(blocks_.types()[type].width);
                if (is) {
                    Vector push = nothing();
                    add(push, law.push(number), contact.node, type, turn, Number(1));
                    rows_.impulse += width * push.head(inputs_);
                    inequalities_.push_back({push, Number(0), {Kind::push, number, type, turn}});
                } else {
                    forEachSide(contact, [&](std::size_t node, int sign) {
                        add(distance, law.velocity(node), node, type, turn, Number(sign) * width);
                    });
                }
                was = is;
            }
        }
    }

    /// Distances that close tie bars that drift to others or to the ground: as many as it takes.
    [[nodiscard]] std::vector<Made> takeTied()
    {
        std::vector<Made> tied;
        std::vector<std::size_t> tree(bars_.size() + 1);  // bars tied together, last the ground
        std::iota(tree.begin(), tree.end(), std::size_t{0});
        const auto isTaken = [&](Made& made) {
            const auto drifts = driftsOf(network_, made.of.contact);
            const std::size_t one = drifts.empty() ? tree.back() : tree[drifts.front().first];
            const std::size_t other = drifts.size() < 2 ? tree.back() : tree[drifts.back().first];
            if (one == other) {
                return false;
            }
            std::replace(tree.begin(), tree.end(), other, one);
            tied.push_back(std::move(made));
            return true;
        };
        std::vector<Made> kept;
        for (Made& made : equalities_) {
            if (!isTaken(made)) {
                kept.push_back(std::move(made));
            }
        }
        equalities_ = std::move(kept);
        for (std::size_t k = 0; k < bars_.size(); ++k) {
            if (tree[k] != tree.back()) {
                throwFault(
                    "bar", bars_[k] + 1,
                    "bars that drift with contacts that close and tie them to what is held: the "
                    "place of this one is not told by the schedule");
            }
        }
        return tied;
    }

    /// Once bars that drift have gone where what closes wants them.
    void leaveDriftsOut()
    {
        if (bars_.empty()) {
            return;
        }
        const std::vector<Made> tied = takeTied();
        const auto count = static_cast<Eigen::Index>(tied.size());
        Eigen::MatrixXd signs(count, count);        // +-1 and 0
        MatrixOf<Number> rows(count, drifts_ + 1);  // the last column: right sides
        for (Eigen::Index k = 0; k < count; ++k) {
            const Made& made = tied[static_cast<std::size_t>(k)];
            signs.row(k) = made.row.tail(count).transpose().template cast<double>();
            rows.row(k) << made.row.head(drifts_).transpose(), made.rhs;
            rows_.tied.push_back(made.of);
        }
        rows_.driftBy = -FullFactors(signs).inverse();
        rows = product<Number>(rows_.driftBy.template cast<Number>(), rows);
        for (auto* list : {&equalities_, &inequalities_}) {
            for (Made& made : *list) {
                const MatrixOf<Number> by = product<Number>(made.row.tail(count).transpose(), rows);
                made.row.head(drifts_) += by.leftCols(drifts_).transpose();
                made.rhs += by(0, drifts_);
                made.row.tail(count).setZero();
            }
        }
    }

    void addTies()
    {
        std::size_t number = 0;
        const auto tie = [&](const Vector& row) {
            equalities_.push_back({row, Number(0), {Kind::tie, number++, 0, 0}});
        };
        for (std::size_t node = 0; node < network_.nodes.size(); ++node) {
            if (network_.nodes[node].isClamped && displacementOf(network_, node).clamp != node) {
                tie(displacement(node));
            }
        }
        for (std::size_t k = 0; k < network_.stubs.size(); ++k) {
            const std::size_t node = network_.stubs[k].node;
            if (network_.stubs[k].kind == StubKind::spring &&
                displacementOf(network_, node).spring != k) {
                Vector row = displacement(node);
                addWaves(row, {{{2 * network_.rows.size() + k, Number(1)}}}, 0, 0, Number(1));
                tie(row);
            }
        }
    }

    /// In a period a bar that drifts comes back.
    void addWays()
    {
        for (std::size_t k = 0; k < bars_.size(); ++k) {
            const std::size_t node = network_.bars[bars_[k]].firstNode;
            Vector way = nothing();
            for (std::size_t type = 0; type < blocks_.types().size(); ++type) {
                const auto width = static_cast<double>(blocks_.types()[type].width);
                for (std::int64_t turn = 0; turn < blocks_.turns(); ++turn) {
                    add(way, laws_.of(blocks_.closed(type, turn)).velocity(node), node, type, turn,
                        width);
                }
            }
            equalities_.push_back({way, Number(0), {Kind::drift, k, 0, 0}});
        }
    }

    /// No work on waves that nothing damps, where something could do some.
    void addWork()
    {
        double forces = 0.0;
        for (const NetworkNode& node : network_.nodes) {
            forces += std::abs(node.force);
        }
        for (std::size_t type = 0; type < kernel_.work.size(); ++type) {
            const auto& work = kernel_.work[type];
            for (Eigen::Index k = 0; k < work.rows(); ++k) {
                Vector row = nothing();
                row.segment(inputs_, work.cols()) = work.row(k).transpose();
                Number& steady = row[drifts_ - 1];
                const bool isWork =
                    kernel_.hasForces && std::abs(static_cast<double>(steady)) > 1e-11 * forces;
                if (kernel_.hasForces && !isWork) {
                    steady = 0;
                }
                if (isWork || !kernel_.shapes.empty()) {
                    equalities_.push_back({row, Number(0), {Kind::work, 0, type, k}});
                }
            }
        }
    }

    /// Constant forces go to the right; what is left of numbers that cancel is 0.
    NetworkRows<Number> assembled()
    {
        using std::abs;
        RowSystemOf<Number>& system = rows_.system;
        system.equalities = static_cast<Eigen::Index>(equalities_.size());
        const auto count = system.equalities + static_cast<Eigen::Index>(inequalities_.size());
        const auto shapes = static_cast<Eigen::Index>(kernel_.shapes.size());
        system.rows.resize(count, inputs_);
        system.rhs.resize(count);
        rows_.driven.resize(count, shapes);
        Eigen::Index next = 0;
        for (const auto* list : {&equalities_, &inequalities_}) {
            for (const Made& made : *list) {
                for (Eigen::Index k = 0; k < inputs_; ++k) {
                    const Number size = abs(made.row[k]);
                    const bool isNone = size <= cancelled<Number>;
                    rows_.isClear = rows_.isClear && !(isNone && size > surelyNone);
                    system.rows(next, k) = isNone ? Number(0) : made.row[k];
                }
                rows_.driven.row(next) = made.row.segment(inputs_, shapes).transpose();
                system.rhs[next] = made.rhs;
                if (kernel_.hasForces) {
                    system.rhs[next] -= made.row[drifts_ - 1];
                }
                ++next;
                rows_.conditions.push_back(made.of);
            }
        }
        clearRightSides();
        return std::move(rows_);
    }

    /// Of what forces and places of bars that drift make, relative to the largest of the kind.
    void clearRightSides()
    {
        if (!kernel_.hasForces && bars_.empty()) {
            return;
        }
        using std::abs;
        std::array<Number, 2> most{0, 0};
        const auto kindOf = [this](Eigen::Index k) {
            return rows_.conditions[static_cast<std::size_t>(k)].kind == Kind::push ? 1U : 0U;
        };
        for (const NetworkNode& node : network_.nodes) {
            most[1] += abs(Number(node.force));
        }
        VectorOf<Number>& rhs = rows_.system.rhs;
        for (Eigen::Index k = 0; k < rhs.size(); ++k) {
            most[kindOf(k)] = std::max<Number>(most[kindOf(k)], abs(rhs[k]));
        }
        for (Eigen::Index k = 0; k < rhs.size(); ++k) {
            rhs[k] = abs(rhs[k]) <= cancelled<Number> * most[kindOf(k)] ? Number(0) : rhs[k];
        }
    }

    const NetworkBlocks& blocks_;
    const Network& network_;
    const NetworkKernel<Number>& kernel_;
    std::vector<std::size_t> bars_;  ///< that drift
    NetworkLaws<Number> laws_;
    Eigen::Index inputs_;  ///< the first column of inputs
    Eigen::Index drifts_;  ///< and of displacements that drift
    std::vector<Made> equalities_;
    std::vector<Made> inequalities_;
    NetworkRows<Number> rows_;
};

}  // namespace

template <typename Number>
NetworkRows<Number> rowsOf(const NetworkBlocks& blocks, const NetworkKernel<Number>& kernel)
{
    return RowMaker<Number>(blocks, kernel).run();
}

template NetworkRows<double> rowsOf(const NetworkBlocks&, const NetworkKernel<double>&);
template NetworkRows<FineNumber> rowsOf(const NetworkBlocks&, const NetworkKernel<FineNumber>&);

}  // namespace signorini
