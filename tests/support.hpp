#pragma once
/// \file
/// What several tests share.

#include <algorithm>
#include <cstdint>
#include <random>

#include "catch.hpp"
#include "signorini/motion.hpp"
#include "signorini/schedule.hpp"

namespace signorini::test {

inline Schedule onePhase(std::int64_t cells, std::int64_t contact, std::int64_t free)
{
    return {cells, {{contact, free}}};
}

/// Calls action(schedule) for every one-phase schedule with N <= maxCells, n_c <= 2N + margin and
/// n_f <= 8N + margin.
template <typename Action>
void forAllSchedules(std::int64_t maxCells, std::int64_t margin, Action action)
{
    for (std::int64_t cells = 1; cells <= maxCells; ++cells) {
        for (std::int64_t contact = 1; contact <= 2 * cells + margin; ++contact) {
            for (std::int64_t free = 1; free <= 8 * cells + margin; ++free) {
                action(onePhase(cells, contact, free));
            }
        }
    }
}

/// 1..maxPhases phases on 1..maxCells cells; half of them with flights near the free period 4N,
/// where motions are frequent.
inline Schedule randomSchedule(std::mt19937_64& generator, std::int64_t maxCells, int maxPhases)
{
    const auto draw = [&generator](std::int64_t low, std::int64_t high) {
        return std::uniform_int_distribution<std::int64_t>(low, high)(generator);
    };
    Schedule schedule{draw(1, maxCells), {}};
    const std::int64_t count = draw(1, maxPhases);
    for (std::int64_t k = 0; k < count; ++k) {
        const std::int64_t contact = draw(1, schedule.cells);
        const std::int64_t free =
            draw(0, 1) == 0
                ? draw(1, 8 * schedule.cells)
                : std::max<std::int64_t>(1, 4 * schedule.cells - contact - draw(0, schedule.cells));
        schedule.phases.push_back({contact, free});
    }
    return schedule;
}

/// A state with values in [-1, 1], the same for the same seed.
inline State randomState(std::int64_t cells, unsigned seed = 1)
{
    std::mt19937_64 generator(seed);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    State state{Eigen::VectorXd(cells), Eigen::VectorXd(cells)};
    for (Eigen::Index i = 0; i < cells; ++i) {
        state.a[i] = value(generator);
        state.b[i] = value(generator);
    }
    return state;
}

/// The unknowns (a, b) of the paper as one vector.
inline Eigen::VectorXd stacked(const State& state)
{
    Eigen::VectorXd x(2 * state.cells());
    x << state.a, state.b;
    return x;
}

inline void checkEqual(const Extremes& left, const Extremes& right, double tolerance = 1e-12)
{
    const auto near = [tolerance](double value) {
        return Approx(value).epsilon(tolerance).margin(tolerance);
    };
    CHECK(left.period == near(right.period));
    CHECK(left.contactTime == near(right.contactTime));
    CHECK(left.peakForce == near(right.peakForce));
    CHECK(left.impulse == near(right.impulse));
    CHECK(left.approachSpeed == near(right.approachSpeed));
    CHECK(left.peakCompression == near(right.peakCompression));
    CHECK(left.peakTension == near(right.peakTension));
    CHECK(left.lowestTip == near(right.lowestTip));
}

}  // namespace signorini::test
