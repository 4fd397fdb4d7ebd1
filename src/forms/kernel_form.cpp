#include <Eigen/QR>
#include <cmath>
#include <utility>

#include "row_list.hpp"
#include "stepped_form.hpp"

namespace signorini {

namespace {

/// The waves of one type over n/G turns and a state, as functions of the state: one row for each
/// r^j_k, k < turns + M_j.
class Propagation {
public:
    Propagation(const SteppedBlocks& blocks, std::size_t type) : blocks_(blocks)
    {
        const Eigen::Index size = blocks.stateSize();
        Eigen::Index first = 0;
        for (const std::int64_t delay : blocks.delays) {
            Eigen::MatrixXd& wave = waves_.emplace_back(blocks.turns + delay, size);
            wave.topRows(delay).setZero();
            wave.block(0, first, delay, delay).setIdentity();
            first += delay;
        }
        for (std::int64_t k = 0; k < blocks.turns; ++k) {
            step(type, k);
        }
    }

    /// r^j_k as a function of the state.
    [[nodiscard]] const Eigen::MatrixXd& wave(std::size_t joint) const { return waves_[joint]; }

    /// W - 1 in the norm of the energy, and below it the velocities of joints with a dashpot: what
    /// repeats leaves them at rest. W - 1 alone says so with the square of a velocity only.
    [[nodiscard]] Eigen::MatrixXd change() const
    {
        const Eigen::Index size = blocks_.stateSize();
        Eigen::MatrixXd change(size, size);
        const Eigen::VectorXd scale = scales();
        Eigen::Index first = 0;
        for (std::size_t j = 0; j < waves_.size(); ++j) {
            const std::int64_t delay = blocks_.delays[j];
            change.middleRows(first, delay) = waves_[j].bottomRows(delay);
            first += delay;
        }
        change = scale.asDiagonal() * change * scale.cwiseInverse().asDiagonal();
        change.diagonal().array() -= 1.0;
        const auto damped = static_cast<Eigen::Index>(dampedVelocities_.size());
        change.conservativeResize(size + damped, size);
        for (Eigen::Index k = 0; k < damped; ++k) {
            change.row(size + k) =
                dampedVelocities_[static_cast<std::size_t>(k)].cwiseQuotient(scale.transpose());
        }
        return change;
    }

    /// sqrt(Z) of each wave of the state.
    [[nodiscard]] Eigen::VectorXd scales() const
    {
        Eigen::VectorXd scale(blocks_.stateSize());
        Eigen::Index first = 0;
        for (std::size_t j = 0; j < waves_.size(); ++j) {
            scale.segment(first, blocks_.delays[j])
                .setConstant(std::sqrt(blocks_.bar.segments[j].impedance));
            first += blocks_.delays[j];
        }
        return scale;
    }

private:
    void step(std::size_t type, std::int64_t k)
    {
        const std::size_t tip = waves_.size() - 1;
        Eigen::RowVectorXd l = blocks_.echoOf(type, k) * waves_[tip].row(k);
        for (std::size_t j = tip; j > 0; --j) {
            const JointWeights& w = blocks_.bar.joints[j - 1];
            const auto r = waves_[j - 1].row(k);
            const Eigen::RowVectorXd v =
                (2.0 / static_cast<double>(w.all)) *
                (static_cast<double>(w.left) * r + static_cast<double>(w.right) * l);
            if (w.all > w.left + w.right) {
                dampedVelocities_.push_back(v);
            }
            waves_[j].row(k + blocks_.delays[j]) = v - l;
            l = v - r;
        }
        waves_[0].row(k + blocks_.delays[0]) = -l;
    }

