#include <algorithm>
#include <cmath>
#include <cstddef>

#include "compensated_sum.hpp"
#include "faults.hpp"
#include "signorini/simulation.hpp"

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

Waves wavesAtRest(double stepsPerCrossing)
{
    Faults faults;
    faults.requirePositive("stepsPerCrossing", stepsPerCrossing, "-");
    faults.throwIfAny();
    return {stepsPerCrossing, {{stepsPerCrossing, 0.0}}, {{stepsPerCrossing, 0.0}}};
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

void SettlingWatch::see(const BarSimulation& simulation)
{
    const auto contacts = static_cast<std::int64_t>(simulation.contacts().size());
    periods_.push_back(
        {simulation.tip(), simulation.impulse() - impulseBefore_, contacts - contactsBefore_});
    impulseBefore_ = simulation.impulse();
    contactsBefore_ = contacts;
    constexpr std::size_t most = 4096;
    if (periods_.size() > most) {
        periods_.erase(periods_.begin(), periods_.begin() + most / 2);
    }
}

bool SettlingWatch::repeats(std::size_t length, double tolerance) const
{
    const std::size_t compared = length * static_cast<std::size_t>(repeats_);
    const auto isAlike = [tolerance](const Period& one, const Period& other) {
        return std::abs(one.tip - other.tip) <= tolerance * std::max(1.0, std::abs(other.tip)) &&
               std::abs(one.impulse - other.impulse) <= tolerance * std::max(1.0, other.impulse);
    };
    const auto last = periods_.end() - static_cast<std::ptrdiff_t>(compared);
    return compared + length <= periods_.size() &&
           std::equal(last, periods_.end(), last - static_cast<std::ptrdiff_t>(length), isAlike);
}

std::optional<Settled> SettlingWatch::settled() const
{
    constexpr std::size_t longest = 16;
    // On the way to a short period deviations may take turns: such a one is not yet a long period.
    constexpr double turns = 1e3;
    std::size_t length = 1;
    while (length <= longest && !repeats(length, tolerance_)) {
        if (repeats(length, turns * tolerance_)) {
            return std::nullopt;
        }
        ++length;
    }
    if (length > longest) {
        return std::nullopt;
    }
    Settled result{static_cast<std::int64_t>(length), 0, 0.0};
    const auto compared = static_cast<std::ptrdiff_t>(length) * repeats_;
    for (auto period = periods_.end() - compared; period != periods_.end(); ++period) {
        result.contacts += period->contacts;
        result.impulse += period->impulse;
    }
    // A contact is counted when it ends, so single periods may be one off.
    result.contacts = (2 * result.contacts + repeats_) / (2 * repeats_);
    result.impulse /= static_cast<double>(repeats_);
    return result;
}

}  // namespace signorini
