#include "dense.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>

namespace signorini {

namespace {

/// One column is solved for as a vector; fine numbers gain nothing from several at once.
template <typename Number>
MatrixOf<Number> columnsSolved(const auto& factors, Eigen::Index rows, const MatrixOf<Number>& b)
{
    if (!isFine<Number> && b.cols() != 1) {
        return factors.solve(b);
    }
    MatrixOf<Number> x(rows, b.cols());
    for (Eigen::Index k = 0; k < b.cols(); ++k) {
        x.col(k) = factors.solve(VectorOf<Number>(b.col(k)));
    }
    return x;
}

}  // namespace

template <typename Number>
MatrixOf<Number> product(const MatrixOf<Number>& a, const MatrixOf<Number>& b)
{
    if constexpr (isFine<Number>) {
        return a.lazyProduct(b);
    } else {
        return a * b;
    }
}
template MatrixOf<double> product(const MatrixOf<double>&, const MatrixOf<double>&);
template MatrixOf<FineNumber> product(const MatrixOf<FineNumber>&, const MatrixOf<FineNumber>&);

struct SquareFactors::Inside {
    Eigen::PartialPivLU<Eigen::MatrixXd> factors;
};

SquareFactors::SquareFactors(const Eigen::MatrixXd& a)
    : inside_(new Inside{Eigen::PartialPivLU<Eigen::MatrixXd>(a)})
{
}

Eigen::MatrixXd SquareFactors::solve(const Eigen::MatrixXd& b) const
{
    return columnsSolved(inside_->factors, b.rows(), b);
}

Eigen::MatrixXd SquareFactors::solveTransposed(const Eigen::MatrixXd& b) const
{
    return inside_->factors.transpose().solve(b);
}

double SquareFactors::rcond() const
{
    return inside_->factors.rcond();
}

double SquareFactors::leastPivot() const
{
    return inside_->factors.matrixLU().diagonal().cwiseAbs().minCoeff();
}

template <typename Number>
struct OrthogonalFactors<Number>::Inside {
    std::conditional_t<isFine<Number>, Eigen::FullPivHouseholderQR<MatrixOf<Number>>,
                       Eigen::ColPivHouseholderQR<MatrixOf<Number>>>
        factors;
};

template <typename Number>
OrthogonalFactors<Number>::OrthogonalFactors(const MatrixOf<Number>& a)
    : inside_(new Inside{decltype(Inside::factors)(a)})
{
}

template <typename Number>
MatrixOf<Number> OrthogonalFactors<Number>::solve(const MatrixOf<Number>& b) const
{
    return columnsSolved(inside_->factors, inside_->factors.cols(), b);
}

template <typename Number>
Number OrthogonalFactors<Number>::pivot(Eigen::Index k) const
{
    using std::abs;
    return abs(inside_->factors.matrixQR()(k, k));
}

template <typename Number>
MatrixOf<Number> OrthogonalFactors<Number>::beyond(Eigen::Index rank) const
{
    const auto& factors = inside_->factors;
    const Eigen::Index size = factors.rows();
    if constexpr (isFine<Number>) {
        return MatrixOf<Number>(factors.matrixQ()).rightCols(size - rank);
    } else {
        MatrixOf<Number> basis = MatrixOf<Number>::Zero(size, size - rank);
        basis.bottomRows(size - rank).setIdentity();
        return factors.householderQ() * basis;
    }
}

template class OrthogonalFactors<double>;
template class OrthogonalFactors<FineNumber>;

struct FullFactors::Inside {
    Eigen::FullPivLU<Eigen::MatrixXd> factors;
};

FullFactors::FullFactors(const Eigen::MatrixXd& a)
    : inside_(new Inside{Eigen::FullPivLU<Eigen::MatrixXd>(a)})
{
}

Eigen::Index FullFactors::rank() const
{
    return inside_->factors.rank();
}

Eigen::MatrixXd FullFactors::kernel() const
{
    return inside_->factors.kernel();
}

Eigen::VectorXd FullFactors::solve(const Eigen::VectorXd& b) const
{
    return inside_->factors.solve(b);
}

Eigen::MatrixXd FullFactors::inverse() const
{
    return inside_->factors.inverse();
}

struct LeastSquares::Inside {
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors;
};

LeastSquares::LeastSquares(const Eigen::MatrixXd& a, double none)
{
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors;
    if (none > 0.0) {
        factors.setThreshold(none);
    }
    factors.compute(a);
    inside_ = std::make_shared<const Inside>(Inside{std::move(factors)});
}

Eigen::VectorXd LeastSquares::solve(const Eigen::VectorXd& b) const
{
    return inside_->factors.solve(b);
}

Eigen::Index LeastSquares::rank() const
{
    return inside_->factors.rank();
}

Eigen::MatrixXd LeastSquares::kernel() const
{
    const auto& factors = inside_->factors;
    const Eigen::Index unknowns = factors.cols();
    Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(unknowns, unknowns - factors.rank());
    basis.bottomRows(basis.cols()).setIdentity();
    return factors.colsPermutation() * (factors.matrixZ().transpose() * basis);
}

}  // namespace signorini
