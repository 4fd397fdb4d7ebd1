#include "signorini/motion.hpp"

#include <algorithm>
#include <array>

#include "echo.hpp"
#include "faults.hpp"

namespace signorini {

namespace {

/// The sum of squares in an order that no compiler or instruction set changes: every build prints
/// the same energy.
double squaresOf(const Eigen::VectorXd& values)
{
    std::array<double, 4> lanes{};
    const Eigen::Index whole = values.size() - values.size() % 4;
    for (Eigen::Index i = 0; i < whole; i += 4) {
        for (Eigen::Index lane = 0; lane < 4; ++lane) {
            lanes[static_cast<std::size_t>(lane)] += values[i + lane] * values[i + lane];
        }
    }
    for (Eigen::Index i = whole; i < values.size(); ++i) {
        lanes[static_cast<std::size_t>(i - whole)] += values[i] * values[i];
    }
    return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}

}  // namespace

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
    return energyOf(squaresOf(state.a) + squaresOf(state.b), state.cells());
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
