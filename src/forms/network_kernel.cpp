#include "network_kernel.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace signorini {

namespace {

template <typename Number>
constexpr double cancelled = isFine<Number> ? 1e-35 : 1e-11;  // of a sum of waves of size 1
constexpr double surelyNone = 3e-15;  // what is smaller is rounding of doubles
/// Rows of waves are added to each other.
template <typename Number>
using WaveRows = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The laws of a schedule, each made once.
template <typename Number>
class Laws {
public:
    explicit Laws(const Network& network) : network_(network) {}

    const NetworkLaw<Number>& of(ContactSet closed)
    {
        return laws_.try_emplace(closed, network_, closed).first->second;
    }

private:
    const Network& network_;
    std::map<ContactSet, NetworkLaw<Number>> laws_;
};

/// The waves of one type over a period and a state, as functions of the state.
template <typename Number>
class Propagation {
public:
    Propagation(const NetworkBlocks& blocks, std::size_t type, Laws<Number>& laws)
        : blocks_(blocks), size_(blocks.stateSize())
    {
        Eigen::Index first = 0;
        for (std::size_t channel = 0; channel < blocks.network().channels(); ++channel) {
            const Eigen::Index delay = blocks.delay(channel);
            WaveRows<Number>& wave = waves_.emplace_back(blocks.turns() + delay, size_);
            wave.topRows(delay).setZero();
            wave.block(0, first, delay, delay).setIdentity();
            first += delay;
        }
        for (std::int64_t turn = 0; turn < blocks.turns(); ++turn) {
            step(laws.of(blocks.closed(type, turn)), turn);
        }
    }

    /// What arrives in a channel, turn after turn.
    [[nodiscard]] const WaveRows<Number>& wave(std::size_t channel) const
    {
        return waves_[channel];
    }

    /// W - 1 in the norm of the energy, and below it the velocities of nodes with a dashpot: what
    /// repeats leaves them at rest. W - 1 alone says so with the square of a velocity only.
    [[nodiscard]] MatrixOf<Number> change() const
    {
        const auto damped = static_cast<Eigen::Index>(damped_.size());
        const VectorOf<Number> scale = scales();
        MatrixOf<Number> change(size_ + damped, size_);
        Eigen::Index first = 0;
        for (std::size_t channel = 0; channel < waves_.size(); ++channel) {
            const Eigen::Index delay = blocks_.delay(channel);
            change.middleRows(first, delay) = waves_[channel].bottomRows(delay);
            first += delay;
        }
        for (Eigen::Index k = 0; k < damped; ++k) {
            change.row(size_ + k) = damped_[static_cast<std::size_t>(k)];
        }
        change.topRows(size_) = scale.asDiagonal() * change.topRows(size_);
        change = change * scale.cwiseInverse().asDiagonal();
        change.topRows(size_).diagonal().array() -= Number(1);
        return change;
    }

    /// sqrt(Z) of each wave of the state.
    [[nodiscard]] VectorOf<Number> scales() const
    {
        using std::sqrt;
        VectorOf<Number> scale(size_);
        Eigen::Index first = 0;
        for (std::size_t channel = 0; channel < waves_.size(); ++channel) {
            const Eigen::Index delay = blocks_.delay(channel);
            scale.segment(first, delay)
                .setConstant(sqrt(asNumber<Number>(blocks_.network().impedanceOf(channel))));
            first += delay;
        }
        return scale;
    }

private:
    /// From right to left: what nodes send to the left arrives at once.
    void step(const NetworkLaw<Number>& law, std::int64_t turn)
    {
        const auto& scatterers = law.scatterers();
        for (auto node = scatterers.rbegin(); node != scatterers.rend(); ++node) {
            WaveRows<Number> v = WaveRows<Number>::Zero(1, size_);
            for (const auto& branch : node->branches) {
                if (branch.weight != 0) {
                    v += branch.weight * waves_[branch.channel].row(turn);
                }
            }
            if (!node->nodes.held && isDamped(node->nodes)) {
                damped_.push_back(v);
            }
            for (const auto& branch : node->branches) {
                waves_[branch.entered].row(turn + blocks_.delay(branch.entered)) =
                    branch.sign * (v - waves_[branch.channel].row(turn));
            }
        }
    }

