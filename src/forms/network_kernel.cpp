#include "network_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace signorini {

namespace {

constexpr double leastPivot = 1e-10;             // of 1 - W; below it driven waves are a guess
constexpr std::int64_t mostValues = 40'000'000;  // kept of waves

bool hasDashpot(const NetworkNode& node)
{
    return node.dashpot > 0.0;
}

/// What is kept of a propagation.
enum class Kept {
    end,      ///< the last state
    dampers,  ///< and velocities of nodes with a dashpot
    all,      ///< what arrives in each turn
};

/// The waves of one type over a period, from states, a column each; the inputs drive the last ones.
template <typename Number>
class Propagation {
    /// Rows of waves are added to each other.
    using WaveRows = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

public:
    Propagation(const NetworkBlocks& blocks, std::size_t type, NetworkLaws<Number>& laws,
                const NetworkKernel<Number>& inputs, const MatrixOf<Number>& start, Kept kept)
        : blocks_(blocks), type_(type), inputs_(inputs), columns_(start.cols()), kept_(kept)
    {
        Eigen::Index first = 0;
        for (std::size_t channel = 0; channel < blocks.network().channels(); ++channel) {
            const Eigen::Index delay = blocks.delay(channel);
            waves_.emplace_back((kept == Kept::all ? blocks.turns() : 1) + delay, columns_);
            waves_.back().topRows(delay) = start.middleRows(first, delay);
            first += delay;
        }
        for (std::int64_t turn = 0; turn < blocks.turns(); ++turn) {
            step(laws.of(blocks.closed(type, turn)), turn);
        }
    }

    /// What arrives in a channel, turn after turn.
    [[nodiscard]] auto arrived(std::size_t channel) const
    {
        return waves_[channel].topRows(blocks_.turns());
    }
    /// The states after the period.
    [[nodiscard]] MatrixOf<Number> end() const
    {
        MatrixOf<Number> states(blocks_.stateSize(), columns_);
        Eigen::Index next = 0;
        for (std::size_t channel = 0; channel < waves_.size(); ++channel) {
            for (std::int64_t k = 0; k < blocks_.delay(channel); ++k) {
                states.row(next++) = waves_[channel].row(at(channel, blocks_.turns() + k));
            }
        }
        return states;
    }
    [[nodiscard]] const std::vector<WaveRows>& damped() const { return damped_; }

private:
    [[nodiscard]] Eigen::Index at(std::size_t channel, std::int64_t turn) const
    {
        return turn % waves_[channel].rows();
    }

    /// From right to left: what nodes send to the left arrives at once.
    void step(const NetworkLaw<Number>& law, std::int64_t turn)
    {
        const auto& scatterers = law.scatterers();
        for (auto node = scatterers.rbegin(); node != scatterers.rend(); ++node) {
            WaveRows v = WaveRows::Zero(1, columns_);
            for (const auto& branch : node->branches) {
                if (branch.weight != 0) {
                    v += branch.weight * waves_[branch.channel].row(at(branch.channel, turn));
                }
            }
            if (kept_ == Kept::dampers && !node->nodes.held && isDamped(node->nodes)) {
                damped_.push_back(v);
            }
            drive(v, *node, turn);
            for (const auto& branch : node->branches) {
                const std::int64_t later = turn + blocks_.delay(branch.entered);
                waves_[branch.entered].row(at(branch.entered, later)) =
                    branch.sign * (v - waves_[branch.channel].row(at(branch.channel, turn)));
            }
        }
    }

    void drive(WaveRows& v, const typename NetworkLaw<Number>::Scatterer& node,
               std::int64_t turn) const
    {
        const auto& pulled = node.velocity;
        const auto step =
            static_cast<std::size_t>(blocks_.stepOf(node.nodes.firstNode, type_, turn));
        Eigen::Index column = columns_ - inputs_.inputs();
        for (const StepDrive& shape : inputs_.shapes) {
            v(0, column++) += pulled.perForce * Number(shape.forces[step]) +
                              pulled.perBase * Number(shape.velocities[step]);
        }
        if (inputs_.hasForces) {
            v(0, column) += pulled.constant;
        }
    }

    [[nodiscard]] bool isDamped(const Cluster& nodes) const
    {
        const NetworkNode* const all = blocks_.network().nodes.data();
        return std::any_of(all + nodes.firstNode, all + nodes.lastNode + 1, hasDashpot);
    }

