#include "echo.hpp"

#include <utility>

#include "catch.hpp"
#include "equations.hpp"
#include "support.hpp"

using namespace signorini;

namespace {

/// r_1 on the last cell after the steps of a map.
double lastWave(const SparseMatrix& map, const State& state)
{
    return (map * test::stacked(state))[state.cells() - 1];
}

}  // namespace

TEST_CASE("echo: the maps (29) of the paper bring the waves to the tip in its order and with it")
{
    for (const std::int64_t cells : {1, 2, 7}) {
        const State state = test::randomState(cells);
        for (std::int64_t m = 0; m < 2 * cells; ++m) {
            const double p = waveAt(state, m);
            CHECK(lastWave(contactMap(cells, m), state) == p);
            CHECK(lastWave(freeMap(cells, m), state) == p);
            CHECK(lastWave(contactMap(cells, 2 * cells + m), state) == contactFactor * p);
            CHECK(lastWave(freeMap(cells, 2 * cells + m), state) == flightFactor * p);
            CHECK(lastWave(freeMap(cells, 6 * cells + m), state) == flightsFactor(3) * p);
        }
    }
}

TEST_CASE("echo: unknowns, window and state are the same 2N numbers")
{
    constexpr std::int64_t cells = 5;
    const State state = test::randomState(cells);
    const Eigen::VectorXd p = windowOf(state);
    const Eigen::VectorXd x = test::stacked(state);
    for (std::int64_t m = 0; m < 2 * cells; ++m) {
        const auto [index, sign] = unknownOf(m, cells);
        CHECK(p[m] == waveAt(state, m));
        CHECK(p[m] == sign * x[index]);
        CHECK(unknownOf(index, cells).index == m);
        CHECK(unknownOf(index, cells).sign == sign);
    }
    CHECK(stateOfWaves(cells, [&p](std::int64_t m) { return p[m]; }) == state);
    for (std::int64_t split = 0; split <= 2 * cells; ++split) {
        State filled{Eigen::VectorXd::Zero(cells), Eigen::VectorXd::Zero(cells)};
        for (const auto& [begin, end] : {std::pair{std::int64_t{0}, split}, {split, 2 * cells}}) {
            fillWaves(filled, begin, end, [&, first = begin](auto& run, double sign, auto offset) {
                run = sign * p.segment(first + offset, run.size());
            });
        }
        CHECK(filled == state);
    }
}

TEST_CASE("echo: gap and energy of a state, written in its waves")
{
    constexpr std::int64_t cells = 9;
    const State state = test::randomState(cells);
    const Eigen::VectorXd p = windowOf(state);
    CHECK(displacement(state)[cells - 1] == Approx(-p.sum() / cells));
    CHECK(displacement(state)[cells - 1] * static_cast<double>(gapSum(cells, 1)) ==
          Approx(p.sum()));
    CHECK(gapSum(cells, -1) == -gapSum(cells, 1));
    CHECK(gapSum(cells, 0) == 0);
    CHECK(energyRatio(state) == Approx(energyOf(p.squaredNorm(), cells)));
    CHECK(energyOf(2.0, 12, 3) == 1.0);
    CHECK(squaresOf(1.0, 12, 3) == 2.0);
}
