#include "stepped_energy.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <cmath>

#include "exact_multipliers.hpp"
#include "infeasibility.hpp"
#include "rational.hpp"
#include "stepped_form.hpp"
#include "stepped_proof.hpp"

namespace signorini {

namespace {

/// Going from row to row multiplies by reflections over and over: doubles lose all their digits.
using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                           boost::multiprecision::et_off>;
using RealMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using RealVector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

constexpr double noRank = 1e-30;     // pivots below it, relative to the largest
constexpr double noDescent = 1e-30;  // of a multiplier that would leave 0

Eigen::CompleteOrthogonalDecomposition<RealMatrix> factorized(const RealMatrix& matrix)
{
    Eigen::CompleteOrthogonalDecomposition<RealMatrix> factors;
    factors.setThreshold(noRank);
    factors.compute(matrix);
    return factors;
}

/// min |a u - b| over u, but for the first `free` >= 0, by the active sets of Lawson and Hanson
/// (Solving Least Squares Problems, 1974, chapter 23).
class LeastSquares {
public:
    LeastSquares(RealMatrix a, RealVector b, Eigen::Index free)
        : a_(std::move(a)), b_(std::move(b)), free_(free), u_(RealVector::Zero(a_.cols()))
    {
        const RealVector norms = a_.colwise().norm();
        isNothing_ = norms.array() <= noRank * norms.maxCoeff();
        for (Eigen::Index k = 0; k < free_; ++k) {
            used_.push_back(k);
        }
    }

    RealVector solve()
    {
        u_ = solved();
        refused_ = isNothing_;
        for (Eigen::Index turn = 0; turn < 3 * a_.cols(); ++turn) {
            const Eigen::Index next = steepest();
            if (next < 0) {
                break;
            }
            used_.push_back(next);
            if (descend()) {
                refused_ = isNothing_;
            } else {
                refused_[next] = true;  // it is its slope that is rounding
            }
        }
        return u_;
    }

private:
    /// The least squares of the columns in use alone.
    [[nodiscard]] RealVector solved() const
    {
        RealVector wanted = RealVector::Zero(a_.cols());
        if (!used_.empty()) {
            const RealMatrix columns = a_(Eigen::all, used_);
            const RealVector values = factorized(columns).solve(b_);
            wanted(used_) = values;
        }
        return wanted;
    }

    /// The column that is to have a multiplier next: none in use has a slope.
    [[nodiscard]] Eigen::Index steepest() const
    {
        const RealVector slope = a_.transpose() * (b_ - a_ * u_);
        Eigen::Index best = -1;
        Real steep = noDescent * b_.norm();
        for (Eigen::Index k = free_; k < a_.cols(); ++k) {
            const bool isUsed = std::find(used_.begin(), used_.end(), k) != used_.end();
            if (!isUsed && !refused_[k] && slope[k] > steep * a_.col(k).norm()) {
                best = k;
                steep = slope[k] / a_.col(k).norm();
            }
        }
        return best;
    }

    /// Goes to the least squares of the columns in use, leaving out those that would become
    /// negative on the way. False if it got nowhere.
    bool descend()
    {
        const Real before = (b_ - a_ * u_).squaredNorm();
        for (RealVector wanted = solved();; wanted = solved()) {
            Real way = 1;
            Eigen::Index last = -1;
            for (const Eigen::Index k : used_) {
                if (k < free_ || wanted[k] > 0.0) {
                    continue;
                }
                const Real part = u_[k] > 0.0 ? Real(u_[k] / (u_[k] - wanted[k])) : Real(0.0);
                if (part < way) {
                    way = part;
                    last = k;
                }
            }
            u_ += way * (wanted - u_);
            if (last < 0) {
                break;
            }
            u_[last] = 0.0;
            std::erase(used_, last);
        }
        return (b_ - a_ * u_).squaredNorm() < before;
    }

    using Flags = Eigen::Array<bool, Eigen::Dynamic, 1>;

