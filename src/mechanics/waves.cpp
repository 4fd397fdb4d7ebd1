#include <cstddef>

#include "compensated_sum.hpp"
#include "faults.hpp"
#include "signorini/simulation.hpp"
#include "stops.hpp"

namespace signorini {

namespace {

/// The integral of a wave from the base to each node, in g; `isReversed` for a, whose first piece
/// is at the tip.
Eigen::VectorXd integralOf(const std::vector<Piece>& pieces, double crossing, std::int64_t cells,
                           bool isReversed)
{
    Eigen::VectorXd result = Eigen::VectorXd::Zero(cells + 1);
    CompensatedSum sum;
    double passed = 0.0;
    std::size_t k = 0;
    for (std::int64_t i = 1; i <= cells; ++i) {
        const double at = crossing * static_cast<double>(i) / static_cast<double>(cells);
        const auto piece = [&] { return pieces[isReversed ? pieces.size() - 1 - k : k]; };
        while (k < pieces.size() && passed + piece().duration <= at) {
            sum.add(piece().duration * piece().value);
            passed += piece().duration;
            ++k;
        }
        const double rest = k < pieces.size() ? (at - passed) * piece().value : 0.0;
        result[i] = (sum.value() + rest) / crossing;
    }
    return result;
}

}  // namespace

Waves wavesOf(const State& state)
{
    Waves waves;
    const std::int64_t cells = state.cells();
    waves.crossing = static_cast<double>(cells);
    for (std::int64_t i = 0; i < cells; ++i) {
        waves.a.push_back({1.0, state.a[cells - 1 - i]});
        waves.b.push_back({1.0, state.b[i]});
    }
    return waves;
}

Waves wavesAtRest(double stepsPerCrossing, const Stops& stops, double base)
{
    Faults faults;
    faults.requirePositive("stepsPerCrossing", stepsPerCrossing, "-");
    faults.throwIfAny();
    const double wave = 0.0 - 0.5 * restingStrain(stops, base);
    return {stepsPerCrossing, {{stepsPerCrossing, wave}}, {{stepsPerCrossing, -wave}}};
}

Eigen::VectorXd stretching(const Waves& waves, std::int64_t cells)
{
    return integralOf(waves.b, waves.crossing, cells, false) -
           integralOf(waves.a, waves.crossing, cells, true);
}

double energyRatio(const Waves& waves)
{
    CompensatedSum squares;
    for (const auto* wave : {&waves.a, &waves.b}) {
        for (const Piece& piece : *wave) {
            squares.add(piece.duration * piece.value * piece.value);
        }
    }
    return 2.0 * squares.value() / waves.crossing;
}

}  // namespace signorini