    [[nodiscard]] bool isDamped(const Cluster& nodes) const
    {
        const auto first = blocks_.network().nodes.begin();
        return std::any_of(first + static_cast<std::ptrdiff_t>(nodes.firstNode),
                           first + static_cast<std::ptrdiff_t>(nodes.lastNode) + 1,
                           [](const NetworkNode& node) { return node.dashpot > 0.0; });
    }

    const NetworkBlocks& blocks_;
    Eigen::Index size_;
    std::vector<WaveRows<Number>> waves_;
    std::vector<WaveRows<Number>> damped_;
};

/// An orthonormal basis of the kernel.
template <typename Number>
MatrixOf<Number> kernelBasis(const MatrixOf<Number>& change, double zero, bool& isClear)
{
    using std::abs;
    const Eigen::Index size = change.cols();
    const double none = isFine<Number> ? 1e-40 : noPivot;
    const double clear = isFine<Number> ? 1e-25 : clearPivot;
    // The rows of change^T = Q R P^T: what Q has beyond the rank is orthogonal to its columns.
    const Eigen::ColPivHouseholderQR<MatrixOf<Number>> factors(change.transpose());
    Eigen::Index rank = 0;
    for (Eigen::Index k = 0; k < size; ++k) {
        const Number pivot = abs(factors.matrixR()(k, k));
        rank += pivot > (isFine<Number> ? none : zero) ? 1 : 0;
        isClear = isClear && !(pivot > none && pivot < clear);
    }
    MatrixOf<Number> basis = MatrixOf<Number>::Zero(size, size - rank);
    basis.bottomRows(size - rank).setIdentity();
    return factors.householderQ() * basis;
}

/// Collects rows.
template <typename Number>
class RowMaker {
    using Vector = VectorOf<Number>;

public:
    RowMaker(const NetworkBlocks& blocks, const NetworkKernel<Number>& kernel)
        : blocks_(blocks), kernel_(kernel), laws_(blocks.network()), first_{0}
    {
        for (const auto& waves : kernel.waves) {
            first_.push_back(first_.back() + waves.cols());
        }
        rows_.impulse = Vector::Zero(first_.back());
    }

    NetworkRows<Number> run()
    {
        for (std::size_t contact = 0; contact < blocks_.network().contacts.size(); ++contact) {
            follow(contact);
        }
        addTies();
        return assembled();
    }

private:
    struct Made {
        Vector row;
        Number rhs;
        BlockCondition of;
    };

    [[nodiscard]] Vector nothing() const { return Vector::Zero(first_.back()); }

    /// Adds a form in what arrives in a block.
    void add(Vector& to, const LinearForm<Number>& form, std::size_t type, std::int64_t turn,
             const Number& factor) const
    {
        const auto& waves = kernel_.waves[type];
        for (const auto& term : form.terms) {
            to.segment(first_[type], waves.cols()) +=
                (factor * term.coefficient) *
                waves.row(static_cast<Eigen::Index>(term.channel) * blocks_.turns() + turn)
                    .transpose();
        }
    }

    /// u of a node when its clock begins; along a row it falls by what arrives at its right end.
    [[nodiscard]] Vector displacement(std::size_t node) const
    {
        const DisplacementForm form = displacementOf(blocks_.network(), node);
        Vector u = nothing();
        for (const auto& [row, sign] : form.rows) {
            for (std::size_t type = 0; type < kernel_.waves.size(); ++type) {
                const Number width = static_cast<double>(-sign * blocks_.types()[type].width);
                for (std::int64_t k = 0; k < blocks_.delay(2 * row); ++k) {
                    add(u, {{{2 * row, Number(1)}}}, type, k % blocks_.turns(), width);
                }
            }
        }
        if (form.spring) {
            add(u, {{{2 * blocks_.network().rows.size() + *form.spring, Number(1)}}}, 0, 0,
                Number(-1));
        }
        return u;
    }

