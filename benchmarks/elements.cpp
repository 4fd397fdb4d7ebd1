#include "elements.hpp"

namespace signorini::bench {

Eigen::VectorXd Tridiagonal::times(const Eigen::VectorXd& x) const
{
    const Eigen::Index n = x.size();
    Eigen::VectorXd y = diagonal.cwiseProduct(x);
    y.head(n - 1) += off * x.tail(n - 1);
    y.tail(n - 1) += off * x.head(n - 1);
    return y;
}

Tridiagonal Tridiagonal::plus(double factor, const Tridiagonal& other, double atTip) const
{
    Tridiagonal sum{diagonal + factor * other.diagonal, off + factor * other.off, 0.0};
    sum.diagonal[sum.diagonal.size() - 1] += atTip;
    return sum;
}

Factor::Factor(const Tridiagonal& matrix) : off_(matrix.off), pivots_(matrix.diagonal)
{
    for (Eigen::Index i = 1; i < pivots_.size(); ++i) {
        pivots_[i] -= off_ * off_ / pivots_[i - 1];
    }
}

Eigen::VectorXd Factor::solve(Eigen::VectorXd x) const
{
    for (Eigen::Index i = 1; i < x.size(); ++i) {
        x[i] -= off_ / pivots_[i - 1] * x[i - 1];
    }
    x[x.size() - 1] /= pivots_[x.size() - 1];
    for (Eigen::Index i = x.size() - 1; i-- > 0;) {
        x[i] = (x[i] - off_ * x[i + 1]) / pivots_[i];
    }
    return x;
}

Eigen::VectorXd Factor::unit() const
{
    return solve(Eigen::VectorXd::Unit(pivots_.size(), pivots_.size() - 1));
}

ElementModel::ElementModel(const MarchedBar& given, int elements, Mass kind) : bar(given)
{
    const double cell = 1.0 / elements;
    const int first = bar.isClamped ? 1 : 0;
    const int nodes = elements + 1 - first;
    const double own = kind == Mass::consistent ? cell / 3.0 : cell / 2.0;
    mass = {Eigen::VectorXd::Constant(nodes, 2.0 * own),
            kind == Mass::consistent ? cell / 6.0 : 0.0, own};
    stiffness = {Eigen::VectorXd::Constant(nodes, 2.0 / cell), -1.0 / cell, 1.0 / cell};
    weight = Eigen::VectorXd::Constant(nodes, bar.weight * cell);
    u.resize(nodes);
    v.resize(nodes);
    for (int i = 0; i < nodes; ++i) {
        const double x = (i + first) * cell;
        u[i] = bar.displacement(x);
        // Where the velocity jumps a node takes the mean.
        v[i] = 0.5 * (bar.velocity(std::max(x - 0.5 * cell, 0.0)) +
                      bar.velocity(std::min(x + 0.5 * cell, 1.0)));
    }
    for (Eigen::Index end : {Eigen::Index{0}, last()}) {
        if (end == last() || !bar.isClamped) {
            mass.diagonal[end] *= 0.5;
            stiffness.diagonal[end] *= 0.5;
            weight[end] *= 0.5;
        }
    }
    if (kind == Mass::redistributed) {
        mass.diagonal[last() - 1] += mass.diagonal[last()];
        mass.diagonal[last()] = 0.0;
        weight[last() - 1] += weight[last()];
        weight[last()] = 0.0;
    }
}

Eigen::VectorXd ElementModel::pull(const Eigen::VectorXd& at, const Eigen::VectorXd& speed,
                                   double time) const
{
    Eigen::VectorXd pull = weight - stiffness.times(at);
    pull[last()] += bar.force(time) - bar.dashpot * speed[last()];
    return pull;
}

}  // namespace signorini::bench
