#include "moreau_jean.hpp"

#include <cmath>
#include <numbers>

#include "common/stopwatch.hpp"

namespace signorini::bench {

namespace {

/// A symmetric tridiagonal matrix of equal rows, but for the last one: the tip.
struct Tridiagonal {
    double diagonal;
    double off;
    double last;

    [[nodiscard]] Eigen::VectorXd times(const Eigen::VectorXd& x) const
    {
        const Eigen::Index n = x.size();
        Eigen::VectorXd y = diagonal * x;
        y[n - 1] = last * x[n - 1];
        y.head(n - 1) += off * x.tail(n - 1);
        y.tail(n - 1) += off * x.head(n - 1);
        return y;
    }
};

/// Solves with one such matrix again and again.
class Factor {
public:
    Factor(const Tridiagonal& matrix, Eigen::Index n) : off_(matrix.off), pivots_(n)
    {
        for (Eigen::Index i = 0; i < n; ++i) {
            const double own = i + 1 < n ? matrix.diagonal : matrix.last;
            pivots_[i] = own - (i > 0 ? off_ * off_ / pivots_[i - 1] : 0.0);
        }
    }

    void solve(Eigen::VectorXd& x) const
    {
        for (Eigen::Index i = 1; i < x.size(); ++i) {
            x[i] -= off_ / pivots_[i - 1] * x[i - 1];
        }
        x[x.size() - 1] /= pivots_[x.size() - 1];
        for (Eigen::Index i = x.size() - 1; i-- > 0;) {
            x[i] = (x[i] - off_ * x[i + 1]) / pivots_[i];
        }
    }

private:
    double off_;
    Eigen::VectorXd pivots_;
};

/// Values at the nodes of the elements, of a function that is linear between those of the state.
Eigen::VectorXd atNodes(const Eigen::VectorXd& values, double atBase, int elements)
{
    Eigen::VectorXd result(elements);
    const auto cells = static_cast<double>(values.size());
    for (int i = 1; i <= elements; ++i) {
        const double x = cells * i / elements;
        const auto below = std::min(static_cast<Eigen::Index>(x), values.size() - 1);
        const double from = below > 0 ? values[below - 1] : atBase;
        result[i - 1] = std::lerp(from, values[below], x - static_cast<double>(below));
    }
    return result;
}

}  // namespace

TimeSteps runMoreauJean(const SiconosRun& run)
{
    const double h = run.period / run.steps;
    const double cell = 1.0 / run.elements;
    const Tridiagonal mass{4.0 * cell / 6.0, cell / 6.0, 2.0 * cell / 6.0};
    const Tridiagonal stiffness{2.0 / cell, -1.0 / cell, 1.0 / cell};
    const double share = 0.25 * h * h;
    const Factor factor(
        {mass.diagonal + share * stiffness.diagonal, mass.off + share * stiffness.off,
         mass.last + share * stiffness.last + 0.5 * h * run.dashpot},
        run.elements);
    const State& state = run.state;
    const Eigen::VectorXd inCells = velocity(state);
    Eigen::VectorXd speeds = inCells;
    speeds.head(speeds.size() - 1) =
        0.5 * (inCells.head(speeds.size() - 1) + inCells.tail(speeds.size() - 1));
    Eigen::VectorXd u = atNodes(displacement(state), 0.0, run.elements);
    Eigen::VectorXd v = atNodes(speeds, 0.0, run.elements);
    const Eigen::Index tip = run.elements - 1;
    Eigen::VectorXd push = Eigen::VectorXd::Zero(run.elements);
    push[tip] = 1.0;
    factor.solve(push);

    TimeSteps result;
    result.samples.reserve(static_cast<std::size_t>(run.steps * run.periods));
    const Stopwatch stopwatch;
    for (int k = 1; k <= run.steps * run.periods; ++k) {
        const double force =
            run.amplitude * std::cos(2.0 * std::numbers::pi * (k - 0.5) / run.steps - run.phase);
        Eigen::VectorXd change = -h * stiffness.times(u + 0.5 * h * v);
        change[tip] += h * (force - run.dashpot * v[tip]);
        factor.solve(change);
        const bool isNear = u[tip] + 0.5 * h * v[tip] >= 1.0;
        if (const double speed = v[tip] + change[tip]; isNear && speed > 0.0) {
            change -= speed / push[tip] * push;
        }
        u += h * (v + 0.5 * change);
        v += change;
        result.samples.push_back(
            {h * k, u[tip], 0.5 * v.dot(mass.times(v)) + 0.5 * u.dot(stiffness.times(u))});
    }
    result.seconds = stopwatch.seconds();
    return result;
}

}  // namespace signorini::bench