    const NetworkBlocks& blocks_;
    std::size_t type_;
    const NetworkKernel<Number>& inputs_;
    Eigen::Index columns_;
    Kept kept_;
    std::vector<WaveRows> waves_;  ///< by channel, as many turns as are kept
    std::vector<WaveRows> damped_;
};

/// sqrt(Z) of each wave of the state.
template <typename Number>
VectorOf<Number> scalesOf(const NetworkBlocks& blocks)
{
    using std::sqrt;
    VectorOf<Number> scale(blocks.stateSize());
    Eigen::Index first = 0;
    for (std::size_t channel = 0; channel < blocks.network().channels(); ++channel) {
        const Eigen::Index delay = blocks.delay(channel);
        scale.segment(first, delay)
            .setConstant(sqrt(asNumber<Number>(blocks.network().impedanceOf(channel))));
        first += delay;
    }
    return scale;
}

/// Fine numbers have no factors of their own for square matrices.
template <typename Number>
using Factors = std::conditional_t<isFine<Number>, OrthogonalFactors<Number>, SquareFactors>;

/// An orthonormal basis of the kernel.
template <typename Number>
MatrixOf<Number> kernelBasis(const MatrixOf<Number>& change, double zero, bool& isClear)
{
    const Eigen::Index size = change.cols();
    const double none = isFine<Number> ? 1e-40 : noPivot;
    const double clear = isFine<Number> ? 1e-25 : clearPivot;
    // The rows of change^T = Q R P^T: what Q has beyond the rank is orthogonal to its columns.
    const OrthogonalFactors<Number> factors(change.transpose());
    Eigen::Index rank = 0;
    for (Eigen::Index k = 0; k < size; ++k) {
        const Number pivot = factors.pivot(k);
        rank += pivot > (isFine<Number> ? none : zero) ? 1 : 0;
        isClear = isClear && !(pivot > none && pivot < clear);
    }
    return factors.beyond(rank);
}

template <typename Number>
bool isRegular(const Factors<Number>& factors, Eigen::Index size, double least)
{
    if constexpr (isFine<Number>) {
        bool isClear = true;
        for (Eigen::Index k = 0; k < size; ++k) {
            isClear = isClear && factors.pivot(k) > 1e-25;
        }
        return isClear;
    } else {
        return factors.leastPivot() > least && factors.rcond() > least;
    }
}

/// The kernel, type after type.
template <typename Number>
class KernelFinder {
    using Matrix = MatrixOf<Number>;

public:
    KernelFinder(const NetworkBlocks& blocks, double zero, const std::vector<StepDrive>& shapes)
        : blocks_(blocks),
          zero_(zero),
          laws_(blocks.network()),
          scale_(scalesOf<Number>(blocks)),
          isDamped_(
              std::any_of(blocks.network().nodes.begin(), blocks.network().nodes.end(), hasDashpot))
    {
        kernel_.shapes = shapes;
        kernel_.hasForces = !(withoutForces(blocks.network()) == blocks.network());
    }

    std::optional<NetworkKernel<Number>> run()
    {
        for (std::size_t type = 0; type < blocks_.types().size(); ++type) {
            if (!add(type)) {
                return std::nullopt;
            }
        }
        return std::move(kernel_);
    }

private:
    [[nodiscard]] Propagation<Number> propagated(std::size_t type, const Matrix& start, Kept kept)
    {
        return {blocks_, type, laws_, kernel_, start, kept};
    }

    /// 1 - W in the norm of the energy, of all types that close the same contacts turn by turn.
    struct Period {
        std::vector<ContactSet> closed;
        Matrix basis;                            ///< of the kernel
        std::optional<Factors<Number>> factors;  ///< of 1 - W, regular on the kernel, too
        bool isWhole = false;                    ///< nothing repeats undriven
    };

    [[nodiscard]] std::vector<ContactSet> closedIn(std::size_t type) const
    {
        std::vector<ContactSet> closed;
        closed.reserve(static_cast<std::size_t>(blocks_.turns()));
        for (std::int64_t turn = 0; turn < blocks_.turns(); ++turn) {
            closed.push_back(blocks_.closed(type, turn));
        }
        return closed;
    }

    void factor(std::size_t type)
    {
        const Eigen::Index size = blocks_.stateSize();
        const bool isDriven = kernel_.inputs() > 0;
        Matrix start = Matrix::Zero(size, size + kernel_.inputs());
        start.leftCols(size).setIdentity();
        Matrix rest = propagated(type, start, Kept::end).end().leftCols(size);
        rest = -(scale_.asDiagonal() * rest) * scale_.cwiseInverse().asDiagonal();
        rest.diagonal().array() += Number(1);
        if (isDamped_ || isDriven) {
            period_.factors.emplace(rest);
        }
        period_.isWhole = period_.factors && isRegular<Number>(*period_.factors, size, clearPivot);
        period_.basis = period_.isWhole ? Matrix(size, 0) : basisOf(type, rest, start);
        if (isDriven && !period_.isWhole) {
            period_.factors.emplace(rest +
                                    product<Number>(period_.basis, period_.basis.transpose()));
        }
        if (isDriven) {
            kernel_.isClear =
                kernel_.isClear && isRegular<Number>(*period_.factors, size, leastPivot);
        }
    }