    RealMatrix a_;
    RealVector b_;
    Eigen::Index free_;
    RealVector u_;
    Flags isNothing_;  ///< columns of rounding
    Flags refused_;
    std::vector<Eigen::Index> used_;
};

/// A condition with a multiplier: an inequality, or a bound of a prefix sum.
struct BoundRow {
    Eigen::Index inequality = -1;
    Eigen::Index unknown = -1;
    bool isUpper = true;
};

/// Multipliers in one kind of number, and what they add up to.
template <typename Number>
struct Combined {
    std::vector<Number> equalities;  ///< y
    std::vector<Number> given;       ///< inequalities^T mu, less what bounds take to the right side
    std::vector<Number> bounds;      ///< what they take: equalities^T y + inequalities^T mu there
};

class EnergyBound {
public:
    explicit EnergyBound(const SteppedBlocks& blocks)
        : posed_(jointsForm(blocks)),
          program_(posed_.program),
          equal_(program_.equalities),
          isOpen_(static_cast<std::size_t>(program_.variables()), false)
    {
        for (Eigen::Index k = 0; k < program_.variables(); ++k) {
            if (posed_.energyWeights[k] > 0.0) {
                isOpen_[static_cast<std::size_t>(k)] = true;
                open_.push_back(k);
            }
        }
        for (const auto& [unknown, block] : posed_.prefixes) {
            if (program_.lower[unknown] == program_.upper[unknown]) {
                bounds_.push_back({.unknown = unknown});
            }
        }
        fixed_ = static_cast<Eigen::Index>(bounds_.size());
        for (Eigen::Index row = 0; row < program_.inequalities.rows(); ++row) {
            bounds_.push_back({.inequality = row});
        }
        for (const auto& [unknown, block] : posed_.prefixes) {
            if (program_.lower[unknown] == program_.upper[unknown]) {
                continue;
            }
            if (std::isfinite(program_.upper[unknown])) {
                bounds_.push_back({.unknown = unknown});
            }
            if (std::isfinite(program_.lower[unknown])) {
                bounds_.push_back({.unknown = unknown, .isUpper = false});
            }
        }
        order_ = followingRows(program_, isOpen_);
    }

    /// Multipliers of open rows, of the gap, of fixed bounds, of conditions.
    [[nodiscard]] RealVector best() const
    {
        const auto open = static_cast<Eigen::Index>(open_.size());
        const Eigen::Index others = 1 + static_cast<Eigen::Index>(bounds_.size());
        RealMatrix columns(open, open + others);
        RealVector right(open + others);
        for (Eigen::Index k = 0; k < columns.cols(); ++k) {
            RealVector unit = RealVector::Zero(columns.cols());
            unit[k] = 1.0;
            const auto combined = follow<Real>(unit);
            for (Eigen::Index i = 0; i < open; ++i) {
                const Eigen::Index unknown = open_[static_cast<std::size_t>(i)];
                columns(i, k) = columnOf(equal_, unknown, combined.given, combined.equalities) /
                                std::sqrt(posed_.energyWeights[unknown]);
            }
            right[k] = rightSide(combined);
        }
        const Real nothing = noRank * columns.lpNorm<Eigen::Infinity>();
        columns = (columns.array().abs() <= nothing).select(Real(0), columns);
        const auto factors = factorized(columns.leftCols(open));
        const RealMatrix basis = factors.householderQ();
        const RealMatrix kernel = basis.rightCols(open - factors.rank());
        RealMatrix distance(kernel.cols() + 1, others);
        distance.topRows(kernel.cols()) = kernel.transpose() * columns.rightCols(others);
        distance.bottomRows(1) = -right.tail(others).transpose();
        RealVector corner = RealVector::Zero(kernel.cols() + 1);
        corner[kernel.cols()] = 1.0;
        RealVector all(open + others);
        all.tail(others) = LeastSquares(distance, corner, 1 + fixed_).solve();
        const RealVector wanted = -(columns.rightCols(others) * all.tail(others));
        all.head(open) = factors.solve(wanted);
        return all;
    }

    /// The same and those that follow, as fractions.
    [[nodiscard]] RationalProof multipliers() const
    {
        const RealVector values = best();
        const auto combined = follow<Rational>(values);
        RationalProof result;
        for (std::size_t row = 0; row < combined.equalities.size(); ++row) {
            if (!combined.equalities[row].is_zero()) {
                result.equalities.push_back(
                    {static_cast<std::int64_t>(row), combined.equalities[row].str()});
            }
        }
        for (std::size_t k = 0; k < bounds_.size(); ++k) {
            const Real& value = values[firstBound() + static_cast<Eigen::Index>(k)];
            if (bounds_[k].inequality >= 0 && value > 0.0) {
                result.inequalities.push_back({bounds_[k].inequality, Rational(value).str()});
            }
        }
        return result;
    }