    /// Distances and pushes of one contact, block after block of its clock.
    void follow(std::size_t number)
    {
        const NetworkContact& contact = blocks_.network().contacts[number];
        const bool isGap = contact.kind == ContactKind::gap;
        const Number sign = contact.kind == ContactKind::stopLeft ? 1 : -1;
        Vector distance = sign * displacement(contact.node);
        if (isGap) {
            distance += displacement(contact.node + 1);
        }
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
                                    {BlockCondition::Kind::place, number, type, turn}});
                }
                const Number width = static_cast<double>(blocks_.types()[type].width);
                if (is) {
                    Vector push = nothing();
                    add(push, law.push(number), type, turn, Number(1));
                    rows_.impulse += width * push;
                    inequalities_.push_back(
                        {push, Number(0), {BlockCondition::Kind::push, number, type, turn}});
                } else {
                    add(distance, law.velocity(contact.node), type, turn, sign * width);
                    if (isGap) {
                        add(distance, law.velocity(contact.node + 1), type, turn, width);
                    }
                }
                was = is;
            }
        }
    }

    void addTies()
    {
        const Network& network = blocks_.network();
        std::size_t number = 0;
        const auto tie = [&](const Vector& row) {
            equalities_.push_back({row, Number(0), {BlockCondition::Kind::tie, number++, 0, 0}});
        };
        for (std::size_t node = 0; node < network.nodes.size(); ++node) {
            if (network.nodes[node].isClamped && displacementOf(network, node).clamp != node) {
                tie(displacement(node));
            }
        }
        for (std::size_t k = 0; k < network.stubs.size(); ++k) {
            const std::size_t node = network.stubs[k].node;
            if (network.stubs[k].kind == StubKind::spring &&
                displacementOf(network, node).spring != k) {
                Vector row = displacement(node);
                add(row, {{{2 * network.rows.size() + k, Number(1)}}}, 0, 0, Number(1));
                tie(row);
            }
        }
    }

    /// What is left of coefficients that cancel is no coefficient.
    NetworkRows<Number> assembled()
    {
        using std::abs;
        RowSystemOf<Number>& system = rows_.system;
        system.equalities = static_cast<Eigen::Index>(equalities_.size());
        const auto count = system.equalities + static_cast<Eigen::Index>(inequalities_.size());
        system.rows.resize(count, first_.back());
        system.rhs.resize(count);
        Eigen::Index next = 0;
        for (const auto* list : {&equalities_, &inequalities_}) {
            for (const Made& made : *list) {
                for (Eigen::Index k = 0; k < made.row.size(); ++k) {
                    const Number size = abs(made.row[k]);
                    const bool isNone = size <= cancelled<Number>;
                    rows_.isClear = rows_.isClear && !(isNone && size > surelyNone);
                    system.rows(next, k) = isNone ? Number(0) : made.row[k];
                }
                system.rhs[next++] = made.rhs;
                rows_.conditions.push_back(made.of);
            }
        }
        return std::move(rows_);
    }

    const NetworkBlocks& blocks_;
    const NetworkKernel<Number>& kernel_;
    Laws<Number> laws_;
    std::vector<Eigen::Index> first_;  ///< coordinate of each type
    std::vector<Made> equalities_;
    std::vector<Made> inequalities_;
    NetworkRows<Number> rows_;
};

}  // namespace

template <typename Number>
Eigen::Index NetworkKernel<Number>::coordinates() const
{
    Eigen::Index all = 0;
    for (const auto& part : waves) {
        all += part.cols();
    }
    return all;
}

template <typename Number>
std::optional<NetworkKernel<Number>> kernelOf(const NetworkBlocks& blocks, double zero)
{
    constexpr std::int64_t mostValues = 40'000'000;
    const std::int64_t size = blocks.stateSize();
    const auto channels = static_cast<Eigen::Index>(blocks.network().channels());
    const Eigen::Index turns = blocks.turns();
    if (size > (isFine<Number> ? mostFineState : mostKernelState) ||
        channels * turns + size > mostValues / size) {
        return std::nullopt;
    }
    Laws<Number> laws(blocks.network());
    NetworkKernel<Number> kernel;
    for (std::size_t type = 0; type < blocks.types().size(); ++type) {
        using std::sqrt;
        const Propagation<Number> propagation(blocks, type, laws);
        const MatrixOf<Number> basis = kernelBasis(propagation.change(), zero, kernel.isClear);
        const Number width = static_cast<double>(blocks.types()[type].width);
        const MatrixOf<Number> states =
            (sqrt(width) * propagation.scales()).cwiseInverse().asDiagonal() * basis;
        MatrixOf<Number>& waves = kernel.waves.emplace_back(channels * turns, basis.cols());
        for (Eigen::Index channel = 0; channel < channels; ++channel) {
            waves.middleRows(channel * turns, turns) =
                propagation.wave(static_cast<std::size_t>(channel)).topRows(turns) * states;
        }
        kernel.dimension += blocks.types()[type].width * basis.cols();
    }
    return kernel;
}

