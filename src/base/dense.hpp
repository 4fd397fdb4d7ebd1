#pragma once
/// \file
/// Dense systems of linear equations, in doubles and in 50 digits.
///
/// The work is Eigen's. It is compiled in one place, for what is made of a factorization takes as
/// long to compile as a floor; so its headers are read nowhere else. `Number`: double or
/// FineNumber.

#include <Eigen/Core>
#include <memory>
#include <type_traits>

#include "fine_number.hpp"

namespace signorini {

template <typename Number>
inline constexpr bool isFine = std::is_same_v<Number, FineNumber>;

template <typename Number>
using MatrixOf = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;
template <typename Number>
using VectorOf = Eigen::Matrix<Number, Eigen::Dynamic, 1>;

/// a b. O(rows columns inner).
template <typename Number>
[[nodiscard]] MatrixOf<Number> product(const MatrixOf<Number>& a, const MatrixOf<Number>& b);

/// P A = L U of a square A, pivots from each column. O(n^3).
class SquareFactors {
public:
    explicit SquareFactors(const Eigen::MatrixXd& a);
    /// A^-1 b; not finite where A is singular.
    [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;
    /// A^-T b.
    [[nodiscard]] Eigen::MatrixXd solveTransposed(const Eigen::MatrixXd& b) const;
    /// Of 1/(|A| |A^-1|), an estimate.
    [[nodiscard]] double rcond() const;
    /// The least |U_kk|.
    [[nodiscard]] double leastPivot() const;

private:
    struct Inside;
    std::shared_ptr<const Inside> inside_;
};

/// A P = Q R, the largest pivots first. O(rows columns^2).
///
/// Of fine numbers it is what Eigen has without blocks: these gain nothing where an operation is a
/// call.
template <typename Number>
class OrthogonalFactors {
public:
    explicit OrthogonalFactors(const MatrixOf<Number>& a);
    /// The x of least |A x - b|, column by column.
    [[nodiscard]] MatrixOf<Number> solve(const MatrixOf<Number>& b) const;
    /// |R_kk|.
    [[nodiscard]] Number pivot(Eigen::Index k) const;
    /// What a square Q has beyond its first `rank` columns: at right angles to those of A.
    [[nodiscard]] MatrixOf<Number> beyond(Eigen::Index rank) const;

private:
    struct Inside;
    std::shared_ptr<const Inside> inside_;
};

/// P A Q = L U of any A, the largest pivots first; what rounding leaves counts as 0. O(n^3).
class FullFactors {
public:
    explicit FullFactors(const Eigen::MatrixXd& a);
    [[nodiscard]] Eigen::Index rank() const;
    /// All x with A x = 0, one in each column.
    [[nodiscard]] Eigen::MatrixXd kernel() const;
    /// One x with A x = b, if there is any.
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
    /// Not finite where A is singular.
    [[nodiscard]] Eigen::MatrixXd inverse() const;

private:
    struct Inside;
    std::shared_ptr<const Inside> inside_;
};

/// The x of least norm among those of least |a x - b|.
class LeastSquares {
public:
    /// Pivots below `none` times the largest count as 0; 0 leaves that to rounding. O(rows
    /// columns^2).
    explicit LeastSquares(const Eigen::MatrixXd& a, double none = 0.0);
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
    [[nodiscard]] Eigen::Index rank() const;
    /// An orthonormal basis of all x with a x = 0, one in each column. O(columns^3).
    [[nodiscard]] Eigen::MatrixXd kernel() const;

private:
    struct Inside;
    std::shared_ptr<const Inside> inside_;
};

}  // namespace signorini