    /// What multipliers prove, by themselves.
    [[nodiscard]] std::optional<double> provedBy(const RationalProof& multipliers) const
    {
        const auto sum = boundedSum(multipliers, program_);
        if (!sum || sum->left.empty() || sum->right >= 0) {
            return std::nullopt;
        }
        Rational squares = 0;
        for (const auto& [unknown, factor] : sum->left) {
            const double weight = posed_.energyWeights[unknown];
            if (weight == 0.0) {
                return std::nullopt;
            }
            squares += factor * factor / Rational(weight);
        }
        return static_cast<double>(Rational(sum->right * sum->right / squares));
    }

private:
    [[nodiscard]] Eigen::Index firstBound() const
    {
        return static_cast<Eigen::Index>(open_.size()) + 1;
    }

    /// All multipliers that follow from those given.
    template <typename Number>
    [[nodiscard]] Combined<Number> follow(const RealVector& values) const
    {
        using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
        Combined<Number> result;
        result.equalities.resize(static_cast<std::size_t>(program_.equalities.rows()));
        result.given.resize(static_cast<std::size_t>(program_.variables()));
        result.bounds.resize(result.given.size());
        for (std::size_t i = 0; i < open_.size(); ++i) {
            result.equalities[static_cast<std::size_t>(open_[i])] =
                Number(values[static_cast<Eigen::Index>(i)]);
        }
        result.equalities.back() = Number(values[firstBound() - 1]);  // of the gap
        for (std::size_t k = 0; k < bounds_.size(); ++k) {
            const Real& value = values[firstBound() + static_cast<Eigen::Index>(k)];
            if (bounds_[k].inequality >= 0) {
                for (Rows::InnerIterator entry(program_.inequalities, bounds_[k].inequality); entry;
                     ++entry) {
                    result.given[static_cast<std::size_t>(entry.col())] +=
                        Number(value) * Number(entry.value());
                }
            } else {
                const auto unknown = static_cast<std::size_t>(bounds_[k].unknown);
                const Number taken(bounds_[k].isUpper ? Real(-value) : value);
                result.bounds[unknown] += taken;
                result.given[unknown] -= taken;
            }
        }
        followRows(equal_, order_, result.given, result.equalities);
        return result;
    }

    /// Of the rows, less what prefix sums have at their bounds.
    template <typename Number>
    [[nodiscard]] Number rightSide(const Combined<Number>& combined) const
    {
        const Eigen::Index gap = program_.variables();
        Number right = combined.equalities.back() * Number(program_.equalityRhs[gap]);
        for (const auto& [unknown, block] : posed_.prefixes) {
            const Number& factor = combined.bounds[static_cast<std::size_t>(unknown)];
            if (factor != 0) {
                right -=
                    factor * Number(factor > 0 ? program_.lower[unknown] : program_.upper[unknown]);
            }
        }
        return right;
    }

    SteppedProgram posed_;
    const Program& program_;
    ProgramColumns equal_;
    std::vector<bool> isOpen_;
    std::vector<Eigen::Index> open_;  ///< unknowns that the energy counts
    std::vector<BoundRow> bounds_;    ///< first those that fix a prefix sum
    Eigen::Index fixed_ = 0;
    std::vector<Eigen::Index> order_;
};

}  // namespace

std::optional<SteppedEnergyProof> leastEnergyProof(const SteppedBlocks& blocks)
{
    if (blocks.stateSize() * static_cast<std::int64_t>(blocks.types.size()) > mostExactRows ||
        JointsLayout(blocks).unknowns() > mostProofRows) {
        return std::nullopt;
    }
    const EnergyBound bound(blocks);
    RationalProof multipliers = bound.multipliers();
    const auto least = bound.provedBy(multipliers);
    return least ? std::optional(SteppedEnergyProof{std::move(multipliers), *least}) : std::nullopt;
}

}  // namespace signorini