template <typename Number>
NetworkRows<Number> rowsOf(const NetworkBlocks& blocks, const NetworkKernel<Number>& kernel)
{
    return RowMaker<Number>(blocks, kernel).run();
}

template <typename Number>
std::vector<double> wavesAt(const NetworkBlocks& blocks, const NetworkKernel<Number>& kernel,
                            const VectorOf<Number>& z)
{
    std::vector<VectorOf<Number>> arriving;
    Eigen::Index first = 0;
    for (const auto& waves : kernel.waves) {
        arriving.push_back(waves * z.segment(first, waves.cols()));
        first += waves.cols();
    }
    const auto at = [&](std::size_t channel, std::int64_t step) {
        const auto [type, turn] = blocks.placeOf(blocks.network().nodeOf(channel), step);
        return static_cast<double>(
            arriving[type][static_cast<Eigen::Index>(channel) * blocks.turns() + turn]);
    };
    std::vector<double> all;
    all.reserve(blocks.network().waves());
    const std::vector<CellRow>& rows = blocks.network().rows;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        for (std::int64_t cell = rows[row].cells; cell-- > 0;) {
            all.push_back(at(2 * row, cell));
        }
        for (std::int64_t cell = 0; cell < rows[row].cells; ++cell) {
            all.push_back(at(2 * row + 1, cell));
        }
    }
    for (std::size_t channel = 2 * rows.size(); channel < blocks.network().channels(); ++channel) {
        all.push_back(at(channel, 0));
    }
    return all;
}

EnergyFloor conditionsOf(const NetworkBlocks& blocks, const std::vector<BlockCondition>& conditions,
                         const Eigen::VectorXd& multipliers)
{
    EnergyFloor floor;
    for (std::size_t k = 0; k < conditions.size(); ++k) {
        const auto& [kind, contact, type, turn] = conditions[k];
        const double value = multipliers[static_cast<Eigen::Index>(k)];
        if (value == 0.0 || kind == BlockCondition::Kind::tie) {
            continue;  // of ties any multiple may be taken away
        }
        const std::size_t node = blocks.network().contacts[contact].node;
        const std::int64_t step = blocks.stepOf(node, type, turn);
        if (kind == BlockCondition::Kind::place) {
            floor.places.push_back({contact, step, value});
            continue;
        }
        const std::int64_t width = blocks.types()[type].width;
        const std::int64_t steps = blocks.unit() * blocks.turns();
        for (std::int64_t residue = 0; residue < width; ++residue) {
            floor.pushes.push_back(
                {contact, (step + residue) % steps, value / static_cast<double>(width)});
        }
    }
    const auto inOrder = [](const ContactMultiplier& x, const ContactMultiplier& y) {
        return std::pair(x.step, x.contact) < std::pair(y.step, y.contact);
    };
    std::sort(floor.places.begin(), floor.places.end(), inOrder);
    std::sort(floor.pushes.begin(), floor.pushes.end(), inOrder);
    return floor;
}

#define SIGNORINI_KERNEL_OF(Number)                                                          \
    template struct NetworkKernel<Number>;                                                   \
    template std::optional<NetworkKernel<Number>> kernelOf(const NetworkBlocks&, double);    \
    template NetworkRows<Number> rowsOf(const NetworkBlocks&, const NetworkKernel<Number>&); \
    template std::vector<double> wavesAt(const NetworkBlocks&, const NetworkKernel<Number>&, \
                                         const VectorOf<Number>&);
SIGNORINI_KERNEL_OF(double)
SIGNORINI_KERNEL_OF(FineNumber)
#undef SIGNORINI_KERNEL_OF

}  // namespace signorini
