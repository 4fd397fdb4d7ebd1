#include "signorini/motion.hpp"

#include <algorithm>

#include "echo.hpp"
#include "faults.hpp"

namespace signorini {

void requireCells(const State& state, std::int64_t cells)
{
    if (state.a.size() != cells || state.b.size() != cells) {
        throw std::invalid_argument(
            fmt::format("state: {} and {} cells: allowed {}, as in the schedule", state.a.size(),
                        state.b.size(), cells));
    }
}

Eigen::VectorXd velocity(const State& state)
{
    return state.a + state.b;
}

Eigen::VectorXd strain(const State& state)
{
    return state.b - state.a;
}

Eigen::VectorXd displacement(const State& state)
{
    Eigen::VectorXd u = strain(state);
    double sum = 0.0;
    for (double& value : u) {
        sum += value;
        value = sum / static_cast<double>(state.cells());
    }
    return u;
}

double energyRatio(const State& state)
{
    return energyOf(state.a.squaredNorm() + state.b.squaredNorm(), state.cells());
}

State refined(const State& state, std::int64_t factor)
{
    const auto repeat = [factor](const Eigen::VectorXd& values) {
        return Eigen::VectorXd(values.transpose().replicate(factor, 1).reshaped());
    };
    return {repeat(state.a), repeat(state.b)};
}

double amplitude(const State& state)
{
    return std::max(state.a.lpNorm<Eigen::Infinity>(), state.b.lpNorm<Eigen::Infinity>());
}

}  // namespace signorini
