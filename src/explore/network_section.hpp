#pragma once
/// \file
/// The motions of one schedule and one energy of a network, as points of a sphere.
///
/// In coordinates z of ker(W - 1) (network_kernel.hpp), counted from what constant forces make of
/// them, the energy is |y|^2 and a part that all motions share. The equalities of the schedule
/// leave y = p + Q t, Q orthonormal and p at right angles to it, so the motions of energy E are
///
///     |t| = rho,   G t >= h,
///
/// a sphere cut by a convex polyhedron: rows of pushes, distances, and of the limit on strain,
/// which are added as they are broken. docs/theory.md, section 20.

#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <vector>

#include "network_find.hpp"

namespace signorini {

class NetworkSection {
public:
    /// Motions of an energy [Z_1 delta^2/h]. O(state^3) for each block, rows coordinates^2.
    NetworkSection(const Network& network, const std::vector<ContactSpan>& schedule, double energy);

    /// Is the kernel small enough? Nothing else is known of one that is not.
    [[nodiscard]] bool isWithinReach() const { return kernel_.has_value(); }
    /// Rounding hides neither the kernel, nor a row, nor how many equalities there are.
    [[nodiscard]] bool isClear() const { return isClear_; }
    /// Of t.
    [[nodiscard]] Eigen::Index unknowns() const { return basis_.cols(); }
    /// rho. 0: the energy is less than any motion has, or just that of the only one.
    [[nodiscard]] double radius() const { return radius_; }
    /// The root of the energy [sqrt(Z_1 delta^2/h)].
    [[nodiscard]] double norm() const { return norm_; }
    [[nodiscard]] const Eigen::MatrixXd& rows() const { return rows_; }  ///< G
    [[nodiscard]] const Eigen::VectorXd& rhs() const { return rhs_; }    ///< h

    /// Nearest to waves at the start, in the norm of the energy.
    [[nodiscard]] Eigen::VectorXd unknownsOf(std::span<const double> waves) const;
    [[nodiscard]] NetworkClaim motionOf(const Eigen::VectorXd& t) const;
    /// Waves at the start with the places of the nodes that go with them, if they are a motion.
    [[nodiscard]] NetworkClaim motionOf(std::vector<double> waves) const;
    /// Adds rows of strain that t breaks. Were there any?
    bool addBroken(const Eigen::VectorXd& t);

private:
    void enterRows();
    [[nodiscard]] Eigen::VectorXd coordinatesAt(const Eigen::VectorXd& t) const;

    NetworkBlocks blocks_;
    std::optional<NetworkKernel<double>> kernel_;
    NetworkRows<double> conditions_ = {};
    Eigen::VectorXd steady_ = {};  ///< coordinates of what constant forces make
    Eigen::VectorXd centre_ = {};  ///< p
    Eigen::MatrixXd basis_ = {};   ///< Q
    Eigen::MatrixXd rows_ = {};
    Eigen::VectorXd rhs_ = {};
    bool isClear_ = false;
    double norm_ = 0.0;
    double radius_ = 0.0;
};

/// Points spread evenly over a sphere cut by rows: from one point along a random great circle to
/// any other of it that meets all rows, again and again. The circle may cross what breaks them, so
/// parts that no curve joins are reached, too. O(rows unknowns) a move.
class GreatCircles {
public:
    /// \pre two unknowns at least; t is on the sphere and meets the rows but for rounding.
    GreatCircles(Eigen::VectorXd t, std::uint64_t seed);

    /// Moves and returns where it is then.
    const Eigen::VectorXd& next(const NetworkSection& section, int moves);

private:
    void move(const NetworkSection& section);

    Eigen::VectorXd t_;
    std::mt19937_64 generator_;
};

}  // namespace signorini
