#pragma once
/// \file
/// Linear elements of a bar, for the schemes that use them: tridiagonal matrices, and what pulls.

#include "schemes.hpp"

namespace signorini::bench {

/// How an element's mass comes to its nodes.
enum class Mass {
    consistent,
    lumped,
    redistributed,  ///< lumped, but none at the tip: its neighbour has it, too
};

/// Symmetric, one value beside the diagonal.
struct Tridiagonal {
    Eigen::VectorXd diagonal;
    double off = 0.0;
    double last = 0.0;  ///< of the last element alone: what its end adds to the diagonal

    [[nodiscard]] Eigen::VectorXd times(const Eigen::VectorXd& x) const;
    /// This + factor * other + atTip on the last place.
    [[nodiscard]] Tridiagonal plus(double factor, const Tridiagonal& other, double atTip) const;
};

/// Solves with one such matrix again and again.
class Factor {
public:
    Factor() = default;
    explicit Factor(const Tridiagonal& matrix);
    [[nodiscard]] Eigen::VectorXd solve(Eigen::VectorXd x) const;
    /// What a unit force on the tip gives.
    [[nodiscard]] Eigen::VectorXd unit() const;

private:
    double off_ = 0.0;
    Eigen::VectorXd pivots_;
};

/// A spring in place of the wall is ten times as stiff as an element.
[[nodiscard]] inline double penaltyOf(int elements)
{
    return 10.0 * elements;
}

/// The bar in elements: nodes from the base to the tip; a clamped base is left out.
struct ElementModel {
    MarchedBar bar;
    Tridiagonal mass;
    Tridiagonal stiffness;
    Eigen::VectorXd u;
    Eigen::VectorXd v;
    Eigen::VectorXd weight;

    ElementModel(const MarchedBar& given, int elements, Mass kind);

    [[nodiscard]] Eigen::Index last() const { return u.size() - 1; }
    [[nodiscard]] double tip() const { return u[last()]; }
    /// 1 at the tip.
    [[nodiscard]] Eigen::VectorXd unit() const { return Eigen::VectorXd::Unit(u.size(), last()); }
    /// Forces on the nodes but for the wall.
    [[nodiscard]] Eigen::VectorXd pull(const Eigen::VectorXd& at, const Eigen::VectorXd& speed,
                                       double time) const;
    [[nodiscard]] double energy() const
    {
        return 0.5 * v.dot(mass.times(v)) + 0.5 * u.dot(stiffness.times(u)) - weight.dot(u);
    }
};

}  // namespace signorini::bench
