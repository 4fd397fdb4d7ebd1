#include <cmath>
#include <limits>
#include <stdexcept>

#include "echo.hpp"
#include "faults.hpp"
#include "signorini/amplitude_set.hpp"
#include "signorini/one_phase_set.hpp"

namespace signorini {

namespace {

/// How far given amplitudes may lie outside the set, relative to |S|.
constexpr double amplitudeTolerance = 1e-9;

void requireMotion(const Verdict& verdict)
{
    if (verdict.reason || verdict.set.kind == SetKind::empty) {
        throw std::invalid_argument("one phase: the schedule has no motion");
    }
}

/// Writes p_m = epsilon_alpha z_j on live classes and 0 elsewhere: fill(run, sign, firstClass) sets
/// a run of neighbouring classes to sign z.
template <typename Fill>
State writeState(const OnePhaseSet& r, Fill fill)
{
    const std::int64_t cells = r.schedule.cells;
    State state{Eigen::VectorXd(cells), Eigen::VectorXd(cells)};
    if (r.kernelDimension < r.classes) {
        state.a.setZero();
        state.b.setZero();
    }
    for (std::int64_t block = 0, alpha = 0; block < r.window; ++block, ++alpha) {
        alpha -= alpha == r.members ? r.members : 0;
        const double sign = r.signs[static_cast<std::size_t>(alpha)];
        const std::int64_t begin = block * r.classes + r.firstLive;
        fillWaves(
            state, begin, begin + r.kernelDimension,
            [&](auto& run, double side, std::int64_t first) { fill(run, side * sign, first); });
    }
    return state;
}

}  // namespace

EnergyRange energyRange(const Verdict& verdict)
{
    requireMotion(verdict);
    if (verdict.set.kind == SetKind::cone) {
        return {0.0, std::numeric_limits<double>::infinity()};
    }
    // With S = -N/win both ends are rational; integers below 2^53 make their quotient the double
    // nearest to it.
    const auto sum = static_cast<double>(verdict.windowSum);
    const auto count = static_cast<double>(verdict.set.count);
    const double whole =
        2.0 * static_cast<double>(verdict.window) * static_cast<double>(verdict.cells);
    const double squares = verdict.set.sum * verdict.set.sum;
    const double most = std::round(mostSquares(verdict.set) / squares);  // 1 on a simplex
    return {whole / (sum * sum * count), whole * most / (sum * sum)};
}

State motionOf(const OnePhaseSet& whole, std::span<const double> amplitudes)
{
    requireMotion(whole);
    const double outside = distanceOutside(whole.set, amplitudes);
    if (!(outside <= amplitudeTolerance)) {
        throw std::invalid_argument(
            fmt::format("amplitudes: outside the solution set by {} |S|: allowed at most {}",
                        outside, amplitudeTolerance));
    }
    const Eigen::Map<const Eigen::VectorXd> z(amplitudes.data(),
                                              static_cast<Eigen::Index>(amplitudes.size()));
    return writeState(whole, [&z](auto& run, double sign, std::int64_t first) {
        run = sign * z.segment(first, run.size());
    });
}

std::vector<double> amplitudesOf(const OnePhaseSet& whole, const State& state)
{
    requireMotion(whole);
    requireCells(state, whole.schedule.cells);
    std::vector<double> z(static_cast<std::size_t>(whole.kernelDimension), 0.0);
    for (std::int64_t block = 0; block < whole.window; ++block) {
        const double sign = whole.signs[static_cast<std::size_t>(block % whole.members)];
        for (std::size_t j = 0; j < z.size(); ++j) {
            const std::int64_t m =
                block * whole.classes + whole.firstLive + static_cast<std::int64_t>(j);
            z[j] += sign * waveAt(state, m);
        }
    }
    for (double& value : z) {
        value /= static_cast<double>(whole.window);  // last: equal terms cancel without a rest
    }
    return z;
}

State leastEnergyMotion(const OnePhaseSet& whole)
{
    requireMotion(whole);
    const double z = whole.set.sum / static_cast<double>(whole.set.count);
    return writeState(whole,
                      [z](auto& run, double sign, std::int64_t) { run.setConstant(sign * z); });
}

}  // namespace signorini