    /// False if there is too much of it.
    bool add(std::size_t type)
    {
        if (std::vector<ContactSet> closed = closedIn(type); closed != period_.closed) {
            period_ = {std::move(closed), {}, {}, false};
            factor(type);
        }
        const Eigen::Index size = blocks_.stateSize();
        const Eigen::Index inputs = kernel_.inputs();
        const Matrix& basis = period_.basis;
        const auto channels = static_cast<std::int64_t>(blocks_.network().channels());
        kept_ += (channels * blocks_.turns() + size) * (basis.cols() + inputs);
        if (kept_ > mostValues) {
            return false;
        }
        using std::sqrt;
        const Number width = sqrt(Number(static_cast<double>(blocks_.types()[type].width)));
        Matrix states(size, basis.cols() + inputs);
        states.leftCols(basis.cols()) = basis / width;
        if (inputs > 0) {
            const Matrix made =
                scale_.asDiagonal() * propagated(type, Matrix::Zero(size, inputs), Kept::end).end();
            const Matrix work = product<Number>(basis.transpose(), made);
            states.rightCols(inputs) = period_.factors->solve(made - product<Number>(basis, work));
            kernel_.work.push_back(width * work);
        }
        if constexpr (!isFine<Number>) {
            if (period_.isWhole) {
                kernel_.factors.push_back(*period_.factors);
            }
        }
        keep(type, basis.cols(), scale_.cwiseInverse().asDiagonal() * states);
        return true;
    }

    /// What repeats leaves nodes with a dashpot at rest: W - 1 alone says so with the square of a
    /// velocity only.
    [[nodiscard]] Matrix basisOf(std::size_t type, const Matrix& rest, const Matrix& start)
    {
        const Eigen::Index size = rest.cols();
        Matrix change = -rest;
        if (isDamped_) {
            const Propagation<Number> again = propagated(type, start, Kept::dampers);
            const auto count = static_cast<Eigen::Index>(again.damped().size());
            change.conservativeResize(size + count, size);
            for (Eigen::Index k = 0; k < count; ++k) {
                change.row(size + k) = again.damped()[static_cast<std::size_t>(k)].leftCols(size) *
                                       scale_.cwiseInverse().asDiagonal();
            }
        }
        return kernelBasis(change, zero_, kernel_.isClear);
    }

    void keep(std::size_t type, Eigen::Index coordinates, const Matrix& states)
    {
        const Propagation<Number> kept = propagated(type, states, Kept::all);
        const Eigen::Index turns = blocks_.turns();
        const auto channels = static_cast<Eigen::Index>(blocks_.network().channels());
        Matrix& waves = kernel_.waves.emplace_back(channels * turns, coordinates);
        Matrix& driven = kernel_.driven.emplace_back(channels * turns, kernel_.inputs());
        for (Eigen::Index channel = 0; channel < channels; ++channel) {
            const auto arrived = kept.arrived(static_cast<std::size_t>(channel));
            waves.middleRows(channel * turns, turns) = arrived.leftCols(coordinates);
            driven.middleRows(channel * turns, turns) = arrived.rightCols(kernel_.inputs());
        }
        kernel_.firsts.push_back(kernel_.coordinates() + coordinates);
        kernel_.dimension += blocks_.types()[type].width * coordinates;
    }

    const NetworkBlocks& blocks_;
    double zero_;
    NetworkLaws<Number> laws_;
    VectorOf<Number> scale_;
    bool isDamped_;
    Period period_;  ///< of the last type
    std::int64_t kept_ = 0;
    NetworkKernel<Number> kernel_;
};

}  // namespace

template <typename Number>
std::optional<NetworkKernel<Number>> kernelOf(const NetworkBlocks& blocks, double zero,
                                              const std::vector<StepDrive>& shapes)
{
    if (blocks.stateSize() > (isFine<Number> ? mostFineState : mostKernelState)) {
        return std::nullopt;
    }
    return KernelFinder<Number>(blocks, zero, shapes).run();
}

template std::optional<NetworkKernel<double>> kernelOf(const NetworkBlocks&, double,
                                                       const std::vector<StepDrive>&);
template std::optional<NetworkKernel<FineNumber>> kernelOf(const NetworkBlocks&, double,
                                                           const std::vector<StepDrive>&);

}  // namespace signorini