    const SteppedBlocks& blocks_;
    std::vector<Eigen::MatrixXd> waves_;
    std::vector<Eigen::RowVectorXd> dampedVelocities_;
};

/// An orthonormal basis of the kernel.
Eigen::MatrixXd kernelBasis(const Eigen::MatrixXd& change, double zero, bool& isClear)
{
    const Eigen::Index size = change.cols();
    // The rows of change^T = Q R P^T: what Q has beyond the rank is orthogonal to its columns.
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(change.transpose());
    Eigen::Index rank = 0;
    for (Eigen::Index k = 0; k < size; ++k) {
        const double pivot = std::abs(factors.matrixR()(k, k));
        rank += pivot > zero ? 1 : 0;
        isClear = isClear && !(pivot > noPivot && pivot < clearPivot);
    }
    Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(size, size - rank);
    basis.bottomRows(size - rank).setIdentity();
    return factors.householderQ() * basis;
}

/// A linear function of the unknowns.
using Form = Eigen::VectorXd;

/// What is left of coefficients that cancel is no coefficient: a solver that scales rows would
/// believe it.
Row rowOf(const Form& form)
{
    constexpr double rounding = 1e-11;  // of a sum of waves of size 1
    Row row;
    for (Eigen::Index k = 0; k < form.size(); ++k) {
        if (std::abs(form[k]) > rounding) {
            row.emplace_back(k, form[k]);
        }
    }
    return row;
}

}  // namespace

std::optional<SteppedKernel> kernelOf(const SteppedBlocks& blocks, double zero)
{
    constexpr std::int64_t mostValues = 40'000'000;
    const std::int64_t size = blocks.stateSize();
    const auto segments = static_cast<Eigen::Index>(blocks.delays.size());
    if (size > mostKernelState || segments * blocks.turns + size > mostValues / size) {
        return std::nullopt;
    }
    SteppedKernel kernel;
    for (std::size_t t = 0; t < blocks.types.size(); ++t) {
        const Propagation propagation(blocks, t);
        const Eigen::MatrixXd basis = kernelBasis(propagation.change(), zero, kernel.isClear);
        const Eigen::MatrixXd states = propagation.scales().cwiseInverse().asDiagonal() * basis;
        Eigen::MatrixXd waves(segments * blocks.turns, basis.cols());
        for (Eigen::Index j = 0; j < segments; ++j) {
            waves.middleRows(j * blocks.turns, blocks.turns) =
                propagation.wave(static_cast<std::size_t>(j)).topRows(blocks.turns) * states;
        }
        kernel.waves.push_back(std::move(waves));
        kernel.dimension += blocks.types[t].width * basis.cols();
    }
    return kernel;
}

SteppedProgram kernelForm(const SteppedBlocks& blocks, const SteppedKernel& kernel)
{
    SteppedProgram result;
    std::vector<Eigen::Index> first{0};
    for (const Eigen::MatrixXd& waves : kernel.waves) {
        first.push_back(first.back() + waves.cols());
    }
    const Eigen::Index unknowns = first.back();
    result.program = emptyProgram(unknowns);
    result.impulse.setZero(unknowns);
    result.energyWeights.resize(unknowns);
    const auto cells = static_cast<double>(blocks.bar.cells);
    const auto tip = static_cast<std::int64_t>(blocks.delays.size()) - 1;
    const auto add = [&](Form& form, std::int64_t joint, std::size_t type, std::int64_t turn) {
        form.segment(first[type], kernel.waves[type].cols()) +=
            kernel.waves[type].row(joint * blocks.turns + turn).transpose();
    };

    Form gap = Form::Zero(unknowns);
    for (std::size_t t = 0; t < blocks.types.size(); ++t) {
        result.energyWeights.segment(first[t], kernel.waves[t].cols())
            .setConstant(2.0 / (cells * static_cast<double>(blocks.types[t].width)));
        for (std::size_t i = 0; i < blocks.delays.size(); ++i) {
            for (std::int64_t k = 0; k < blocks.delays[i]; ++k) {
                add(gap, static_cast<std::int64_t>(i), t, k % blocks.turns);
            }
        }
    }
    RowList equal;
    RowList below;
    equal.add(rowOf(gap), -blocks.startPlace() * cells);
    Form prefix = Form::Zero(unknowns);
    const double force = 2.0 * blocks.bar.segments.back().impedance / cells;
    for (std::size_t number = 0; number < blocks.blocks.size(); ++number) {
        const StepBlock& block = blocks.blocks[number];
        const bool isLast = number + 1 == blocks.blocks.size();
        Form p = Form::Zero(unknowns);
        add(p, tip, block.type, block.turn);
        if (block.isContact) {
            below.add(rowOf(-block.push * p), 0.0);
            result.conditions.push_back({SteppedRule::push, number});
            result.impulse += block.push * force * p;
            continue;
        }
        prefix += p;
        if (block.isFlightEnd && !isLast) {
            equal.add(rowOf(prefix), block.landing);
            result.landings.push_back(number);
        } else if (!isLast) {
            below.add(rowOf(prefix), block.bound);
            result.conditions.push_back({SteppedRule::bound, number});
            if (std::isfinite(block.floor)) {
                below.add(rowOf(-prefix), -block.floor);
                result.conditions.push_back({SteppedRule::floor, number});
            }
        }
        if (block.isFlightEnd) {
            prefix.setZero();
        }
    }
    equal.moveTo(result.program.equalities, result.program.equalityRhs, unknowns);
    below.moveTo(result.program.inequalities, result.program.inequalityRhs, unknowns);

    for (std::int64_t j = 0; j <= tip; ++j) {
        std::vector<Eigen::Triplet<double>> entries;
        for (std::size_t t = 0; t < blocks.types.size(); ++t) {
            for (std::int64_t k = 0; k < blocks.turns; ++k) {
                for (Eigen::Index c = 0; c < kernel.waves[t].cols(); ++c) {
                    entries.emplace_back(
                        static_cast<int>(static_cast<std::int64_t>(t) * blocks.turns + k),
                        static_cast<int>(first[t] + c), kernel.waves[t](j * blocks.turns + k, c));
                }
            }
        }
        SparseRows& reading = result.reading.emplace_back(
            static_cast<Eigen::Index>(blocks.types.size()) * blocks.turns, unknowns);
        reading.setFromTriplets(entries.begin(), entries.end());
    }
    return result;
}

}  // namespace signorini
