#pragma once
/// \file
/// The echo: the one law that everything else stands on.
///
/// The bar is known by the waves p_m that arrive at the tip, one in each step. What the tip sends
/// back arrives again 2N steps later,
///
///     p_{m+2N} = factor p_m + source,
///
/// with factor +1 in contact (DD, equation (19)), -1 in free flight (DN, equation (17)), and source
/// 0. The 2N waves under way at t = 0 are the state; in the order of their arrival
///
///     a_i = p_{N-i},   b_i = -p_{N+i-1},
///     u(L, 0)/g = -(1/N) sum p_m,   E/E_1 = (2/N) sum p_m^2,   m = 0..2N-1.

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>

#include "signorini/motion.hpp"

namespace signorini {

/// What a step does to the wave that arrives in it. No step adds to the wave: the source is 0.
inline constexpr int contactFactor = 1;
inline constexpr int flightFactor = -1;

/// The factor of one step.
[[nodiscard]] constexpr int echoFactor(bool isContact)
{
    return isContact ? contactFactor : flightFactor;
}

/// The factor of `count` echoes in flight, however many there are in contact between them.
[[nodiscard]] constexpr int flightsFactor(std::int64_t count)
{
    return count % 2 == 0 ? 1 : flightFactor;
}

/// p_0 + ... + p_{2N-1} where the tip is at the wall, `right` the sign of the gap: the gap row
/// (31).
[[nodiscard]] constexpr std::int64_t gapSum(std::int64_t cells, int right)
{
    return -right * cells;
}

/// Number among a_1..a_N, b_1..b_N, and sign there, of the wave that arrives in step m < 2N.
struct Unknown {
    std::int64_t index = 0;
    int sign = 1;
};

/// Its own inverse: unknown number k arrives in step unknownOf(k, cells).index.
[[nodiscard]] constexpr Unknown unknownOf(std::int64_t m, std::int64_t cells)
{
    return m < cells ? Unknown{cells - 1 - m, 1} : Unknown{m, -1};
}

/// \throws std::invalid_argument unless both waves of the state have so many cells.
void requireCells(const State& state, std::int64_t cells);

/// p_m of a state, m < 2N.
[[nodiscard]] inline double waveAt(const State& state, std::int64_t m)
{
    const std::int64_t cells = state.cells();
    return m < cells ? state.a[cells - 1 - m] : -state.b[m - cells];
}

/// p_0 .. p_{2N-1} of a state. O(N).
[[nodiscard]] inline Eigen::VectorXd windowOf(const State& state)
{
    Eigen::VectorXd p(2 * state.cells());
    p << state.a.reverse(), -state.b;
    return p;
}

/// The state with the waves p(m), m < 2N. O(N).
template <typename Wave>
[[nodiscard]] State stateOfWaves(std::int64_t cells, Wave p)
{
    State state{Eigen::VectorXd(cells), Eigen::VectorXd(cells)};
    for (std::int64_t m = 0; m < cells; ++m) {
        state.a[cells - 1 - m] = p(m);
        state.b[m] = -p(cells + m);
    }
    return state;
}

/// Writes p_m, begin <= m < end, into a state: fill(run, sign, offset) sets neighbours of one of
/// its arrays to sign p_m, m = begin + offset, ...
template <typename Fill>
void fillWaves(State& state, std::int64_t begin, std::int64_t end, Fill fill)
{
    const std::int64_t cells = state.cells();
    const std::int64_t split = std::clamp(cells, begin, end);
    if (begin < split) {
        auto run = state.a.reverse().segment(begin, split - begin);
        fill(run, 1.0, std::int64_t{0});
    }
    if (split < end) {
        auto run = state.b.segment(split - cells, end - split);
        fill(run, -1.0, split - begin);
    }
}

/// E/E_1 of a sum of squares of waves that each occur `repeats` times in the 2N of a state.
template <typename Number>
[[nodiscard]] Number energyOf(const Number& squares, std::int64_t cells, std::int64_t repeats = 1)
{
    return Number(Number(2 * repeats) * squares / Number(cells));
}

/// The sum of squares that has the energy E/E_1.
template <typename Number>
[[nodiscard]] Number squaresOf(const Number& energy, std::int64_t cells, std::int64_t repeats = 1)
{
    return Number(energy * Number(cells) / Number(2 * repeats));
}

}  // namespace signorini
